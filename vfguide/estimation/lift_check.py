"""Roll and pitch against the forces: lift and weight alone turn the velocity of an aeroplane.

A wrong roll shows as a force across the fuselage; sideslip looks the same for a moment and is
allowed for. A wrong pitch shows twice: as a lift that does not belong to its angle of attack, as in
a vertical wind, and as an acceleration along the path that thrust, drag and weight do not give, as
with errors of the model.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.coordinated_turn import angle_of_attack
from vfguide.aircraft.flight_model import modelled_flight, side_force_slope, specific_force
from vfguide.aircraft.performance import Performance, alpha_of_load, nonzero_airspeed
from vfguide.aircraft.state import FlightState
from vfguide.estimation.velocity_check import velocity_jumps
from vfguide.geometry.units import DEG, G0
from vfguide.geometry.vector import Vec3, dot, sub
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import replacing

LIFT_TIME = 0.3
"""Time constant with which force and angle are smoothed [s]; chosen, so that they are known within
a second."""
SIDE_FORCE_LIMIT = 2.8
"""Specific force across the fuselage above which the roll is wrong [m/s^2]: a roll error of 17
degrees in level flight; chosen above what sideslip in gusts gives."""
LATERAL_GUST = 9.0
"""Gust from the side whose force is allowed for as well [m/s]; chosen above three standard
deviations in severe turbulence."""
PITCH_ERROR_LIMIT = 12.0 * DEG
"""Error of the pitch that lift and acceleration both show above which the pitch is wrong [rad];
chosen above what gusts and errors of the model give together."""
VERTICAL_GUST = 8.0
"""Vertical wind beyond which the lift alone shows a wrong pitch [m/s]; chosen above that of
thermals."""
LIFT_FAULT_TIME = 0.5
"""Time above a limit after which roll or pitch are wrong [s]; chosen, so that gusts pass."""


class LiftCheck(NamedTuple):
    """What lift and attitude have shown."""

    v_n: Vec3
    """Velocity over ground at the step before, NED [m/s]."""
    side_force: float
    """Specific force to the right across the fuselage, smoothed [m/s^2]."""
    alpha_error: float
    """Angle of attack by the attitude less the one by the lift, smoothed [rad]."""
    path_error: float
    """Acceleration along the path beyond the modelled one, over gravity, smoothed: the pitch error
    that would explain it [rad]."""
    age: float
    """Time since the first velocity [s]."""
    time: float
    """Time for which an error has been above its limit, weighted with the square of its ratio to
    the limit [s], so that gross errors are found sooner."""


with_velocity = replacing(LiftCheck, "v_n")


@compiled
def first_lift(v_n: Vec3) -> LiftCheck:
    """The check after one velocity over ground, NED [m/s]: nothing is known yet."""
    return LiftCheck(v_n, 0.0, 0.0, 0.0, 0.0, 0.0)


@compiled
def follow_lift(
    s: LiftCheck, v_n: Vec3, state: FlightState, thrust: float, aircraft: Performance, dt: float
) -> LiftCheck:
    """The check `dt` [s] later; up to an age of LIFT_TIME its smoothed values are plain means.

    Args:
        s: the check at the step before.
        v_n: reported velocity over ground, NED [m/s]; its change shows the force, unless it jumps.
        state: the state that is believed.
        thrust: thrust setpoint of the step before, 0 to 1.
        aircraft: its lift, thrust and drag.
        dt: time step [s].
    """
    if velocity_jumps(s.v_n, v_n, dt):
        return with_velocity(s, v_n)
    force_n, R = specific_force(s.v_n, v_n, dt), state.R_nb
    speed = nonzero_airspeed(state.airspeed, aircraft)
    load = -dot(force_n, (R[0][2], R[1][2], R[2][2])) / G0
    by_lift = alpha_of_load(load, speed, aircraft)
    flight = modelled_flight(R, speed, thrust, 0.0, aircraft)
    beyond = dot(force_n, flight.d_n) + G0 * flight.d_n[2] - flight.acceleration
    age = s.age + dt
    blend = dt / min(age, LIFT_TIME + dt)
    across = dot(force_n, (R[0][1], R[1][1], R[2][1]))
    side = s.side_force + blend * (across - s.side_force)
    off = angle_of_attack(R, sub(state.v_n, state.wind_n)) - by_lift
    alpha_error = s.alpha_error + blend * (off - s.alpha_error)
    path_error = s.path_error + blend * (beyond / G0 - s.path_error)
    agree = alpha_error * path_error > 0.0
    pitch_error = min(abs(alpha_error), abs(path_error)) if agree else 0.0
    gust = side_force_slope(speed, aircraft) * LATERAL_GUST / speed
    alone = PITCH_ERROR_LIMIT + math.asin(min(1.0, VERTICAL_GUST / speed))
    ratio = max(
        abs(side) / max(SIDE_FORCE_LIMIT, gust),
        pitch_error / PITCH_ERROR_LIMIT,
        abs(alpha_error) / alone,
    )
    time = s.time + ratio**2 * dt if ratio > 1.0 else 0.0
    return LiftCheck(v_n, side, alpha_error, path_error, age, time)
