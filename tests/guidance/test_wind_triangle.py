"""The wind triangle closes, and its rate is the derivative."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.guidance.wind_triangle import heading_for_course

ANGLES = st.floats(-math.pi, math.pi)
WINDS = st.tuples(st.floats(-14.0, 14.0), st.floats(-14.0, 14.0))


@given(ANGLES, WINDS)
def test_the_triangle_closes(chi, wind):
    found = heading_for_course(chi, 0.0, wind, 25.0)
    north = 25.0 * math.cos(found.psi) + wind[0]
    east = 25.0 * math.sin(found.psi) + wind[1]
    assert found.groundspeed > 0.0
    assert north == pytest.approx(found.groundspeed * math.cos(chi), abs=1e-9)
    assert east == pytest.approx(found.groundspeed * math.sin(chi), abs=1e-9)


@given(ANGLES, WINDS, st.floats(-0.5, 0.5))
def test_the_rate_is_the_derivative(chi, wind, rate):
    step = 1e-5
    after = heading_for_course(chi + step * rate, rate, wind, 25.0).psi
    before = heading_for_course(chi - step * rate, rate, wind, 25.0).psi
    found = heading_for_course(chi, rate, wind, 25.0).psi_rate
    assert found == pytest.approx((after - before) / (2.0 * step), abs=1e-6)


def test_without_wind_the_nose_goes_where_the_course_goes():
    assert heading_for_course(0.7, 0.1, (0.0, 0.0), 25.0) == (0.7, 0.1, 25.0)


@pytest.mark.parametrize("speed", [25.0, 30.0, 100.0])
def test_a_wind_that_cannot_be_held_stays_defined(speed):
    found = heading_for_course(0.0, 0.1, (0.0, speed), 25.0)
    assert all(map(math.isfinite, found))
    assert math.sin(found.psi) == pytest.approx(-0.95)
