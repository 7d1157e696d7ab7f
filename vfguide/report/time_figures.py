"""Figures over time: position, attitude, speed, flight envelope, body rates, air."""

from collections.abc import Callable

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Series
from vfguide.report.drawing import GOAL_COLOUR, Flights, broken, line_of
from vfguide.report.panels import LIMIT_LINE, WANTED_LINE, Panel, draw_panels
from vfguide.results.record import AirBelief, FlightRecord


def draw_position(figure: Figure, flights: Flights) -> None:
    """Draw the position north, east and above the origin, with each goal when it was reached."""
    panels = [
        Panel("North [m]", lambda each: each.p_n[:, 0], span=5.0),
        Panel("East [m]", lambda each: each.p_n[:, 1], span=5.0),
        Panel("Above the origin [m]", lambda each: -each.p_n[:, 2], span=5.0),
    ]
    mark = Line2D(
        [], [], color=GOAL_COLOUR, marker="D", linestyle="none", markersize=5, label="Goal"
    )
    grid = draw_panels(figure, flights, "Position", panels, [mark])
    for record in flights.records:
        for goal, best in zip(record.vehicle.goals, record.legs().best(), strict=True):
            if best is None or not best.reaches:
                continue
            north, east, down = goal.position_m
            for axes, value in zip(grid, (north, east, -down), strict=True):
                axes.plot(best.time, value, "D", color=GOAL_COLOUR, markersize=5, zorder=5)


def draw_attitude(figure: Figure, flights: Flights) -> None:
    """Draw roll, pitch and yaw of the body against NED."""
    panels = [
        Panel("Roll [°]", lambda each: broken(each.euler[:, 0] / DEG)),
        Panel("Pitch [°]", lambda each: each.euler[:, 1] / DEG, span=10.0),
        Panel("Yaw [°]", lambda each: broken(each.euler[:, 2] / DEG % 360.0), around=True),
    ]
    draw_panels(figure, flights, "Attitude (Euler angles)", panels, [])


def draw_envelope(figure: Figure, flights: Flights) -> None:
    """Draw airspeed, bank, load factor and thrust, with their limits.

    Limits are those of the first vehicle; those of the aircraft are left out where there are
    several.
    """
    loaded = flights.loaded
    first = flights.records[0].vehicle
    each = loaded.performance_aloft(first)
    same = len(loaded.aircraft) == 1
    bank = loaded.gains(first).bank_max / DEG
    panels = [
        Panel(
            "True airspeed [m/s]",
            lambda record: record.airspeed,
            (each.airspeed_min, each.airspeed_max) if same else (),
        ),
        Panel(
            "Bank [°]",
            lambda record: np.abs(record.euler[:, 0]) / DEG,
            (bank,) if same else (),
        ),
        Panel(
            "Load factor",
            lambda record: record.load_factor,
            (each.load_min, each.load_max) if same else (),
        ),
        Panel("Thrust setpoint", lambda record: record.thrust, (0.0, 1.0)),
    ]
    draw_panels(
        figure, flights, "Flight envelope", panels, [Line2D([], [], **LIMIT_LINE, label="Limit")]
    )


def draw_speed(figure: Figure, flights: Flights) -> None:
    """Draw the speed of vehicles that do not fly through air."""
    panel = Panel("Speed [m/s]", lambda each: np.linalg.norm(each.v_n, axis=1))
    draw_panels(figure, flights, "Speed", [panel], [])


def draw_rates(figure: Figure, flights: Flights) -> None:
    """Draw body rates, commanded and flown; those of a rigid body are the same."""
    panels = [
        Panel(
            label,
            lambda each, axis=axis: each.omega_b[:, axis] / DEG,
            wanted=None
            if flights.kinematic
            else lambda each, axis=axis: each.omega_wanted_b[:, axis] / DEG,
        )
        for axis, label in enumerate(
            ("Roll rate p [°/s]", "Pitch rate q [°/s]", "Yaw rate r [°/s]")
        )
    ]
    flown = [] if flights.several else [Line2D([], [], **line_of(0), label="Flown")]
    wanted = Line2D([], [], **WANTED_LINE, label="Commanded")
    draw_panels(
        figure, flights, "Body rates", panels, [] if flights.kinematic else [*flown, wanted]
    )


def draw_air(figure: Figure, flights: Flights) -> None:
    """Draw wind and true airspeed, true and as the companion estimates them."""
    panels = [
        Panel(
            "Wind to north [m/s]",
            lambda each: each.wind_n[:, 0],
            wanted=lambda each: believed(each, lambda air: (air.wind_north, air.wind_sigma)),
            span=2.0,
        ),
        Panel(
            "Wind to east [m/s]",
            lambda each: each.wind_n[:, 1],
            wanted=lambda each: believed(each, lambda air: (air.wind_east, air.wind_sigma)),
            span=2.0,
        ),
        Panel(
            "True airspeed [m/s]",
            lambda each: each.airspeed,
            wanted=lambda each: believed(each, lambda air: (air.airspeed, air.airspeed_sigma)),
            span=2.0,
        ),
    ]
    true = [] if flights.several else [Line2D([], [], **line_of(0), label="True, with gusts")]
    estimated = Line2D([], [], **WANTED_LINE, label="Estimated by the companion")
    draw_panels(figure, flights, "Air: true and estimated", panels, [*true, estimated])


def believed(record: FlightRecord, part: Callable[[AirBelief], tuple[Series, Series]]) -> Series:
    """An estimate at each sample, (n,); NaN where the companion has made none yet.

    `part` takes the estimate and its standard deviation out of the record.
    """
    if record.air is None:
        return np.full_like(record.time, np.nan)
    values, sigma = part(record.air)
    return np.where(sigma > 0.0, values, np.nan)
