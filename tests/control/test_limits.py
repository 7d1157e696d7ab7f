"""The last stage: only setpoints within the limits of the aircraft leave it."""

import math

import pytest
from flight_states import AEROSONDE, VEHICLE, is_within_limits
from hypothesis import given
from hypothesis import strategies as st

from vfguide.aircraft.state import RateSetpoint
from vfguide.control import limits

ANYTHING = st.floats(allow_nan=True, allow_infinity=True)


@given(st.tuples(ANYTHING, ANYTHING, ANYTHING), ANYTHING)
def test_whatever_goes_in_only_limited_setpoints_come_out(omega, thrust):
    asked = RateSetpoint(omega, thrust, (1.0, 0.0, 0.0, 0.0))
    once = limits.apply(asked, VEHICLE)
    assert is_within_limits(once)
    assert limits.apply(once, VEHICLE) == once


def test_what_is_within_the_limits_passes_as_it_is():
    asked = RateSetpoint((0.3, -0.2, 0.1), 0.6, (0.8, 0.6, 0.0, 0.0))
    assert limits.apply(asked, VEHICLE) == asked


@pytest.mark.parametrize("axis", range(3))
def test_each_rate_has_its_own_limit(axis):
    omega = tuple(99.0 if k == axis else 0.0 for k in range(3))
    fast = limits.apply(RateSetpoint(omega, 0.5, (1.0, 0.0, 0.0, 0.0)), VEHICLE)
    assert fast.omega_b[axis] == AEROSONDE.rate_max[axis]
    assert sum(map(abs, fast.omega_b)) == AEROSONDE.rate_max[axis]
    slow = limits.apply(RateSetpoint(tuple(-w for w in omega), 0.5, (1.0, 0.0, 0.0, 0.0)), VEHICLE)
    assert slow.omega_b[axis] == -AEROSONDE.rate_max[axis]


def test_what_is_no_number_becomes_no_rate_and_the_thrust_of_level_flight():
    asked = RateSetpoint((math.nan, 0.1, math.nan), math.nan, (1.0, 0.0, 0.0, 0.0))
    assert limits.apply(asked, VEHICLE) == ((0.0, 0.1, 0.0), AEROSONDE.thrust_trim, asked.q_nb)
