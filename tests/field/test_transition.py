import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.field.transition import smooth_step, transition
from vfguide.geometry.dual import Dual


@pytest.mark.parametrize("s", [-math.inf, -1e300, -1.0, 0.0, 5e-324, 1e-300, 1e-10, 1e-4])
def test_closed_up_to_zero(s):
    assert smooth_step(s) == (0.0, 0.0)


@pytest.mark.parametrize("s", [1.0, 1.0 + 1e-15, 2.0, 1e300, math.inf, 1.0 - 1e-15, 1.0 - 1e-4])
def test_open_from_one_on(s):
    assert smooth_step(s) == (1.0, 0.0)


def test_numbers_worked_by_hand():
    assert smooth_step(0.5) == (0.5, 2.0)  # dS/ds = (1/4) (4 + 4)
    # 1/s - 1/(1 - s) = 4 - 4/3 at s = 1/4.
    assert smooth_step(0.25)[0] == pytest.approx(1.0 / (1.0 + math.exp(8.0 / 3.0)), rel=1e-15)


@given(st.floats(0.01, 0.99))
def test_the_two_sides_mirror_each_other(s):
    (S, slope), (mirrored, same_slope) = smooth_step(s), smooth_step(1.0 - s)
    assert mirrored == pytest.approx(1.0 - S, abs=1e-14)
    assert same_slope == pytest.approx(slope, rel=1e-10, abs=1e-14)


@given(st.floats(0.01, 0.99))
def test_slope_is_the_central_difference(s):
    h = 1e-5
    difference = (smooth_step(s + h)[0] - smooth_step(s - h)[0]) / (2.0 * h)
    assert smooth_step(s)[1] == pytest.approx(difference, rel=1e-4, abs=1e-8)
    assert 0.0 < smooth_step(s)[1] <= 2.0


@given(st.floats(-0.5, 1.5), st.floats(1e-6, 1e-2))
def test_it_never_falls(s, step):
    assert smooth_step(s + step)[0] >= smooth_step(s)[0]


def test_transition_between_two_levels():
    chi = transition(Dual(2.5, 6.0), 1.0, 4.0)
    assert chi == (0.5, pytest.approx(2.0 / 3.0 * 6.0))
    assert transition(Dual(1.0, 6.0), 1.0, 4.0) == (0.0, 0.0)
    assert transition(Dual(4.0, 6.0), 1.0, 4.0) == (1.0, 0.0)
