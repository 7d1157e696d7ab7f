"""Roll and pitch against the forces: lift and weight alone turn the velocity of an aeroplane.

A wrong roll shows as a force across the fuselage, a wrong pitch as a lift that its angle of attack
does not give. Sideslip and vertical wind look the same for a moment and are allowed for.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.coordinated_turn import angle_of_attack
from vfguide.aircraft.flight_model import specific_force
from vfguide.aircraft.performance import Performance
from vfguide.aircraft.state import FlightState
from vfguide.estimation.velocity_check import velocity_jumps
from vfguide.geometry.compiled import compiled
from vfguide.geometry.units import G0
from vfguide.geometry.vector import Vec3, dot, sub

LIFT_TIME = 0.3
"""Time constant with which force and angle are smoothed [s]; chosen, so that they are known within
a second."""
SIDE_FORCE_LIMIT = 2.8
"""Specific force across the fuselage above which the roll is wrong [m/s^2]: a roll error of 17
degrees in level flight; chosen above what sideslip in gusts gives."""
VERTICAL_GUST = 6.0
"""Vertical wind that may explain an angle of attack without its lift [m/s]; chosen as that of a
strong thermal."""
LIFT_FAULT_TIME = 0.4
"""Time above a limit after which roll or pitch are wrong [s]; chosen, so that gusts pass."""


class LiftCheck(NamedTuple):
    """What lift and attitude have shown."""

    v_n: Vec3
    """Velocity over ground at the step before, NED [m/s]."""
    side_force: float
    """Specific force to the right across the fuselage, smoothed [m/s^2]."""
    alpha_error: float
    """Angle of attack by the attitude less the one by the lift, smoothed [rad]."""
    time: float
    """Time for which one of them has been above its limit, times the square of how many times above
    it [s]: gross errors are found sooner."""


@compiled
def first_lift(v_n: Vec3) -> LiftCheck:
    """The check after one velocity over ground, NED [m/s]: nothing is known yet."""
    return LiftCheck(v_n, 0.0, 0.0, 0.0)


@compiled
def follow_lift(
    s: LiftCheck, v_n: Vec3, state: FlightState, aircraft: Performance, dt: float
) -> LiftCheck:
    """The check `dt` [s] later.

    Args:
        s: the check at the step before.
        v_n: told velocity over ground, NED [m/s], whose changes count; a jump shows no force.
        state: the state that is believed.
        aircraft: its lift.
        dt: time step [s].
    """
    if velocity_jumps(s.v_n, v_n, dt):
        return LiftCheck(v_n, s.side_force, s.alpha_error, s.time)
    force_n, R = specific_force(s.v_n, v_n, dt), state.R_nb
    speed = max(state.airspeed, 0.5 * aircraft.airspeed_min)
    load = -dot(force_n, (R[0][2], R[1][2], R[2][2])) / G0
    by_lift = aircraft.alpha_zero + aircraft.alpha_load * load / (speed * speed)
    off = angle_of_attack(R, sub(state.v_n, state.wind_n)) - by_lift
    blend = dt / (LIFT_TIME + dt)
    across = dot(force_n, (R[0][1], R[1][1], R[2][1]))
    side = s.side_force + blend * (across - s.side_force)
    alpha_error = s.alpha_error + blend * (off - s.alpha_error)
    gust = math.asin(min(1.0, VERTICAL_GUST / speed))
    ratio = max(abs(side) / SIDE_FORCE_LIMIT, abs(alpha_error) / gust)
    return LiftCheck(v_n, side, alpha_error, s.time + ratio**2 * dt if ratio > 1.0 else 0.0)
