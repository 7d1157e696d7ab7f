"""F_OA for an aircraft of constant airspeed, among barriers that move, in wind."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from vfguide.geometry.vector import add, cross, dot, norm, scale, sub, unit
from vfguide.guidance.flown_avoidance import (
    COLLINEAR_SINE,
    AircraftMotion,
    MovingBarrier,
    flown_field,
    no_barriers,
    past_barrier,
)

AIRSPEED = 25.0
STILL = (0.0, 0.0, 0.0)
directions = st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda a: norm(a) > 0.1).map(unit)
slow = st.tuples(st.floats(-8.0, 8.0), st.floats(-8.0, 8.0), st.floats(-1.0, 1.0))


def past(g, *barriers, wind=STILL, moving=None, keeps=True, has_airspeed=True):
    """F_OA of some barriers; the aircraft moves as it is asked to, or as `moving`."""
    motion = AircraftMotion(moving or g, wind, AIRSPEED, keeps, has_airspeed)
    by = no_barriers()
    for barrier in barriers:
        by = past_barrier(by, g, barrier, motion)
    return flown_field(by, g)


@given(directions, directions, slow, slow, st.floats(0.0, 50.0))
def test_at_the_margin_it_comes_no_nearer_at_its_airspeed(ahead, n, v_n, wind, clearance):
    g = add(scale(AIRSPEED, ahead), wind)
    assume(dot(sub(g, v_n), n) < -0.1)
    F = past(g, MovingBarrier(0.0, n, v_n, clearance), wind=wind)
    assert dot(sub(F, v_n), n) == pytest.approx(0.0, abs=1e-9)
    assert norm(sub(F, wind)) == pytest.approx(AIRSPEED)


@given(directions, directions, slow, slow)
def test_inside_the_margin_it_leaves(ahead, n, v_n, wind):
    g = add(scale(AIRSPEED, ahead), wind)
    assume(dot(sub(g, v_n), n) < -0.1)
    F = past(g, MovingBarrier(0.0, n, v_n, -5.0), wind=wind)
    assert dot(sub(F, v_n), n) == pytest.approx(1.5)


@given(directions, directions, slow, st.floats(0.0, 1.0))
def test_what_is_not_approached_or_far_away_does_nothing(ahead, n, v_n, chi):
    g = scale(AIRSPEED, ahead)
    away = dot(sub(g, v_n), n) >= 0.0
    F = past(g, MovingBarrier(chi if away else 1.0, n, v_n, 10.0))
    assert pytest.approx(g) == F


@given(directions, directions, st.floats(0.0, 1.0))
def test_one_that_stands_is_passed_as_the_paper_says(ahead, n, chi):
    """F_OA = chi F + (1 - chi) tau with unit vectors F and tau = (n x F) x n."""
    tangent = cross(cross(n, ahead), n)
    assume(dot(ahead, n) < -0.01 and norm(tangent) > COLLINEAR_SINE)
    F = past(scale(AIRSPEED, ahead), MovingBarrier(chi, n, STILL, 10.0))
    wanted = add(scale(chi, ahead), scale(1.0 - chi, unit(tangent)))
    assert np.array(F) == pytest.approx(AIRSPEED * np.array(wanted), abs=1e-9)


@given(st.floats(-math.pi, math.pi), st.floats(-0.1, 0.1), st.sampled_from((-1.0, 1.0)))
def test_dead_ahead_the_side_is_that_of_the_own_motion(azimuth, off, side):
    """However slightly the field points to the other side."""
    n = (-math.cos(azimuth), -math.sin(azimuth), 0.0)
    g = (AIRSPEED * math.cos(azimuth + off), AIRSPEED * math.sin(azimuth + off), 0.0)
    turned = azimuth + side * 0.3
    moving = (AIRSPEED * math.cos(turned), AIRSPEED * math.sin(turned), 0.0)
    F = past(g, MovingBarrier(0.0, n, STILL, 10.0), moving=moving)
    assert cross(n, F)[2] * cross(n, moving)[2] > 0.0
    assert abs(dot(F, n)) < 1e-9


@given(st.lists(st.tuples(directions, slow, st.floats(0.0, 1.0)), max_size=6), directions, slow)
def test_it_is_always_finite(barriers, ahead, wind):
    g = add(scale(AIRSPEED, ahead), wind)
    rows = [MovingBarrier(chi, n, v_n, 10.0 * chi - 5.0) for n, v_n, chi in barriers]
    for has_airspeed in (True, False):
        F = past(g, *rows, wind=wind, has_airspeed=has_airspeed)
        assert all(map(math.isfinite, F))


def test_a_barrier_faster_than_the_aircraft_is_left_as_well_as_can_be():
    n, v_n = (-1.0, 0.0, 0.0), (-60.0, 0.0, 0.0)
    F = past((AIRSPEED, 0.0, 0.0), MovingBarrier(0.0, n, v_n, 10.0), moving=(20.0, 5.0, 0.0))
    assert all(map(math.isfinite, F))
    assert F[0] <= 0.0


def test_straight_up_or_down_it_goes_on_level():
    F = past((0.0, 0.0, AIRSPEED), MovingBarrier(0.0, (0.0, 0.0, -1.0), STILL, 10.0))
    assert pytest.approx((AIRSPEED, 0.0, 0.0)) == F
