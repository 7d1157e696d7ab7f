"""Goals in their order: passed, reached, missed, and the circle after the last one."""

import math

import pytest

from vfguide.companion.plan import Goal, Plan
from vfguide.companion.step import fresh_route, note_pass, pass_of, step, target_of
from vfguide.flight.performance import Gains
from vfguide.flight.state import FlightState
from vfguide.geometry.geodesy import tangent_plane
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG
from vfguide.scenario.aircraft_file import load_aircraft
from vfguide.scenario.data import find_aircraft

FRAME = tangent_plane(0.8, 0.1, 400.0)
GOALS = (
    Goal((0.0, 0.0, -150.0), 0.0, 0.0, 5.0, 10.0 * DEG),
    Goal((500.0, 100.0, -160.0), 0.5 * math.pi, 3.0 * DEG, 5.0, 10.0 * DEG),
)
PLAN = Plan(
    FRAME,
    GOALS,
    -1.0,
    120.0,
    50.0,
    load_aircraft(find_aircraft("aerosonde")).performance(),
    Gains(25.0),
)


def state(p_n, course=0.0, climb=0.0, time=1.0):
    v_n = (
        25.0 * math.cos(climb) * math.cos(course),
        25.0 * math.cos(climb) * math.sin(course),
        -25.0 * math.sin(climb),
    )
    return FlightState(time, p_n, v_n, from_euler(0.0, 0.05, course), 25.0, (0.0, 0.0, 0.0))


def passed(offset, course=0.0, climb=0.0):
    """The memory after passing the first goal at some offset to the side."""
    before = state((-0.3, offset, -150.0), course, climb)
    after = state((0.2, offset, -150.0), course, climb, time=1.02)
    memory = fresh_route()._replace(before=before)
    return note_pass(after, PLAN, memory)


def test_a_goal_that_is_reached_gives_way_to_the_next():
    assert passed(4.9).goal == 1
    assert passed(0.0, course=9.0 * DEG, climb=9.0 * DEG).goal == 1


@pytest.mark.parametrize(
    "how", [{"offset": 5.1}, {"offset": 0.0, "course": 11.0 * DEG}, {"offset": 0.0, "climb": 0.2}]
)
def test_a_goal_that_is_missed_is_flown_to_again(how):
    memory = passed(**how)
    assert memory.goal == 0
    assert memory.before is None
    assert memory.flight.leg == fresh_route().flight.leg


def test_a_pass_is_where_the_distance_was_least():
    before, after = state((-0.3, 1.0, -150.0)), state((0.2, 1.0, -150.0))
    assert pass_of(before, after, GOALS[0]) == pytest.approx((1.0, 0.0))
    assert pass_of(after, state((0.7, 1.0, -150.0)), GOALS[0])[0] == math.inf
    assert pass_of(state((-0.9, 1.0, -150.0)), before, GOALS[0])[0] == math.inf


def test_after_the_last_goal_the_circle_touches_it():
    target = target_of(PLAN, 2)
    assert target.p_n == GOALS[1].p_n
    assert target.course == GOALS[1].course
    assert (target.circle, target.radius) == (-1.0, 120.0)


def test_a_step_remembers_its_state():
    here = state((-400.0, 30.0, -140.0))
    _, memory, wish = step(here, PLAN, fresh_route())
    assert memory.before == here
    assert memory.goal == 0
    assert wish.remaining > 390.0
