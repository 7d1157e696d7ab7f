"""Body rates of attitudes whose angles change."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.aircraft.coordinated_turn import attitude_for_lift, attitude_rate_for_lift
from vfguide.geometry.so3 import body_rates, from_euler, log
from vfguide.geometry.vector import matmul, transpose

STEP = 1e-5
angles = st.floats(-math.pi, math.pi)
steep = st.floats(-1.4, 1.4)
rates = st.floats(-2.0, 2.0)


def between(before, after):
    """Body rates from one attitude to another one two steps later."""
    return np.array(log(matmul(transpose(before), after))) / (2.0 * STEP)


@given(angles, steep, angles, st.tuples(rates, rates, rates))
def test_body_rates_of_euler_angles(roll, pitch, yaw, changes):
    def at(t):
        roll_rate, pitch_rate, yaw_rate = changes
        return from_euler(roll + t * roll_rate, pitch + t * pitch_rate, yaw + t * yaw_rate)

    expected = between(at(-STEP), at(STEP))
    assert body_rates(roll, pitch, changes) == pytest.approx(expected, abs=1e-6)


@given(angles, steep, angles, st.floats(-0.3, 0.3), st.tuples(rates, rates, rates, rates))
def test_body_rates_of_a_lift_that_changes(azimuth, elevation, bank, alpha, changes):
    *euler, pitching = changes

    def at(t):
        banking, climbing, turning = euler
        return attitude_for_lift(
            azimuth + t * turning,
            elevation + t * climbing,
            bank + t * banking,
            alpha + t * pitching,
        )

    flown = attitude_rate_for_lift(elevation, bank, alpha, tuple(euler), pitching)
    assert flown == pytest.approx(between(at(-STEP), at(STEP)), abs=1e-6)
