"""Air that rises or sinks, from the lift that is felt.

No autopilot tells the vertical wind. The lift tells the angle at which the air meets the wing; the
attitude and the velocity tell at which it would, were the air level. A gust is the difference: it
shows before the path bends.
"""

import math

from vfguide.flight.air_state import (
    AIRSPEED,
    EAST,
    NORTH,
    RISE,
    TIME,
    TOLD_BEFORE,
    AirState,
    X,
)
from vfguide.flight.attitude import angle_of_attack
from vfguide.flight.performance import Performance
from vfguide.flight.state import FlightState
from vfguide.geometry.compiled import compiled
from vfguide.geometry.units import G0
from vfguide.geometry.vector import dot, scale, sub

RISE_TIME = 0.15
"""It is smoothed over this time [s]."""
STEEPEST_AIR = 0.3
"""The air rises or sinks no faster than this times the airspeed."""


LONGEST = 0.5
"""After a pause longer than this it begins anew [s]."""


@compiled
def feel_rise(told: FlightState, air: AirState, aircraft: Performance) -> None:
    """How fast the air rises, from the lift since the last step; fills `air`.

    Args:
        told: what the autopilot told, not predicted: a turn of the fuselage that the velocity does
            not show yet would count as a gust.
        air: what is believed since the last step.
        aircraft: its lift.
    """
    dt, R = told.time - air[TIME], told.R_nb
    z_n = (R[0][2], R[1][2], R[2][2])
    level_n = sub(told.v_n, (air[X + NORTH], air[X + EAST], 0.0))
    angle = angle_of_attack(R, level_n)
    before = (air[TOLD_BEFORE], air[TOLD_BEFORE + 1], air[TOLD_BEFORE + 2])
    halfway = 0.5 * (angle + air[TOLD_BEFORE + 3])
    for k in range(3):
        air[TOLD_BEFORE + k] = told.v_n[k]
    air[TOLD_BEFORE + 3] = angle
    if air[TIME] < 0.0 or not 0.0 < dt < LONGEST:
        air[RISE] = 0.0
        return
    force_n = sub(scale(1.0 / dt, sub(told.v_n, before)), (0.0, 0.0, G0))
    speed = max(air[X + AIRSPEED], 0.5 * aircraft.airspeed_min)
    load = -dot(force_n, z_n) / G0
    gust = aircraft.alpha_zero + aircraft.alpha_load * load / (speed * speed) - halfway
    if math.isfinite(gust):
        rise = speed * z_n[2] * max(-STEEPEST_AIR, min(STEEPEST_AIR, gust))
        air[RISE] += dt / (RISE_TIME + dt) * (rise - air[RISE])
