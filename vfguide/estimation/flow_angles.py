"""Angles at which the air meets the aircraft, by roll, pitch and body rates alone, without gusts.

The wing carries the weight along a path that follows the nose, and an aircraft that is banked
without being yawed slips. At small angles, with lift and side force in proportion to them (Stevens
and Lewis, Aircraft Control and Simulation, section 2.5):

    alpha' = q - p tan(beta) + g (cos pitch cos bank - n) / V
    beta'  = p alpha - r + g (cos pitch sin bank) / V - beta / T

Neither yaw, ground velocity nor wind enters. Where one of them is wrong and yaws the aircraft out
of its path, these angles show it; the air velocity that is made of the three does not.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.flight_model import side_force_slope
from vfguide.aircraft.performance import Performance, alpha_of_load
from vfguide.geometry.units import DEG, G0
from vfguide.geometry.vector import Mat3, Vec3
from vfguide.kernels.compiled import compiled

LARGEST_FLOW_ANGLE = 60.0 * DEG
"""Largest angle that is followed [rad]; chosen, since the tangent grows without bound."""
LONGEST_FLOW_GAP = 1.0
"""Longest time between two measurements through which the rates of the later one are taken as
constant [s]; chosen above the time constant of the angle of attack."""
FLOW_SUBSTEP = 0.05
"""Longest time for which one of the two angles is constant while the other one follows [s]; chosen
below the time constant of the angle of attack."""


class FlowAngles(NamedTuple):
    """The direction of the air against the fuselage."""

    alpha: float
    """Angle of attack [rad]."""
    beta: float
    """Sideslip [rad], positive with the air from the right."""


@compiled
def fresh_flow() -> FlowAngles:
    """The angles before the first measurement."""
    return FlowAngles(0.0, 0.0)


@compiled
def follow_flow(
    s: FlowAngles, R_nb: Mat3, omega_b: Vec3, airspeed: float, aircraft: Performance, elapsed: float
) -> FlowAngles:
    """The angles `elapsed` seconds later.

    Args:
        s: the angles at the step before.
        R_nb: attitude, body FRD to NED; its yaw does not matter.
        omega_b: measured body rates, FRD [rad/s].
        airspeed: true airspeed [m/s], taken within the limits of the aircraft.
        aircraft: its lift.
        elapsed: time since the step before [s].
    """
    speed = max(aircraft.airspeed_min, min(aircraft.airspeed_max, airspeed))
    turn = G0 / speed
    alpha_rate = turn * speed * speed / aircraft.alpha_load
    beta_rate = side_force_slope(speed, aircraft) / speed
    (p, q, r), (_, right, down) = omega_b, R_nb[2]
    alpha, beta = s
    left = min(elapsed, LONGEST_FLOW_GAP)
    while left > 0.0:
        dt = min(left, FLOW_SUBSTEP)
        steady = alpha_of_load(down + (q - p * math.tan(beta)) / turn, speed, aircraft)
        level = (p * alpha - r + turn * right) / beta_rate
        alpha = bounded(steady + (alpha - steady) * math.exp(-alpha_rate * dt))
        beta = bounded(level + (beta - level) * math.exp(-beta_rate * dt))
        left -= dt
    return FlowAngles(alpha, beta)


@compiled
def bounded(angle: float) -> float:
    """An angle within LARGEST_FLOW_ANGLE [rad]."""
    return max(-LARGEST_FLOW_ANGLE, min(LARGEST_FLOW_ANGLE, angle))
