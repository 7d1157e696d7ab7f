"""Body rates that lead to no bank and no load factor outside their limits, also in gusts.

The attitude that flies a path knows nothing of the gust that bends it: a push in air that stops
rising takes the wing through zero lift. A gust that is faster than the body turns is felt all the
same.
"""

import math

from vfguide.aircraft.coordinated_turn import angle_of_attack
from vfguide.aircraft.performance import Performance
from vfguide.geometry.compiled import compiled
from vfguide.geometry.units import G0
from vfguide.geometry.vector import Mat3, Vec3

LOAD_TIME = 0.3
"""A load factor outside the limits is taken back in this time [s]."""
OUTSIDE = 1.0
"""A load factor farther outside than this counts as so far outside: the air meets the wing from
behind, as in a tumble."""
SPARE = 0.3
"""So much above the least load factor, but not above halfway to 1, nothing is pushed any more: the
next gust takes the rest."""
STRONGER = 1.2
"""A gust in a turn may pull more than the turn is planned with, by this factor."""
BANK_TIME = 0.3
"""The bank comes no nearer to its limit than would take it there in this time [s], ..."""
BANK_OVER = 0.035
"""... and the limit is so much beyond the largest that is asked for [rad]."""


@compiled
def load_of(R: Mat3, air: Vec3, speed: float, aircraft: Performance) -> float:
    """Load factor: the lift at the angle at which the air meets the wing, over the weight.

    Args:
        R: attitude, body to NED.
        air: velocity through the air, NED [m/s].
        speed: true airspeed [m/s].
        aircraft: its lift.
    """
    alpha = angle_of_attack(R, air) - aircraft.alpha_zero
    return alpha * speed * speed / aircraft.alpha_load


@compiled
def within_envelope(
    omega: Vec3, R: Mat3, load: float, speed: float, bank_max: float, aircraft: Performance
) -> Vec3:
    """Body rates [rad/s] that lead to no bank and no load factor outside the limits.

    At a steady load factor n the nose follows the path, q = g (n - cos pitch cos bank) / V; a
    load that is outside is taken back in LOAD_TIME by a change of the angle of attack. In a steep
    bank the least load asks for no pull.

    Args:
        omega: wanted.
        R: attitude, body to NED.
        load: load factor now.
        speed: true airspeed [m/s].
        bank_max: largest bank that is asked for [rad].
        aircraft: its limits.
    """
    upright, bank = R[2][2], math.atan2(R[2][1], R[2][2])
    steady, back = G0 / speed, aircraft.alpha_load / (speed * speed * LOAD_TIME)
    least = aircraft.load_min + min(SPARE, 0.5 * (1.0 - aircraft.load_min))
    most = STRONGER * aircraft.load_max
    load = max(least - OUTSIDE, min(most + OUTSIDE, load))
    down = min(least - upright, 0.0) * steady + (least - load) * back
    up = (most - upright) * steady + (most - load) * back
    limit = bank_max + BANK_OVER
    left, right = (-limit - bank) / BANK_TIME, (limit - bank) / BANK_TIME
    return max(left, min(right, omega[0])), max(down, min(up, omega[1])), omega[2]
