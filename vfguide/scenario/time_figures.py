"""Figures over time: position, attitude, flight envelope, body rates."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from vfguide.geometry.units import DEG
from vfguide.scenario.drawing import COLUMNS, GOAL, MUTED, Flights, broken, line_of, vehicle_lines
from vfguide.scenario.record import Array, FlightRecord

_LIMIT: dict[str, Any] = {"color": MUTED, "linestyle": (0, (4, 3)), "linewidth": 1.2}
_WANTED: dict[str, Any] = {"color": GOAL, "linewidth": 0.9}


@dataclass(frozen=True)
class Panel:
    """One pair of axes: what is drawn over time, and the limits it should keep."""

    label: str
    values: Callable[[FlightRecord], Array]
    limits: Sequence[float] = ()
    wanted: Callable[[FlightRecord], Array] | None = None
    """What was commanded, drawn beside what was flown."""


def draw_position(figure: Figure, flights: Flights) -> None:
    """North, east and height of the origin, with the goals where they were reached."""
    panels = [
        Panel("North [m]", lambda its: its.p_n[:, 0]),
        Panel("East [m]", lambda its: its.p_n[:, 1]),
        Panel("Above the origin [m]", lambda its: -its.p_n[:, 2]),
    ]
    mark = Line2D([], [], color=GOAL, marker="D", linestyle="none", markersize=5, label="Goal")
    grid = _draw(figure, flights, "Position", panels, [mark])
    for record in flights.records:
        for goal, best in zip(record.vehicle.goals, record.legs().best(), strict=True):
            if best is None or not best.reaches:
                continue
            north, east, down = goal.position_m
            for axes, value in zip(grid, (north, east, -down), strict=True):
                axes.plot(best.time, value, "D", color=GOAL, markersize=5, zorder=5)


def draw_attitude(figure: Figure, flights: Flights) -> None:
    """Roll, pitch and yaw."""
    panels = [
        Panel("Roll [°]", lambda its: broken(its.euler[:, 0] / DEG)),
        Panel("Pitch [°]", lambda its: its.euler[:, 1] / DEG),
        Panel("Yaw [°]", lambda its: broken(its.euler[:, 2] / DEG % 360.0)),
    ]
    _draw(figure, flights, "Attitude (Euler angles)", panels, [])


def draw_envelope(figure: Figure, flights: Flights) -> None:
    """Airspeed, bank, load factor and thrust, with the limits of the aircraft."""
    loaded = flights.loaded
    first = flights.records[0].vehicle
    its = loaded.performance(first)
    same = len(loaded.aircraft) == 1
    bank = loaded.gains(first).bank_max / DEG
    panels = [
        Panel(
            "True airspeed [m/s]",
            lambda record: record.airspeed,
            (its.airspeed_min, its.airspeed_max) if same else (),
        ),
        Panel(
            "Bank [°]",
            lambda record: np.abs(record.euler[:, 0]) / DEG,
            (bank,) if same else (),
        ),
        Panel(
            "Load factor",
            lambda record: record.load_factor,
            (its.load_min, its.load_max) if same else (),
        ),
        Panel("Thrust setpoint", lambda record: record.thrust, (0.0, 1.0)),
    ]
    _draw(figure, flights, "Flight envelope", panels, [Line2D([], [], **_LIMIT, label="Limit")])


def draw_rates(figure: Figure, flights: Flights) -> None:
    """Body rates, commanded and flown."""
    panels = [
        Panel(
            label,
            lambda its, axis=axis: its.omega_b[:, axis] / DEG,
            wanted=lambda its, axis=axis: its.omega_wanted_b[:, axis] / DEG,
        )
        for axis, label in enumerate(
            ("Roll rate p [°/s]", "Pitch rate q [°/s]", "Yaw rate r [°/s]")
        )
    ]
    flown = [] if flights.several else [Line2D([], [], **line_of(0), label="Flown")]
    wanted = Line2D([], [], **_WANTED, label="Commanded")
    _draw(figure, flights, "Body rates", panels, [*flown, wanted])


def _draw(
    figure: Figure, flights: Flights, title: str, panels: Sequence[Panel], marks: Sequence[Line2D]
) -> Sequence[Axes]:
    """Panels under each other over one time axis, and the legend with `marks` below."""
    legend = [*(vehicle_lines(flights) if flights.several else ()), *marks]
    bottom = 0.55 + 0.24 * math.ceil(len(legend) / COLUMNS)
    height = 0.4 + 1.75 * len(panels) + bottom
    figure.set_size_inches(8.6, height)
    figure.subplots_adjust(0.1, bottom / height, 0.97, 1.0 - 0.4 / height, hspace=0.13)
    grid: Sequence[Axes] = figure.subplots(len(panels), 1, sharex=True)
    for axes, panel in zip(grid, panels, strict=True):
        _draw_panel(axes, panel, flights)
    grid[0].set_title(title)
    grid[-1].set_xlabel("Time [s]")
    if legend:
        figure.legend(handles=legend, loc="lower center", ncols=min(len(legend), COLUMNS))
    return grid


def _draw_panel(axes: Axes, panel: Panel, flights: Flights) -> None:
    for limit in panel.limits:
        axes.axhline(limit, **_LIMIT)
    for index, record in enumerate(flights.records):
        axes.plot(record.time, panel.values(record), **line_of(index))
        if panel.wanted is not None:
            axes.plot(record.time, panel.wanted(record), **_WANTED)
    axes.set_ylabel(panel.label)
    axes.yaxis.set_label_coords(-0.075, 0.5)
    axes.margins(x=0.01, y=0.12)
