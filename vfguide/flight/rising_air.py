"""Air that rises or sinks, from the lift that is felt.

No autopilot tells the vertical wind. The lift tells the angle at which the air meets the wing; the
attitude and the velocity tell at which it would, were the air level. A gust is the difference: it
shows before the path bends.
"""

import math

from vfguide.flight.air_state import RISE, AirState
from vfguide.flight.performance import Performance
from vfguide.geometry.compiled import compiled
from vfguide.geometry.units import G0
from vfguide.geometry.vector import Mat3, Vec3, dot

RISE_TIME = 0.15
"""It is smoothed over this time [s]."""
STEEPEST_AIR = 0.2
"""The air rises or sinks no faster than this times the airspeed."""


@compiled
def feel_rise(
    air: AirState,
    force_n: Vec3,
    v_air_n: Vec3,
    R_nb: Mat3,
    airspeed: float,
    aircraft: Performance,
    dt: float,
) -> None:
    """How fast the air rises, from the specific force `force_n` [m/s^2].

    Args:
        air: what is believed; its RISE goes on by `dt` [s].
        force_n: v' - g, NED.
        v_air_n: velocity through air that does not rise, NED [m/s].
        R_nb: attitude.
        airspeed: true [m/s].
        aircraft: its lift.
        dt: time since the last step [s].
    """
    x_n, z_n = (R_nb[0][0], R_nb[1][0], R_nb[2][0]), (R_nb[0][2], R_nb[1][2], R_nb[2][2])
    speed = max(airspeed, 0.5 * aircraft.airspeed_min)
    load = -dot(force_n, z_n) / G0
    alpha = aircraft.alpha_zero + aircraft.alpha_load * load / (speed * speed)
    gust = alpha - math.atan2(dot(v_air_n, z_n), dot(v_air_n, x_n))
    if math.isfinite(gust):
        rise = speed * z_n[2] * max(-STEEPEST_AIR, min(STEEPEST_AIR, gust))
        air[RISE] += dt / (RISE_TIME + dt) * (rise - air[RISE])
