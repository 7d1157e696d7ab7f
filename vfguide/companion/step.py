"""The one step that the aircraft, the simulation and the replay share.

`step(state, plan, memory) -> (setpoint, memory, wish)`: no clock, no socket, no log.
"""

import math
from typing import NamedTuple

from vfguide.companion.plan import Goal, Plan
from vfguide.flight.memory import Memory, Target, Wish, fresh_memory
from vfguide.flight.state import FlightState, RateSetpoint
from vfguide.geometry.angles import wrap
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3, dot, norm, scale, sub
from vfguide.safety.limits import guide_within_limits

GATE = 200.0
"""A goal is passed only closer than this [m]; farther away it is not yet approached."""


class RouteMemory(NamedTuple):
    """What one step leaves for the next."""

    goal: int
    """Index of the goal that is flown to; the number of goals: all are reached."""
    before: FlightState | None
    """State of the last step on this leg."""
    flight: Memory


def fresh_route() -> RouteMemory:
    """Memory of a vehicle that has not begun."""
    return RouteMemory(0, None, fresh_memory())


def step(
    state: FlightState, plan: Plan, memory: RouteMemory
) -> tuple[RateSetpoint, RouteMemory, Wish]:
    """The setpoint for this state, within the limits of the aircraft."""
    memory = note_pass(state, plan, memory)
    target = target_of(plan, memory.goal)
    setpoint, flight, wish = guide_within_limits(state, target, plan.law, memory.flight)
    return setpoint, RouteMemory(memory.goal, state, flight), wish


def target_of(plan: Plan, index: int) -> Target:
    """The goal of this index; after the last one the circle that leaves the last one."""
    if index < len(plan.goals):
        goal = plan.goals[index]
        return Target(goal.p_n, goal.course, math.tan(goal.climb), 0.0, 0.0)
    goal = plan.goals[-1]
    return Target(goal.p_n, goal.course, 0.0, plan.loiter_side, plan.loiter_radius)


def note_pass(state: FlightState, plan: Plan, memory: RouteMemory) -> RouteMemory:
    """Go on to the next goal when this one was reached, begin the leg anew when it was missed."""
    before = memory.before
    if before is None or memory.goal == len(plan.goals):
        return memory
    goal = plan.goals[memory.goal]
    miss, angle = pass_of(before, state, goal)
    if miss > GATE:
        return memory
    reached = miss <= goal.tolerance and angle <= goal.tolerance_angle
    index = memory.goal + 1 if reached else memory.goal
    return RouteMemory(index, None, memory.flight._replace(leg=fresh_memory().leg))


def pass_of(before: FlightState, after: FlightState, goal: Goal) -> tuple[float, float]:
    """Miss [m] and angle [rad] of a pass of the goal between two states, see `passing`."""
    way = Way(before.p_n, before.v_n, after.p_n, after.v_n)
    return passing(way, goal.p_n, goal.course, goal.climb)


class Way(NamedTuple):
    """Position [m] and ground velocity [m/s] at two instants."""

    p_before: Vec3
    v_before: Vec3
    p_after: Vec3
    v_after: Vec3


@compiled
def passing(way: Way, p_n: Vec3, course: float, climb: float) -> tuple[float, float]:
    """How a pose was passed on the way: the miss [m], and the larger error of course and climb.

    The miss is where the distance was least, the angles are those of the ground velocity [rad].
    It is infinite where the pose was not passed.
    """
    opening = dot(sub(way.p_after, p_n), way.v_after)
    if not (dot(sub(way.p_before, p_n), way.v_before) < 0.0 <= opening):
        return math.inf, math.inf
    late = opening / max(dot(way.v_after, way.v_after), 1e-6)
    north, east, down = way.v_after
    course_error = wrap(math.atan2(east, north) - course)
    climb_error = math.atan2(-down, math.hypot(north, east)) - climb
    miss = norm(sub(sub(way.p_after, p_n), scale(late, way.v_after)))
    return miss, max(abs(course_error), abs(climb_error))
