"""Jumps of the position: noticed, let in slowly, and no goal is passed by one."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.aircraft.state import FlightState
from vfguide.estimation.position_resets import (
    LONGEST_PAUSE,
    RESET_ACCELERATION,
    RESET_DISTANCE,
    follow_resets,
    no_resets,
    settled,
    smoothed,
)
from vfguide.geometry.so3 import IDENTITY

pytestmark = pytest.mark.slow

DT = 0.02
V = (25.0, 0.0, 0.0)


def at(p_n, time=1.0, v_n=V):
    return FlightState(time, tuple(p_n), v_n, IDENTITY, 25.0, (0.0, 0.0, 0.0))


def flown(jumps_at, steps=400):
    """Places that are flown on in a straight flight, the told one jumping at some steps."""
    jumps, here, offset, places, sizes = no_resets(), (0.0, 0.0, -100.0), np.zeros(3), [], []
    for k in range(1, steps):
        offset = offset + jumps_at.get(k, np.zeros(3))
        told = at(np.array((25.0 * DT * k, 0.0, -100.0)) + offset)
        jumps = follow_resets(jumps, (here, V), told, DT)
        here = smoothed(told, jumps).p_n
        places.append(here)
        sizes.append(jumps)
    return np.array(places), sizes


@given(st.tuples(*(st.floats(-500.0, 500.0),) * 3).filter(lambda j: math.hypot(*j) > 3.0))
def test_a_jump_is_let_in_slowly(jump):
    places, jumps = flown({100: np.array(jump)})
    steps = np.linalg.norm(np.diff(places, axis=0), axis=1)
    # 2 % of what is left in each step, whatever the size.
    assert steps.max() <= 25.0 * DT + 0.021 * math.hypot(*jump)
    assert np.linalg.norm(places[99] - (25.0 * DT * 100, 0.0, -100.0)) < 1e-9
    assert places[-1] == pytest.approx(
        np.array((25.0 * DT * 399, 0.0, -100.0)) + jump, abs=0.01 * math.hypot(*jump)
    )
    assert jumps[-1].number == 1
    assert jumps[-1].size == pytest.approx(math.hypot(*jump))


@given(
    st.tuples(*(st.floats(-4.0, 4.0),) * 3),
    st.floats(0.0, 8.0),
    st.integers(1, 60),
    st.integers(0, 1000),
)
def test_jumps_without_end_do_not_hide_the_position(error, size, every, seed):
    """The velocity is wrong by up to 7 m/s, and positions out of order leap all the time.

    Each leap held the offset of all before it, so that the place was dead reckoning: 120 m were
    lost in half a minute, though the position was right.
    """
    rng = np.random.default_rng(seed)
    v_n = (25.0 + error[0], error[1], error[2])
    jumps, here, farthest = no_resets(), (0.0, 0.0, -100.0), 0.0
    for k in range(1, 1500):
        right = np.array((25.0 * DT * k, 0.0, -100.0))
        leap = rng.uniform(-size, size, 3) if k % every == 0 else np.zeros(3)
        jumps = follow_resets(jumps, (here, v_n), at(right + leap, v_n=v_n), DT)
        here = smoothed(at(right + leap), jumps).p_n
        farthest = max(farthest, float(np.linalg.norm(here - right)))
    assert farthest < 12.0 * size + 2.5 * math.hypot(*error) + RESET_DISTANCE


@pytest.mark.parametrize("size", [0.5, 1.9, 2.1, 50.0])
def test_what_an_aeroplane_can_fly_is_no_jump(size):
    _, jumps = flown({100: np.array((0.0, size, 0.0))}, 102)
    assert jumps[-1].number == (size > RESET_DISTANCE + RESET_ACCELERATION * DT * DT)


def test_a_jump_that_is_undone_leaves_nothing():
    there = np.array((300.0, -400.0, 20.0))
    places, jumps = flown({100: there, 101: -there})
    assert places[-1] == pytest.approx((25.0 * DT * 399, 0.0, -100.0), abs=0.2)
    assert np.linalg.norm(np.diff(places, axis=0), axis=1).max() < 25.0 * DT + 1e-9
    assert settled(jumps[-1])


def test_a_steep_turn_is_no_jump():
    """Steps of half a second on a circle of 60 m radius at 30 m/s: 15 m/s^2."""
    jumps, before = no_resets(), None
    for k in range(50):
        angle = 30.0 / 60.0 * 0.5 * k
        p_n = (60.0 * math.sin(angle), -60.0 * math.cos(angle), -100.0)
        v_n = (30.0 * math.cos(angle), 30.0 * math.sin(angle), 0.0)
        if before is not None:
            jumps = follow_resets(jumps, before, at(p_n, v_n=v_n), 0.5)
        before = (p_n, v_n)
    assert jumps.number == 0


@given(st.lists(st.floats(0.0, 0.5), min_size=2, max_size=40), st.floats(-0.5, 0.5))
def test_a_delay_that_changes_is_no_jump(leads, turn_rate):
    """The state is predicted by the delay of the link: along the flight, here a circle."""

    def ahead(time):
        angle = turn_rate * time
        if turn_rate == 0.0:
            return (25.0 * time, 0.0, -100.0), V
        p_n = (25.0 * math.sin(angle) / turn_rate, 25.0 * (1.0 - math.cos(angle)) / turn_rate)
        return (*p_n, -100.0), (25.0 * math.cos(angle), 25.0 * math.sin(angle), 0.0)

    jumps, before = no_resets(), ahead(leads[0])
    for k, (was, lead) in enumerate(pairwise(leads), start=1):
        p_n, v_n = ahead(DT * k + lead)
        jumps = follow_resets(jumps, before, at(p_n, v_n=v_n), DT, lead - was)
        before = (p_n, v_n)
    assert jumps.number == 0


@pytest.mark.parametrize("dt", [0.0, -1.0, LONGEST_PAUSE, 10.0])
def test_after_a_pause_nothing_is_known_of_a_jump(dt):
    jumps = no_resets()._replace(offset_n=(5.0, 0.0, 0.0), number=3)
    after = follow_resets(jumps, ((0.0, 0.0, 0.0), V), at((900.0, 0.0, 0.0)), dt)
    assert after.offset_n == (0.0, 0.0, 0.0)
    assert after.number == 3
