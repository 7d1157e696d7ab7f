"""Azimuth, path angle and horizontal part of a velocity, against how it is made of them."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.geometry.velocity import azimuth_of, horizontal_norm, path_of

speeds = st.floats(0.1, 100.0)
azimuths = st.floats(-3.1, 3.1)
climbs = st.floats(-1.5, 1.5)


@given(speeds, azimuths, climbs)
def test_a_velocity_has_the_angles_that_it_was_made_of(speed, azimuth, climb):
    level = speed * math.cos(climb)
    v_n = (level * math.cos(azimuth), level * math.sin(azimuth), -speed * math.sin(climb))
    assert azimuth_of(v_n) == pytest.approx(azimuth, abs=1e-12)
    assert path_of(v_n, speed) == pytest.approx(climb, abs=1e-6)
    assert horizontal_norm(v_n) == pytest.approx(level, rel=1e-12)


def test_a_velocity_that_is_steeper_than_its_speed_allows_is_vertical():
    assert path_of((0.0, 0.0, -30.0), 25.0) == 0.5 * math.pi
    assert path_of((0.0, 0.0, 30.0), 25.0) == -0.5 * math.pi
