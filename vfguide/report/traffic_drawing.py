"""Other aircraft as figures show them: their paths, and their volumes where they came nearest."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from vfguide.geometry.vector import Vector, Vectors
from vfguide.report.meshes import outline
from vfguide.report.obstacle_drawing import MAX_NAMES, east_north_up, write_name
from vfguide.results.record import Array, FlightRecord
from vfguide.results.traffic_results import volume_distance
from vfguide.scenario.resolved import Scenario
from vfguide.scenario.traffic import path_of
from vfguide.sim.traffic import motion_at

AIRCRAFT_COLOUR = "#7a4fa3"
"""Colour of other aircraft and their volumes."""
VOLUME_CORNERS = 48
"""Number of corners around a drawn volume; chosen."""
_PATH: Any = {"color": AIRCRAFT_COLOUR, "linestyle": (0, (5, 2, 1, 2)), "linewidth": 1.3}
_VOLUME: Any = {
    "facecolor": (AIRCRAFT_COLOUR, 0.15),
    "edgecolor": AIRCRAFT_COLOUR,
    "linewidth": 0.9,
}


@dataclass(frozen=True)
class TrafficPath:
    """Another aircraft as it is drawn, over the time of a run."""

    name: str
    p_n: Vectors
    """(n, 3) positions on its path, NED [m]."""
    volume: Vectors
    """(m, 3) points on the edges of its volume when that came nearest to a vehicle, NED [m]."""
    nearest: Vector
    """(3,) its position when its volume came nearest to a vehicle, NED [m]."""


def traffic_paths_of(
    scenario: Scenario, records: Sequence[FlightRecord]
) -> tuple[TrafficPath, ...]:
    """The other aircraft of a run."""
    edges = _edges(scenario.avoidance.traffic_radius_m, scenario.avoidance.traffic_half_height_m)
    traffic: list[TrafficPath] = []
    for each in scenario.traffic:
        p_n, _ = motion_at(path_of(each), records[0].time)
        apart = [volume_distance(scenario.avoidance, p_n - record.p_n) for record in records]
        nearest = p_n[int(np.nan_to_num(np.min(apart, axis=0), nan=np.inf).argmin())]
        traffic.append(TrafficPath(each.name, p_n, nearest + edges, nearest))
    return tuple(traffic)


def _edges(radius: float, half_height: float) -> Array:
    """Points on the two circles that bound an upright cylinder, (2 VOLUME_CORNERS, 3), NED [m]."""
    angle = np.linspace(0.0, 2.0 * np.pi, VOLUME_CORNERS, endpoint=False)
    x, y, down = (
        radius * np.cos(angle),
        radius * np.sin(angle),
        np.full(VOLUME_CORNERS, half_height),
    )
    return np.vstack((np.column_stack((x, y, -down)), np.column_stack((x, y, down))))


def draw_traffic(axes: Axes, traffic: Sequence[TrafficPath], onto: Array) -> None:
    """Draw paths and volumes of traffic on a plane; `onto`, (3, 2), projects NED to its axes."""
    for each in traffic:
        axes.plot(*(each.p_n @ onto).T, zorder=1.6, **_PATH)
        axes.fill(*outline(each.volume @ onto).T, zorder=1.4, **_VOLUME)


def name_traffic(axes: Axes, traffic: Sequence[TrafficPath], onto: Array) -> None:
    """Write the names of traffic above their volumes, unless there are too many.

    `onto`, (3, 2), projects NED to the axes of the figure.
    """
    for each in traffic if len(traffic) <= MAX_NAMES else ():
        across, up = (each.volume @ onto).T
        top = np.array((0.5 * (across.min() + across.max()), up.max()))
        write_name(axes, each.name, top, AIRCRAFT_COLOUR, above=True)


def draw_traffic_in_space(axes: Any, traffic: Sequence[TrafficPath]) -> None:
    """Draw paths and volumes of traffic in axes east, north, up."""
    for each in traffic:
        axes.plot(*east_north_up(each.p_n).T, zorder=1.6, axlim_clip=True, **_PATH)
        for circle in each.volume.reshape(2, VOLUME_CORNERS, 3):
            around = np.arange(VOLUME_CORNERS + 1) % VOLUME_CORNERS
            x, y, z = east_north_up(circle[around]).T
            axes.plot(x, y, z, color=AIRCRAFT_COLOUR, linewidth=0.9, zorder=1.6, axlim_clip=True)


def traffic_marks(traffic: Sequence[TrafficPath]) -> list[Patch | Line2D]:
    """Entries of the legend for traffic."""
    if not traffic:
        return []
    path = Line2D([], [], **_PATH, label="Other aircraft")
    return [path, Patch(**_VOLUME, label="Its volume, when nearest")]
