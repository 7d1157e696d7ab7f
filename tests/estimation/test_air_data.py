"""Wind and airspeed are found where they can be, and the uncertainty says where they cannot."""

import math

import numpy as np
import pytest
from aeroplanes import AEROSONDE
from air_flights import BANK, DT, Air
from flight_states import GAINS, VEHICLE
from hypothesis import given, settings
from hypothesis import strategies as st

from vfguide.aircraft.flight_model import SLIP_MAX, slip
from vfguide.estimation.air_data import FAILURE_TIME, RECOVERY_TIME, sense_air
from vfguide.estimation.air_state import AIRSPEED, EAST, NORTH, fresh_air, report_air, sigma
from vfguide.estimation.caution import cautious
from vfguide.estimation.estimation import known_state
from vfguide.geometry.units import DEG
from vfguide.kernels.rows import row_of

pytestmark = pytest.mark.slow

WINDS = st.tuples(st.floats(-18.0, 18.0), st.floats(-18.0, 18.0))


def wind_error(flight):
    found = report_air(flight.air)
    return math.hypot(found.wind_north - flight.wind[0], found.wind_east - flight.wind[1])


@settings(max_examples=20)
@given(WINDS)
def test_wind_is_found_in_straight_flight_with_an_airspeed_sensor(wind):
    flight = Air(wind)
    flight.fly(5.0)
    assert wind_error(flight) < 0.05


@settings(max_examples=10)
@given(WINDS, st.floats(19.0, 31.0))
def test_wind_and_airspeed_are_found_in_turns_without_a_sensor(wind, airspeed):
    flight = Air(wind, airspeed)
    flight.fly(60.0, BANK, sensor=False)
    assert wind_error(flight) < 0.3
    assert report_air(flight.air).airspeed == pytest.approx(airspeed, abs=0.3)


@settings(max_examples=10)
@given(WINDS, st.floats(-4.0, 4.0), st.floats(-1.5, 1.5))
def test_turns_tell_the_errors_of_sensor_and_compass_from_the_wind(wind, yaw_deg, sensor):
    flight = Air(wind, yaw_error=yaw_deg * DEG, sensor_error=sensor)
    straight = flight.fly(5.0)
    assert straight[-1][0].airspeed == pytest.approx(25.0 + sensor)
    flight.fly(90.0, BANK)
    assert wind_error(flight) < 0.6
    assert report_air(flight.air).airspeed == pytest.approx(25.0, abs=0.5)


def test_straight_flight_without_a_sensor_leaves_the_wind_along_it_open():
    flight = Air((5.0, -3.0))
    flight.fly(3.0, sensor=False)
    along, across = (sigma(flight.air.estimate.P[state, state]) for state in (NORTH, EAST))
    assert along > 1.3
    assert sigma(flight.air.estimate.P[AIRSPEED, AIRSPEED]) > 1.3
    flight.fly(60.0, BANK, sensor=False)
    assert report_air(flight.air).wind_sigma < along
    assert across > 0.5


def test_the_uncertainty_is_honest():
    """Random winds, errors and turns: 99 % of all errors within three standard deviations."""
    within, all_of_them = 0, 0
    for number in range(40):
        rng = np.random.default_rng([7, number])
        flight = Air(
            rng.uniform(-15.0, 15.0, 2),
            rng.uniform(22.0, 28.0),
            rng.normal(0.0, 2.0 * DEG),
            rng.normal(0.0, 0.7),
            rng,
        )
        for _ in range(4):
            sensor, bank = bool(number % 2), rng.uniform(-0.8, 0.8)
            for _, air in flight.fly(rng.uniform(1.0, 6.0), bank, sensor=sensor)[::25]:
                north, east, airspeed = air.estimate.x[[NORTH, EAST, AIRSPEED]]
                errors = (*((north, east) - flight.wind[:2]), airspeed - flight.airspeed)
                sigmas = [sigma(air.estimate.P[state, state]) for state in (NORTH, EAST, AIRSPEED)]
                within += sum(abs(e) <= 3.0 * s for e, s in zip(errors, sigmas, strict=True))
                all_of_them += 3
    assert within >= 0.99 * all_of_them


def test_the_covariance_stays_one():
    flight = Air((8.0, 3.0))
    for sensor in (True, False):
        flight.fly(30.0, BANK, sensor=sensor)
        covariance = flight.air.estimate.P
        assert covariance == pytest.approx(covariance.T, abs=1e-12)
        assert np.linalg.eigvalsh(covariance).min() > 0.0


def test_what_is_told_is_flown_on():
    flight = Air((4.0, 1.0))
    for state, _ in flight.fly(3.0, told=(4.5, 0.5, 0.2)):
        assert state.airspeed == 25.0
        assert state.wind_n[:2] == (4.5, 0.5)
        assert abs(state.wind_n[2]) < 0.05, "the vertical part is felt, whatever is told"


def test_what_is_not_told_is_estimated():
    flight = Air((4.0, 1.0))
    state, air = flight.fly(30.0, BANK, sensor=False)[-1]
    found = report_air(air)
    assert state.airspeed == found.airspeed
    assert state.wind_n[:2] == (found.wind_north, found.wind_east)
    assert not found.trusts_sensor


@pytest.mark.parametrize("fault", [math.nan, 0.0, 12.0, 60.0])
def test_an_implausible_sensor_is_not_flown_on_and_has_failed_soon(fault):
    flight = Air((6.0, 0.0))
    flight.fly(10.0, BANK)
    during = flight.fly(FAILURE_TIME + 0.2, BANK, fault=fault)
    for state, _ in during:
        assert state.airspeed == pytest.approx(25.0, abs=1.0)
    trusted = [report_air(air).trusts_sensor for _, air in during]
    assert sum(trusted) * DT == pytest.approx(FAILURE_TIME, abs=2.0 * DT)


def test_a_sensor_that_works_again_is_believed_after_a_while():
    rng = np.random.default_rng(1)
    flight = Air((6.0, 0.0), rng=rng)
    flight.fly(5.0)
    flight.fly(5.0, fault=math.nan)
    after = [report_air(air).trusts_sensor for _, air in flight.fly(RECOVERY_TIME + 1.0)]
    assert after.count(False) * DT == pytest.approx(RECOVERY_TIME, abs=0.1)


def test_a_number_that_stands_still_while_the_airspeed_changes_has_failed():
    flight = Air((3.0, 2.0))
    flight.fly(8.0, BANK)
    assert report_air(flight.air).trusts_sensor  # it stood still, and was right
    flight.acceleration = 0.5
    for _ in range(300):
        flight.airspeed += 0.5 * DT
        flight.fly(DT, BANK, fault=25.0)
    assert not report_air(flight.air).trusts_sensor


def cautious_gains(flight, state):
    """The gains of a vehicle that is flown on what is believed of the air."""
    air = flight.air
    nav = known_state(state, state.time - DT)._replace(
        trusts_sensor=air.sensor.trusted,
        airspeed=air.estimate.x[AIRSPEED],
        airspeed_sigma=sigma(air.estimate.P[AIRSPEED, AIRSPEED]),
    )
    vehicle = cautious(nav, VEHICLE)
    assert vehicle._replace(gains=GAINS) == VEHICLE
    return vehicle.gains


def test_without_a_sensor_the_law_is_faster_and_banks_less():
    flight = Air((0.0, 0.0), 20.0)
    state, _ = flight.fly(2.0)[-1]
    assert cautious_gains(flight, state) == GAINS
    state, _ = flight.fly(5.0, sensor=False)[-1]
    gains = cautious_gains(flight, state)
    unsure = 2.0 * sigma(flight.air.estimate.P[AIRSPEED, AIRSPEED])
    assert gains.airspeed == max(25.0, 1.2 * 18.0 + unsure)
    load = ((report_air(flight.air).airspeed - unsure) / 18.0) ** 2
    assert gains.bank_max == pytest.approx(math.acos(1.0 / max(load, 1.05)))
    assert gains.bank_max < 0.6 < GAINS.bank_max
    assert gains._replace(airspeed=25.0, bank_max=GAINS.bank_max) == GAINS


def test_the_estimate_begins_anew_after_a_pause():
    flight = Air((10.0, 0.0))
    flight.fly(10.0)
    flight.wind[:] = (-10.0, 0.0, 0.0)
    flight.time += 2.0
    flight.fly(DT)
    assert wind_error(flight) < 0.5


def test_a_step_changes_no_memory_of_the_one_before():
    flight = Air((3.0, 4.0))
    flight.fly(1.0)
    before = row_of(flight.air)
    state = flight.state(0.0, sensor=True, told=(math.nan,) * 3, fault=None)
    sense_air(state._replace(time=state.time + DT), flight.air, flight.asked, AEROSONDE, 25.0)
    assert (row_of(flight.air) == before).all()


def test_nothing_is_known_at_first():
    assert report_air(fresh_air()) == (0.0, 0.0, 0.0, 0.0, 0.0, False)


@pytest.mark.parametrize("side", [-30.0, -1.0, 0.0, 1.0, 30.0])
def test_air_from_the_right_pushes_to_the_left(side):
    found = slip(side, 25.0, AEROSONDE)
    assert np.sign(found) == -np.sign(side)
    assert abs(found) <= SLIP_MAX
    if abs(side) == 1.0:
        assert abs(found) == pytest.approx(1.0 / (0.12 * 9.80665 * 625.0 / (3493.0 * DEG)))
