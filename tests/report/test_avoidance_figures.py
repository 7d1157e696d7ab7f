"""What the report shows of a fence and of the run-time assurance."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from drawings import drawn
from flight_samples import record_of, straight
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon
from scenario_samples import loaded_from
from scenario_texts import MINIMAL

from vfguide.report.assurance_figure import SHADES, draw_assurance
from vfguide.report.drawing import Flights
from vfguide.report.figures import draw_figures
from vfguide.report.path_figures import draw_plan, draw_side
from vfguide.report.report import render
from vfguide.results.judge import judge
from vfguide.results.record import Decisions

WORLD = """
[fence]
floor_m = 60
ceiling_m = 150

[[fence.zone]]
kind = "include"
polygon_m = [[-600, -80], [300, -80], [300, 90], [-600, 90]]

[[fence.zone]]
kind = "exclude"
centre_m = [-200, 60]
radius_m = 25

[[obstacle]]
name = "tower"
shape = "cylinder"
position_m = [-100, -60, -50]
radius_m = 20
height_m = 200
"""


@pytest.fixture
def flights(tmp_path: Path) -> Flights:
    loaded = loaded_from(tmp_path, MINIMAL + WORLD)
    record = record_of(loaded.scenario.vehicles[0], straight, 25.0)
    guard = np.tile((0.0, 12.0, np.inf, -1.0), (len(record.time), 1))
    guard[500:550] = (1.0, 8.0, 3.0, 0.0)
    guard[800:810] = (2.0, -1.0, 2.0, 2.0)
    return Flights(loaded, [replace(record, decisions=Decisions(*guard.T))])


def labels(figure: Figure) -> list[str]:
    return [text.get_text() for legend in figure.legends for text in legend.get_texts()]


def test_the_plan_shows_the_zones_of_the_fence(flights: Flights) -> None:
    figure = drawn(draw_plan, flights)
    (axes,) = figure.axes
    (circle,) = [patch for patch in axes.patches if isinstance(patch, Circle)]
    assert (circle.center, circle.radius) == ((60.0, -200.0), 25.0)
    corners = [patch.get_xy().tolist() for patch in axes.patches if isinstance(patch, Polygon)]
    assert [[-80.0, -600.0], [-80.0, 300.0], [90.0, 300.0]] in [its[:3] for its in corners]
    assert {"Fence, stay inside", "Fence, stay out"} < set(labels(figure))
    (west, east), (south, north) = axes.get_xlim(), axes.get_ylim()
    assert west < -80.0 < 90.0 < east
    assert south < -600.0 < 300.0 < north


def test_the_side_shows_floor_and_ceiling(flights: Flights) -> None:
    figure = drawn(draw_side, flights)
    (axes,) = figure.axes
    levels = [line.get_ydata() for line in axes.lines if len(set(line.get_ydata())) == 1]
    assert {60.0, 150.0} <= {float(values[0]) for values in levels}
    assert "Floor and ceiling of the fence" in labels(figure)
    low, high = axes.get_ylim()
    assert low < 60.0
    assert high > 150.0


def test_the_nearest_hazard_over_time_is_shaded_where_the_assurance_acted(flights: Flights) -> None:
    (axes,) = drawn(draw_assurance, flights).axes
    shown = [(its.get_x(), its.get_width(), its.get_facecolor()[:3]) for its in axes.patches]
    colours = [to_rgb(SHADES[reason]["facecolor"]) for reason in ("escape", "least bad")]
    assert [left for left, *_ in shown] == pytest.approx([10.0, 16.0])
    assert [width for _, width, _ in shown] == pytest.approx([1.0, 0.2])
    assert [colour for *_, colour in shown] == colours
    surface, margin, nearest = (np.asarray(line.get_ydata(), float) for line in axes.lines)
    assert set(surface) == {0.0}
    scenario = flights.loaded.scenario
    (vehicle,) = scenario.vehicles
    least = 12.0 * scenario.airspeed_of(vehicle) / 25.0
    assert margin.tolist() == pytest.approx([least, least], abs=0.1)
    assert nearest[0] == pytest.approx(40.0)  # the floor; the start is farther from the rest
    assert nearest[600] == pytest.approx(35.0, abs=0.5)  # beside the circle
    assert nearest.min() == pytest.approx(35.0, abs=0.1)


def test_the_report_has_a_table_of_the_episodes(flights: Flights) -> None:
    result = judge(flights.loaded.scenario, flights.records, 25.0, 0.1)
    page = render(flights.loaded, result, [], "vfguide run x.toml")
    assert "Run-time assurance" in page
    assert "<td>10.0</td>" in page
    assert "best effort" in page
    assert "<td>fence.zone[1]</td>" in page
    assert "<td>tower</td>" in page


@pytest.mark.parametrize("unclear", [0, 10])
def test_the_report_does_not_promise_what_was_not_kept(flights: Flights, unclear: int) -> None:
    """A setpoint goes out where nothing is clear too: the text is as true as the table over it."""
    (record,) = flights.records
    assert record.decisions is not None
    reason = np.where(
        (record.decisions.reason == 2.0) & (unclear == 0), 0.0, record.decisions.reason
    )
    kept = replace(record, decisions=record.decisions._replace(reason=reason))
    result = judge(flights.loaded.scenario, [kept], 25.0, 0.1)
    page = " ".join(render(flights.loaded, result, [], "vfguide run x.toml").split())
    assert "only if" not in page
    assert "an escape from here is flown instead" in page
    assert (f"{unclear} setpoints here" in page) == (unclear > 0)


def test_without_hazards_there_is_no_such_figure_and_no_table(tmp_path: Path) -> None:
    loaded = loaded_from(tmp_path)
    record = record_of(loaded.scenario.vehicles[0], straight, 25.0)
    result = judge(loaded.scenario, [record], 25.0, 0.1)
    assert "Run-time assurance" not in render(loaded, result, [], "vfguide run x.toml")
    names = [picture.name for picture in draw_figures(Flights(loaded, [record]))]
    assert "assurance" not in names
