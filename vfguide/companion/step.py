"""The one step that the aircraft, the simulation and the replay share.

`step(state, plan, memory) -> (setpoint, memory, wish)`: no clock, no socket, no log.
"""

import math
from typing import NamedTuple

from vfguide.companion.plan import Goal, Plan
from vfguide.flight.memory import Memory, Target, Wish, fresh_memory, next_leg
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
    setpoint, flight, wish = guide_within_limits(
        state, target, plan.aircraft, plan.gains, memory.flight
    )
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
    miss = passing(before, state, goal.p_n)
    if miss is None or norm(miss) > GATE:
        return memory
    reached = norm(miss) <= goal.tolerance and within_angles(state, goal)
    index = memory.goal + 1 if reached else memory.goal
    return RouteMemory(index, None, next_leg(memory.flight))


def passing(before: FlightState, after: FlightState, p_n: Vec3) -> Vec3 | None:
    """Offset from `p_n` where the distance to it was least between two states, if it was [m]."""
    if not (approach(before.p_n, before.v_n, p_n) < 0.0 <= approach(after.p_n, after.v_n, p_n)):
        return None
    opening = approach(after.p_n, after.v_n, p_n)
    late = opening / max(dot(after.v_n, after.v_n), 1e-6)
    return sub(sub(after.p_n, p_n), scale(late, after.v_n))


@compiled
def approach(p_n: Vec3, v_n: Vec3, goal_n: Vec3) -> float:
    """Half the rate of the squared distance to `goal_n`: negative on approach [m^2/s]."""
    return dot(sub(p_n, goal_n), v_n)


def within_angles(state: FlightState, goal: Goal) -> bool:
    """Whether the ground velocity has the goal's course and climb."""
    north, east, down = state.v_n
    course_error = wrap(math.atan2(east, north) - goal.course)
    climb_error = math.atan2(-down, math.hypot(north, east)) - goal.climb
    return max(abs(course_error), abs(climb_error)) <= goal.tolerance_angle
