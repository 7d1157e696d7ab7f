"""The leg to a goal: which phase is flown where, and what is kept."""

import math

import pytest
from closed_loop import GAINS
from hypothesis import assume, given
from hypothesis import strategies as st

from vfguide.flight.approach import Planar
from vfguide.flight.planner import (
    CIRCLE,
    FIELD,
    GAIN_HEIGHT,
    NEW,
    SWITCH_GAIN,
    Leg,
    choose_side,
    circle_here,
    circle_length,
    fly_leg,
    keep_radius,
    leg_course,
    new_leg,
    turn_radius,
)
from vfguide.geometry.units import DEG, G0

RADIUS, SPEED = 80.0, 25.0
FINAL = GAINS.final * RADIUS
PLACE = st.floats(-600.0, 600.0)
COURSE = st.floats(-math.pi, math.pi)
SIDE = st.sampled_from([1.0, -1.0])


def at(x, y, course=0.0):
    return Planar(x, y, SPEED * math.cos(course), SPEED * math.sin(course))


def leg(phase=NEW, side=1.0, radius=RADIUS):
    return Leg(phase, side, 0.0, 0.0, radius)


@given(PLACE, PLACE, COURSE, st.sampled_from([NEW, FIELD, CIRCLE, GAIN_HEIGHT]), SIDE)
def test_every_leg_leads_on(x, y, course, phase, side):
    for climb_needed in (0.0, 500.0):
        after = fly_leg(leg(phase, side), at(x, y, course), climb_needed, GAINS)
        wanted = leg_course(after, at(x, y, course), GAINS)
        assert after.phase in (FIELD, CIRCLE, GAIN_HEIGHT)
        assert after.radius == RADIUS
        assert math.isfinite(wanted.chi)
        assert wanted.remaining >= min(0.0, -x) - 1e-9


@given(st.floats(-1200.0, -300.0), st.floats(-0.5, 0.5))
def test_far_before_the_goal_on_its_course_the_field_is_flown(x, share):
    y = share * x
    after = fly_leg(leg(), at(x, y, 2.0 * math.atan2(-y, -x)), 0.0, GAINS)
    assert after.phase == FIELD


@given(st.floats(0.0, 1000.0), st.floats(-300.0, 300.0), COURSE)
def test_from_beyond_the_goal_a_circle_is_flown(x, y, course):
    assert fly_leg(leg(), at(x + 1.0, y, course), 0.0, GAINS).phase == CIRCLE


@given(st.floats(-0.99 * FINAL, -0.01), st.floats(-0.7, 0.7), st.floats(-0.04, 0.04))
def test_on_the_straight_end_it_goes_straight_on(x, y, course):
    after = fly_leg(leg(), at(x, y, course), 0.0, GAINS)
    assert after.phase == FIELD
    assert abs(leg_course(after, at(x, y, course), GAINS).chi) < 0.1


@pytest.mark.parametrize("where", [(-20.0, 1.5, 0.0), (-20.0, 0.0, 0.1), (0.5, 0.0, 0.0)])
def test_beside_the_straight_end_or_behind_it_a_new_approach_is_flown(where):
    assert fly_leg(leg(), at(*where), 0.0, GAINS).phase == CIRCLE


@given(PLACE, PLACE, COURSE, SIDE)
def test_the_other_goal_circle_is_taken_only_when_it_saves_enough(x, y, course, side):
    here = at(x, y, course)
    own, other = (circle_length(here, course, each, RADIUS) for each in (side, -side))
    assume(abs(own - other - SWITCH_GAIN * RADIUS) > 1e-6 and abs(own - other) > 1e-6)
    changed = choose_side(leg(CIRCLE, side), here, course) == -side
    assert changed == (own - other > SWITCH_GAIN * RADIUS)
    assert choose_side(leg(), here, course) == (side if own < other else -side)


@given(PLACE, PLACE, COURSE, SIDE)
def test_a_circle_for_height_touches_the_present_path(x, y, course, side):
    found = circle_here(leg(CIRCLE, side), at(x, y, course))
    assert found.phase == GAIN_HEIGHT
    to_centre = (found.x - x, found.y - y)
    assert math.hypot(*to_centre) == pytest.approx(RADIUS)
    ahead = (math.cos(course), math.sin(course))
    assert ahead[0] * to_centre[1] - ahead[1] * to_centre[0] == pytest.approx(side * RADIUS)
    wanted = leg_course(found, at(x, y, course), GAINS)
    assert wanted.chi_rate == pytest.approx(side * SPEED / RADIUS)


def test_height_is_flown_off_before_the_goal_and_not_close_to_it():
    far, close = at(-300.0, 0.0), at(-100.0, 0.0)
    assert fly_leg(leg(FIELD), far, 310.0, GAINS).phase == GAIN_HEIGHT
    assert fly_leg(leg(FIELD), far, 290.0, GAINS).phase == FIELD
    assert fly_leg(leg(FIELD), close, 310.0, GAINS).phase == FIELD
    assert fly_leg(leg(NEW), close, 310.0, GAINS).phase == GAIN_HEIGHT


def test_a_circle_for_height_is_left_with_a_margin_so_that_it_is_not_begun_again_at_once():
    here = at(-300.0, 0.0)
    assert fly_leg(leg(GAIN_HEIGHT), here, 280.0, GAINS).phase == GAIN_HEIGHT
    left = fly_leg(leg(GAIN_HEIGHT), here, 260.0, GAINS)
    assert left.phase == FIELD
    assert fly_leg(left, here, 260.0, GAINS).phase == FIELD


@pytest.mark.parametrize(
    ("radius", "kept"), [(84.0, True), (69.0, True), (85.0, False), (67.0, False)]
)
def test_the_radius_changes_only_for_a_reason(radius, kept):
    assert keep_radius(leg(FIELD), radius) == leg(FIELD, radius=RADIUS if kept else radius)


def test_a_new_leg_takes_the_radius_that_is_flyable():
    assert keep_radius(new_leg(), 66.0) == new_leg()._replace(radius=66.0)


@pytest.mark.parametrize("bank", [20.0, 50.0])
def test_the_radius_is_that_of_a_turn_down_wind_with_a_margin(bank):
    turn = turn_radius(25.0, 5.0, bank * DEG, 1.25)
    lateral = 30.0**2 / (turn / 1.25)
    assert math.atan(lateral / G0) == pytest.approx(bank * DEG)
