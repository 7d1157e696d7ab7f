"""Least squares with standard errors, and the response of first order."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.aircraft.least_squares import (
    best_time,
    first_order,
    fitted,
    noise_correlation,
    with_constant,
)

DT = 0.02
SEEDS = st.integers(0, 2**32 - 1)


@given(SEEDS, st.integers(1, 4), st.integers(6, 60))
def test_it_is_numpy_s_least_squares(seed, n, N):
    rng = np.random.default_rng(seed)
    A, y = rng.normal(0.0, 10.0 ** rng.uniform(-4, 4, n), (N, n)), rng.normal(0.0, 3.0, N)
    fit = fitted(A, y)
    x, squares, *_ = np.linalg.lstsq(A, y)
    assert fit.x == pytest.approx(x, rel=1e-6)
    assert fit.squares == pytest.approx(float(squares[0]), rel=1e-6)
    left = y - A @ x
    covariance = np.linalg.inv(A.T @ A) * float(squares[0]) / (N - n) * noise_correlation(left)
    assert fit.covariance == pytest.approx(covariance, rel=1e-5)


@given(SEEDS)
def test_instruments_find_what_noise_in_the_regressor_hides(seed):
    rng = np.random.default_rng(seed)
    z = rng.normal(0.0, 1.0, 20_000)
    noise = rng.normal(0.0, 1.0, len(z))
    x, y = z + noise, 2.0 * z - noise
    assert fitted(with_constant(x), y).x[1] < 1.0
    assert fitted(with_constant(x), y, with_constant(z)).x[1] == pytest.approx(2.0, abs=0.15)


@pytest.mark.parametrize("other", [1.0, 8.0, -3.0])
def test_regressors_that_cannot_be_told_apart_have_no_standard_error(other):
    t = np.linspace(0.0, 1.0, 50)
    fit = fitted(with_constant(t, np.full_like(t, other)), 1.0 + t)
    assert fit.sigma(1.0, 0.0, 0.0) == math.inf
    assert fit.sigma(0.0, 1.0, 0.0) == math.inf


def test_errors_that_last_count_as_fewer():
    rng = np.random.default_rng(1)
    white = rng.normal(0.0, 1.0, 4000)
    assert noise_correlation(white) == pytest.approx(1.0, abs=0.3)
    # Of a mean over 25 samples the autocorrelations sum up to 25.
    lasting = np.convolve(white, np.ones(25), "valid")
    assert noise_correlation(lasting) == pytest.approx(25.0, rel=0.3)


@given(st.floats(0.02, 1.0), SEEDS)
def test_the_best_time_is_the_true_one(true, seed):
    rng = np.random.default_rng(seed)
    time = np.arange(0.0, 60.0, DT)
    asked = np.repeat(rng.uniform(-1.0, 1.0, 60), 50)
    none = np.zeros_like(time)
    y = first_order(time, asked, none, true) + rng.normal(0.0, 0.02, len(time))
    found, sigma, fit = best_time(lambda lag: with_constant(first_order(time, asked, none, lag)), y)
    assert found == pytest.approx(true, rel=0.02, abs=5.0 * sigma)
    assert 0.0 < sigma < 0.05 * true
    assert fit.x[1] == pytest.approx(1.0, abs=0.02)


def test_a_time_beyond_all_that_are_tried_is_not_known():
    time = np.arange(0.0, 60.0, DT)
    asked, none = np.repeat(np.resize([1.0, -1.0], 60), 50), np.zeros_like(time)
    y = first_order(time, asked, none, 30.0)
    _, sigma, _ = best_time(lambda lag: with_constant(first_order(time, asked, none, lag)), y)
    assert sigma == math.inf


@pytest.mark.parametrize("delay", [0.0, 0.013, 0.1])
def test_a_step_is_followed_with_a_lag_of_first_order(delay):
    time = np.arange(0.0, 2.0, DT)
    asked = np.where(time >= 0.5, 1.0, 0.0)
    follows = first_order(time, asked, np.full_like(time, delay), 0.2)
    since = time - 0.5 - delay
    exact = np.where(since > 0.0, -np.expm1(-since / 0.2), 0.0)
    assert follows == pytest.approx(exact, abs=1e-12)
