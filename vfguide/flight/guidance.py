"""One step of the flight law: from the state and a target to body rates and thrust."""

import math

import numpy as np

from vfguide.field.rate_law import rate_law
from vfguide.flight.attitude import attitude_for_lift
from vfguide.flight.detour_leg import DetourState, detour_course, is_on_detour, level_of
from vfguide.flight.energy import integrate_error, thrust_for
from vfguide.flight.envelope import load_of, within_envelope
from vfguide.flight.horizontal import (
    flyable_radius,
    plan_course,
    plan_turn,
    usable_bank,
    wider_by,
)
from vfguide.flight.leg import AWAY, keep_radius
from vfguide.flight.memory import Memory, Target, Wish
from vfguide.flight.passing import aim_at
from vfguide.flight.performance import Gains, Performance, turn_length
from vfguide.flight.state import FlightState, RateSetpoint
from vfguide.flight.vertical import (
    allowed_path,
    blended,
    floor_share,
    path_angle,
    path_limits,
    plan_slope,
)
from vfguide.flight.wind import heading_for_course
from vfguide.geometry.compiled import compiled
from vfguide.geometry.so3 import log, to_quaternion
from vfguide.geometry.vector import Mat3, Vec3, add, matmul, norm, scale, sub, transpose

REFERENCE_RATE = 1.5
"""The reference attitude's angular velocity is not taken above this [rad/s]."""
SPARING, SHORT = 0.05, 0.05
"""No bank is larger than the first where the climb near the floor is the second short [rad]."""
FIRST_STEP = 0.02
LONGEST_STEP = 0.2
"""Bounds of the time between two steps [s]."""


@compiled
def guide(
    state: FlightState, target: Target, aircraft: Performance, gains: Gains, memory: Memory
) -> tuple[RateSetpoint, Memory, Wish]:
    """One step of the flight law; the setpoint is not limited yet."""
    wish, planned = plan_flight(state, target, aircraft, gains, memory, np.zeros(0), math.inf)
    setpoint, after = fly_wish(state, wish, aircraft, gains, planned)
    return setpoint, after, wish


@compiled
def plan_flight(
    state: FlightState,
    target: Target,
    aircraft: Performance,
    gains: Gains,
    memory: Memory,
    detour: DetourState,
    above: float,
) -> tuple[Wish, Memory]:
    """The first half of a step: where to fly, as a bank, a load factor and a path angle.

    While a `detour` is flown the leg waits; a circle is flown all the same. `above` is the height
    above the floor, infinite where there is none [m]. The memory has what was planned; its time
    is still that of the step before.
    """
    air = sub(state.v_n, state.wind_n)
    speed = max(state.airspeed, 0.5 * aircraft.airspeed_min)
    steady = usable_bank(aircraft, gains, gains.airspeed)
    leg = memory.leg
    if is_on_detour(detour) and target.circle == 0.0:
        course = detour_course(detour, soon(state, gains), leg, target.course)
    else:
        leg = keep_radius(leg, flyable_radius(state, steady, gains))
        leg, course = plan_course(soon(state, gains), target, aircraft, gains, leg, memory.slope)
    flown = path_of(air, speed)
    heading = heading_for_course(
        target.course + course.chi,
        course.chi_rate,
        (state.wind_n[0], state.wind_n[1]),
        speed * math.cos(flown),
    )
    level, fall = level_of(detour)
    slope = plan_slope(
        state,
        aim_at(level, fall, target, math.inf if leg.phase == AWAY else course.remaining),
        aircraft,
        gains.airspeed,
        course.remaining,
        heading.groundspeed,
        wider_by(leg, state, aircraft, gains),
        memory.slope,
        time_since(memory, state),
    )
    limits = path_limits(norm(air), gains.airspeed, above, aircraft)
    asked = path_angle(slope, heading.groundspeed, state.wind_n[2], speed)
    gamma, climb = allowed_path(asked, limits)
    bank_max = usable_bank(aircraft, gains, speed)
    last = floor_share(above, turn_length(gains.airspeed))
    bank_max = sparing_bank(bank_max, last * min(asked - gamma, state.wind_n[2] / speed))
    lift, turning = plan_turn(
        heading, azimuth_of(air), flown, speed, bank_max, aircraft, gains, memory.turning
    )
    wish = Wish(
        target.course + course.chi,
        heading.psi,
        gamma,
        climb,
        lift.bank,
        lift.load,
        course.remaining,
        leg.phase,
        leg.radius,
    )
    m = memory
    return wish, Memory(
        m.time, leg, slope, turning, m.R_na, m.omega_a, m.thrust_integral, m.alpha_bias
    )


@compiled
def sparing_bank(bank: float, missing: float) -> float:
    """The largest bank where the path near the floor is less steep than is asked for [rad].

    Air that sinks faster than the aircraft climbs is flown out of with wings level: a turn takes
    thrust, and may end where another has to follow.

    Args:
        bank: the largest one elsewhere.
        missing: of the path angle through air that sinks, less where the floor is farther below.
    """
    return blended(bank, min(bank, SPARING), max(0.0, min(1.0, missing / SHORT)))


@compiled
def fly_wish(
    state: FlightState, wish: Wish, aircraft: Performance, gains: Gains, memory: Memory
) -> tuple[RateSetpoint, Memory]:
    """The second half: body rates and thrust that fly the bank, load factor and path angle."""
    air, dt = sub(state.v_n, state.wind_n), time_since(memory, state)
    speed = max(state.airspeed, 0.5 * aircraft.airspeed_min)
    climbing = wish.gamma - path_of(air, speed)
    alpha_bias = learn_alpha(memory.alpha_bias, climbing, gains, dt)
    alpha = aircraft.alpha_zero + aircraft.alpha_load * wish.load / speed**2 + alpha_bias
    elevation = wish.gamma + gains.k_elevation * climbing
    R_na = attitude_for_lift(azimuth_of(air), elevation, wish.bank, alpha)
    omega_a = (0.0, 0.0, 0.0)
    if memory.time >= 0.0:
        omega_a = reference_rate(memory, R_na, gains.smoothing, dt)
    omega = rate_law(state.R_nb, R_na, omega_a, gains.k_w)
    load = load_of(state.R_nb, air, speed, aircraft)
    omega = within_envelope(omega, state.R_nb, load, speed, gains.bank_max, aircraft)

    error = gains.airspeed - state.airspeed
    thrust = thrust_for(aircraft, error, wish.climb, wish.load, memory.thrust_integral)
    integral = integrate_error(aircraft, error, thrust, memory.thrust_integral, dt)
    m = memory
    after = Memory(state.time, m.leg, m.slope, m.turning, R_na, omega_a, integral, alpha_bias)
    return RateSetpoint(omega, thrust, to_quaternion(R_na)), after


@compiled
def time_since(memory: Memory, state: FlightState) -> float:
    """Time since the step before, bounded [s]."""
    if memory.time < 0.0:
        return FIRST_STEP
    return min(max(state.time - memory.time, 1e-3), LONGEST_STEP)


@compiled
def azimuth_of(air: Vec3) -> float:
    """Azimuth of the velocity through the air [rad]."""
    return math.atan2(air[1], air[0])


@compiled
def path_of(air: Vec3, speed: float) -> float:
    """Path angle through the air [rad]."""
    return math.asin(max(-1.0, min(1.0, -air[2] / speed)))


@compiled
def soon(state: FlightState, gains: Gains) -> FlightState:
    """The state with the position half a roll response later, when a turn will have begun."""
    p_n = add(state.p_n, scale(0.5 * gains.sluggish, state.v_n))
    return FlightState(state.time, p_n, state.v_n, state.R_nb, state.airspeed, state.wind_n)


@compiled
def learn_alpha(bias: float, error: float, gains: Gains, dt: float) -> float:
    """Next correction of the angle of attack from the error of the path angle [rad]."""
    return max(-0.05, min(0.05, bias + gains.k_alpha * error * dt))


@compiled
def reference_rate(memory: Memory, R_na: Mat3, smoothing: float, dt: float) -> Vec3:
    """Angular velocity of the reference attitude, body axes, smoothed [rad/s]."""
    turned = scale(1.0 / dt, log(matmul(transpose(memory.R_na), R_na)))
    size = norm(turned)
    if size > REFERENCE_RATE:
        turned = scale(REFERENCE_RATE / size, turned)
    blend = dt / (smoothing + dt)
    return add(memory.omega_a, scale(blend, sub(turned, memory.omega_a)))
