"""Envelope protection: body rates that keep bank, load and sideslip in limits, also in gusts.

The reference attitude does not take gusts into account: where rising air ends, the pitch down to it
would take the wing through zero lift. A gust faster than the pitch rate still exceeds the limits.

A wrong yaw, ground velocity or wind yaws the aircraft out of its path. The sideslip by attitude and
rates shows it (`vfguide.estimation.flow_angles`). It is limited, and so are both estimates of the
load factor, since a roll turns sideslip into angle of attack.
"""

from vfguide.aircraft.coordinated_turn import angle_of_attack
from vfguide.aircraft.flight_model import side_force_slope
from vfguide.aircraft.performance import Performance, load_of_alpha
from vfguide.estimation.flow_angles import FlowAngles
from vfguide.geometry.so3 import bank_angle
from vfguide.geometry.units import DEG, G0
from vfguide.geometry.vector import Mat3, Vec3
from vfguide.kernels.compiled import compiled

LOAD_TIME = 0.3
"""Time in which a load factor outside its limits is taken back [s]; chosen with
`tools/measure_poses.py` in turbulence."""
MAX_LOAD_EXCESS = 1.0
"""Largest excess of the load factor over its limit, as a number of g, that is answered; chosen,
since beyond it the air meets the wing from behind, as in a tumble."""
LOAD_RESERVE = 0.3
"""Load factor above the least one, dimensionless and at most half of the distance to 1, below which
the nose is not pushed down any more; chosen, since the next gust takes the rest."""
GUST_LOAD_RATIO = 1.2
"""Ratio of the load factor that a gust in a turn may reach to the largest with which turns are
planned; chosen."""
BANK_TIME = 0.3
"""Least time in which the roll rate may take the bank to its limit [s]; chosen with
`tools/measure_poses.py` in turbulence."""
BANK_OVERSHOOT = 0.035
"""Limit of the bank beyond the largest that is commanded [rad], two degrees; tuned: with one degree
less, loiters and escapes were flown worse."""

SIDESLIP_MAX = 8.0 * DEG
"""Largest sideslip by attitude and rates that yaw rates lead to [rad]; chosen with
`tools/measure_lies.py` above what honest flight in calm air needs."""
SIDESLIP_TIME = 0.3
"""Least time in which the yaw rate may take the sideslip to its limit [s]; chosen, `BANK_TIME`."""


@compiled
def load_of(R: Mat3, air: Vec3, speed: float, aircraft: Performance) -> float:
    """Load factor: the lift at the angle at which the air meets the wing, over the weight.

    Args:
        R: attitude, body to NED.
        air: velocity through the air, NED [m/s].
        speed: true airspeed [m/s].
        aircraft: its lift.
    """
    return load_of_alpha(angle_of_attack(R, air), speed, aircraft)


@compiled
def within_envelope(
    omega: Vec3,
    R: Mat3,
    load: float,
    flow: FlowAngles,
    speed: float,
    bank_max: float,
    aircraft: Performance,
) -> Vec3:
    """Body rates [rad/s] that lead to no bank, load factor or sideslip outside the limits.

    At a steady load factor n the nose follows the path, q = g (n - cos pitch cos bank) / V; a
    load factor that is outside is taken back in LOAD_TIME by a change of the angle of attack. In a
    steep bank the least load factor asks for no pull. Where one load factor is too small and the
    other too large, the rate is halfway between what they ask for.

    Args:
        omega: wanted.
        R: attitude, body to NED.
        load: load factor now, by the velocity through the air.
        flow: angle of attack and sideslip now, by attitude and rates.
        speed: true airspeed [m/s].
        bank_max: largest bank that is asked for [rad].
        aircraft: its limits.
    """
    upright, bank = R[2][2], bank_angle(R)
    steady, back = G0 / speed, aircraft.alpha_load / (speed * speed * LOAD_TIME)
    least = aircraft.load_min + min(LOAD_RESERVE, 0.5 * (1.0 - aircraft.load_min))
    most = GUST_LOAD_RATIO * aircraft.load_max
    load = answered(load, least, most)
    by_flow = answered(load_of_alpha(flow.alpha, speed, aircraft), least, most)
    low, high = min(load, by_flow), max(load, by_flow)
    down = min(least - upright, 0.0) * steady + (least - low) * back
    up = (most - upright) * steady + (most - high) * back
    between = 0.5 * (down + up)
    down, up = min(down, between), max(up, between)
    limit = bank_max + BANK_OVERSHOOT
    left, right = (-limit - bank) / BANK_TIME, (limit - bank) / BANK_TIME
    p = max(left, min(right, omega[0]))
    return p, max(down, min(up, omega[1])), within_sideslip(omega[2], p, R, flow, speed, aircraft)


@compiled
def answered(load: float, least: float, most: float) -> float:
    """A load factor, at most MAX_LOAD_EXCESS outside its least and largest one."""
    return max(least - MAX_LOAD_EXCESS, min(most + MAX_LOAD_EXCESS, load))


@compiled
def within_sideslip(
    r: float, p: float, R: Mat3, flow: FlowAngles, speed: float, aircraft: Performance
) -> float:
    """Yaw rate [rad/s] that leads to no sideslip outside SIDESLIP_MAX.

    Args:
        r: wanted [rad/s].
        p: roll rate [rad/s].
        R: attitude, body to NED.
        flow: angle of attack and sideslip now, by attitude and rates.
        speed: true airspeed [m/s].
        aircraft: its lift.
    """
    force = G0 * R[2][1] - side_force_slope(speed, aircraft) * flow.beta
    steady = p * flow.alpha + force / speed
    least = steady - (SIDESLIP_MAX - flow.beta) / SIDESLIP_TIME
    most = steady + (SIDESLIP_MAX + flow.beta) / SIDESLIP_TIME
    return max(least, min(most, r))
