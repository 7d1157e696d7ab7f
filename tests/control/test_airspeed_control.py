"""Thrust: what climb, turn and airspeed take, and an integral that does not wind up."""

import math

import pytest
from flight_states import AEROSONDE
from hypothesis import given
from hypothesis import strategies as st

from vfguide.control.airspeed_control import integrate_error, thrust_for
from vfguide.geometry.units import DEG, G0

GAMMA = st.floats(-10.0 * DEG, 10.0 * DEG)
ERROR = st.floats(-10.0, 10.0)
THRUST = st.floats(-1.0, 2.0)
INTEGRAL = st.floats(-0.3, 0.3)
WEIGHT, FULL = 11.0 * G0, 36.0
"""Of the Aerosonde [N]."""


def test_level_flight_at_the_wanted_airspeed_takes_the_trim():
    assert thrust_for(AEROSONDE, 0.0, 0.0, 1.0, 0.0) == AEROSONDE.thrust_trim


@given(GAMMA)
def test_a_climb_takes_the_part_of_the_weight_along_the_path(gamma):
    more = thrust_for(AEROSONDE, 0.0, gamma, 1.0, 0.0) - AEROSONDE.thrust_trim
    assert more * FULL == pytest.approx(WEIGHT * math.sin(gamma), rel=0.01)


@given(ERROR, GAMMA, st.floats(0.0, 1.7), INTEGRAL)
def test_more_airspeed_missing_a_tighter_turn_and_the_integral_take_more(error, gamma, load, kept):
    thrust = thrust_for(AEROSONDE, error, gamma, load, kept)
    assert thrust_for(AEROSONDE, error + 1.0, gamma, load, kept) - thrust == pytest.approx(
        AEROSONDE.thrust_per_airspeed
    )
    assert thrust_for(AEROSONDE, error, gamma, load + 0.1, kept) > thrust
    assert thrust_for(AEROSONDE, error, gamma, load, kept + 0.1) - thrust == pytest.approx(0.1)


@given(ERROR, THRUST, INTEGRAL, st.floats(0.0, 0.2))
def test_the_integral_rests_at_the_stops_and_stays_in_its_bounds(error, thrust, integral, dt):
    after = integrate_error(AEROSONDE, error, thrust, integral, dt)
    assert abs(after) <= 0.3
    if not 0.0 < thrust < 1.0:
        assert after == integral
    elif abs(after) < 0.3:
        assert after - integral == pytest.approx(AEROSONDE.thrust_integral * error * dt, abs=1e-12)


def test_a_long_climb_that_is_too_slow_leaves_no_surplus():
    """A minute at full thrust with 5 m/s missing, then the airspeed is there again."""
    integral = 0.1
    for _ in range(3000):
        thrust = thrust_for(AEROSONDE, 5.0, 10.0 * DEG, 1.0, integral)
        integral = integrate_error(AEROSONDE, 5.0, thrust, integral, 0.02)
    assert thrust > 1.0
    assert integral == 0.1
