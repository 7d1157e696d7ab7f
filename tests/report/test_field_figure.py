"""What the report shows of law field."""

from dataclasses import replace
from itertools import pairwise
from unittest import mock

import numpy as np
import pytest
from drawings import drawn
from flight_samples import moved, record_of, straight
from matplotlib.patches import Circle
from matplotlib.quiver import Quiver
from scenario_samples import loaded_from
from scenario_texts import MINIMAL, SECOND

from vfguide.assurance.decision import Reason
from vfguide.field_points.field_plane import field_plane
from vfguide.guidance.guidance_state import Leader
from vfguide.report.drawing import Flights, to_png
from vfguide.report.field_drawing import AREA_COLOURS
from vfguide.report.field_figure import MAX_GOALS, draw_field
from vfguide.report.figures import draw_figures
from vfguide.report.meshes import section
from vfguide.report.obstacle_drawing import drawn_obstacle
from vfguide.results.record import Decisions

pytestmark = pytest.mark.slow

TOWER = """
[[obstacle]]
name = "tower"
shape = "cylinder"
position_m = [-100, 60, -50]
radius_m = 40
height_m = 300
"""
BELOW = """
[[obstacle]]
name = "hut"
shape = "box"
position_m = [-300, 0, -10]
size_m = [20, 20, 20]
"""
MOVING = """
[[obstacle]]
name = "balloon"
shape = "sphere"
position_m = [-250, -300, -100]
radius_m = 20
velocity_mps = [0, 20, 0]
"""


def flights_of(folder, text, changes=("law=field",), seconds=25.0):
    loaded = loaded_from(folder, text, changes)
    records = [
        record_of(vehicle, moved(straight, (0.0, 30.0 * index, 0.0)), seconds)
        for index, vehicle in enumerate(loaded.scenario.vehicles)
    ]
    return Flights(loaded, records)


def labels(figure):
    return [text.get_text() for legend in figure.legends for text in legend.get_texts()]


def arrows_of(axes):
    (quiver,) = [each for each in axes.collections if isinstance(each, Quiver)]
    return quiver.XY, np.column_stack((quiver.U, quiver.V))


def test_arrows_lead_to_the_goal_and_round_the_tower(tmp_path):
    figure = drawn(draw_field, flights_of(tmp_path, MINIMAL + TOWER))
    (axes,) = figure.axes
    places, toward = arrows_of(axes)
    assert len(places) > 300
    assert np.linalg.norm(toward, axis=1) == pytest.approx(np.hypot(*toward[0]))
    from_tower = places - (60.0, -100.0)
    assert (np.hypot(*from_tower.T) > 40.0).all()
    before = (np.abs(places[:, 0]) < 20.0) & (places[:, 1] < -300.0)
    assert before.any()
    assert (toward[before, 1] > 0.0).all()
    close = np.hypot(*from_tower.T) < 52.0
    assert close.any()
    assert (np.einsum("ij,ij->i", toward, from_tower)[close] > -0.1 * 52.0).all()
    assert {"Obstacle", "Reactive area, χ < 1", "Approach by law flight"} < set(labels(figure))
    assert "tower" in [text.get_text() for text in axes.texts]


def test_reactive_areas_are_the_darker_the_nearer(tmp_path):
    (axes,) = drawn(draw_field, flights_of(tmp_path, MINIMAL + TOWER)).axes
    (areas,) = [
        each for each in axes.collections if len(each.get_facecolors()) == len(AREA_COLOURS)
    ]
    extents = [path.get_extents() for path in areas.get_paths()]
    for outer, inner in pairwise(extents):
        assert outer.y0 <= inner.y0
        assert outer.x1 >= inner.x1
    assert extents[0].y0 < -140.0 < extents[-1].y1


def test_without_hazards_there_are_arrows_alone(tmp_path):
    figure = drawn(draw_field, flights_of(tmp_path, MINIMAL))
    (axes,) = figure.axes
    assert len(arrows_of(axes)[0]) > 300
    assert "Reactive area, χ < 1" not in labels(figure)


def test_what_does_not_reach_the_plane_is_not_shown(tmp_path):
    (axes,) = drawn(draw_field, flights_of(tmp_path, MINIMAL + BELOW)).axes
    assert "hut" not in [text.get_text() for text in axes.texts]


def test_what_moves_is_shown_when_it_was_nearest(tmp_path):
    (axes,) = drawn(draw_field, flights_of(tmp_path, MINIMAL + MOVING)).axes
    assert axes.get_title() == "Field to the goal, 100 m above the origin, after 12 s"
    hollow = [line for line in axes.lines if line.get_markerfacecolor() == "white"]
    assert [line.get_ydata()[0] for line in hollow] == pytest.approx([-190.0], abs=25.0)


def test_a_path_is_hollow_where_the_field_did_not_lead(tmp_path):
    flights = flights_of(tmp_path, MINIMAL + TOWER)
    (record,) = flights.records
    leaders, reason = np.zeros((2, len(record.time)))
    leaders[100:200], reason[300:350] = Leader.ROUTE, Reason.RECOVERY
    other = replace(record, leaders=leaders, decisions=Decisions(reason, *np.zeros((3, 1))))
    figure = drawn(draw_field, Flights(flights.loaded, [other]))
    (hollow,) = [line for line in figure.axes[0].lines if line.get_color() == "white"]
    assert np.flatnonzero(np.isfinite(hollow.get_xdata())).tolist() == [
        *range(100, 200),
        *range(300, 350),
    ]
    assert "Escape or route" in labels(figure)
    assert "Escape or route" not in labels(drawn(draw_field, flights))


def test_without_the_approach_there_is_no_circle(tmp_path):
    for changes, shown in (((), True), (("guidance.remedies.approach=false",), False)):
        figure = drawn(draw_field, flights_of(tmp_path, MINIMAL, ("law=field", *changes)))
        (axes,) = figure.axes
        radii = [patch.radius for patch in axes.patches if isinstance(patch, Circle)]
        assert any(radius > 100.0 for radius in radii) is shown
        assert ("Approach by law flight" in labels(figure)) is shown


def test_vehicles_with_the_same_goal_share_it(tmp_path):
    (axes,) = drawn(draw_field, flights_of(tmp_path, MINIMAL + SECOND)).axes
    paths = [line for line in axes.lines if len(line.get_xdata()) > 100]
    assert len(paths) == 1
    same = MINIMAL + MINIMAL[MINIMAL.index("[[vehicle]]") :].replace("id = 1", "id = 2").replace(
        "position_m = [-500", "position_m = [-600"
    )
    (axes,) = drawn(draw_field, flights_of(tmp_path, same)).axes
    assert len([line for line in axes.lines if len(line.get_xdata()) > 100]) == 2


def test_each_of_the_first_goals_has_a_panel(tmp_path):
    goal = "\n[[vehicle.goal]]\nposition_m = [{}, 0, -{}]\nheading_deg = 0\n"
    text = MINIMAL + "".join(goal.format(400 * k, 100 + 10 * k) for k in range(1, 6))
    figure = drawn(draw_field, flights_of(tmp_path, text))
    titles = [axes.get_title() for axes in figure.axes]
    assert len(titles) == MAX_GOALS
    assert titles[1] == "Field to goal 2, 110 m above the origin"


def test_it_is_drawn_for_law_field_alone(tmp_path):
    for law, shown in (("field", True), ("flight", False)):
        flights = flights_of(tmp_path, MINIMAL + TOWER, (f"law={law}",))
        names = [picture.name for picture in draw_figures(flights)]
        assert ("field" in names) is shown


def test_it_takes_few_points(tmp_path):
    """Less than half a second of them: one takes 5 us among five obstacles."""
    flights = flights_of(tmp_path, MINIMAL + TOWER)
    with mock.patch("vfguide.report.field_drawing.field_plane", wraps=field_plane) as evaluate:
        assert to_png(draw_field, flights).startswith(b"\x89PNG")
    assert sum(len(call.args[2]) for call in evaluate.call_args_list) <= 50_000


def test_a_section_is_as_wide_as_the_body_there(tmp_path):
    sphere = flights_of(tmp_path, MINIMAL + MOVING).loaded.scenario.obstacles[0]
    surface = drawn_obstacle(sphere, 0.0).surface
    corners = section(surface, -112.0)
    assert np.hypot(*(corners - (-250.0, -300.0)).T) == pytest.approx(16.0, rel=0.02)
    assert len(section(surface, -121.0)) == len(section(surface, -79.0)) == 0
