"""The stage of estimation: what it knows of the step before, and what the others fly on."""

import math

import pytest
from flight_states import VEHICLE, state

from vfguide.estimation import estimation
from vfguide.estimation.air_state import AIRSPEED, sigma
from vfguide.estimation.estimation import Inputs, fresh_estimation
from vfguide.geometry.vector import ZERO
from vfguide.kernels.rows import row_of

DT = 0.02
UNKNOWN = (math.nan, math.nan, math.nan)


def flown(seconds, thrust=0.4, jump=0.0, exact=False, **told):
    """What is known after a straight flight to the north, and what the last step left."""
    s, nav = fresh_estimation(), None
    for k in range(round(seconds / DT) + 1):
        north = 25.0 * DT * k + (jump if k and k == round(seconds / DT) else 0.0)
        here = state((north, 0.0, -150.0), 0.0, roll=0.0, time=1.0 + DT * k)._replace(**told)
        nav, s = estimation.update(Inputs(here, here, ZERO, exact, 0.0), thrust, s, VEHICLE)
    return nav, s


def test_the_first_step_has_none_before_it():
    nav, s = flown(0.0)
    assert (nav.is_first, nav.is_continuous, nav.is_settled) == (True, False, True)
    assert (s.time, s.is_continuous, s.p_n) == (1.0, True, (0.0, 0.0, -150.0))


def test_a_step_knows_where_the_one_before_was():
    nav, _ = flown(DT)
    assert (nav.is_first, nav.is_continuous) == (False, True)
    assert nav.elapsed == pytest.approx(DT)
    assert nav.p_n_before == (0.0, 0.0, -150.0)
    assert nav.v_n_before == nav.state.v_n


def test_a_jump_is_let_in_slowly_and_until_then_the_place_is_not_settled():
    nav, s = flown(1.0, jump=50.0)
    assert nav.state.p_n[0] == pytest.approx(25.0, abs=0.1)
    assert not nav.is_settled
    assert (s.resets.number, s.p_n) == (1, nav.state.p_n)


def test_what_is_known_of_the_airspeed_is_what_is_believed_of_the_air():
    for told in ({}, {"airspeed": math.nan, "wind_n": UNKNOWN}):
        nav, s = flown(3.0, **told)
        air = s.air
        assert nav.trusts_sensor == air.sensor.trusted == (not told)
        assert nav.airspeed == air.estimate.x[AIRSPEED]
        assert nav.airspeed_sigma == sigma(air.estimate.P[AIRSPEED, AIRSPEED])
        assert nav.state.airspeed == (nav.airspeed if told else 25.0)


def test_the_thrust_of_the_step_before_moves_the_estimate():
    unmeasured = {"airspeed": math.nan, "wind_n": UNKNOWN}
    (slow, _), (fast, _) = (flown(2.0, thrust, **unmeasured) for thrust in (0.0, 1.0))
    assert fast.airspeed > slow.airspeed + 0.5


def test_the_lift_is_felt_as_it_was_measured_and_not_as_it_is_predicted():
    measured, predicted = state((0.0, 0.0, -150.0), 0.0), state((1.0, 0.0, -150.0), 0.3)
    s = fresh_estimation()
    for k in range(2):
        p_n = (measured.v_n[0] * DT * k, 0.0, -150.0 + measured.v_n[2] * DT * k)
        now = measured._replace(time=1.0 + DT * k, p_n=p_n)
        then = predicted._replace(time=1.0 + DT * k)
        nav, s = estimation.update(Inputs(then, now, ZERO, False, 0.02), 0.4, s, VEHICLE)
    assert nav.state.p_n == predicted.p_n
    assert s.air.vertical.v_n == measured.v_n
    assert s.air.v_n == predicted.v_n


def test_a_state_that_is_known_exactly_is_flown_on_as_it_is():
    nav, s = flown(1.0, exact=True, airspeed=7.0)
    assert nav.state.airspeed == 7.0
    assert nav.trusts_sensor
    assert (row_of(s.air) == row_of(fresh_estimation().air)).all()
