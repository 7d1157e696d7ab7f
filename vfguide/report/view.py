"""The part of space that a figure of paths shows, and what all such figures share."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from vfguide.geometry.vector import Vector, Vectors
from vfguide.report.drawing import GOAL_COLOUR, MUTED_COLOUR, Flights, goal_axis, vehicle_lines
from vfguide.report.fence_figure import places_of
from vfguide.report.obstacle_drawing import body_marks
from vfguide.report.traffic_drawing import traffic_marks
from vfguide.results.record import Array
from vfguide.scenario.resolved import Goal

VIEW_MARGIN = 0.5
"""Distance within which obstacles are in view, as a share of the longest extent of paths and goals;
chosen."""
ARROW_LENGTH = 0.15
"""Length of the arrow of a goal, as a share of the longest extent of paths and goals; chosen."""
LEAST_EXTENT = 20.0
"""Least value of the longest extent [m]; chosen, so that a short flight is not magnified."""
LEAST_WIDTH_SHARE = 0.35
"""Least extent along a horizontal axis, as a share of the longest one; chosen, so that no figure is
a strip."""
LEAST_HEIGHT_SHARE = 0.25
"""Least extent along any other axis, as a share of the longest one; chosen, so that no figure is a
strip."""
FRAME_SHARE = 0.07
"""Margin round everything that is shown, as a share of the longest extent; chosen."""
WIDE_LEGEND = 5
"""Largest number of entries of a legend in one row; chosen."""
NARROW_LEGEND = 4
"""Number of entries in each row of a legend of several rows; chosen."""
PATH_MARKS = (
    Line2D([], [], color=MUTED_COLOUR, marker="o", linestyle="none", markersize=6, label="Start"),
    Line2D(
        [],
        [],
        color=GOAL_COLOUR,
        marker=">",
        linestyle="-",
        markersize=6,
        label="Goal and its course",
    ),
)
"""Entries of a legend for start and goal."""


@dataclass(frozen=True)
class View:
    """The box that a figure shows, and the length of the arrows in it."""

    limits: Vectors
    """(k, 2) least and greatest coordinate along each axis [m]."""
    arrow: float
    """Length of the arrow of a goal [m]."""


def view_of(flights: Flights, axes_n: Vectors) -> View:
    """The part of space that shows `flights` along the axes `axes_n`, (k, 3), unit vectors, NED.

    It contains all paths and goals, and what is near them of the fence, of obstacles and of the
    volumes of traffic, with a margin. None of its sides is much shorter than the others.
    """
    goals = [goal for record in flights.records for goal in record.vehicle.goals]
    places = np.array([goal.position_m for goal in goals])
    points = np.vstack([*(record.p_n for record in flights.records), places])
    points = points[np.isfinite(points).all(axis=1)] @ axes_n.T
    longest = max(float(np.ptp(points, axis=0).max()), LEAST_EXTENT)
    ahead = np.array([goal_axis(goal.heading_deg, goal.climb_deg) for goal in goals])
    points = np.vstack((points, (places + ARROW_LENGTH * longest * ahead) @ axes_n.T))
    points = np.vstack((points, *_bodies_near(flights, points, VIEW_MARGIN * longest, axes_n)))
    low, high = points.min(axis=0), points.max(axis=0)
    longest_shown = max(float((high - low).max()), LEAST_EXTENT)
    least = np.where(axes_n[:, 2] == 0.0, LEAST_WIDTH_SHARE, LEAST_HEIGHT_SHARE) * longest_shown
    centre = (low + high) / 2.0
    half = np.maximum(high - low, least) / 2.0 + FRAME_SHARE * longest_shown
    return View(np.column_stack((centre - half, centre + half)), ARROW_LENGTH * longest)


def _bodies_near(flights: Flights, points: Array, reach: float, axes_n: Array) -> Iterator[Array]:
    """Corners (2, k) of what is within `reach` of the box of `points`, cut off there [m].

    They are those of the fence, of each obstacle, and of the volume of each other aircraft.
    """
    low, high = points.min(axis=0) - reach, points.max(axis=0) + reach
    fence = places_of(flights.loaded.scenario.fence, flights.records[0].p_n[0]) @ axes_n.T
    if len(fence):
        yield np.clip((fence.min(axis=0), fence.max(axis=0)), low, high)
    shown = [body.surface + shift for body in flights.bodies for shift, _ in body.places]
    for surface in (*shown, *(path.volume for path in flights.traffic)):
        corners = surface.reshape(-1, 3) @ axes_n.T
        least, most = corners.min(axis=0), corners.max(axis=0)
        if (least < high).all() and (most > low).all():
            yield np.clip((least, most), low, high)


def numbered(goals: Sequence[Goal]) -> list[tuple[str, Goal]]:
    """Goals with their labels: numbers from 1, or nothing where there is only one goal."""
    if len(goals) == 1:
        return [("", goals[0])]
    return [(str(number), goal) for number, goal in enumerate(goals, start=1)]


def draw_goal(axes: Axes, at: Vector, tip: Vector, label: str) -> None:
    """Draw the arrow of a goal from its position `at`, (2,), to `tip`, and its label."""
    look = {"arrowstyle": "-|>", "color": GOAL_COLOUR, "lw": 1.8, "shrinkA": 0}
    (x, y), (to_x, to_y) = at, tip
    axes.plot(x, y, "o", color=GOAL_COLOUR, markersize=5, zorder=5)
    axes.annotate("", (to_x, to_y), (x, y), arrowprops=look)
    axes.annotate(label, (x, y), (-8, 6), textcoords="offset points", ha="right", color=GOAL_COLOUR)


def draw_legend(figure: Figure, flights: Flights, more: Sequence[Artist] = ()) -> None:
    """Place a legend of vehicles, starts, goals, obstacles, traffic and `more` below the figure."""
    bodies, traffic = body_marks(flights.bodies), traffic_marks(flights.traffic)
    place_legend(figure, [*vehicle_lines(flights), *PATH_MARKS, *bodies, *traffic, *more])


def place_legend(figure: Figure, handles: Sequence[Artist]) -> None:
    """Place a legend below the figure."""
    columns = len(handles) if len(handles) <= WIDE_LEGEND else NARROW_LEGEND
    figure.legend(handles=handles, loc="outside lower center", ncols=columns)
