"""Coasting: body rates for the time in which no attitude arrives but the autopilot still follows.

A body rate that is held keeps rolling the aircraft. So when attitudes stop arriving, one more
setpoint is sent, which flies a coordinated turn at the bank that is reached by then.
"""

from vfguide.aircraft.coordinated_turn import turn_rate
from vfguide.geometry.so3 import Quaternion, bank_angle, exp, from_quaternion, to_quaternion
from vfguide.geometry.vector import Vec3, add, matmul, scale
from vfguide.kernels.compiled import compiled

LEVELLING_TIME = 1.0
"""Time in which a bank beyond the largest is taken back [s]; chosen as the time after which
autopilots fly on by themselves."""


@compiled
def coast(
    q_nb: Quaternion, omega_b: Vec3, age: float, airspeed: float, bank_max: float
) -> tuple[Vec3, Quaternion]:
    """Body rates of a level coordinated turn, and the attitude in which it begins.

    The turn rate g tan(bank) / V about the vertical, in body axes (Beard and McLain, Small Unmanned
    Aircraft, 2012, chapter 5).

    Args:
        q_nb: the last attitude received, w, x, y, z, body FRD to NED.
        omega_b: body rates that have been flown since then, FRD [rad/s].
        age: time since then [s].
        airspeed: true airspeed [m/s].
        bank_max: largest bank [rad].
    """
    R_nb = matmul(from_quaternion(q_nb), exp(scale(age, omega_b)))
    bank, down_b = bank_angle(R_nb), R_nb[2]
    kept = max(-bank_max, min(bank_max, bank))
    turn = scale(turn_rate(kept, airspeed), down_b)
    return add(turn, ((kept - bank) / LEVELLING_TIME, 0.0, 0.0)), to_quaternion(R_nb)
