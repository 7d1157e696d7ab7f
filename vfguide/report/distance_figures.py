"""Figures of distances over time: from obstacles, and between vehicles."""

from collections.abc import Sequence
from itertools import combinations
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from vfguide.geometry.vector import Matrices
from vfguide.report.drawing import Flights, line_of, vehicle_lines
from vfguide.report.obstacle_drawing import shortened
from vfguide.report.panels import LIMIT_LINE, lay_out, make_near_large, name_axis
from vfguide.results.clearance import clearances
from vfguide.results.record import Array
from vfguide.scenario.obstacles import rows_of

MAX_OBSTACLES = 8
"""Largest number of obstacles that are drawn, those that came nearest; chosen."""
MAX_PAIRS = 6
"""Largest number of pairs of vehicles whose lines have names; chosen."""
TALL = 3.6
"""Height of a single panel [inch]; chosen."""
_PAIR: Any = {"color": "#c3cad4", "linewidth": 1.0}


def draw_clearance(figure: Figure, flights: Flights) -> None:
    """Clearances from obstacles: one line each; with several vehicles, one panel each."""
    obstacles = flights.loaded.scenario.obstacles
    rows = rows_of(obstacles)
    measured: Matrices = np.array([clearances(record, rows) for record in flights.records])
    shown = nearest(measured)
    names = [shortened(obstacles[which].name) for which in shown]
    title = "Clearance from obstacles"
    if len(shown) < len(obstacles):
        title = f"Clearance from the nearest {len(shown)} of {len(obstacles)} obstacles"
    surface = Line2D([], [], **LIMIT_LINE, label="Surface")
    if flights.several:
        grid = lay_out(figure, title, len(shown), [*vehicle_lines(flights), surface])
        for axes, which, name in zip(grid, shown, names, strict=True):
            _draw_clearances(axes, flights, measured[:, :, which], f"{name} [m]")
    else:
        lines = [Line2D([], [], **line_of(i), label=name) for i, name in enumerate(names)]
        (axes,) = lay_out(figure, title, 1, [*lines, surface], TALL)
        _draw_clearances(axes, flights, measured[0, :, shown], "Clearance [m]")


def nearest(measured: Array) -> list[int]:
    """Indices of the obstacles that came nearest, ascending, at most MAX_OBSTACLES.

    `measured` are clearances (vehicles, n, M) [m].
    """
    least = np.fmin.reduce(measured, axis=(0, 1))
    return sorted(np.argsort(least, kind="stable")[:MAX_OBSTACLES].tolist())


def _draw_clearances(axes: Axes, flights: Flights, lines: Array, label: str) -> None:
    axes.axhline(0.0, **LIMIT_LINE)
    for index, values in enumerate(lines):
        axes.plot(flights.records[0].time, values, **line_of(index))
    name_axis(axes, label)
    make_near_large(axes, flights.loaded.scenario.avoidance.safety_radius_m)


def draw_separation(figure: Figure, flights: Flights) -> None:
    """Distances between the vehicles, and the least distance that they have to keep."""
    avoidance = flights.loaded.scenario.avoidance
    keep = 2.0 * avoidance.safety_radius_m
    lines, legend = _pairs(flights)
    if avoidance.between_vehicles:
        legend = [*legend, Line2D([], [], **LIMIT_LINE, label=f"To keep: {keep:g} m")]
    (axes,) = lay_out(figure, "Distance between vehicles", 1, legend, TALL)
    if avoidance.between_vehicles:
        axes.axhline(keep, **LIMIT_LINE)
    for values, look in lines:
        axes.plot(flights.records[0].time, values, **look)
    name_axis(axes, "Distance [m]")
    axes.set_ylim(bottom=0.0)
    make_near_large(axes, keep)


def _pairs(flights: Flights) -> tuple[Sequence[tuple[Array, Any]], Sequence[Line2D]]:
    """Distances of all pairs with the styles of their lines, and the legend.

    Of more than MAX_PAIRS, only the least distance at each time has a line of its own style.
    """
    pairs = list(combinations(flights.records, 2))
    apart = [np.linalg.norm(one.p_n - other.p_n, axis=1) for one, other in pairs]
    if len(pairs) > MAX_PAIRS:
        looks = {"Each pair": _PAIR, "Nearest pair": line_of(0)}
        lines = [*((values, _PAIR) for values in apart), (np.fmin.reduce(apart), line_of(0))]
    else:
        names = [f"{one.vehicle.id} and {other.vehicle.id}" for one, other in pairs]
        looks = {name: line_of(index) for index, name in enumerate(names)}
        lines = list(zip(apart, looks.values(), strict=True))
    return lines, [Line2D([], [], **look, label=name) for name, look in looks.items()]
