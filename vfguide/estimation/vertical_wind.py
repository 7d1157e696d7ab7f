"""Vertical wind, estimated from the lift.

No autopilot reports the vertical wind. The specific force gives the angle of attack; attitude and
velocity give the angle of attack in level air. Their difference times the airspeed is the vertical
wind, which is known in this way before the path bends.

Langelaan, Alley and Neidhoefer, Wind field estimation for small unmanned aerial vehicles, Journal
of Guidance, Control, and Dynamics 34 (4), 2011: gusts from the difference of motion over ground and
through the air.
"""

import math

from vfguide.aircraft.coordinated_turn import angle_of_attack
from vfguide.aircraft.flight_model import specific_force
from vfguide.aircraft.performance import Performance, alpha_of_load, nonzero_airspeed
from vfguide.aircraft.state import FlightState
from vfguide.estimation.air_state import AIRSPEED, EAST, NORTH, AirState, VerticalWind
from vfguide.geometry.blending import blended, low_pass_share
from vfguide.geometry.units import G0
from vfguide.geometry.vector import dot, sub
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import replacing

RISE_TIME = 0.15
"""Time constant with which the vertical wind is smoothed [s]; chosen short, since the path has to
be corrected before it bends."""
GUST_ANGLE_MAX = 0.3
"""Largest ratio of the vertical wind to the airspeed that is estimated; chosen."""
LONGEST_GAP = 0.5
"""Time between two steps after which the vertical wind starts anew [s]; chosen."""

with_vertical = replacing(AirState, "vertical")


@compiled
def feel_rise(measured: FlightState, air: AirState, aircraft: Performance) -> AirState:
    """The estimate of the air with the vertical wind of this step.

    Args:
        measured: the measured state, not the predicted one: a predicted turn of the fuselage that
            the velocity does not show yet would count as a gust.
        air: estimate of the step before.
        aircraft: its lift.
    """
    level_n = sub(measured.v_n, (air.estimate.x[NORTH], air.estimate.x[EAST], 0.0))
    alpha = angle_of_attack(measured.R_nb, level_n)
    rise = 0.0
    if air.time >= 0.0 and 0.0 < measured.time - air.time < LONGEST_GAP:
        rise = rise_by_lift(measured, alpha, air, aircraft)
    return with_vertical(air, VerticalWind(rise, measured.v_n, alpha))


@compiled
def rise_by_lift(
    measured: FlightState, alpha: float, air: AirState, aircraft: Performance
) -> float:
    """Vertical wind, up positive [m/s], smoothed; `alpha` is the one of level air [rad]."""
    before, dt, R = air.vertical, measured.time - air.time, measured.R_nb
    z_n = (R[0][2], R[1][2], R[2][2])
    halfway = 0.5 * (alpha + before.alpha)
    force_n = specific_force(before.v_n, measured.v_n, dt)
    speed = nonzero_airspeed(air.estimate.x[AIRSPEED], aircraft)
    load = -dot(force_n, z_n) / G0
    gust = alpha_of_load(load, speed, aircraft) - halfway
    if not math.isfinite(gust):
        return before.rise
    rise = speed * z_n[2] * max(-GUST_ANGLE_MAX, min(GUST_ANGLE_MAX, gust))
    return blended(before.rise, rise, low_pass_share(RISE_TIME, dt))
