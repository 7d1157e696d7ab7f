"""Figures of the path: in space, from above and from the side."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.transforms import ScaledTranslation, Transform

from vfguide.geometry.units import DEG
from vfguide.scenario.drawing import (
    COLUMNS,
    GOAL,
    MUTED,
    Flights,
    goal_axis,
    line_of,
    vehicle_lines,
)
from vfguide.scenario.record import Array
from vfguide.scenario.resolved import Goal

_MARKS = [
    Line2D([], [], color=MUTED, marker="o", linestyle="none", markersize=6, label="Start"),
    Line2D(
        [], [], color=GOAL, marker=">", linestyle="-", markersize=6, label="Goal and its course"
    ),
]


def draw_space(figure: Figure, flights: Flights) -> None:
    """The paths in space, with their shadows on the floor of the box; axes to one scale."""
    figure.set_size_inches(8.6, 5.9)
    figure.set_layout_engine("constrained")
    axes: Any = figure.add_subplot(projection="3d", computed_zorder=False)
    box = _box(flights)
    floor = box[2, 0]
    for index, record in enumerate(flights.records):
        north, east, up = _neu(record.p_n)
        line = line_of(index)
        axes.plot(east, north, np.full_like(up, floor), color="#d1d5db", linewidth=1.4)
        axes.plot(east, north, up, **line)
        axes.scatter(east[:1], north[:1], up[:1], color=line["color"], s=32)
        for goal in record.vehicle.goals:
            _arrow_in_space(axes, goal, floor, _arrow_length(box))
    axes.set(xlim=box[1], ylim=box[0], zlim=box[2])
    axes.set_box_aspect((box[:, 1] - box[:, 0])[[1, 0, 2]], zoom=1.1)
    axes.view_init(elev=28, azim=-60)
    figure.suptitle("Path in space", x=0.02, ha="left", fontsize=12, fontweight="bold")
    axes.set_xlabel("East of the origin [m]", labelpad=10)
    axes.set_ylabel("North of the origin [m]", labelpad=10)
    axes.set_zlabel("Above the origin [m]", labelpad=4)
    _draw_legend(figure, flights)


def draw_plan(figure: Figure, flights: Flights) -> None:
    """The paths from above, north up, east to the right, axes to one scale, and the wind."""
    figure.set_size_inches(8.0, 7.4)
    figure.set_layout_engine("constrained")
    axes = figure.add_subplot()
    box = _box(flights)
    for index, record in enumerate(flights.records):
        north, east, _ = _neu(record.p_n)
        _draw_path(axes, east, north, index)
        for label, goal in _numbered(record.vehicle.goals):
            ahead = goal_axis(goal.heading_deg, goal.climb_deg)
            at = (goal.position_m[1], goal.position_m[0])
            _arrow(axes, at, (ahead[1], ahead[0]), _arrow_length(box), label)
    axes.set(xlim=box[1], ylim=box[0], aspect="equal")
    axes.set(xlabel="East of the origin [m]", ylabel="North of the origin [m]")
    axes.set_title("Path from above")
    _draw_wind(figure, axes, flights)
    _draw_legend(figure, flights)


def draw_side(figure: Figure, flights: Flights) -> None:
    """The paths from the right of the last goal's course, axes to one scale."""
    figure.set_size_inches(8.6, 4.4)
    figure.set_layout_engine("constrained")
    axes = figure.add_subplot()
    course = flights.records[0].vehicle.goals[-1].heading_deg
    along = np.array(goal_axis(course, 0.0))
    box = _box(flights)
    for index, record in enumerate(flights.records):
        _draw_path(axes, record.p_n @ along, -record.p_n[:, 2], index)
        for label, goal in _numbered(record.vehicle.goals):
            ahead = np.array(goal_axis(goal.heading_deg, goal.climb_deg))
            at = (float(goal.position_m @ along), -goal.position_m[2])
            _arrow(axes, at, (float(ahead @ along), -float(ahead[2])), _arrow_length(box), label)
    axes.set(aspect="equal", ylim=box[2])
    axes.margins(x=0.06)
    axes.set_xlabel(f"From the origin along the course {course % 360.0:03.0f}° [m]")
    axes.set_ylabel("Above the origin [m]")
    axes.set_title(f"Path from the side, seen toward {(course - 90.0) % 360.0:03.0f}°")
    _draw_legend(figure, flights)


def _neu(p_n: Array) -> tuple[Array, Array, Array]:
    return p_n[:, 0], p_n[:, 1], -p_n[:, 2]


def _box(flights: Flights) -> Array:
    """Limits of north, east and up, (3, 2): all that is drawn, with a margin, not too flat."""
    goals = [goal.position_m for its in flights.records for goal in its.vehicle.goals]
    points = np.vstack([*(record.p_n for record in flights.records), np.array(goals)])
    points = points[np.isfinite(points).all(axis=1)] * (1.0, 1.0, -1.0)
    low, high = points.min(axis=0), points.max(axis=0)
    longest = max(float((high - low).max()), 20.0)
    least = np.array((0.35, 0.35, 0.25)) * longest
    centre, half = (low + high) / 2.0, np.maximum(high - low, least) / 2.0 + 0.07 * longest
    return np.column_stack((centre - half, centre + half))


def _arrow_length(box: Array) -> float:
    return 0.13 * float((box[:, 1] - box[:, 0]).max())


def _draw_path(axes: Axes, x: Array, y: Array, index: int) -> None:
    line = line_of(index)
    axes.plot(x, y, **line)
    axes.plot(x[:1], y[:1], "o", color=line["color"], markersize=7, zorder=4)


def _numbered(goals: Sequence[Goal]) -> list[tuple[str, Goal]]:
    """Goals with their numbers, where there is more than one."""
    if len(goals) == 1:
        return [("", goals[0])]
    return [(str(number), goal) for number, goal in enumerate(goals, start=1)]


def _arrow(
    axes: Axes, at: tuple[float, float], ahead: tuple[float, float], length: float, label: str
) -> None:
    tip = (at[0] + length * ahead[0], at[1] + length * ahead[1])
    look = {"arrowstyle": "-|>", "color": GOAL, "lw": 1.8, "shrinkA": 0}
    axes.plot(*at, "o", color=GOAL, markersize=5, zorder=5)
    axes.annotate("", tip, at, arrowprops=look)
    axes.annotate(label, at, (-8, 6), textcoords="offset points", ha="right", color=GOAL)


def _arrow_in_space(axes: Any, goal: Goal, floor: float, length: float) -> None:
    north, east, down = goal.position_m
    n, e, d = goal_axis(goal.heading_deg, goal.climb_deg)
    axes.plot([east, east], [north, north], [floor, -down], color=MUTED, lw=0.9, ls=":")
    axes.scatter([east], [north], [-down], color=GOAL, s=20)
    axes.quiver(east, north, -down, e, n, -d, length=length, color=GOAL, lw=1.8)


def _draw_wind(figure: Figure, axes: Axes, flights: Flights) -> None:
    """An arrow that points where the wind blows, with its numbers, in the emptiest corner."""
    wind = flights.loaded.scenario.wind
    if wind.speed_mps == 0.0:
        return
    corner = _emptiest_corner(axes, flights)
    centre = np.array((42.0, 52.0)) * (1.0 - 2.0 * np.array(corner)) + (0.0, 12.0 * corner[1])
    toward = (wind.from_deg + 180.0) * DEG
    half = 17.0 * np.array((np.sin(toward), np.cos(toward)))
    axes.annotate(
        "",
        corner,
        corner,
        xycoords=_points_from(figure, axes, centre + half),
        textcoords=_points_from(figure, axes, centre - half),
        arrowprops={"arrowstyle": "-|>", "color": MUTED, "lw": 2.2, "mutation_scale": 16},
    )
    text = f"Wind {wind.speed_mps:g} m/s\nfrom {wind.from_deg % 360.0:03.0f}°"
    below = _points_from(figure, axes, centre - (0.0, 20.0))
    axes.annotate(text, corner, xycoords=below, ha="center", va="top", color=MUTED, fontsize=9)


def _points_from(figure: Figure, axes: Axes, offset: Array) -> Transform:
    """Fractions of the axes, moved by an offset in points, 1/72 inch."""
    x, y = offset / 72.0
    return axes.transAxes + ScaledTranslation(x, y, figure.dpi_scale_trans)


def _emptiest_corner(axes: Axes, flights: Flights) -> tuple[float, float]:
    """The corner that is farthest from the paths, as fractions of the axes."""
    (west, east), (south, north) = axes.get_xlim(), axes.get_ylim()
    paths = np.vstack([record.p_n[:, :2] for record in flights.records])
    seen = (paths - (south, west)) / (north - south, east - west)

    def room(corner: tuple[float, float]) -> float:
        return float(np.nanmin(np.hypot(seen[:, 1] - corner[0], seen[:, 0] - corner[1])))

    return max(((x, y) for x in (0.0, 1.0) for y in (0.0, 1.0)), key=room)


def _draw_legend(figure: Figure, flights: Flights) -> None:
    handles = [*vehicle_lines(flights), *_MARKS]
    columns = min(len(handles), COLUMNS)
    figure.legend(handles=handles, loc="outside lower center", ncols=columns)
