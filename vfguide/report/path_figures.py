"""Figures of the path: in space, from above and from the side."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from vfguide.geometry.vector import Series
from vfguide.report.drawing import GOAL_COLOUR, MUTED_COLOUR, Flights, goal_axis, line_of
from vfguide.report.fence_figure import draw_heights, draw_zones, height_marks, zone_marks
from vfguide.report.meshes import outline
from vfguide.report.obstacle_drawing import draw_outlines, draw_surfaces, east_north_up, write_names
from vfguide.report.traffic_drawing import draw_traffic, draw_traffic_in_space, name_traffic
from vfguide.report.view import draw_goal, draw_legend, numbered, view_of
from vfguide.report.wind_arrow import draw_wind
from vfguide.results.record import Array
from vfguide.scenario.resolved import Goal

EAST_AXIS = np.array((0.0, 1.0, 0.0))
"""Unit vector to the east, NED, dimensionless."""
NORTH_AXIS = np.array((1.0, 0.0, 0.0))
"""Unit vector to the north, NED, dimensionless."""
UP_AXIS = np.array((0.0, 0.0, -1.0))
"""Unit vector upwards, NED, dimensionless."""


def draw_space(figure: Figure, flights: Flights) -> None:
    """Draw the paths in space, with their shadows on the floor of the box; axes to one scale."""
    figure.set_size_inches(8.6, 6.4)
    figure.set_layout_engine("constrained")
    axes: Any = figure.add_subplot(projection="3d", computed_zorder=False)
    view = view_of(flights, np.array((EAST_AXIS, NORTH_AXIS, UP_AXIS)))
    box, floor = view.limits, float(view.limits[2, 0])
    axes.set(xlim=box[0], ylim=box[1], zlim=box[2])
    draw_surfaces(axes, flights.bodies, floor)
    draw_traffic_in_space(axes, flights.traffic)
    for index, record in enumerate(flights.records):
        x, y, z = east_north_up(record.p_n).T
        line = line_of(index)
        axes.plot(x, y, np.full_like(z, floor), color="#d1d5db", linewidth=1.4, zorder=0.6)
        axes.plot(x, y, z, **line)
        axes.scatter(x[:1], y[:1], z[:1], color=line["color"], s=32, zorder=3)
        for goal in record.vehicle.goals:
            _arrow_in_space(axes, goal, floor, view.arrow)
    axes.locator_params(nbins=6)
    extent: Series = np.ptp(box, axis=1)
    axes.set_box_aspect(extent, zoom=1.2 - 0.4 * extent[2] / extent.max())
    axes.view_init(elev=28, azim=-60)
    figure.suptitle("Path in space", x=0.02, ha="left", fontsize=12, fontweight="bold")
    axes.set_xlabel("East of the origin [m]", labelpad=10)
    axes.set_ylabel("North of the origin [m]", labelpad=10)
    axes.set_zlabel("Above the origin [m]", labelpad=10)
    draw_legend(figure, flights)


def draw_plan(figure: Figure, flights: Flights) -> None:
    """Draw the paths from above, north up, east to the right, axes to one scale, and the wind."""
    figure.set_size_inches(8.0, 7.4)
    figure.set_layout_engine("constrained")
    axes = figure.add_subplot()
    _draw_flat(axes, flights, EAST_AXIS, NORTH_AXIS)
    draw_zones(axes, flights.loaded.scenario.fence)
    write_names(axes, flights.bodies, np.column_stack((EAST_AXIS, NORTH_AXIS)))
    name_traffic(axes, flights.traffic, np.column_stack((EAST_AXIS, NORTH_AXIS)))
    axes.set(xlabel="East of the origin [m]", ylabel="North of the origin [m]")
    axes.set_title("Path from above")
    wind = flights.loaded.scenario.wind
    if any(speed > 0.0 for _, speed, _ in wind.stages):
        outlines = [outline(body.surface[..., [1, 0]]) for body in flights.bodies]
        paths = [record.p_n[:, [1, 0]] for record in flights.records]
        draw_wind(figure, axes, wind, np.vstack((*paths, *outlines)))
    draw_legend(figure, flights, zone_marks(flights.loaded.scenario.fence))


def draw_side(figure: Figure, flights: Flights) -> None:
    """Draw the paths from the right of the course at the first vehicle's last goal."""
    figure.set_layout_engine("constrained")
    axes = figure.add_subplot()
    course = flights.records[0].vehicle.goals[-1].heading_deg
    _draw_flat(axes, flights, np.array(goal_axis(course, 0.0)), UP_AXIS)
    slope = np.ptp(axes.get_ylim()) / np.ptp(axes.get_xlim())
    figure.set_size_inches(8.6, float(np.clip(7.7 * slope + 1.7, 4.4, 7.4)))
    axes.set_xlabel(f"From the origin along the course {course % 360.0:03.0f}° [m]")
    axes.set_ylabel("Above the origin [m]")
    axes.set_title(f"Path from the side, seen toward {(course - 90.0) % 360.0:03.0f}°")
    draw_heights(axes, flights.loaded.scenario.fence)
    draw_legend(figure, flights, height_marks(flights.loaded.scenario.fence))


def _draw_flat(axes: Axes, flights: Flights, right: Array, up: Array) -> None:
    """Draw obstacles, traffic, paths and goals on the plane of two unit vectors (3,), NED."""
    onto = np.column_stack((right, up))
    view = view_of(flights, onto.T)
    draw_outlines(axes, flights.bodies, onto)
    draw_traffic(axes, flights.traffic, onto)
    for index, record in enumerate(flights.records):
        x, y = (record.p_n @ onto).T
        line = line_of(index)
        axes.plot(x, y, **line)
        axes.plot(x[:1], y[:1], "o", color=line["color"], markersize=7, zorder=4)
        for label, goal in numbered(record.vehicle.goals):
            at = np.array(goal.position_m) @ onto
            tip = at + view.arrow * np.array(goal_axis(goal.heading_deg, goal.climb_deg)) @ onto
            draw_goal(axes, at, tip, label)
    axes.set(xlim=view.limits[0], ylim=view.limits[1], aspect="equal")


def _arrow_in_space(axes: Any, goal: Goal, floor: float, length: float) -> None:
    x, y, z = east_north_up(np.array(goal.position_m))
    ahead = east_north_up(np.array(goal_axis(goal.heading_deg, goal.climb_deg)))
    axes.plot([x, x], [y, y], [floor, z], color=MUTED_COLOUR, lw=0.9, ls=":")
    axes.scatter([x], [y], [z], color=GOAL_COLOUR, s=20, zorder=3)
    axes.quiver(x, y, z, *ahead, length=length, color=GOAL_COLOUR, lw=1.8, zorder=3)
