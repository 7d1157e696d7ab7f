"""The figure of law `field`: where it leads in the plane of each goal, and what was flown.

The field is that of the first vehicle, with all hazards known. The paths are those of all vehicles
that have the same goal.
"""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patheffects import withStroke

from vfguide.assurance.decision import Reason
from vfguide.geometry.vector import Mask
from vfguide.guidance.guidance_state import Leader
from vfguide.report.drawing import MUTED_COLOUR, Flights, goal_axis, line_of, vehicle_lines
from vfguide.report.fence_figure import draw_zones, zone_marks
from vfguide.report.field_drawing import GoalPlane, draw_field_in, field_marks
from vfguide.report.obstacle_drawing import draw_sections, drawn_obstacle, section_mark
from vfguide.report.path_figures import EAST_AXIS, NORTH_AXIS
from vfguide.report.view import PATH_MARKS, View, draw_goal, numbered, place_legend, view_of
from vfguide.results.clearance import clearances
from vfguide.results.record import FlightRecord
from vfguide.scenario.obstacles import rows_of
from vfguide.scenario.plans import plan_of
from vfguide.scenario.wind import blowing

MAX_GOALS = 4
"""Largest number of goals whose planes are drawn, each in a panel of its own; chosen."""
ARROWS = 40
"""Number of arrows along the longer side of the only panel; chosen, so that each is seen."""
PANEL_ARROWS = 24
"""Number of arrows along the longer side of one of several panels; chosen, so that each is seen."""
_HOLLOW: Any = {"color": "white", "linewidth": 0.9, "zorder": 2.3}


def draw_field(figure: Figure, flights: Flights) -> None:
    """Draw a panel for each of the first MAX_GOALS goals of the first vehicle."""
    planes = goal_planes(flights)
    columns = min(2, len(planes))
    rows = -(-len(planes) // columns)
    figure.set_size_inches(8.0 if columns == 1 else 10.0, 7.4 if rows == 1 else 10.0)
    figure.set_layout_engine("constrained")
    view = view_of(flights, np.array((EAST_AXIS, NORTH_AXIS)))
    grid = figure.subplots(rows, columns, squeeze=False).ravel()
    for axes, plane in zip(grid, planes, strict=False):
        draw_plane(axes, flights, plane, view)
    for axes in grid[len(planes) :]:
        axes.set_axis_off()
    scenario = flights.loaded.scenario
    bodies = [section_mark()] if scenario.obstacles else []
    marks = [*vehicle_lines(flights), *PATH_MARKS, *bodies, *zone_marks(scenario.fence)]
    place_legend(figure, [*marks, *field_marks(planes[0]), *led_elsewhere_marks(flights)])


def goal_planes(flights: Flights) -> list[GoalPlane]:
    """The planes of the first MAX_GOALS goals of the first vehicle, in the wind of the start."""
    scenario, vehicle = flights.loaded.scenario, flights.records[0].vehicle
    plan, time = plan_of(flights.loaded, vehicle), time_shown(flights)
    wind_n = blowing(scenario.wind.speed_mps, scenario.wind.from_deg)
    goals = enumerate(vehicle.goals[:MAX_GOALS])
    return [GoalPlane(plan, number, goal, time, wind_n) for number, goal in goals]


def time_shown(flights: Flights) -> float:
    """Time at which the obstacles are shown [s]: 0 where none moves.

    Otherwise it is the time at which the first vehicle was nearest to an obstacle.
    """
    record, obstacles = flights.records[0], flights.loaded.scenario.obstacles
    if not any(body.moves for body in flights.bodies):
        return 0.0
    nearest = np.nanmin(clearances(record, rows_of(obstacles)), axis=1)
    return float(record.time[np.nanargmin(nearest)])


def draw_plane(axes: Axes, flights: Flights, plane: GoalPlane, view: View) -> None:
    """Draw the field, the obstacles at the time of the plane, the fence, the paths and the goal."""
    scenario = flights.loaded.scenario
    arrows = ARROWS if len(flights.records[0].vehicle.goals) == 1 else PANEL_ARROWS
    draw_field_in(axes, plane, view.limits, arrows)
    draw_sections(
        axes, [drawn_obstacle(each, plane.time) for each in scenario.obstacles], plane.down
    )
    draw_zones(axes, scenario.fence)
    for index, record in enumerate(flights.records):
        if plane.goal in record.vehicle.goals:
            draw_path(axes, record, index, plane.time)
    label, goal = numbered(flights.records[0].vehicle.goals)[plane.number]
    at = np.array(goal.position_m)
    tip = at + view.arrow * np.array(goal_axis(goal.heading_deg, goal.climb_deg))
    draw_goal(axes, at[[1, 0]], tip[[1, 0]], label)
    east, north = view.limits
    axes.set(xlim=east, ylim=north, aspect="equal")
    axes.set(xlabel="East of the origin [m]", ylabel="North of the origin [m]")
    axes.set_title(title_of(plane, label))


def draw_path(axes: Axes, record: FlightRecord, index: int, time: float) -> None:
    """Draw the path of the vehicle number `index` of the scenario, and its position at a time [s].

    The line is hollow where an escape or a route was flown instead of the field.
    """
    x, y = record.p_n[:, [1, 0]].T
    line = line_of(index)
    now = np.searchsorted(record.time, time)
    axes.plot(x, y, **line)
    axes.plot(x[:1], y[:1], "o", color=line["color"], markersize=7, zorder=4)
    elsewhere = is_led_elsewhere(record)
    if elsewhere.any():
        axes.plot(np.where(elsewhere, x, np.nan), np.where(elsewhere, y, np.nan), **_HOLLOW)
    if time > 0.0:
        axes.plot(x[now], y[now], "o", mec=line["color"], mfc="white", mew=1.8, zorder=4)


def is_led_elsewhere(record: FlightRecord) -> Mask:
    """Whether an escape of the assurance or a route was flown at each sample, (n,)."""
    elsewhere = np.zeros(len(record.time), bool)
    if record.leaders is not None:
        elsewhere |= record.leaders == Leader.ROUTE
    if record.decisions is not None:
        elsewhere |= record.decisions.reason != Reason.NOMINAL
    return elsewhere


def led_elsewhere_marks(flights: Flights) -> list[Line2D]:
    """The entry of the legend for hollow parts of a path, where there are any."""
    if not any(is_led_elsewhere(record).any() for record in flights.records):
        return []
    around = [withStroke(linewidth=2.6, foreground=MUTED_COLOUR)]
    return [Line2D([], [], **_HOLLOW, path_effects=around, label="Escape or route")]


def title_of(plane: GoalPlane, label: str) -> str:
    """The title of a panel; `label` is the number of the goal, empty where there is only one."""
    goal = f"goal {label}" if label else "the goal"
    when = f", after {plane.time:.0f} s" if plane.time > 0.0 else ""
    return f"Field to {goal}, {-plane.down:g} m above the origin{when}"
