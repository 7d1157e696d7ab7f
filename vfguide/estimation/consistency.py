"""Consistency: attitude, ground velocity, airspeed and wind are held against each other.

Each has to agree with what the others say of it: fault detection by analytical redundancy. What
does not is doubted, and replaced by what the others say: the yaw by the direction of the wind
triangle, the ground velocity by the motion of the position, the wind and the airspeed by their own
estimates. Roll and pitch have no replacement.

Gertler, Fault Detection and Diagnosis in Engineering Systems, 1998: parity equations.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.performance import Performance
from vfguide.aircraft.state import FlightState
from vfguide.estimation.air_check import LEAST_DOUBT, AirCheck, doubting_wind, first_check
from vfguide.estimation.air_state import AIRSPEED, EAST, NORTH, AirState
from vfguide.estimation.attitude_check import (
    AttitudeCheck,
    corrected_attitude,
    first_attitude,
    follow_attitude,
    uncorrected,
)
from vfguide.estimation.fault_isolation import check_air
from vfguide.estimation.lift_check import LIFT_FAULT_TIME, LiftCheck, first_lift, follow_lift
from vfguide.estimation.velocity_check import (
    VelocityCheck,
    corrected_velocity,
    first_velocity,
    follow_velocity,
)
from vfguide.geometry.so3 import IDENTITY
from vfguide.geometry.vector import ZERO, Vec3
from vfguide.kernels.compiled import compiled

FIRST_CHECK = 0.2
"""Time of measurements after which the wind triangle is judged [s]; chosen, so that a wrong ground
velocity is found first."""
FIRST_LIFT = 0.4
"""Time of measurements after which lift and attitude are compared [s]; chosen, so that a wrong
ground velocity, yaw or wind is found first."""
LONGEST_GAP_CHECKED = 1.0
"""Time between two steps after which the checks start anew [s]; chosen."""


class Consistency(NamedTuple):
    """What was reported last, what the checks have shown, and how long each thing is doubted."""

    time: float
    """Time of the step [s]; negative before the first."""
    attitude: AttitudeCheck
    velocity: VelocityCheck
    lift: LiftCheck
    air: AirCheck
    yaw_doubt: float
    """Time for which the reported yaw has not been believed [s]; 0: it is believed."""
    velocity_doubt: float
    """Time for which the ground velocity has not been believed [s]; 0: it is believed."""
    attitude_doubt: float
    """Time for which roll and pitch have not been believed [s]; it does not end by itself."""
    was_misled: bool
    """Whether the estimate of the air has to start anew: the wind that was believed is wrong."""


@compiled
def fresh_consistency() -> Consistency:
    """The state before the first step."""
    attitude, velocity = first_attitude(IDENTITY, ZERO), first_velocity(ZERO, ZERO)
    return Consistency(
        -1.0, attitude, velocity, first_lift(ZERO), first_check(), 0.0, 0.0, 0.0, False
    )


@compiled
def follow(
    m: FlightState,
    omega_b: Vec3,
    thrust: float,
    s: Consistency,
    air: AirState,
    aircraft: Performance,
) -> Consistency:
    """The state after one more measurement.

    Args:
        m: the measured state; airspeed and wind are not numbers where they are not measured.
        omega_b: measured body rates [rad/s].
        thrust: thrust setpoint of the step before, 0 to 1.
        s: the state before.
        air: estimate of the air at the step before.
        aircraft: its lift, thrust and drag.
    """
    dt = m.time - s.time
    if dt == 0.0:
        return s
    if s.time < 0.0 or not 0.0 < dt < LONGEST_GAP_CHECKED:
        attitude, velocity = first_attitude(m.R_nb, omega_b), first_velocity(m.p_n, m.v_n)
        lift, dt, tilted = first_lift(m.v_n), 0.0, False
    else:
        attitude = follow_attitude(s.attitude, m.R_nb, omega_b, dt)
        velocity = follow_velocity(s.velocity, m.p_n, m.v_n, dt)
        lift, tilted = first_lift(m.v_n), s.attitude_doubt > 0.0
        is_known = air.time >= 0.0 or not math.isnan(m.wind_n[0] + m.airspeed)
        if is_known and velocity.age > FIRST_LIFT:
            state = believed(m, attitude, velocity, s.air, air)
            lift = follow_lift(s.lift, m.v_n, state, thrust, aircraft, dt)
    state = believed(m, attitude, velocity, s.air, air)
    by_wind, checked = attitude.is_by_wind, s.air
    if velocity.age > FIRST_CHECK:
        attitude, checked = check_air(state, m, attitude, checked, air, aircraft, dt)
    if by_wind and lift.time > LIFT_FAULT_TIME:
        attitude, checked = uncorrected(attitude), doubting_wind(checked, dt)
    was_misled = by_wind and checked.wind_doubt > 0.0
    if was_misled:
        lift = first_lift(m.v_n)
    is_tilted = attitude.is_tilted or lift.time > LIFT_FAULT_TIME or tilted
    return Consistency(
        m.time,
        attitude,
        velocity,
        lift,
        checked,
        lasted(s.yaw_doubt, attitude.yaw_correction != 0.0, dt),
        lasted(s.velocity_doubt, velocity.is_doubted, dt),
        lasted(s.attitude_doubt, is_tilted, dt),
        was_misled,
    )


@compiled
def lasted(time: float, is_doubted: bool, dt: float) -> float:
    """Duration of a doubt `dt` later [s]; 0 where there is none."""
    return time + max(dt, LEAST_DOUBT) if is_doubted else 0.0


@compiled
def believed(
    m: FlightState,
    attitude: AttitudeCheck,
    velocity: VelocityCheck,
    checked: AirCheck,
    air: AirState,
) -> FlightState:
    """The measured state, with replacements for what is doubted or not reported."""
    own_n = (air.estimate.x[NORTH], air.estimate.x[EAST], 0.0)
    wind_n = own_n if checked.wind_doubt > 0.0 or math.isnan(m.wind_n[0]) else m.wind_n
    untold = checked.airspeed_doubt > 0.0 or math.isnan(m.airspeed)
    speed = air.estimate.x[AIRSPEED] if untold else m.airspeed
    v_n = corrected_velocity(velocity, m.v_n)
    return FlightState(m.time, m.p_n, v_n, corrected_attitude(attitude, m.R_nb), speed, wind_n)


@compiled
def as_flown(state: FlightState, s: Consistency) -> FlightState:
    """A state, measured or predicted, as it is flown on: what is doubted is replaced.

    Airspeed and wind are not numbers where they are doubted.
    """
    nan = math.nan
    return FlightState(
        state.time,
        state.p_n,
        corrected_velocity(s.velocity, state.v_n),
        corrected_attitude(s.attitude, state.R_nb),
        nan if s.air.airspeed_doubt > 0.0 else state.airspeed,
        (nan, nan, nan) if s.air.wind_doubt > 0.0 else state.wind_n,
    )
