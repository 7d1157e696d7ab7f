"""Ways that are made longer for the height are long enough, and the shortest of their kind."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from planar_states import at

from vfguide.geometry.angles import FULL_TURN
from vfguide.geometry.se2 import Pose, after_turn
from vfguide.paths.dubins import length_of, shortest_path
from vfguide.paths.path_stretching import (
    LEAST_GAIN,
    LENGTH_SLACK,
    OUTBOUND_TURN,
    OUTBOUND_TURNS,
    STRIDES,
    best_end,
    best_outbound,
    outbound_length,
)

RADIUS = 62.5
PLACE, COURSE = st.floats(-500.0, 500.0), st.floats(-math.pi, math.pi)
NEEDED = st.floats(0.0, 2000.0)


def shortest(x, y, course):
    return RADIUS * length_of(shortest_path(x, y, course, RADIUS))


@given(PLACE, PLACE, COURSE, NEEDED)
def test_a_longer_end_makes_the_path_as_long_as_needed_and_no_shorter_end_does(
    x, y, course, needed
):
    progress = shortest(x, y, course)
    needed = min(needed, progress + FULL_TURN * RADIUS)
    farther, length = best_end(at(x, y, course), RADIUS, needed)
    if math.isinf(length):
        ends = [0.1 * RADIUS * k for k in range(STRIDES)]
        assert all(end + shortest(x + end, y, course) < needed for end in ends)
        return
    assert length == pytest.approx(farther + shortest(x + farther, y, course))
    assert length >= needed
    before = farther - 0.1 * RADIUS
    if before > -1e-9:
        assert before + shortest(x + before, y, course) < needed + 1e-6
    else:
        assert farther == 0.0


@given(PLACE, PLACE, COURSE, NEEDED)
def test_the_course_away_is_the_one_of_the_shortest_path_with_slack(x, y, course, needed):
    needed = min(needed, shortest(x, y, course) + FULL_TURN * RADIUS)
    chosen, length = best_outbound(at(x, y, course), RADIUS, needed)
    assert needed <= length < math.inf
    lengths = {}
    for k in range(-OUTBOUND_TURNS, OUTBOUND_TURNS + 1):
        arc = abs(k) * OUTBOUND_TURN * RADIUS
        pose = after_turn(Pose(x, y, course), math.copysign(1.0, k), abs(k) * OUTBOUND_TURN, RADIUS)
        lengths[pose.course] = tuple(
            arc + outbound_length(pose, RADIUS, needed + slack * RADIUS - arc)
            for slack in (0.0, LENGTH_SLACK)
        )
    nearest = min(lengths, key=lambda other: abs(math.remainder(other - chosen, FULL_TURN)))
    plain, with_slack = lengths[nearest]
    assert length == pytest.approx(plain)
    assert with_slack <= min(its[1] for its in lengths.values()) + LEAST_GAIN * RADIUS + 1e-6


def test_a_course_on_which_a_metre_more_leaps_by_most_of_a_circle_is_not_taken():
    """Half a radian to the right is the shortest way away, and leads on for 0.4 m no more."""
    course = math.radians(-79.0)
    here = at(-337.8, 115.83, course)
    right = after_turn(Pose(here.x, here.y, course), 1.0, OUTBOUND_TURN, RADIUS)
    arc, needed = OUTBOUND_TURN * RADIUS, 483.5
    ahead = outbound_length(Pose(here.x, here.y, course), RADIUS, needed)
    assert arc + outbound_length(right, RADIUS, needed - arc) < ahead
    assert arc + outbound_length(right, RADIUS, needed + 1.0 - arc) > ahead + 3.0 * RADIUS
    chosen, length = best_outbound(here, RADIUS, needed)
    assert chosen == pytest.approx(course)
    assert length == pytest.approx(ahead)


def test_a_little_that_is_missing_costs_no_circle_where_one_of_both_is_steady():
    """20 m more than the shortest way: a longer end, or away from the goal, leaps by 170 m."""
    course = math.radians(310.7)
    here = at(-111.6, 137.6, course)
    progress = shortest(here.x, here.y, course)
    assert best_end(here, RADIUS, progress + 20.0)[1] < progress + 25.0
    assert best_outbound(here, RADIUS, progress + 20.0)[1] > progress + 200.0
    course = math.radians(118.2)
    here = at(-134.1, -84.5, course)
    progress = shortest(here.x, here.y, course)
    assert best_end(here, RADIUS, progress + 20.0)[1] > progress + 170.0
    assert best_outbound(here, RADIUS, progress + 20.0)[1] < progress + 25.0


@pytest.mark.parametrize(
    ("x", "needed", "end_found", "away_found"),
    [
        (-200.0, 380.0, True, True),
        (-5e3, 0.0, True, True),
        (-5e3, 380.0, False, True),
        (-1e6, 380.0, False, True),
        (300.0, 380.0, True, True),
        (-200.0, math.nan, False, False),
    ],
)
def test_every_search_ends(x, needed, end_found, away_found):
    here, needed = at(x, 0.0, 0.0), shortest(x, 0.0, 0.0) + needed
    assert math.isfinite(best_end(here, RADIUS, needed)[1]) == end_found
    assert math.isfinite(best_outbound(here, RADIUS, needed)[1]) == away_found
