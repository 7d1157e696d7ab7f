"""Rows of flights: the worst of all goals, obstacles and vehicles; and the columns they make."""

import math
from dataclasses import asdict, dataclass

import pyarrow as pa
import pytest
from campaign_rows import flown_row, goal, vehicle

from vfguide.campaign.draws import Draw, draw
from vfguide.campaign.rows import columns_of, failed_row, row_of
from vfguide.campaign.schema import arrow_type, schema_of, simple_columns
from vfguide.files.vary import Uniform
from vfguide.results.result import Result

DRAW = Draw(3, 17, (("wind.speed_mps", 2.5),))


def result(*vehicles, verdict="good", separation=None):
    return Result("x", "0", 17, verdict, (), 30.0, 0.2, 150.0, separation, vehicles)


def test_figures_are_the_worst():
    one = vehicle(goal(0.5), goal(-0.75), clearances=(12.0, 3.0))
    other = vehicle(goal(0.25, reached=False), clearances=(4.0,))
    row = row_of(DRAW, result(one, other, verdict="bad", separation=21.0), "w", "cpu")
    assert (row.miss_m, row.min_clearance_m, row.min_separation_m) == (-0.75, 3.0, 21.0)
    assert (row.reached, row.goals_reached, row.verdict) == (False, 2, "bad")
    assert (row.load_factor_least, row.load_factor_most) == (0.9, 1.5)
    assert (row.airspeed_least_mps, row.altitude_most_m) == (24.0, 640.0)
    assert (row.worker, row.processor, row.index, row.seed) == ("w", "cpu", 3, 17)


def test_a_goal_that_was_never_passed_leaves_no_worst_miss():
    row = row_of(DRAW, result(vehicle(goal(0.5), goal(None, reached=False))), "w", "cpu")
    assert row.miss_m is None


def test_without_obstacles_there_is_no_clearance():
    assert row_of(DRAW, result(vehicle(goal())), "w", "cpu").min_clearance_m is None


@pytest.mark.parametrize(
    "row", [flown_row(DRAW), failed_row(DRAW, "why", "w", "cpu")], ids=["flown", "failed"]
)
def test_a_row_goes_through_the_table_unchanged(row):
    schema = schema_of(["wind.speed_mps"])
    columns = columns_of(row, DRAW, "vfguide run x")
    (back,) = pa.Table.from_pylist([columns], schema=schema).to_pylist()
    assert list(back) == schema.names
    assert {**back, "vehicles": None, "reasons": tuple(back["reasons"])} == {
        **asdict(row),
        "vehicles": None,
        "command": "vfguide run x",
        "wind.speed_mps": 2.5,
    }
    for there, here in zip(back["vehicles"], row.vehicles, strict=True):
        assert there["goals"] == [asdict(each) for each in here.goals]
        assert tuple(there["load_factor"]) == here.load_factor


def test_simple_columns_are_no_lists():
    names = simple_columns(schema_of(["wind.speed_mps"]))
    assert {"miss_m", "verdict", "reached", "wind.speed_mps"} <= set(names)
    assert not {"vehicles", "reasons"} & set(names)


def test_a_type_that_no_column_can_hold():
    @dataclass
    class Holder:
        it: dict[str, int]

    with pytest.raises(TypeError, match="dict"):
        arrow_type(Holder)


def test_drawn_values_are_columns():
    drawn = draw(1, 0, {"wind.speed_mps": Uniform(1.0, 2.0)})
    columns = columns_of(flown_row(drawn), drawn, "")
    assert 1.0 <= columns["wind.speed_mps"] <= 2.0
    assert not math.isnan(columns["miss_m"])
