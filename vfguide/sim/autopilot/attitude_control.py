"""Attitude control of the software autopilot: roll and pitch to body rates, as PX4 flies them.

Roll and pitch errors decay with a time constant of their own; the yaw rate is that of a coordinated
turn at the present bank. Beard and McLain, *Small Unmanned Aircraft*, 2012, chapters 3 and 9.
Nothing here is shared with the companion's control, nor with the rate law of the field.
"""

import math

from vfguide.aircraft.performance import Performance
from vfguide.geometry.angles import wrap
from vfguide.geometry.so3 import from_quaternion, to_euler
from vfguide.geometry.units import DEG, G0
from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled
from vfguide.link.enums import AttitudeTypeMask
from vfguide.link.messages import SetAttitudeTarget

ATTITUDE_IGNORE = int(AttitudeTypeMask.ATTITUDE_IGNORE)
"""Type mask flag of an ignored attitude as a plain integer: a flag of an enumeration costs a
microsecond."""
THROTTLE_IGNORE = int(AttitudeTypeMask.THROTTLE_IGNORE)
"""Type mask flag of an ignored thrust as a plain integer."""
ROLL_RATE_IGNORE = int(AttitudeTypeMask.BODY_ROLL_RATE_IGNORE)
"""Type mask flag of an ignored roll rate as a plain integer."""
PITCH_RATE_IGNORE = int(AttitudeTypeMask.BODY_PITCH_RATE_IGNORE)
"""Type mask flag of an ignored pitch rate as a plain integer."""
YAW_RATE_IGNORE = int(AttitudeTypeMask.BODY_YAW_RATE_IGNORE)
"""Type mask flag of an ignored yaw rate as a plain integer."""
ATTITUDE_GAIN = 2.5
"""Rate at which errors of roll and pitch decay [1/s]: 1 / FW_R_TC and 1 / FW_P_TC, PX4's defaults
of 0.4 s."""
TURN_BANK_MAX = 80.0 * DEG
"""Largest bank for which the yaw rate of a coordinated turn is made [rad]; chosen, since it grows
without bound."""
TURN_AIRSPEED_MIN = 3.0
"""Least airspeed with which rates of turns are made [m/s]; chosen, so that they stay finite."""
LOAD_SHARE = 0.7
"""Share of the difference of the aircraft's load factors from 1 that a pull or a push may take;
chosen, since a change of the angle of attack overshoots."""


Demand = tuple[float, float, float, float]
"""Body rates p, q, r, FRD [rad/s], and thrust, 0 to 1."""


def demand_of(setpoint: SetAttitudeTarget, euler: Vec3, airspeed: float) -> Demand:
    """Body rates and thrust of a setpoint; what it ignores is not made up for.

    Of an attitude roll and pitch are flown, with the yaw rate of a coordinated turn.

    Args:
        setpoint: of attitude, or of body rates.
        euler: roll, pitch and yaw now [rad].
        airspeed: true airspeed [m/s].
    """
    mask = setpoint.type_mask
    thrust = 0.0 if mask & THROTTLE_IGNORE else setpoint.thrust
    if not mask & ATTITUDE_IGNORE:
        roll, pitch, _ = to_euler(from_quaternion(setpoint.q))
        return (*rates_for_attitude(roll, pitch, euler, airspeed), thrust)
    return (
        0.0 if mask & ROLL_RATE_IGNORE else setpoint.body_roll_rate,
        0.0 if mask & PITCH_RATE_IGNORE else setpoint.body_pitch_rate,
        0.0 if mask & YAW_RATE_IGNORE else setpoint.body_yaw_rate,
        thrust,
    )


@compiled
def rates_for_attitude(roll: float, pitch: float, euler: Vec3, airspeed: float) -> Vec3:
    """Body rates p, q, r, FRD [rad/s], that lead roll and pitch to those asked for.

    Args:
        roll: roll asked for [rad].
        pitch: pitch asked for [rad].
        euler: roll, pitch and yaw now [rad].
        airspeed: true airspeed [m/s].
    """
    phi, theta, _ = euler
    roll_rate = ATTITUDE_GAIN * wrap(roll - phi)
    pitch_rate = ATTITUDE_GAIN * (pitch - theta)
    yaw_rate = coordinated_yaw_rate(phi, theta, airspeed)
    return (
        roll_rate - yaw_rate * math.sin(theta),
        pitch_rate * math.cos(phi) + yaw_rate * math.sin(phi) * math.cos(theta),
        yaw_rate * math.cos(phi) * math.cos(theta) - pitch_rate * math.sin(phi),
    )


@compiled
def coordinated_yaw_rate(roll: float, pitch: float, airspeed: float) -> float:
    """Rate of the heading in a turn without sideslip, g tan(roll) cos(pitch) / V [rad/s].

    Roll and pitch are in rad, the true airspeed in m/s.
    """
    bank = max(-TURN_BANK_MAX, min(TURN_BANK_MAX, roll))
    return G0 * math.tan(bank) * math.cos(pitch) / max(airspeed, TURN_AIRSPEED_MIN)


@compiled
def within_limits(omega_b: Vec3, euler: Vec3, airspeed: float, aircraft: Performance) -> Vec3:
    """Body rates [rad/s] inside the limits of the aircraft, with a pitch rate for its load factors.

    A steady pull has the load factor n = cos(pitch) cos(roll) + q V / g.

    Args:
        omega_b: body rates p, q, r asked for, FRD [rad/s].
        euler: roll, pitch and yaw now [rad].
        airspeed: true airspeed [m/s].
        aircraft: its limits.
    """
    p, q, r = omega_b
    weight = math.cos(euler[0]) * math.cos(euler[1])
    least = 1.0 - LOAD_SHARE * (1.0 - aircraft.load_min) - weight
    most = 1.0 + LOAD_SHARE * (aircraft.load_max - 1.0) - weight
    turn = G0 / max(airspeed, TURN_AIRSPEED_MIN)
    most_p, most_q, most_r = aircraft.rate_max
    q = max(turn * least, min(turn * most, q))
    return _clip(p, most_p), _clip(q, most_q), _clip(r, most_r)


@compiled
def _clip(value: float, limit: float) -> float:
    return max(-limit, min(limit, value))
