"""The table of laws side by side."""

import csv

import compare_laws
import numpy as np
import pytest
from flown_worlds import scenario_of
from outcomes import flight
from world_tables import loaded_from

from vfguide.guidance.remedies import Remedies
from vfguide.results.field_share import FieldResult


def test_laws_side_by_side_as_a_table(tmp_path):

    def flown_as(**changes):
        return compare_laws.Flown(flight(**changes), np.array([10.0, 20.0, 30.0]))

    flown = [
        {"printed": flown_as(clearance_m=-2.0, best_m=4.0), "ours": flown_as()},
        {"printed": flown_as(reached=False), "ours": flown_as(miss_m=7.0)},
    ]
    rows = [compare_laws.row_of("field", law, flown) for law in ("printed", "ours")]
    printed, ours = rows
    assert (printed.worlds, printed.entered, printed.no_escape, printed.reached) == (2, 1, 0, 0)
    assert (ours.entered, ours.reached, ours.length_median) == (0, 1, 1.1)
    assert ours.step_median_us == 20.0
    text = compare_laws.markdown(rows)
    assert "| field | printed | 2 | 1 | 0 | -2.0 | 0 | - | 20, 30 | 10.00 | - |" in text
    compare_laws.write_csv(rows, tmp_path / "laws.csv")
    with (tmp_path / "laws.csv").open() as file:
        assert [line["law"] for line in csv.DictReader(file)] == ["printed", "ours"]


def test_who_led_is_in_the_table():
    led = [FieldResult(0.9, 0.8, 0.0, 0), FieldResult(0.5, 0.4, 0.3, 2)]
    flown = [{"field": compare_laws.Flown(flight(field=each), np.array([10.0]))} for each in led]
    row = compare_laws.row_of("dead-end", "field", flown)
    assert (row.leading_percent, row.least_leading_percent, row.route_percent) == (70.0, 50.0, 15.0)
    assert compare_laws.cells(row)[-1] == "70.0, 50, 15.0"


def test_each_remedy_has_a_law_with_it_alone():
    for name in Remedies._fields:
        remedies = compare_laws.FLOWN[f"only {name}"].remedies
        assert [each for each, on in remedies._asdict().items() if on] == [name]
        bare = compare_laws.FLOWN[f"only {name}, unassured"]
        assert (bare.remedies, bare.is_assured) == (remedies, False)
    assert not any(compare_laws.FLOWN["no remedy"].remedies)
    assert all(compare_laws.FLOWN["field"].remedies)


def test_the_worlds_can_be_flown_on_the_papers_plant(tmp_path):
    for kind in ("field", "movers", "cluster", "overtaking", "popup", "dead-end"):
        table = compare_laws.with_reach(scenario_of(kind, 1, 0), 100.0)
        assert compare_laws.is_for("own plant", table)
        scenario = loaded_from(compare_laws.on_papers_plant(table), tmp_path).scenario
        assert (scenario.plant, scenario.law) == ("kinematic", "paper")
        assert len(scenario.obstacles) == len(table["obstacle"])
    assert not compare_laws.is_for("own plant", scenario_of("turning", 1, 0))
    assert not compare_laws.is_for("own plant", scenario_of("fence", 1, 0))


def test_reactive_areas_reach_as_far_as_asked_for():
    assert compare_laws.level_of({"shape": "sphere", "radius_m": 50.0}, 100.0) == pytest.approx(9)
    wall = {"shape": "box", "size_m": [900.0, 100.0, 290.0]}
    assert compare_laws.level_of(wall, 50.0) == pytest.approx(256.0)
