"""Excess wind: about as fast as the aircraft flies, so that it holds against the wind.

No course can be made good in such a wind. The hold is flown in a frame that drifts with the air,
where flying backwards over ground reverses nothing: level, at the airspeed, the nose into the wind.

The problem is that of T. Stastny and R. Siegwart, On Flying Backwards: Preventing Run-away of
Small, Low-speed, Fixed-wing UAVs in Strong Winds, IROS 2019.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.state import FlightState
from vfguide.geometry.vector import sub
from vfguide.geometry.velocity import horizontal_norm
from vfguide.kernels.compiled import compiled
from vfguide.planning.objective import GuidanceTarget

EXCESS_RATIO = 0.95
"""Ratio of the wind to the airspeed above which a wind hold starts, and the largest sine of the
crab angle, that of 72 degrees; chosen below 1, where the rate of the azimuth has no bound."""
RELEASE_RATIO = 0.85
"""Ratio of the wind to the airspeed below which a wind hold ends; chosen as hysteresis."""
WIND_SMOOTHING_TIME = 3.0
"""Time constant with which that ratio is smoothed [s]; chosen, so that a gust starts no hold."""
STRAIGHT_RADIUS = 1e5
"""Radius of the circle that stands for a straight line [m]; chosen."""


class WindHold(NamedTuple):
    """State of the wind hold."""

    ratio: float
    """Ratio of wind to airspeed, smoothed; negative before the first step."""
    holds: bool
    """Whether the vehicle holds."""
    down: float
    """Height that is held, z of NED [m]."""


@compiled
def fresh_wind_hold() -> WindHold:
    """The wind hold before the first step."""
    return WindHold(-1.0, False, 0.0)


@compiled
def update_wind_hold(
    wind_hold: WindHold, state: FlightState, airspeed: float, dt: float
) -> WindHold:
    """The wind hold `dt` [s] later; `airspeed` is the one to fly [m/s]."""
    now = horizontal_norm(state.wind_n) / airspeed
    ratio = (
        now
        if wind_hold.ratio < 0.0
        else wind_hold.ratio + min(dt / WIND_SMOOTHING_TIME, 1.0) * (now - wind_hold.ratio)
    )
    if wind_hold.holds:
        return WindHold(ratio, ratio > RELEASE_RATIO, wind_hold.down)
    return WindHold(ratio, ratio > EXCESS_RATIO, state.p_n[2])


@compiled
def in_air_frame(state: FlightState) -> FlightState:
    """The state in a frame that drifts with the wind."""
    v_n = sub(state.v_n, state.wind_n)
    return FlightState(state.time, state.p_n, v_n, state.R_nb, state.airspeed, (0.0, 0.0, 0.0))


@compiled
def into_wind(wind_hold: WindHold, state: FlightState) -> GuidanceTarget:
    """The target of a hold: a line from here against the wind, at the height that is held."""
    course = math.atan2(-state.wind_n[1], -state.wind_n[0])
    here = (state.p_n[0], state.p_n[1], wind_hold.down)
    return GuidanceTarget(here, course, 0.0, 1.0, STRAIGHT_RADIUS)
