"""The level turn: bank, load factor, turn rate and radius of one turn agree."""

import math

import pytest
from aeroplanes import AEROSONDE, CESSNA, EASYSTAR
from hypothesis import given
from hypothesis import strategies as st

from vfguide.aircraft.coordinated_turn import turn_rate
from vfguide.aircraft.envelope import (
    LEAST_LOAD,
    bank_of_turn,
    carried_load,
    turn_radius,
    usable_bank,
)
from vfguide.aircraft.performance import Gains, nonzero_airspeed
from vfguide.geometry.units import G0

AIRCRAFT = (AEROSONDE, EASYSTAR, CESSNA)
banks = st.floats(0.05, 1.3)
airspeeds = st.floats(5.0, 80.0)


@given(banks, airspeeds)
def test_the_radius_is_the_airspeed_over_the_turn_rate(bank, airspeed):
    radius = turn_radius(airspeed, 0.0, bank, 1.0)
    assert radius * turn_rate(bank, airspeed) == pytest.approx(airspeed, rel=1e-12)
    assert turn_rate(-bank, airspeed) == -turn_rate(bank, airspeed)


@given(banks, airspeeds)
def test_the_lift_of_a_turn_is_weight_and_centripetal_force(bank, airspeed):
    load, across = 1.0 / math.cos(bank), airspeed * turn_rate(bank, airspeed) / G0
    assert bank_of_turn(load) == pytest.approx(bank, rel=1e-9)
    assert math.hypot(1.0, across) == pytest.approx(load, rel=1e-12)


@pytest.mark.parametrize("aircraft", AIRCRAFT)
def test_the_usable_bank_grows_with_the_airspeed_to_the_largest(aircraft):
    gains = Gains(aircraft.airspeed_cruise, bank_max=aircraft.bank_max)
    speeds = [0.01 * k * aircraft.airspeed_max for k in range(1, 160)]
    bank = [usable_bank(aircraft, gains, speed) for speed in speeds]
    assert bank == sorted(bank)
    assert bank[0] == pytest.approx(bank_of_turn(LEAST_LOAD))
    assert bank[-1] == min(aircraft.bank_max, bank_of_turn(aircraft.load_max))
    assert carried_load(aircraft, 2.0 * aircraft.airspeed_min) == pytest.approx(4.0)


@pytest.mark.parametrize("aircraft", AIRCRAFT)
def test_no_law_divides_by_less_than_half_of_the_slowest_airspeed(aircraft):
    least = 0.5 * aircraft.airspeed_min
    assert nonzero_airspeed(0.0, aircraft) == nonzero_airspeed(-5.0, aircraft) == least
    assert nonzero_airspeed(3.0 * least, aircraft) == 3.0 * least
