"""Linear interpolation, and the low-pass filter against the exact exponential."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.geometry.blending import blended, low_pass_share

numbers = st.floats(-1e6, 1e6)
times = st.floats(1e-3, 1e3)


@given(numbers, numbers)
def test_the_ends_are_the_two_values(first, second):
    size = max(abs(first), abs(second), 1.0)
    assert blended(first, second, 0.0) == first
    assert blended(first, second, 1.0) == pytest.approx(second, abs=1e-15 * size)
    assert blended(first, second, 0.5) == pytest.approx(0.5 * (first + second), abs=1e-15 * size)


@given(times, times)
def test_the_filter_never_overshoots_and_follows_sooner_with_longer_steps(time, dt):
    share = low_pass_share(time, dt)
    assert 0.0 < share < 1.0
    assert low_pass_share(time, 2.0 * dt) > share > low_pass_share(2.0 * time, dt)


@pytest.mark.parametrize("time", [0.15, 0.7, 10.0])
def test_after_its_time_constant_63_percent_of_a_step_are_followed(time):
    value, steps = 0.0, 2000
    for _ in range(steps):
        value = blended(value, 1.0, low_pass_share(time, time / steps))
    assert value == pytest.approx(1.0 - math.exp(-1.0), abs=1e-3)


def test_without_time_nothing_is_followed():
    assert low_pass_share(1.0, 0.0) == 0.0
