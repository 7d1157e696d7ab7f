"""Other laws in the place of the flight law, for comparison: nothing that can be flown with.

Each is a copy of the companion's compiled step with one function exchanged; nothing of it is kept
on disk. The law of the paper is its composite field as printed: obstacles and, with priority,
traffic. The field's direction and its exact turning are flown by the same inner half of the flight
law, at the aircraft's own speed, in the wind, and within the aircraft's limits.
"""

import math
from collections.abc import Callable
from types import FunctionType
from typing import Any

import numba
import numpy as np

from vfguide.companion import step as steps
from vfguide.companion.step import step_on
from vfguide.field.avoidance import avoidance_field, no_deflection
from vfguide.field.composite import deflect_by_obstacles, deflect_by_robot, free_field
from vfguide.field.dual import Dual3
from vfguide.field.goal_frame import goal_frame
from vfguide.field.robots import Robot, Spacing
from vfguide.flight.detour_leg import DetourState
from vfguide.flight.guidance import azimuth_of, fly_wish, path_of, plan_flight
from vfguide.flight.horizontal import plan_turn, usable_bank
from vfguide.flight.memory import Memory, Target, Wish
from vfguide.flight.performance import Law, unpacked
from vfguide.flight.state import FlightState, RateSetpoint
from vfguide.flight.vertical import allowed_path, path_angle, path_limits
from vfguide.flight.wind import heading_for_course
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import add, norm, scale, sub
from vfguide.safety.guard import GuardState, Watch, guide_clear, in_sight
from vfguide.safety.hazards import Hazards, Intruder, read_intruder
from vfguide.safety.limits import limit_setpoint

SIGHT = 300.0
"""r_d: the paper's robots see each other from here on, the default of a scenario [m]."""
FASTEST = 1.0
"""The turning of the field is fed forward up to this [rad/s]."""
STEEPEST = 1.2
"""Its direction is flown up to this angle to the horizon [rad]."""


def exchanged(function: Any, **others: Any) -> Any:
    """A compiled function that calls `others` instead of its own functions of these names."""
    plain = function.py_func
    copy = FunctionType(plain.__code__, {**plain.__globals__, **others}, plain.__name__)
    return numba.njit(copy)


def step_with(guide: Any) -> Callable[..., Any]:
    """`step_on` that guides among hazards by `guide`, which takes what `guide_clear` does."""
    return exchanged(step_on, step=exchanged(steps.step, guide_clear=guide))


def step_unassured() -> Callable[..., Any]:
    """`step_on` that sends every wish."""
    return step_with(exchanged(guide_clear, assured=as_wished))


def step_printed() -> Callable[..., Any]:
    """`step_on` by the paper's law."""
    return step_with(guide_printed)


@compiled
def as_wished(
    state: FlightState,
    wish: Wish,
    hazards: Hazards,
    watch: Watch,
    law: Law,
    before: float,
    room: float,
    guard: GuardState,
) -> Wish:
    """The wish, in the place of `assured`."""
    return wish


@compiled
def guide_printed(
    state: FlightState,
    flown_in: FlightState,
    target: Target,
    law: Law,
    memory: Memory,
    watch: Watch,
    guard: GuardState,
    detour: DetourState,
) -> tuple[RateSetpoint, Memory, Wish]:
    """One step of the paper's law among what is known; takes what `guide_clear` does.

    After the last goal, of which the paper says nothing, the circle is flown.
    """
    aircraft, gains = unpacked(law)
    if target.circle != 0.0:
        wish, planned = plan_flight(flown_in, target, aircraft, gains, memory, detour, math.inf)
    else:
        hazards = in_sight(watch.hazards, guard, state.p_n, watch.time)
        wish, planned = printed_wish(state, target, law, memory, hazards, watch.time)
    setpoint, after = fly_wish(flown_in, wish, aircraft, gains, planned)
    return limit_setpoint(setpoint, aircraft), after, wish


@compiled
def printed_wish(
    state: FlightState, target: Target, law: Law, memory: Memory, hazards: Hazards, t: float
) -> tuple[Wish, Memory]:
    """The bank and the path angle that follow the paper's field at the state."""
    aircraft, gains = unpacked(law)
    course, turning, climb = printed_direction(state, target, hazards, t)
    air, m = sub(state.v_n, state.wind_n), memory
    speed = max(state.airspeed, 0.5 * aircraft.airspeed_min)
    flown = path_of(air, speed)
    wind = (state.wind_n[0], state.wind_n[1])
    heading = heading_for_course(course, turning, wind, speed * math.cos(flown))
    slope = math.tan(climb)
    limits = path_limits(norm(air), gains.airspeed, math.inf, aircraft)
    bank_max = usable_bank(aircraft, gains, speed)
    lift, side = plan_turn(
        heading, azimuth_of(air), flown, speed, bank_max, aircraft, gains, m.turning
    )
    asked = path_angle(slope, heading.groundspeed, state.wind_n[2], speed)
    gamma, thrust_climb = allowed_path(asked, limits)
    wish = Wish(
        course,
        heading.psi,
        gamma,
        thrust_climb,
        lift.bank,
        lift.load,
        norm(sub(target.p_n, state.p_n)),
        m.leg.phase,
        m.leg.radius,
    )
    return wish, Memory(
        m.time, m.leg, slope, side, m.R_na, m.omega_a, m.thrust_integral, m.alpha_bias
    )


@compiled
def printed_direction(
    state: FlightState, target: Target, hazards: Hazards, t: float
) -> tuple[float, float, float]:
    """Course of the composite field, how fast it turns [rad/s], and its climb [rad]."""
    goal = goal_frame(target.p_n, target.course, math.atan(target.slope))
    p = Dual3(state.p_n, state.v_n)
    free = free_field(goal, p)
    chi = np.empty(len(hazards.obstacles))
    by = deflect_by_obstacles(no_deflection(), free, p, t, hazards.obstacles, chi)
    for row in hazards.traffic:
        intruder = read_intruder(row)
        spacing = Spacing(0.5 * intruder.radius, SIGHT)
        by = deflect_by_robot(by, free, p, robot_at(intruder, t), spacing)
    F = avoidance_field(free, by)
    x, y, z = F.value
    flat = x * x + y * y
    if flat == 0.0:
        return math.atan2(state.v_n[1], state.v_n[0]), 0.0, 0.0
    turning = (x * F.rate[1] - y * F.rate[0]) / flat
    climb = max(-STEEPEST, min(STEEPEST, math.atan2(-z, math.sqrt(flat))))
    return math.atan2(y, x), max(-FASTEST, min(FASTEST, turning)), climb


@compiled
def robot_at(intruder: Intruder, t: float) -> Robot:
    """An intruder at time `t` [s] as the paper's field takes a robot."""
    way = scale(t - intruder.time, intruder.v_n)
    return Robot(add(intruder.p_n, way), intruder.v_n)
