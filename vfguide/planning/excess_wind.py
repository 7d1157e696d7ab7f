"""Wind about as fast as the aircraft flies: no course can be promised, so it holds against it.

The hold is flown in the frame of the air: there the wind is still, and going backwards over
ground turns nothing round. The aircraft points into the wind, level, at its airspeed.

T. Stastny and R. Siegwart, On Flying Backwards: Preventing Run-away of Small, Low-speed, Fixed-wing
UAVs in Strong Winds, IROS 2019, is where the problem is treated first.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.state import FlightState
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import sub
from vfguide.planning.objective import GuidanceTarget

TOO_STRONG = 0.95
"""A goal is given up while the wind is above this part of the airspeed, ..."""
WEAK_AGAIN = 0.85
"""... until it is below this."""
WIND_SMOOTHING_TIME = 3.0
"""The ratio of the two is smoothed over this time, so that a gust changes nothing [s]."""
STRAIGHT = 1e5
"""Radius of the circle that is flown as a straight line [m]."""


class WindHold(NamedTuple):
    """Memory of the hold against the wind."""

    ratio: float
    """Wind over airspeed, smoothed; negative before the first step."""
    holds: bool
    down: float
    """Height that is held, NED [m]."""


@compiled
def fresh_wind_hold() -> WindHold:
    """Nothing is known of the wind yet."""
    return WindHold(-1.0, False, 0.0)


@compiled
def update_wind_hold(
    wind_hold: WindHold, state: FlightState, airspeed: float, dt: float
) -> WindHold:
    """Whether to hold now; `airspeed` is what is flown to [m/s], `dt` the time step [s]."""
    now = math.hypot(state.wind_n[0], state.wind_n[1]) / airspeed
    ratio = (
        now
        if wind_hold.ratio < 0.0
        else wind_hold.ratio + min(dt / WIND_SMOOTHING_TIME, 1.0) * (now - wind_hold.ratio)
    )
    if wind_hold.holds:
        return WindHold(ratio, ratio > WEAK_AGAIN, wind_hold.down)
    return WindHold(ratio, ratio > TOO_STRONG, state.p_n[2])


@compiled
def in_air_frame(state: FlightState) -> FlightState:
    """The state in a frame that drifts with the wind."""
    v_n = sub(state.v_n, state.wind_n)
    return FlightState(state.time, state.p_n, v_n, state.R_nb, state.airspeed, (0.0, 0.0, 0.0))


@compiled
def into_wind(wind_hold: WindHold, state: FlightState) -> GuidanceTarget:
    """The line from here against the wind, at the height that is held."""
    course = math.atan2(-state.wind_n[1], -state.wind_n[0])
    here = (state.p_n[0], state.p_n[1], wind_hold.down)
    return GuidanceTarget(here, course, 0.0, 1.0, STRAIGHT)
