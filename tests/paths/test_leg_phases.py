"""The leg to a goal: which phase is flown where, and what is kept."""

import math

import pytest
from flight_states import GAINS
from hypothesis import assume, given
from hypothesis import strategies as st
from planar_states import at

from vfguide.aircraft.envelope import turn_radius
from vfguide.geometry.angles import FULL_TURN
from vfguide.geometry.units import DEG, G0
from vfguide.paths.dubins import is_hasty, length_of, shortest_path
from vfguide.paths.leg import FIELD, NEW, ON_PATH, OUTBOUND, keep_radius, new_leg
from vfguide.paths.leg_phases import BREAK_OFF, fly_leg, leg_course
from vfguide.paths.leg_start import (
    APPROACH_STEPS,
    HASTY_FINAL_APPROACH,
    LEAP,
    SHORTEST_FINAL_APPROACH,
    Paths,
    start_here,
)
from vfguide.paths.path_stretching import best_end, best_outbound

RADIUS = 80.0
FINAL, CORE = GAINS.final_approach * RADIUS, GAINS.core * RADIUS
PLACE = st.floats(-600.0, 600.0)
COURSE = st.floats(-math.pi, math.pi)


def leg(phase=NEW):
    return new_leg()._replace(phase=phase, radius=RADIUS, final_approach=FINAL)


def ahead(here, final_approach):
    """Where a way begins, seen from the beginning of the straight end."""
    return here.x + final_approach + 0.37 * here.vx, here.y + 0.37 * here.vy


def needing(path):
    """A change of height that takes so much path, and no faster descent."""
    return Paths(path, 1.0, path)


def begun(x, y, course=0.0, distance_for_altitude=0.0):
    return fly_leg(leg(), at(x, y, course), needing(distance_for_altitude), GAINS)


def begun_end(here, course):
    """The straight end of the shortest way, and that way from there; no end where it leaps."""
    final_approach, path = FINAL, shortest_path(*ahead(here, FINAL), course, RADIUS)
    ends = [max(FINAL, HASTY_FINAL_APPROACH * RADIUS) if is_hasty(path) else FINAL]
    brief = min(SHORTEST_FINAL_APPROACH * RADIUS, FINAL)
    ends += [ends[0] + (brief - ends[0]) * k / APPROACH_STEPS for k in range(1, APPROACH_STEPS + 1)]
    least = math.inf
    for end in ends:
        tried = shortest_path(*ahead(here, end), course, RADIUS)
        length = end + RADIUS * length_of(tried)
        if length < least - LEAP * RADIUS:
            final_approach, path, least = end, tried, length
    return final_approach, path


@given(PLACE, PLACE, COURSE, st.sampled_from([0.0, 300.0, 800.0, 5000.0]))
def test_every_leg_leads_on(x, y, course, distance_for_altitude):
    here, after = at(x, y, course), leg()
    for _ in range(3):
        after = fly_leg(after, here, needing(distance_for_altitude), GAINS)
        wanted = leg_course(after, here, CORE)
        assert after.phase in (FIELD, ON_PATH, OUTBOUND)
        assert after.radius == RADIUS
        assert math.isfinite(wanted.chi)
        assert wanted.remaining >= min(0.0, -x) - 1e-9


@given(st.floats(-1200.0, -400.0), st.floats(-0.4, 0.4))
def test_far_before_the_straight_end_on_its_course_the_field_is_flown(x, share):
    y = share * x
    assert begun(x - FINAL, y, 2.0 * math.atan2(-y, -x)).phase == FIELD


@given(st.floats(0.0, 1000.0), st.floats(-300.0, 300.0), COURSE)
def test_from_beyond_the_goal_a_way_is_flown(x, y, course):
    assert begun(x + 1.0, y, course).phase == ON_PATH


@given(st.floats(-0.99 * FINAL, -0.01), st.floats(-0.7, 0.7), st.floats(-0.04, 0.04))
def test_on_the_straight_end_it_goes_straight_on(x, y, course):
    after = begun(x, y, course)
    assert after.phase == FIELD
    assert abs(leg_course(after, at(x, y, course), CORE).chi) < 0.1


@pytest.mark.parametrize("where", [(-20.0, 1.5, 0.0), (-20.0, 0.0, 0.1), (0.5, 0.0, 0.0)])
def test_beside_the_straight_end_or_behind_it_a_new_approach_is_flown(where):
    assert begun(*where).phase == ON_PATH


def test_behind_the_goal_the_field_is_left():
    assert fly_leg(leg(FIELD), at(-0.5, 0.0), needing(0.0), GAINS).phase == FIELD
    assert fly_leg(leg(FIELD), at(0.5, 0.0), needing(0.0), GAINS).phase == ON_PATH


@given(PLACE, PLACE, COURSE)
def test_a_way_is_as_long_as_the_shortest_word(x, y, course):
    after = begun(x, y, course)
    assume(after.phase == ON_PATH)
    final_approach, path = begun_end(at(x, y, course), course)
    assert after.final_approach == pytest.approx(final_approach)
    shortest = RADIUS * length_of(path) + final_approach
    assert leg_course(after, at(x, y, course), CORE).remaining == pytest.approx(shortest)


def longest_way(x, y, course, distance_for_altitude):
    """The shortest way, or with circles and what is the shorter for the rest, where it lacks."""
    here = at(x, y, course)
    final_approach, path = begun_end(here, course)
    shortest = RADIUS * length_of(path)
    if shortest + final_approach >= distance_for_altitude:
        return shortest + final_approach
    circles = (
        math.floor((distance_for_altitude - final_approach - shortest) / (FULL_TURN * RADIUS))
        * FULL_TURN
        * RADIUS
    )
    begin, needed = (
        at(*ahead(here, final_approach), course),
        distance_for_altitude - final_approach - circles,
    )
    return (
        final_approach
        + circles
        + min(best(begin, RADIUS, needed)[1] for best in (best_end, best_outbound))
    )


@given(PLACE, PLACE, COURSE, st.floats(0.0, 6000.0))
def test_a_way_is_long_enough_for_the_height_or_the_vehicle_flies_away_first(
    x, y, course, distance_for_altitude
):
    after, here = begun(x, y, course, distance_for_altitude), at(x, y, course)
    remaining = leg_course(after, here, CORE).remaining
    if after.phase == OUTBOUND:
        begin = at(*ahead(here, after.final_approach), course)
        needed = distance_for_altitude - after.final_approach - after.circles * FULL_TURN * RADIUS
        chosen, length = best_outbound(begin, RADIUS, needed)
        assert after.outbound == chosen
        assert needed <= length < best_end(begin, RADIUS, needed)[1]
    elif after.phase == ON_PATH:
        assert remaining >= distance_for_altitude - 1e-6
        assert remaining <= longest_way(x, y, course, distance_for_altitude) + 1e-6
    else:
        assert remaining + 0.5 * RADIUS >= distance_for_altitude


def test_of_the_missing_path_only_what_is_no_full_circle_is_flown_away_from_the_goal():
    here = at(-500.0, 0.0)
    path = length_of(shortest_path(*ahead(here, FINAL), 0.0, RADIUS)) * RADIUS
    needed = FINAL + path + 1.5 * FULL_TURN * RADIUS
    outbound = begun(-500.0, 0.0, 0.0, needed)
    assert (outbound.phase, outbound.circles) == (OUTBOUND, 1.0)
    short = 0.4 * FULL_TURN * RADIUS
    assert fly_leg(outbound, here, needing(needed - short), GAINS).phase == OUTBOUND
    short = 0.6 * FULL_TURN * RADIUS
    after = fly_leg(outbound, here, needing(needed - short), GAINS)
    assert after.phase == ON_PATH
    assert after.progress.edge.path.arc >= FULL_TURN


def test_a_path_that_became_too_short_for_the_height_is_planned_anew_but_not_close_to_the_goal():
    far, close = at(-300.0, 0.0), at(-100.0, 0.0)
    assert fly_leg(leg(FIELD), far, needing(320.0 / BREAK_OFF), GAINS).phase == OUTBOUND
    assert fly_leg(leg(FIELD), far, needing(300.0), GAINS).phase == FIELD
    assert fly_leg(leg(FIELD), close, needing(310.0), GAINS).phase == FIELD
    assert begun(-100.0, 0.0, 0.0, 310.0).phase == OUTBOUND


@given(PLACE, PLACE, COURSE, st.floats(0.0, 3000.0))
def test_the_length_of_what_is_begun_is_that_of_its_path(x, y, course, distance_for_altitude):
    """Or that of the way that follows where the vehicle first flies away from the goal."""
    here, its = at(x, y, course), start_here(leg(), at(x, y, course), distance_for_altitude, GAINS)
    if its.leg.phase == OUTBOUND:
        assert its.length >= distance_for_altitude
    else:
        flown = leg_course(its.leg, here, CORE).remaining
        assert its.length == pytest.approx(flown, abs=0.6 * RADIUS)


@given(PLACE, PLACE, COURSE, st.floats(0.0, 3000.0), st.floats(0.5, 1.0))
def test_turns_are_wider_only_where_the_descent_is_shorter_with_them(x, y, course, path, part):
    here, wide = at(x, y, course), leg()._replace(radius=1.15 * RADIUS)
    after = fly_leg(leg(), here, Paths(path, 1.15, part * path), GAINS)
    level = start_here(leg(), here, path, GAINS).length
    descent = start_here(wide, here, part * path, GAINS).length
    assert (after.radius > RADIUS) == (descent < level and part < 1.0)


def test_a_descent_that_takes_more_path_than_the_way_has_is_flown_in_wider_turns():
    here = at(-200.0, 100.0, 2.0)
    assert fly_leg(leg(), here, Paths(900.0, 1.15, 780.0), GAINS).radius == 1.15 * RADIUS
    assert fly_leg(leg(), here, Paths(200.0, 1.15, 175.0), GAINS).radius == RADIUS


def test_a_shorter_straight_end_is_flown_where_the_way_leaps_otherwise():
    """From 150 m beside the goal it flew a circle more, for a third of a radius of straight."""
    radius, here = 62.5, at(-75.4, -135.4, math.radians(81.0))
    near = leg()._replace(radius=radius)
    after = fly_leg(near, here, needing(0.0), GAINS)
    assert SHORTEST_FINAL_APPROACH * radius <= after.final_approach < GAINS.final_approach * radius
    length = leg_course(after, here, CORE).remaining
    leapt = shortest_path(*ahead(here, GAINS.final_approach * radius), math.radians(81.0), radius)
    assert length < GAINS.final_approach * radius + radius * (length_of(leapt) - 5.0)


@pytest.mark.parametrize(
    ("radius", "kept"), [(111.0, True), (58.0, True), (113.0, False), (57.0, False)]
)
def test_the_radius_changes_only_for_a_reason_and_then_a_way_is_planned_anew(radius, kept):
    assert keep_radius(leg(FIELD), radius) == leg(FIELD)._replace(radius=RADIUS if kept else radius)
    assert keep_radius(leg(ON_PATH), radius).phase == (ON_PATH if kept else NEW)


@pytest.mark.parametrize(
    ("radius", "kept"), [(95.0, True), (67.0, True), (97.0, False), (66.0, False)]
)
def test_before_a_leg_is_begun_the_radius_follows_more_closely(radius, kept):
    assert keep_radius(leg(NEW), radius).radius == (RADIUS if kept else radius)


def test_a_new_leg_takes_the_radius_that_is_flyable():
    assert keep_radius(new_leg(), 66.0) == new_leg()._replace(radius=66.0)


@pytest.mark.parametrize("bank", [20.0, 50.0])
def test_the_radius_is_that_of_a_turn_down_wind_with_a_margin(bank):
    turn = turn_radius(25.0, 5.0, bank * DEG, 1.25)
    lateral = 30.0**2 / (turn / 1.25)
    assert math.atan(lateral / G0) == pytest.approx(bank * DEG)
