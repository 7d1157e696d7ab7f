import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.geometry.angles import FULL_TURN, wrap

BELOW_PI = math.nextafter(math.pi, 0.0)


@given(st.floats(-1e6, 1e6))
def test_wrap_is_the_same_direction_within_half_a_turn(angle):
    wrapped = wrap(angle)
    assert -math.pi <= wrapped < math.pi
    assert math.remainder(angle - wrapped, FULL_TURN) == pytest.approx(0.0, abs=1e-9)


@given(st.floats(-1e6, 1e6))
def test_wrapping_twice_changes_nothing(angle):
    assert wrap(wrap(angle)) == wrap(angle)


@pytest.mark.parametrize(
    ("angle", "expected"),
    [
        (0.0, 0.0),
        (math.pi, -math.pi),
        (-math.pi, -math.pi),
        (BELOW_PI, BELOW_PI),
        (-BELOW_PI, -BELOW_PI),
        (-1e-300, -1e-300),
        (3.0 * math.pi, -math.pi),
        (FULL_TURN, 0.0),
        (1.5 * math.pi, -0.5 * math.pi),
    ],
)
def test_wrap_at_its_bounds(angle, expected):
    assert wrap(angle) == pytest.approx(expected, abs=1e-15)


@pytest.mark.parametrize("turns", range(-50, 51))
def test_wrap_stays_in_its_range_an_ulp_beside_every_half_turn(turns):
    half = (2 * turns + 1) * math.pi
    for angle in (half, math.nextafter(half, -math.inf), math.nextafter(half, math.inf)):
        assert -math.pi <= wrap(angle) < math.pi
