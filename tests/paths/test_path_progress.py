"""Shortest words, and the ways along them."""

import math

import pytest
from dubins import dubins_length
from hypothesis import assume, given
from hypothesis import strategies as st

from vfguide.geometry.angles import wrap
from vfguide.paths.course_laws import Planar
from vfguide.paths.dubins import CLOSED, FULL, length_of, shortest_word, turn_of
from vfguide.paths.path_progress import (
    FIRST_TURN,
    LAST_TURN,
    MIDDLE,
    after_turn,
    along,
    begin_of,
    beside,
    in_piece,
    middle_begin,
    new_way,
    way_course,
    way_left,
)

RADIUS, SPEED = 70.0, 25.0
PLACE = st.floats(-800.0, 800.0)
COURSE = st.floats(-math.pi, math.pi)


def at(x, y, course):
    return Planar(x, y, SPEED * math.cos(course), SPEED * math.sin(course))


def way_from(x, y, course, circles=0):
    word = shortest_word(x, y, course, RADIUS)
    return new_way(at(x, y, course), word._replace(arc=word.arc + FULL * circles), RADIUS)


def is_exact(word):
    """Whether no turn of it was taken as none for being nearly a full circle."""
    return all(abs(turn - FULL) > 1.1 * CLOSED for turn in (word.arc, word.end))


@given(PLACE, PLACE, COURSE)
def test_a_word_is_as_long_as_dubins_path_or_shorter_by_turns_that_are_nearly_closed(x, y, course):
    word = shortest_word(x, y, course, RADIUS)
    expected = dubins_length((x, y, course), (0.0, 0.0, 0.0), RADIUS) / RADIUS
    assert length_of(word) <= expected + 1e-6
    assert length_of(word) >= expected - 2.0 * FULL - 1e-6


@given(PLACE, PLACE, COURSE)
def test_the_three_pieces_of_a_word_lead_to_the_origin_along_x(x, y, course):
    way = way_from(x, y, course)
    word, middle = way.word, middle_begin(way)
    if word.middle == 0.0:
        reach = word.reach * RADIUS
        ahead = (math.cos(middle.course), math.sin(middle.course))
        last = middle._replace(x=middle.x + reach * ahead[0], y=middle.y + reach * ahead[1])
    else:
        last = after_turn(middle, word.middle, word.reach, RADIUS)
    end = after_turn(last, word.last, word.end, RADIUS)
    closed = 2.5 * CLOSED * max(RADIUS, math.hypot(x, y))
    exact = math.isclose(
        length_of(word) * RADIUS,
        dubins_length((x, y, course), (0.0, 0.0, 0.0), RADIUS),
        abs_tol=1e-6,
    )
    assert math.hypot(end.x, end.y) < (1e-5 if exact else closed)
    assert abs(wrap(end.course)) < (1e-6 if exact else 2.5 * CLOSED)


@given(PLACE, PLACE, COURSE, st.integers(0, 2))
def test_a_way_is_followed_to_its_end(x, y, course, circles):
    assume(math.hypot(x, y) > 5.0)
    way, dt = way_from(x, y, course, circles), 0.04
    here, flown, total = at(x, y, course), 0.0, way_left(way)
    for _ in range(4000):
        way = along(way, here)
        if way.piece == LAST_TURN and way_left(way) <= 0.0:
            break
        assert beside(way, here) < 0.35 * RADIUS
        chi = way_course(way, here).chi
        here = at(here.x + dt * here.vx, here.y + dt * here.vy, chi)
        flown += dt * SPEED
    assert way.piece == LAST_TURN
    assert math.hypot(here.x, here.y) < 0.3 * RADIUS
    assert flown == pytest.approx(total, abs=0.6 * RADIUS)


@given(st.sampled_from([1.0, -1.0]), st.floats(0.8, 5.5), st.integers(0, 3))
def test_whole_circles_are_counted_down(side, arc, circles):
    way = way_from(-500.0, 30.0, 0.0)
    word = way.word._replace(first=side, arc=arc + FULL * circles)
    way = way._replace(word=word, left=word.arc)
    for gone in (0.05, 0.2, 0.4):
        pose = after_turn(begin_of(way), side, gone, RADIUS)
        way = along(way, at(pose.x, pose.y, pose.course))
        assert way.piece == FIRST_TURN
        assert way.left == pytest.approx(word.arc - gone)


def test_the_roll_from_turn_to_turn_sets_in_twice_as_early_as_from_a_turn_to_a_straight():
    word = shortest_word(-300.0, 250.0, 2.0, RADIUS)._replace(
        first=1.0, arc=2.0, middle=0.0, reach=2.0
    )
    for middle, lead in ((0.0, 0.37), (-1.0, 0.74), (1.0, 0.0)):
        way = new_way(at(-300.0, 250.0, 2.0), word._replace(middle=middle), RADIUS)
        lack = lead * SPEED / RADIUS
        for slack, piece in ((0.01, FIRST_TURN), (-0.01, MIDDLE)):
            pose = after_turn(begin_of(way), 1.0, 2.0 - lack - slack, RADIUS)
            here = in_piece(way, FIRST_TURN, lack + slack)
            assert along(here, at(pose.x, pose.y, pose.course)).piece == piece


def test_a_turn_that_is_nearly_a_full_circle_is_none():
    assert turn_of(FULL - 0.5 * CLOSED) == 0.0
    assert turn_of(-0.5 * CLOSED) == 0.0
    assert turn_of(FULL - 2.0 * CLOSED) == pytest.approx(FULL - 2.0 * CLOSED)
    assert turn_of(0.5 * CLOSED) == 0.5 * CLOSED
