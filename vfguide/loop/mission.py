"""The stage of the mission: the present goal, and when the next one follows."""

import math
from typing import NamedTuple

from vfguide.aircraft.vehicle import Vehicle
from vfguide.estimation.estimation import NavState
from vfguide.geometry.angles import wrap
from vfguide.geometry.vector import Vec3, dot, norm, scale, sub
from vfguide.geometry.velocity import azimuth_of, horizontal_norm
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import replacing
from vfguide.loop.attempts import ATTEMPT_MISS, Attempts, at_next, gives_up, no_attempts, once_more
from vfguide.loop.legs import Goal, Legs, goal_of, target_of
from vfguide.paths.leg import FIELD
from vfguide.planning.excess_wind import (
    WindHold,
    fresh_wind_hold,
    in_air_frame,
    into_wind,
    update_wind_hold,
)
from vfguide.planning.objective import Objective


class Passage(NamedTuple):
    """How a goal was passed between two steps; infinite where it was not."""

    miss: float
    """Least distance from the goal [m]."""
    angle: float
    """The larger error of course and climb of the ground velocity [rad]."""


NO_PASSAGE = Passage(math.inf, math.inf)
"""The passage where no goal was passed, infinite [m, rad]."""


class MissionState(NamedTuple):
    """What the mission keeps from one step to the next."""

    goal: int
    """Index of the present goal; the number of goals after the last one."""
    attempts: Attempts
    wind_hold: WindHold


with_wind_hold = replacing(MissionState, "wind_hold")


@compiled
def fresh_mission() -> MissionState:
    """The mission before its first step."""
    return MissionState(0, no_attempts(), fresh_wind_hold())


@compiled
def update(
    nav: NavState, s: MissionState, phase: int, legs: Legs, vehicle: Vehicle
) -> tuple[Objective, MissionState, Passage]:
    """The objective, the next state of the mission, and the passage of the goal before.

    Args:
        nav: state of the vehicle.
        s: state of the mission at the step before.
        phase: phase of the leg at the step before.
        legs: legs of the mission.
        vehicle: its airspeed to fly.
    """
    since = nav.elapsed if nav.is_continuous else 0.0
    hold = update_wind_hold(s.wind_hold, nav.state, vehicle.gains.airspeed, since)
    passage = passage_since(nav, s.goal, phase, legs)
    if hold.holds or not nav.is_settled:
        passage = NO_PASSAGE
    after = with_wind_hold(note_passage(passage, legs, s), hold)
    begins = not math.isinf(passage.miss) or (s.wind_hold.holds and not hold.holds)
    if hold.holds:
        target, state = into_wind(hold, nav.state), in_air_frame(nav.state)
    else:
        target, state = target_of(legs, after.goal), nav.state
    is_goal = not hold.holds and after.goal < len(legs) - 1
    return Objective(target, state, begins, is_goal), after, passage


@compiled
def note_passage(passage: Passage, legs: Legs, s: MissionState) -> MissionState:
    """The mission after a passage: the next goal if this one was reached or is given up."""
    if math.isinf(passage.miss):
        return s
    goal = goal_of(legs, s.goal)
    if is_reached(passage, goal):
        return MissionState(s.goal + 1, at_next(s.attempts, False), s.wind_hold)
    attempts = once_more(s.attempts)
    if gives_up(attempts, goal):
        return MissionState(s.goal + 1, at_next(s.attempts, True), s.wind_hold)
    return MissionState(s.goal, attempts, s.wind_hold)


@compiled
def is_reached(passage: Passage, goal: Goal) -> bool:
    """Whether the goal counts as reached."""
    return passage.miss <= goal.tolerance and passage.angle <= goal.tolerance_angle


@compiled
def passage_since(nav: NavState, index: int, phase: int, legs: Legs) -> Passage:
    """The passage of the present goal since the step before.

    In another phase than FIELD, or far from the goal, a passage counts only if it reaches the goal.
    """
    if not nav.is_continuous or index == len(legs) - 1:
        return NO_PASSAGE
    goal, state = goal_of(legs, index), nav.state
    passage = passage_of(goal, (nav.p_n_before, nav.v_n_before), (state.p_n, state.v_n))
    is_attempt = phase == FIELD and passage.miss <= max(ATTEMPT_MISS, goal.tolerance)
    return passage if is_attempt or is_reached(passage, goal) else NO_PASSAGE


@compiled
def passage_of(goal: Goal, before: tuple[Vec3, Vec3], after: tuple[Vec3, Vec3]) -> Passage:
    """The passage of a goal between two instants, each a position [m] and a velocity [m/s]."""
    p_n, v_n = after
    p_before, v_before = before
    opening = dot(sub(p_n, goal.p_n), v_n)
    if not (dot(sub(p_before, goal.p_n), v_before) < 0.0 <= opening):
        return NO_PASSAGE
    late = opening / max(dot(v_n, v_n), 1e-6)
    course_error = wrap(azimuth_of(v_n) - goal.course)
    climb_error = math.atan2(-v_n[2], horizontal_norm(v_n)) - goal.climb
    miss = norm(sub(sub(p_n, goal.p_n), scale(late, v_n)))
    return Passage(miss, max(abs(course_error), abs(climb_error)))
