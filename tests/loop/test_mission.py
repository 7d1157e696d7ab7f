"""Goals in their order: passed, reached, missed, and the circle after the last one."""

import math
from typing import NamedTuple

import pytest
from flight_states import VEHICLE
from loop_legs import GOALS, LEGS

from vfguide.aircraft.state import FlightState
from vfguide.estimation.estimation import known_state
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG
from vfguide.kernels.rows import row_of
from vfguide.loop import mission
from vfguide.loop.attempts import Attempts, no_attempts
from vfguide.loop.legs import goal_of, leg_rows, target_of
from vfguide.loop.mission import NO_PASSAGE, MissionState, fresh_mission, passage_of, passage_since
from vfguide.paths.leg import FIELD, ON_PATH
from vfguide.planning import planning
from vfguide.planning.excess_wind import WindHold, in_air_frame, into_wind
from vfguide.planning.route import fresh_route

STUBBORN = leg_rows([goal._replace(attempts=2) for goal in GOALS], -1.0, 120.0)


def state(p_n, course=0.0, climb=0.0, time=1.0):
    v_n = (
        25.0 * math.cos(climb) * math.cos(course),
        25.0 * math.cos(climb) * math.sin(course),
        -25.0 * math.sin(climb),
    )
    return FlightState(time, p_n, v_n, from_euler(0.0, 0.05, course), 25.0, (0.0, 0.0, 0.0))


class Passed(NamedTuple):
    """What a step made of a goal that was passed."""

    goal: int
    begins: bool
    attempts: Attempts


def moved(before, after):
    """What is known at the second of two steps."""
    nav = known_state(after, before.time)
    return nav._replace(is_continuous=True, p_n_before=before.p_n, v_n_before=before.v_n)


def passing(offset, course=0.0, climb=0.0):
    """The vehicle when it has passed the first goal at some offset to the side."""
    before = state((-0.3, offset, -150.0), course, climb)
    return moved(before, state((0.2, offset, -150.0), course, climb, time=1.02))


def passed(offset, course=0.0, climb=0.0, phase=FIELD, legs=LEGS, missed=0):
    s = fresh_mission()._replace(attempts=Attempts(missed, 0))
    goal, after, _ = mission.update(passing(offset, course, climb), s, phase, legs, VEHICLE)
    assert goal.is_goal
    assert goal.target == target_of(legs, after.goal)
    return Passed(after.goal, goal.begins, after.attempts)


def test_a_goal_that_is_reached_gives_way_to_the_next():
    assert passed(4.9) == (1, True, no_attempts())
    assert passed(0.0, course=9.0 * DEG, climb=9.0 * DEG).goal == 1


@pytest.mark.parametrize(
    "how", [{"offset": 5.1}, {"offset": 0.0, "course": 11.0 * DEG}, {"offset": 0.0, "climb": 0.2}]
)
def test_a_goal_that_is_missed_is_flown_to_again(how):
    missed = passed(**how)
    assert (missed.goal, missed.begins) == (0, True)
    on_the_way = passed(**how, phase=ON_PATH)
    assert (on_the_way.goal, on_the_way.begins) == (0, False)


@pytest.mark.parametrize("offset", [4.9, 5.1])
def test_a_leg_that_begins_is_planned_anew(offset):
    """Whatever was flown before."""
    nav = passing(offset)
    goal, _, _ = mission.update(nav, fresh_mission(), FIELD, LEGS, VEHICLE)

    def planned(begins, before):
        objective = goal._replace(begins=begins)
        return planning.update(nav, objective, None, True, before, 0.0, VEHICLE)

    anew = planned(False, fresh_route())
    worn = anew._replace(leg=anew.leg._replace(final_approach=anew.leg.final_approach + 30.0))
    assert row_of(planned(goal.begins, worn)).tolist() == row_of(anew).tolist()
    assert row_of(planned(False, worn)).tolist() != row_of(anew).tolist()


def test_a_goal_is_given_up_when_it_was_missed_as_often_as_it_may_be():
    first = passed(5.1, legs=STUBBORN)
    assert (first.goal, first.attempts) == (0, Attempts(1, 0))
    second = passed(5.1, legs=STUBBORN, missed=1)
    assert second == (1, True, Attempts(0, 1))
    assert passed(4.9, legs=STUBBORN, missed=1).attempts == no_attempts()
    without_end = passed(5.1, missed=1000)
    assert (without_end.goal, without_end.attempts) == (0, Attempts(1001, 0))
    on_the_way = passed(5.1, phase=ON_PATH, legs=STUBBORN, missed=1)
    assert (on_the_way.goal, on_the_way.attempts) == (0, Attempts(1, 0))


def test_far_from_the_goal_nothing_is_missed():
    assert passed(49.0).attempts == Attempts(1, 0)
    assert passed(51.0) == (0, False, no_attempts())


@pytest.mark.parametrize("known", [{"is_settled": False}, {"is_continuous": False}])
def test_no_goal_is_passed_by_a_jump_or_in_a_pause(known):
    nav = passing(0.0)._replace(**known)
    goal, after, passage = mission.update(nav, fresh_mission(), FIELD, LEGS, VEHICLE)
    assert (goal.begins, passage) == (False, NO_PASSAGE)
    assert (after.goal, after.attempts) == (0, no_attempts())


def blown(speed, held, offset=0.0):
    """What is flown to when the first goal is passed in a wind, `held` against before or not."""
    nav, wind_n = passing(offset), (0.0, speed, 0.0)
    nav = nav._replace(state=nav.state._replace(wind_n=wind_n))
    before = MissionState(0, Attempts(1, 0), WindHold(speed / 25.0, held, -120.0))
    goal, after, passage = mission.update(nav, before, FIELD, LEGS, VEHICLE)
    return nav, goal, after, passage


@pytest.mark.parametrize("held", [False, True])
def test_a_wind_that_is_too_strong_is_held_against_and_no_goal_is_passed(held):
    nav, goal, after, passage = blown(30.0, held)
    assert after.wind_hold.holds
    assert (after.goal, after.attempts, passage) == (0, Attempts(1, 0), NO_PASSAGE)
    assert (goal.is_goal, goal.begins) == (False, False)
    assert goal.target == into_wind(after.wind_hold, nav.state)
    assert goal.state == in_air_frame(nav.state)


def test_when_the_wind_has_fallen_the_leg_begins_anew():
    nav, goal, after, passage = blown(10.0, True, offset=60.0)
    assert not after.wind_hold.holds
    assert (goal.is_goal, goal.begins) == (True, True)
    assert (goal.target, goal.state) == (target_of(LEGS, 0), nav.state)
    assert (after.goal, after.attempts, passage) == (0, Attempts(1, 0), NO_PASSAGE)


def test_a_goal_that_is_reached_on_the_way_counts():
    assert passed(4.9, phase=ON_PATH).goal == 1


def between(before, after):
    return passage_of(GOALS[0], (before.p_n, before.v_n), (after.p_n, after.v_n))


def test_a_pass_is_where_the_distance_was_least():
    before, after = state((-0.3, 1.0, -150.0)), state((0.2, 1.0, -150.0))
    beyond, far_before = state((0.7, 1.0, -150.0)), state((-0.9, 1.0, -150.0))
    assert between(before, after) == pytest.approx((1.0, 0.0))
    assert between(after, beyond).miss == math.inf
    assert between(far_before, before).miss == math.inf


def test_after_the_last_goal_the_circle_touches_it():
    target = target_of(LEGS, 2)
    assert target.p_n == GOALS[1].p_n
    assert target.course == GOALS[1].course
    assert (target.circle, target.radius) == (-1.0, 120.0)


def test_the_rows_hold_the_goals():
    assert [goal_of(LEGS, k) for k in range(3)] == [*GOALS, GOALS[1]]
    assert goal_of(STUBBORN, 1).attempts == 2


def test_after_the_last_goal_nothing_is_passed():
    nav = moved(state((499.7, 100.0, -160.0)), state((500.2, 100.0, -160.0), time=1.02))
    assert passage_since(nav, 2, FIELD, LEGS).miss == math.inf
    goal, after, passage = mission.update(
        nav, fresh_mission()._replace(goal=2), FIELD, LEGS, VEHICLE
    )
    assert (after.goal, passage, goal.begins, goal.is_goal) == (2, NO_PASSAGE, False, False)
    assert goal.target == target_of(LEGS, 2)
