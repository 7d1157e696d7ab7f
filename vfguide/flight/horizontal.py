"""The horizontal half of the flight law: from the state to a course, from there to a turn."""

import math

from vfguide.flight.approach import Course, Planar, loiter_course
from vfguide.flight.attitude import Lift, lift_for_turn
from vfguide.flight.leg import Leg, turn_radius
from vfguide.flight.memory import Target
from vfguide.flight.performance import Gains, Performance, turn_length
from vfguide.flight.planner import leg_course
from vfguide.flight.state import FlightState
from vfguide.flight.vertical import path_needed, steepest_descent, widest
from vfguide.flight.wind import Heading
from vfguide.geometry.angles import wrap
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3, add, scale

LATERAL_FEEDBACK = 12.0
"""Largest lateral acceleration that an error of the azimuth asks for [m/s^2]."""
PLANNED = 0.95
"""Part of the steepest slope that ways are planned with."""
SLOWEST_TURN = 2.5
"""No turn is planned tighter than a radian in this time [s]: rolling into it and out of it takes
the same time for a small aircraft, which could turn faster."""
OPPOSITE = 2.5
"""Beyond this error of the azimuth a turn goes on to the side it has begun [rad]."""


@compiled
def usable_bank(aircraft: Performance, gains: Gains, airspeed: float) -> float:
    """Largest bank whose load factor the wing carries at this airspeed [rad]."""
    load = min(aircraft.load_max, max(1.05, (airspeed / aircraft.airspeed_min) ** 2))
    return min(gains.bank_max, math.acos(1.0 / load))


@compiled
def flyable_radius(state: FlightState, bank: float, gains: Gains) -> float:
    """Turn radius over ground at the commanded airspeed in this wind [m]."""
    return radius_in(math.hypot(state.wind_n[0], state.wind_n[1]), bank, gains)


@compiled
def radius_in(wind: float, bank: float, gains: Gains) -> float:
    """The same in a wind of so many m/s."""
    radius = turn_radius(gains.airspeed, wind, bank, gains.turn_margin)
    radius += 0.5 * (gains.airspeed + wind) * gains.sluggish
    return max(radius, SLOWEST_TURN * gains.airspeed)


@compiled
def in_goal_plane(state: FlightState, target: Target) -> Planar:
    """Position and ground velocity in the horizontal plane of the target."""
    c, s = math.cos(target.course), math.sin(target.course)
    dx, dy = state.p_n[0] - target.p_n[0], state.p_n[1] - target.p_n[1]
    vx, vy = state.v_n[0], state.v_n[1]
    return Planar(c * dx + s * dy, c * dy - s * dx, c * vx + s * vy, c * vy - s * vx)


@compiled
def soon(state: FlightState, gains: Gains) -> FlightState:
    """The state with the position half a roll response later, when a turn will have begun."""
    p_n = add(state.p_n, scale(0.5 * gains.sluggish, state.v_n))
    return FlightState(state.time, p_n, state.v_n, state.R_nb, state.airspeed, state.wind_n)


@compiled
def target_course(
    state: FlightState, target: Target, aircraft: Performance, gains: Gains, leg: Leg
) -> Course:
    """The course over ground of a leg, or round a circle, relative to the target's."""
    at = in_goal_plane(state, target)
    if target.circle != 0.0:
        return loiter(at, target, leg)
    core = gains.core * radius_in(0.0, usable_bank(aircraft, gains, gains.airspeed), gains)
    return leg_course(leg, at, core)


@compiled
def wider_by(leg: Leg, state: FlightState, aircraft: Performance, gains: Gains) -> float:
    """By which the turns of the leg are wider than those of level flight, as far as it helps."""
    level = flyable_radius(state, usable_bank(aircraft, gains, gains.airspeed), gains)
    return max(1.0, min(widest(aircraft), leg.radius / level))


@compiled
def path_for_height(
    state: FlightState,
    target: Target,
    aircraft: Performance,
    gains: Gains,
    wider: float,
    slope: float,
) -> float:
    """Path over ground that the rest of the change of height takes [m].

    `wider` is that of `steepest_descent`, `slope` the one that was wanted at the step before.
    """
    height = target.p_n[2] - state.p_n[2]
    descent = steepest_descent(aircraft, wider, target.slope)
    steepest = math.tan(aircraft.climb_max if height < 0.0 else descent)
    tail, unit = wind_along(state.wind_n, target.course), turn_length(gains.airspeed)
    most = PLANNED * steepest / (1.0 + max(0.0, tail) / max(gains.airspeed, 1e-3))
    distance = math.hypot(state.p_n[0] - target.p_n[0], state.p_n[1] - target.p_n[1])
    return path_needed(height, distance, target.slope, max(most, 1e-6), unit, slope)


@compiled
def wind_along(wind_n: Vec3, course: float) -> float:
    """Wind from behind on a course [m/s]."""
    return wind_n[0] * math.cos(course) + wind_n[1] * math.sin(course)


@compiled
def loiter(at: Planar, target: Target, leg: Leg) -> Course:
    """Course round the target's circle, which touches the target's pose."""
    radius = max(target.radius, leg.radius)
    about = Planar(at.x, at.y - target.circle * radius, at.vx, at.vy)
    return loiter_course(about, target.circle, radius)


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
