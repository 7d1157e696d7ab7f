"""Coordinated turn: the lift that a turn takes, and the attitude that gives it.

Without sideslip the lift vector balances gravity and turns the velocity, psi' = g tan(bank) / V in
level flight (Beard and McLain, Small Unmanned Aircraft, 2012, chapter 5).
"""

import math
from typing import NamedTuple

from vfguide.geometry.so3 import body_rates, from_euler, rot_y
from vfguide.geometry.units import G0
from vfguide.geometry.vector import Mat3, Vec3, add, matmul, matvec, transpose
from vfguide.kernels.compiled import compiled


class Lift(NamedTuple):
    """The lift of a turn."""

    bank: float
    """Bank about the air velocity, right wing down positive [rad]."""
    load: float
    """Load factor: lift over weight."""


@compiled
def lift_for_turn(lateral: float, gamma: float, bank_max: float, load_max: float) -> Lift:
    """Bank and load factor for the lateral acceleration [m/s^2] at path angle `gamma`.

    The lift vector is the part of a_n - g across the air velocity. Height has priority: where the
    limits of bank [rad] and load factor forbid the whole turn, the lateral part is cut.
    """
    up = G0 * math.cos(gamma)
    most = min(up * math.tan(bank_max), math.sqrt(max((load_max * G0) ** 2 - up * up, 0.0)))
    right = max(-most, min(most, lateral))
    return Lift(math.atan2(right, up), math.hypot(up, right) / G0)


@compiled
def turn_rate(bank: float, airspeed: float) -> float:
    """Rate of the azimuth in a level turn, psi' = g tan(bank) / V [rad/s], V in [m/s]."""
    return G0 * math.tan(bank) / airspeed


@compiled
def angle_of_attack(R_nb: Mat3, air: Vec3) -> float:
    """Angle of attack atan2(w, u) [rad] of a velocity through the air, NED [m/s]."""
    u, _, w = matvec(transpose(R_nb), air)
    return math.atan2(w, u)


@compiled
def attitude_rate_for_lift(
    elevation: float, bank: float, alpha: float, euler_rates: Vec3, alpha_rate: float
) -> Vec3:
    """Body rates [rad/s] of `attitude_for_lift` as its angles change.

    Args:
        elevation: of the air velocity [rad].
        bank: about it [rad].
        alpha: angle of attack [rad].
        euler_rates: of bank, elevation and azimuth [rad/s].
        alpha_rate: of the angle of attack [rad/s].
    """
    about_velocity = body_rates(bank, elevation, euler_rates)
    return add(matvec(rot_y(-alpha), about_velocity), (0.0, alpha_rate, 0.0))


@compiled
def attitude_for_lift(azimuth: float, elevation: float, bank: float, alpha: float) -> Mat3:
    """R_nb for an air velocity along (azimuth, elevation), the bank about it, and alpha [rad]."""
    return matmul(from_euler(bank, elevation, azimuth), from_euler(0.0, alpha, 0.0))
