"""Goals in their order: passed, reached, missed, and the circle after the last one."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from vfguide.loop.legs import Goal, goal_of, leg_rows, target_of
from vfguide.companion.notes import passage_note
from vfguide.estimation.place import place_state
from vfguide.companion.route_memory import (
    ALARMED,
    HOLDS,
    SENSOR_TRUSTED,
    begin_leg,
    fresh_route,
    packed_memory,
    unpacked_memory,
)
from vfguide.companion.step import note_passage, passage_of, passage_since, step, step_on
from vfguide.loop.attempts import Tries, no_tries
from vfguide.flight.leg import FIELD, WAY, new_leg
from vfguide.flight.outlines import NO_FENCE
from vfguide.flight.performance import Gains, packed
from vfguide.flight.state import FlightState
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG
from vfguide.scenario.aircraft_file import load_aircraft
from vfguide.scenario.data import find_aircraft

GOALS = (
    Goal((0.0, 0.0, -150.0), 0.0, 0.0, 5.0, 10.0 * DEG),
    Goal((500.0, 100.0, -160.0), 0.5 * math.pi, 3.0 * DEG, 5.0, 10.0 * DEG),
)
LEGS = leg_rows(GOALS, -1.0, 120.0)
STUBBORN = leg_rows([goal._replace(attempts=2) for goal in GOALS], -1.0, 120.0)
LAW = packed(load_aircraft(find_aircraft("aerosonde")).performance(), Gains(25.0))


def state(p_n, course=0.0, climb=0.0, time=1.0):
    v_n = (
        25.0 * math.cos(climb) * math.cos(course),
        25.0 * math.cos(climb) * math.sin(course),
        -25.0 * math.sin(climb),
    )
    return FlightState(time, p_n, v_n, from_euler(0.0, 0.05, course), 25.0, (0.0, 0.0, 0.0))


def passed(offset, course=0.0, climb=0.0, phase=FIELD, legs=LEGS, missed=0):
    """The memory after passing the first goal at some offset to the side."""
    before = state((-0.3, offset, -150.0), course, climb)
    after = state((0.2, offset, -150.0), course, climb, time=1.02)
    flight = fresh_route().flight._replace(leg=new_leg()._replace(phase=phase))
    memory = fresh_route()._replace(begun=True, p_n=before.p_n, v_n=before.v_n, flight=flight)
    memory = memory._replace(tries=Tries(missed, 0))
    return note_passage(passage_since(memory, after, legs), legs, memory)


def test_a_goal_that_is_reached_gives_way_to_the_next():
    assert passed(4.9).goal == 1
    assert passed(0.0, course=9.0 * DEG, climb=9.0 * DEG).goal == 1


@pytest.mark.parametrize(
    "how", [{"offset": 5.1}, {"offset": 0.0, "course": 11.0 * DEG}, {"offset": 0.0, "climb": 0.2}]
)
def test_a_goal_that_is_missed_is_flown_to_again(how):
    memory = passed(**how)
    assert memory.goal == 0
    assert not memory.begun
    assert memory.flight.leg == fresh_route().flight.leg
    on_the_way = passed(**how, phase=WAY)
    assert (on_the_way.goal, on_the_way.begun) == (0, True)


def test_a_goal_is_given_up_when_it_was_missed_as_often_as_it_may_be():
    first = passed(5.1, legs=STUBBORN)
    assert (first.goal, first.tries) == (0, Tries(1, 0))
    second = passed(5.1, legs=STUBBORN, missed=1)
    assert (second.goal, second.begun, second.tries) == (1, False, Tries(0, 1))
    assert passed(4.9, legs=STUBBORN, missed=1).tries == no_tries()
    without_end = passed(5.1, missed=1000)
    assert (without_end.goal, without_end.tries) == (0, Tries(1001, 0))
    on_the_way = passed(5.1, phase=WAY, legs=STUBBORN, missed=1)
    assert (on_the_way.goal, on_the_way.tries) == (0, Tries(1, 0))


def test_far_from_the_goal_nothing_is_missed():
    assert passed(49.0).tries == Tries(1, 0)
    far = passed(51.0)
    assert (far.goal, far.begun, far.tries) == (0, True, no_tries())


def note(goal_before, missed, goal_after, given_up):
    """What is told where a goal was passed 5.1 m off."""
    before = fresh_route()._replace(goal=goal_before, tries=Tries(missed, 0))
    after = fresh_route()._replace(goal=goal_after, tries=Tries(0, given_up))
    plan = SimpleNamespace(goals=GOALS)
    return passage_note(packed_memory(before), packed_memory(after), 5.1, plan)


def test_the_operator_is_told_what_became_of_a_goal():
    assert note(0, 2, 1, 1) == "goal 1 missed 3 times: going on to goal 2"
    assert note(1, 0, 2, 1) == "goal 2 missed once: loitering"
    assert note(0, 1, 0, 0) == "goal 1 missed by 5.1 m or by its course: going round"
    assert note(0, 1, 1, 0) == "goal 1 reached, 5.1 m off; flying to goal 2 of 2"


def test_a_goal_that_is_reached_on_the_way_counts():
    assert passed(4.9, phase=WAY).goal == 1


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


def test_a_step_remembers_its_state():
    here = state((-400.0, 30.0, -140.0))
    _, memory, wish, passage = step(here, LEGS, LAW, fresh_route(), None, NO_FENCE, 0.0)
    assert (memory.p_n, memory.v_n, memory.begun) == (here.p_n, here.v_n, True)
    assert memory.goal == 0
    assert wish.remaining > 390.0
    assert passage.miss == math.inf


def test_after_the_last_goal_nothing_is_passed():
    before, after = state((499.7, 100.0, -160.0)), state((500.2, 100.0, -160.0))
    on_circle = begin_leg(2, no_tries(), fresh_route())._replace(begun=True, p_n=before.p_n)
    assert passage_since(on_circle, after, LEGS).miss == math.inf


def test_a_memory_packs_every_number_in_its_own_place():
    count = len(packed_memory(fresh_route()))
    numbers = np.arange(2.0, 2.0 + count)
    numbers[[1, HOLDS, ALARMED, SENSOR_TRUSTED]] = 1.0  # truth values
    assert (packed_memory(unpacked_memory(numbers)) == numbers).all()


def test_the_step_for_a_link_is_the_step():
    origin = (0.8, 0.1, 400.0)
    heard = (
        1.0,
        (0.8001, 0.1, 380.0),
        (-900.0, 20.0, -130.0),
        (24.0, 3.0, -1.0),
        0.02,
        (0.9, 0.1, 0.05, 0.1),
        23.0,
        510.0,
        (2.0, -1.0, 0.0),
        (0.1, 0.2, -0.1),
        0.05,
    )
    memory = fresh_route()
    clear = (None, NO_FENCE, 0.0)
    setpoint, after, _, passage = step(place_state(heard, origin), LEGS, LAW, memory, *clear)
    omega_b, thrust, q_nb, packed_after, miss = step_on(
        heard, origin, LEGS, LAW, packed_memory(memory), *clear
    )
    assert (omega_b, thrust, q_nb) == setpoint
    assert (packed_after == packed_memory(after)).all()
    assert miss == passage.miss
