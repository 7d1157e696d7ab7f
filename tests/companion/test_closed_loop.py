"""Whole flights of a point mass: reached, in good order, and without detours."""

import math

import numpy as np
import pytest
from aeroplanes import AEROSONDE
from closed_loop import GAINS, TURN, blowing, flown, goal, plan_of, shortest
from point_mass import fly
from rate_body import level

from vfguide.geometry.units import DEG

pytestmark = pytest.mark.slow

WINDS = [0.0, 4.0, 8.0, 12.0]
LOOPS = 2.0 * TURN
"""No flight is longer than the shortest path and two circles."""
CLIMB = 0.8 * math.tan(10.0 * DEG)
"""The path that a change of height takes is reckoned with this slope."""


def around(rng, nearest, farthest, height):
    """A place round the goal (0, 0, -150), and a heading in degrees."""
    distance, bearing = rng.uniform(nearest, farthest), rng.uniform(0.0, TURN)
    north, east = distance * math.cos(bearing), distance * math.sin(bearing)
    return (north, east, -150.0 + rng.uniform(-height, height)), rng.uniform(0.0, 360.0)


def longest(flight, start):
    """Length that the flight from `start` may have [m]."""
    (to,), (north, east, _) = flight.goals, flight.moments[0].state.v_n
    path = shortest(start, math.atan2(east, north), flight.radius, to)
    return max(path, abs(start[2] - to.p_n[2]) / CLIMB) + LOOPS * flight.radius


def to_one_goal(rng, start, heading, wind, climb=0.0):
    """The flight to (0, 0, -150) on any course, in a wind from anywhere."""
    to = goal(0.0, 0.0, course=rng.uniform(0.0, 360.0), climb=climb)
    return flown(start, heading, [to], blowing(wind, rng.uniform(0.0, 360.0)))


def assert_in_good_order(flight, start, number):
    assert flight.finished, number
    assert flight.length < longest(flight, start), number
    assert flight.switches <= 6, number
    assert flight.reversals <= 4, number


@pytest.mark.parametrize("wind", WINDS)
def test_from_anywhere_the_goal_is_reached_exactly_and_without_detours(wind):
    for number in range(40):
        rng = np.random.default_rng([1, number, int(wind)])
        start, heading = around(rng, 250.0, 1000.0, 30.0)
        flight = to_one_goal(rng, start, heading, wind)
        assert_in_good_order(flight, start, number)
        assert flight.reached[0].miss < 0.5, number
        assert flight.reached[0].course_error < 1.0 * DEG, number
        assert flight.reached[0].climb_error < 1.0 * DEG, number


@pytest.mark.parametrize("wind", WINDS)
def test_from_close_by_it_is_reached_all_the_same(wind):
    for number in range(40):
        rng = np.random.default_rng([2, number, int(wind)])
        start, heading = around(rng, 0.0, 200.0, 10.0)
        flight = to_one_goal(rng, start, heading, wind)
        assert_in_good_order(flight, start, number)


@pytest.mark.parametrize("wind", [0.0, 10.0])
@pytest.mark.parametrize("behind", [5.0, 10.0, 20.0, 35.0, 60.0, 100.0, 150.0])
def test_from_straight_behind_it_is_reached_at_once_or_after_one_loop(behind, wind):
    for number, off in enumerate((-1.0, 0.0, 1.0)):
        for turned in (0.0, 90.0, 180.0):
            start = (-behind, off, -150.0 + off)
            flight = flown(start, turned, [goal(0.0, 0.0)], blowing(wind, 120.0 * number))
            assert flight.finished, (off, turned)
            assert flight.length < longest(flight, start), (off, turned)


@pytest.mark.parametrize("wind", [0.0, 8.0])
@pytest.mark.parametrize("height", [-100.0, -60.0, -20.0, 20.0, 60.0, 100.0])
def test_height_that_the_path_does_not_allow_is_flown_off_in_circles(height, wind):
    for number in range(12):
        rng = np.random.default_rng([3, number, int(height) + 100])
        start, heading = around(rng, 10.0, 300.0, 0.0)
        start = (start[0], start[1], -150.0 - height)
        flight = to_one_goal(rng, start, heading, wind)
        assert flight.finished, number
        assert flight.reached[0].miss < 5.0, number
        assert flight.length < longest(flight, start), number
        z = flight.path[:, 2] + 150.0
        assert z.max() < max(-height, 0.0) + 3.0, number
        assert z.min() > min(-height, 0.0) - 3.0, number


@pytest.mark.parametrize("climb", [-9.0, -4.0, 4.0, 9.0])
@pytest.mark.parametrize("wind", [0.0, 8.0])
def test_a_climb_angle_is_flown_at_the_goal_and_not_long_before(climb, wind):
    for number in range(12):
        rng = np.random.default_rng([4, number])
        start, heading = around(rng, 250.0, 900.0, 60.0)
        flight = to_one_goal(rng, start, heading, wind, climb)
        assert flight.finished, number
        assert flight.reached[0].miss < 1.0, number
        assert flight.reached[0].climb_error < 2.0 * DEG, number
        z = flight.path[:, 2] + 150.0
        assert z.max() < max(start[2] + 150.0, 0.0) + 15.0, number
        assert z.min() > min(start[2] + 150.0, 0.0) - 15.0, number


@pytest.mark.parametrize("apart", [12.0, 20.0, 35.0, 60.0, 110.0])
@pytest.mark.parametrize("wind", [0.0, 8.0])
def test_goals_in_line_are_flown_through_in_line(apart, wind):
    goals = [goal(k * apart, 0.0) for k in range(5)]
    flight = flown((-400.0, 0.0, -150.0), 0.0, goals, blowing(wind, 70.0))
    assert flight.finished
    assert len(flight.passes) == len(goals)
    assert max(each.miss for each in flight.reached) < 0.2
    assert flight.length < 1.01 * (400.0 + 4.0 * apart)


@pytest.mark.parametrize("wind", [0.0, 6.0, 11.0])
def test_routes_are_flown_goal_by_goal(wind):
    for number in range(8):
        rng = np.random.default_rng([5, number])
        goals, north, east, z = [], 0.0, 0.0, -200.0
        for _ in range(4):
            course, climb = rng.uniform(0.0, 360.0), rng.uniform(-6.0, 6.0)
            goals.append(goal(north, east, z, course, climb))
            step, bearing = rng.uniform(0.0, 400.0), rng.uniform(0.0, TURN)
            north, east = north + step * math.cos(bearing), east + step * math.sin(bearing)
            z += rng.uniform(-30.0, 30.0)
        to = blowing(wind, rng.uniform(0.0, 360.0))
        flight = flown((-300.0, 20.0, -190.0), 0.0, goals, to, 900.0)
        assert flight.finished, number
        assert all(each.miss < 5.0 for each in flight.reached), number
        assert flight.moments[-1].state.time < 70.0 * len(goals), number


def test_a_goal_that_is_missed_is_tried_again_round_by_round():
    to = goal(0.0, 0.0, course=40.0, tolerance=1e-4)
    flight = flown((-500.0, 100.0, -140.0), 0.0, [to], blowing(5.0, 10.0), 250.0)
    assert not flight.finished
    close = [each for each in flight.passes if each.miss < 0.5]
    assert len(close) >= 4
    assert all(each.course_error < 1.0 * DEG for each in close)
    rounds = np.diff([each.time for each in close])
    assert rounds == pytest.approx(rounds.mean(), abs=1.5)


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("wind", [0.0, 6.0, 12.0])
@pytest.mark.parametrize("radius", [50.0, 150.0])
def test_after_the_last_goal_it_stays_on_a_level_circle_that_touches_the_goal(side, wind, radius):
    to, wind_n = goal(0.0, 0.0, course=0.0, climb=5.0), blowing(wind, 200.0)
    body = level((-400.0, 30.0, -150.0), 0.0, GAINS.airspeed, AEROSONDE)
    moments = fly(body, plan_of([to], side, radius), wind_n, 150.0)
    (begun, *_) = (k for k, moment in enumerate(moments) if moment.goal == 1)
    flown_radius = max(radius, moments[-1].command.radius)
    centre = np.array([0.0, side * flown_radius])
    path = np.array([moment.state.p_n for moment in moments[begun:]])
    off = np.linalg.norm(path[:, :2] - centre, axis=1) - flown_radius
    assert abs(off).max() < 8.2  # the roll into the circle takes a moment
    assert abs(off[len(off) // 2 :]).max() < 2.5
    assert abs(path[len(path) // 2 :, 2] + 150.0).max() < 0.5
    assert abs(path[:, 2] + 150.0).max() < 4.0
    turned = np.unwrap(np.arctan2(*(path[:, :2] - centre).T[::-1]))
    assert side * (turned[-1] - turned[0]) > TURN


def test_a_flight_turns_with_the_world():
    angle = 77.0
    c, s = math.cos(angle * DEG), math.sin(angle * DEG)
    here = flown((-350.0, 260.0, -130.0), 100.0, [goal(0.0, 0.0)], blowing(6.0, 30.0))
    there = flown(
        (-350.0 * c - 260.0 * s, 260.0 * c - 350.0 * s, -130.0),
        100.0 + angle,
        [goal(0.0, 0.0, course=angle)],
        blowing(6.0, 30.0 + angle),
    )
    turned = here.path @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    assert there.path == pytest.approx(turned, abs=1e-6)


@pytest.mark.parametrize("heading", [30.0, 300.0])
def test_a_flight_in_a_mirror_is_the_mirrored_flight(heading):
    here = flown((-350.0, 260.0, -130.0), heading, [goal(0.0, 0.0)], blowing(6.0, 30.0))
    there = flown((-350.0, -260.0, -130.0), -heading, [goal(0.0, 0.0)], blowing(6.0, -30.0))
    assert there.path == pytest.approx(here.path * (1.0, -1.0, 1.0), abs=1e-6)
