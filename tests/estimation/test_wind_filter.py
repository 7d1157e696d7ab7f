"""The Kalman filter of the wind triangle against the formulas of the textbook."""

import numpy as np
import pytest

from vfguide.aircraft.flight_model import ModelledFlight
from vfguide.estimation.air_state import ACCELERATION_BIAS, AIRSPEED, STATES, WindEstimate
from vfguide.estimation.wind_filter import PROCESS_NOISE, copied, measurement_update, time_update

DT = 0.02


def some_estimate(seed=1):
    """An estimate with errors that all go together."""
    rng = np.random.default_rng(seed)
    root = rng.normal(0.0, 1.0, (STATES, STATES))
    return WindEstimate(rng.normal(0.0, 5.0, STATES), root @ root.T)


def test_the_time_update_propagates_state_and_covariance():
    before, flight = some_estimate(), ModelledFlight((1.0, 0.0, 0.0), 0.7, -0.3)
    x, covariance = time_update(before, flight, DT)
    F = np.eye(STATES)
    F[AIRSPEED, AIRSPEED] += DT * flight.slope
    F[AIRSPEED, ACCELERATION_BIAS] = DT
    moved = before.x.copy()
    moved[AIRSPEED] += DT * (flight.acceleration + before.x[ACCELERATION_BIAS])
    assert x == pytest.approx(moved)
    assert covariance == pytest.approx(F @ before.P @ F.T + DT * np.diag(PROCESS_NOISE))


def test_the_measurement_update_takes_the_gain_of_kalman():
    before, h, variance = some_estimate(2), np.array((0.6, 0.8, 0.9, 20.0, 1.0, 0.0)), 0.5
    x, covariance = copied(before)
    measurement_update(WindEstimate(x, covariance), tuple(h.tolist()), 1.5, variance)
    gain = before.P @ h / (h @ before.P @ h + variance)
    assert x == pytest.approx(before.x + 1.5 * gain)
    assert covariance == pytest.approx((np.eye(STATES) - np.outer(gain, h)) @ before.P)


def test_updates_leave_the_estimate_of_the_step_before():
    before, same = some_estimate(), some_estimate()
    after = time_update(before, ModelledFlight((1.0, 0.0, 0.0), 0.7, -0.3), DT)
    measurement_update(after, (1.0, 0.0, 0.0, 0.0, 0.0, 0.0), 1.0, 1.0)
    assert np.array_equal(before.x, same.x)
    assert np.array_equal(before.P, same.P)
