"""Shortest Dubins paths, and the progress along them."""

import math

import pytest
from dubins import dubins_length
from hypothesis import assume, given
from hypothesis import strategies as st
from planar_states import SPEED, at

from vfguide.geometry.angles import FULL_TURN, wrap
from vfguide.geometry.se2 import Pose, after_turn, composed
from vfguide.paths.course_laws import PlanarState
from vfguide.paths.dubins import CLOSED_TURN, length_of, shortest_path, turn_of
from vfguide.paths.edge import FIRST_TURN, LAST_TURN, MIDDLE, Edge, edge_end
from vfguide.paths.path_progress import (
    PathProgress,
    along,
    at_segment,
    begin_path,
    beside,
    path_course,
    path_left,
)

pytestmark = pytest.mark.slow

RADIUS = 70.0
PLACE = st.floats(-800.0, 800.0)
COURSE = st.floats(-math.pi, math.pi)


def progress_from(x, y, course, circles=0):
    path = shortest_path(x, y, course, RADIUS)
    return begin_path(at(x, y, course), path._replace(arc=path.arc + FULL_TURN * circles), RADIUS)


def is_exact(path):
    """Whether no turn of it was taken as none for being nearly a full circle."""
    return all(abs(turn - FULL_TURN) > 1.1 * CLOSED_TURN for turn in (path.arc, path.end))


@given(PLACE, PLACE, COURSE)
def test_a_path_is_as_long_as_dubins_or_shorter_by_turns_that_are_nearly_closed(x, y, course):
    path = shortest_path(x, y, course, RADIUS)
    expected = dubins_length((x, y, course), (0.0, 0.0, 0.0), RADIUS) / RADIUS
    assert length_of(path) <= expected + 1e-6
    assert length_of(path) >= expected - 2.0 * FULL_TURN - 1e-6


@given(PLACE, PLACE, COURSE)
def test_the_three_segments_lead_to_the_origin_with_course_0(x, y, course):
    progress = progress_from(x, y, course)
    path, end = progress.edge.path, edge_end(progress.edge, RADIUS)
    closed = 2.5 * CLOSED_TURN * max(RADIUS, math.hypot(x, y))
    exact = math.isclose(
        length_of(path) * RADIUS,
        dubins_length((x, y, course), (0.0, 0.0, 0.0), RADIUS),
        abs_tol=1e-6,
    )
    assert math.hypot(end.x, end.y) < (1e-5 if exact else closed)
    assert abs(wrap(end.course)) < (1e-6 if exact else 2.5 * CLOSED_TURN)


@given(PLACE, PLACE, COURSE, st.integers(0, 2))
def test_a_path_is_followed_to_its_end(x, y, course, circles):
    assume(math.hypot(x, y) > 5.0)
    progress, dt = progress_from(x, y, course, circles), 0.04
    here, flown, total = at(x, y, course), 0.0, path_left(progress)
    for _ in range(4000):
        progress = along(progress, here)
        if progress.segment == LAST_TURN and path_left(progress) <= 0.0:
            break
        assert beside(progress, here) < 0.35 * RADIUS
        chi = path_course(progress, here).chi
        here = at(here.x + dt * here.vx, here.y + dt * here.vy, chi)
        flown += dt * SPEED
    assert progress.segment == LAST_TURN
    assert math.hypot(here.x, here.y) < 0.3 * RADIUS
    assert flown == pytest.approx(total, abs=0.6 * RADIUS)


@given(st.sampled_from([1.0, -1.0]), st.floats(0.8, 5.5), st.integers(0, 3))
def test_whole_circles_are_counted_down(side, arc, circles):
    progress = progress_from(-500.0, 30.0, 0.0)
    path = progress.edge.path._replace(first=side, arc=arc + FULL_TURN * circles)
    progress = progress._replace(edge=progress.edge._replace(path=path), left=path.arc)
    for gone in (0.05, 0.2, 0.4):
        pose = after_turn(progress.edge.begin, side, gone, RADIUS)
        progress = along(progress, at(pose.x, pose.y, pose.course))
        assert progress.segment == FIRST_TURN
        assert progress.left == pytest.approx(path.arc - gone)


def test_the_roll_from_turn_to_turn_sets_in_twice_as_early_as_from_a_turn_to_a_straight():
    path = shortest_path(-300.0, 250.0, 2.0, RADIUS)._replace(
        first=1.0, arc=2.0, middle=0.0, reach=2.0
    )
    for middle, lead in ((0.0, 0.37), (-1.0, 0.74), (1.0, 0.0)):
        progress = begin_path(at(-300.0, 250.0, 2.0), path._replace(middle=middle), RADIUS)
        lack = lead * SPEED / RADIUS
        for slack, segment in ((0.01, FIRST_TURN), (-0.01, MIDDLE)):
            pose = after_turn(progress.edge.begin, 1.0, 2.0 - lack - slack, RADIUS)
            here = at_segment(progress, FIRST_TURN, lack + slack)
            assert along(here, at(pose.x, pose.y, pose.course)).segment == segment


@given(PLACE, PLACE, COURSE, st.builds(Pose, PLACE, PLACE, COURSE), st.integers(0, 2))
def test_a_path_is_followed_alike_wherever_it_lies(x, y, course, end, segment):
    own = progress_from(x, y, course)
    own = at_segment(own, segment, 0.5)
    moved = PathProgress(
        Edge(composed(end, own.edge.begin), own.edge.path), end, RADIUS, segment, 0.5
    )
    c, s = math.cos(end.course), math.sin(end.course)
    here, there = at(x, y, course), composed(end, Pose(x, y, course))
    vehicle = PlanarState(there.x, there.y, c * here.vx - s * here.vy, s * here.vx + c * here.vy)
    one, other = path_course(own, here), path_course(moved, vehicle)
    assert wrap(other.chi - end.course - one.chi) == pytest.approx(0.0, abs=1e-6)
    assert other.chi_rate == pytest.approx(one.chi_rate, abs=1e-6)
    assert beside(moved, vehicle) == pytest.approx(beside(own, here), abs=1e-6)


def test_a_turn_that_is_nearly_a_full_circle_is_none():
    assert turn_of(FULL_TURN - 0.5 * CLOSED_TURN) == 0.0
    assert turn_of(-0.5 * CLOSED_TURN) == 0.0
    assert turn_of(FULL_TURN - 2.0 * CLOSED_TURN) == pytest.approx(FULL_TURN - 2.0 * CLOSED_TURN)
    assert turn_of(0.5 * CLOSED_TURN) == 0.5 * CLOSED_TURN
