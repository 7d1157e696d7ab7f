"""One step of the flight law: from the state and a target to body rates and thrust."""

import math
from typing import NamedTuple

from vfguide.field.rate_law import rate_law
from vfguide.flight.approach import Course, Planar, loiter_course
from vfguide.flight.attitude import Lift, attitude_for_lift, lift_for_turn
from vfguide.flight.energy import integrate_error, thrust_for
from vfguide.flight.performance import Gains, Performance
from vfguide.flight.planner import Leg, fly_leg, keep_radius, leg_course, new_leg, turn_radius
from vfguide.flight.state import FlightState, RateSetpoint
from vfguide.flight.vertical import SLOPE_RATE, goal_slope, path_needed
from vfguide.flight.wind import Heading, heading_for_course
from vfguide.geometry.angles import wrap
from vfguide.geometry.compiled import compiled
from vfguide.geometry.so3 import log, to_quaternion
from vfguide.geometry.vector import Mat3, Vec3, add, matmul, norm, scale, sub, transpose

LOITER_HORIZON = 150.0
"""Distance over which a loitering vehicle takes away an error of height [m]."""
LATERAL_FEEDBACK = 12.0
"""Largest lateral acceleration that an error of the azimuth asks for [m/s^2]."""
OPPOSITE = 2.5
"""Beyond this error of the azimuth a turn goes on to the side it has begun [rad]."""
REFERENCE_RATE = 1.5
"""The reference attitude's angular velocity is not taken above this [rad/s]."""
FIRST_STEP = 0.02
LONGEST_STEP = 0.2
"""Bounds of the time between two steps [s]."""


class Target(NamedTuple):
    """What to fly to: a pose to pass, or a circle to fly round."""

    p_n: Vec3
    """The goal, or a point of the circle [m]."""
    course: float
    """Course over ground there [rad]."""
    slope: float
    """Slope dh/ds of the path at the goal."""
    circle: float
    """0: a goal. +1, -1: the circle that leaves the point to the right or to the left."""
    radius: float
    """Radius of the circle [m]; it grows where wind and bank ask for more."""


class Memory(NamedTuple):
    """What one step leaves for the next."""

    time: float
    """Of the last step [s]; negative before the first."""
    leg: Leg
    slope: float
    """Wanted slope, its rate limited."""
    turning: float
    """Side of the present turn, +1 right, -1 left."""
    R_na: Mat3
    """Reference attitude of the last step."""
    omega_a: Vec3
    """Its angular velocity, smoothed [rad/s]."""
    thrust_integral: float
    alpha_bias: float
    """Learned correction of the angle of attack [rad]."""


class Wish(NamedTuple):
    """What the law wanted at one step: for displays, logs and tests."""

    course: float
    """Over ground [rad]."""
    azimuth: float
    """Of the air velocity [rad]."""
    gamma: float
    """Path angle through the air [rad]."""
    bank: float
    load: float
    remaining: float
    """Path length to the goal [m]."""
    phase: int
    radius: float
    """Turn radius of the approach [m]."""


@compiled
def fresh_memory() -> Memory:
    """Memory before the first step."""
    level = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    return Memory(-1.0, new_leg(), 0.0, 1.0, level, (0.0, 0.0, 0.0), 0.0, 0.0)


@compiled
def next_leg(memory: Memory) -> Memory:
    """The same memory with a new leg begun: the goal changed or was missed."""
    m = memory
    return Memory(
        m.time, new_leg(), m.slope, m.turning, m.R_na, m.omega_a, m.thrust_integral, m.alpha_bias
    )


@compiled
def guide(
    state: FlightState, target: Target, aircraft: Performance, gains: Gains, memory: Memory
) -> tuple[RateSetpoint, Memory, Wish]:
    """One step of the flight law; the setpoint is not limited yet."""
    first = memory.time < 0.0
    dt = FIRST_STEP if first else min(max(state.time - memory.time, 1e-3), LONGEST_STEP)
    air = sub(state.v_n, state.wind_n)
    speed = max(state.airspeed, 0.5 * aircraft.airspeed_min)
    bank_max = usable_bank(aircraft, gains, speed)
    leg = keep_radius(memory.leg, flyable_radius(state, bank_max, gains))
    leg, course = plan_course(state, target, aircraft, gains, leg)
    gamma = math.asin(max(-1.0, min(1.0, -air[2] / speed)))
    heading = heading_for_course(
        target.course + course.chi,
        course.chi_rate,
        (state.wind_n[0], state.wind_n[1]),
        speed * math.cos(gamma),
    )

    slope = plan_slope(state, target, aircraft, course, heading.groundspeed, memory.slope, dt)
    gamma_wanted = path_angle(slope, heading.groundspeed, state.wind_n[2], speed, aircraft)

    azimuth = math.atan2(air[1], air[0])
    lift, turning = plan_turn(
        heading, azimuth, gamma, speed, bank_max, aircraft, gains, memory.turning
    )

    alpha_bias = learn_alpha(memory.alpha_bias, gamma_wanted - gamma, gains, dt)
    alpha = aircraft.alpha_zero + aircraft.alpha_load * lift.load / speed**2 + alpha_bias
    elevation = gamma_wanted + gains.k_elevation * (gamma_wanted - gamma)
    R_na = attitude_for_lift(azimuth, elevation, lift.bank, alpha)
    omega_a = (0.0, 0.0, 0.0) if first else reference_rate(memory, R_na, gains.smoothing, dt)
    omega = rate_law(state.R_nb, R_na, omega_a, gains.k_w)

    error = gains.airspeed - state.airspeed
    thrust = thrust_for(aircraft, error, gamma_wanted, lift.load, memory.thrust_integral)
    integral = integrate_error(aircraft, error, thrust, memory.thrust_integral, dt)
    after = Memory(state.time, leg, slope, turning, R_na, omega_a, integral, alpha_bias)
    wish = Wish(
        target.course + course.chi,
        heading.psi,
        gamma_wanted,
        lift.bank,
        lift.load,
        course.remaining,
        leg.phase,
        leg.radius,
    )
    return RateSetpoint(omega, thrust, to_quaternion(R_na)), after, wish


@compiled
def usable_bank(aircraft: Performance, gains: Gains, airspeed: float) -> float:
    """Largest bank whose load factor the wing carries at this airspeed [rad]."""
    load = min(aircraft.load_max, max(1.05, (airspeed / aircraft.airspeed_min) ** 2))
    return min(gains.bank_max, math.acos(1.0 / load))


@compiled
def flyable_radius(state: FlightState, bank: float, gains: Gains) -> float:
    """Turn radius over ground at the commanded airspeed in this wind [m]."""
    wind = math.hypot(state.wind_n[0], state.wind_n[1])
    return turn_radius(gains.airspeed, wind, bank, gains.turn_margin)


@compiled
def in_goal_plane(state: FlightState, target: Target) -> Planar:
    """Position and ground velocity in the horizontal plane of the target."""
    c, s = math.cos(target.course), math.sin(target.course)
    dx, dy = state.p_n[0] - target.p_n[0], state.p_n[1] - target.p_n[1]
    vx, vy = state.v_n[0], state.v_n[1]
    return Planar(c * dx + s * dy, c * dy - s * dx, c * vx + s * vy, c * vy - s * vx)


@compiled
def plan_course(
    state: FlightState, target: Target, aircraft: Performance, gains: Gains, leg: Leg
) -> tuple[Leg, Course]:
    """Memory of the leg, and the course over ground relative to the target's."""
    at = in_goal_plane(state, target)
    if target.circle != 0.0:
        return leg, loiter(at, target, leg)
    height = target.p_n[2] - state.p_n[2]
    steepest = math.tan(aircraft.climb_max if height < 0.0 else aircraft.descent_max)
    needed = path_needed(height, math.hypot(at.x, at.y), target.slope, 0.8 * steepest)
    leg = fly_leg(leg, at, needed, gains)
    return leg, leg_course(leg, at, gains)


@compiled
def loiter(at: Planar, target: Target, leg: Leg) -> Course:
    """Course round the target's circle, which touches the target's pose."""
    radius = max(target.radius, leg.radius)
    about = Planar(at.x, at.y - target.circle * radius, at.vx, at.vy)
    return loiter_course(about, target.circle, radius)


@compiled
def plan_slope(
    state: FlightState,
    target: Target,
    aircraft: Performance,
    course: Course,
    groundspeed: float,
    before: float,
    dt: float,
) -> float:
    """Slope dh/ds over ground, within the aircraft's path angles, its rate limited."""
    height = target.p_n[2] - state.p_n[2]
    if target.circle != 0.0:
        wanted = -2.0 * height / LOITER_HORIZON
    else:
        wanted = goal_slope(height, course.remaining, target.slope)
    up = airspeed_over_ground(state.airspeed, groundspeed)
    highest, lowest = up * math.sin(aircraft.climb_max), -up * math.sin(aircraft.descent_max)
    wanted = max(lowest, min(highest, wanted))
    return max(before - SLOPE_RATE * dt, min(before + SLOPE_RATE * dt, wanted))


@compiled
def airspeed_over_ground(airspeed: float, groundspeed: float) -> float:
    """Ratio of the speeds, bounded where the wind stops the vehicle."""
    return airspeed / max(groundspeed, 0.2 * airspeed)


@compiled
def path_angle(
    slope: float, groundspeed: float, wind_down: float, airspeed: float, aircraft: Performance
) -> float:
    """Path angle through the air that makes good the slope over ground [rad]."""
    sine = (slope * groundspeed + wind_down) / airspeed
    return max(-aircraft.descent_max, min(aircraft.climb_max, math.asin(max(-1.0, min(1.0, sine)))))


@compiled
def plan_turn(
    heading: Heading,
    azimuth: float,
    gamma: float,
    speed: float,
    bank_max: float,
    aircraft: Performance,
    gains: Gains,
    turning: float,
) -> tuple[Lift, float]:
    """Lift that turns the air velocity onto the wanted azimuth, and the side it turns to.

    An error near 180 degrees is turned away to the side of the present turn.
    """
    error = wrap(heading.psi - azimuth)
    if abs(error) > OPPOSITE and error * turning < 0.0:
        error += 2.0 * math.pi * turning
    feedback = gains.k_lateral * speed * error
    feedback = max(-LATERAL_FEEDBACK, min(LATERAL_FEEDBACK, feedback))
    lateral = speed * math.cos(gamma) * heading.psi_rate + feedback
    lift = lift_for_turn(lateral, gamma, bank_max, aircraft.load_max)
    return lift, 1.0 if lateral >= 0.0 else -1.0


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
