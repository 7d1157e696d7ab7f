"""Least squares and instrumental variables, with standard errors for correlated noise.

It uses loops of its own instead of LAPACK: setpoints follow from the result, and a replay on
another machine must give the same.

L. Ljung, System Identification: Theory for the User, 1999, chapter 7: instrumental variables.
G. V. Bayley and J. M. Hammersley, The "Effective" Number of Independent Observations in an
Autocorrelated Time Series, 1946: `noise_correlation`.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.geometry.vector import Series
from vfguide.kernels.compiled import compiled

Array = NDArray[np.float64]

RESPONSE_TIMES: Series = np.geomspace(0.01, 2.0, 54)
"""Response times that are tried, (54,) [s]: 0.01 to 2 s in steps of 10 %; chosen to enclose those
of small aircraft."""
SINGULAR = 1e-9
"""Least pivot of a matrix of normalised regressors that counts as not zero, dimensionless: the
squared length of what is independent of the others; chosen well above rounding."""
LEAST_CORRELATION = 0.05
"""Autocorrelation, as a share of the power, below which later lags are ignored; chosen."""


class Fit(NamedTuple):
    """Solution of y = A x by least squares."""

    x: Array
    """Estimates, (n,)."""
    covariance: Array
    """Their covariance, (n, n); not numbers where the regressors are linearly dependent."""
    squares: float
    """Sum of the squared residuals."""
    variance: float
    """Variance of a residual, times the `noise_correlation` of the residuals."""

    def sigma(self, *weights: float) -> float:
        """Standard error of the weighted sum of the estimates."""
        square = sum(
            v * w * self.covariance[i, j]
            for i, v in enumerate(weights)
            for j, w in enumerate(weights)
            if v and w
        )
        return math.sqrt(square) if square >= 0.0 else math.inf


def fitted(A: Array, y: Array, instruments: Array | None = None) -> Fit:
    """Solution of y = A x by least squares, or by instrumental variables.

    Args:
        A: (N, n) regressors.
        y: (N,) observations.
        instruments: (N, n), correlated with the regressors but not with the noise; None for the
            regressors themselves.
    """
    x, spread, left = solved(A, y, A if instruments is None else instruments)
    squares = float(np.sum(left**2))
    variance = squares / max(1, len(y) - len(x)) * noise_correlation(left)
    return Fit(x, variance * spread, squares, variance)


def best_time(regressors: Callable[[float], Array], y: Array) -> tuple[float, float, Fit]:
    """The response time with the least residuals [s], its standard error [s], and the fit with it.

    Args:
        regressors: gives the regressors (N, n) for a response time [s].
        y: (N,) observations.
    """
    squares: list[float] = []
    for time in RESPONSE_TIMES.tolist():
        A = regressors(time)
        squares.append(float(np.sum(solved(A, y, A)[2] ** 2)))
    best = int(np.argmin(squares))
    time, fit = float(RESPONSE_TIMES[best]), fitted(regressors(float(RESPONSE_TIMES[best])), y)
    if not 0 < best < len(RESPONSE_TIMES) - 1:
        return time, math.inf, fit
    # The parabola through three sums, over the logarithm of the time.
    before, least, after = squares[best - 1 : best + 2]
    step, bend = math.log(RESPONSE_TIMES[1] / RESPONSE_TIMES[0]), before - 2.0 * least + after
    if not bend > 0.0:
        return time, math.inf, fit
    time *= math.exp(0.5 * (before - after) / bend * step)
    fit = fitted(regressors(time), y)
    return time, time * step * math.sqrt(2.0 * fit.variance / bend), fit


def with_constant(*regressors: Array) -> Array:
    """A constant and the regressors, side by side, (N, n)."""
    return np.column_stack((np.ones_like(regressors[0]), *regressors))


@compiled
def solved(A: Array, y: Array, Z: Array) -> tuple[Array, Array, Array]:
    """Solution x of Z^T A x = Z^T y, its covariance for unit variance, and the residuals of y."""
    N, n = A.shape
    lengths, Z_lengths = column_lengths(A), column_lengths(Z)
    M, ZZ, b = np.zeros((n, n)), np.zeros((n, n)), np.zeros(n)
    for k in range(N):
        for i in range(n):
            z = Z[k, i] / Z_lengths[i]
            b[i] += z * y[k]
            for j in range(n):
                M[i, j] += z * A[k, j] / lengths[j]
                ZZ[i, j] += z * Z[k, j] / Z_lengths[j]
    inverse = inverted(M)
    x, spread, left = np.zeros(n), np.zeros((n, n)), y.copy()
    for i in range(n):
        for j in range(n):
            x[i] += inverse[i, j] * b[j] / lengths[i]
            for k in range(n):
                for m in range(n):
                    part = inverse[i, k] * ZZ[k, m] * inverse[j, m]
                    spread[i, j] += part / (lengths[i] * lengths[j])
    for k in range(N):
        for j in range(n):
            left[k] -= A[k, j] * x[j]
    return x, spread, left


@compiled
def column_lengths(A: Array) -> Array:
    """The length of each column, (n,)."""
    N, n = A.shape
    squares = np.zeros(n)
    for j in range(n):
        for k in range(N):
            squares[j] += A[k, j] ** 2
    return np.sqrt(np.maximum(squares, 1e-300))


@compiled
def inverted(M: Array) -> Array:
    """The inverse by Gauss-Jordan elimination with pivots; not numbers where there is none."""
    n = len(M)
    left, right = M.copy(), np.eye(n)
    for i in range(n):
        pivot = i + int(np.argmax(np.abs(left[i:, i])))
        if not abs(left[pivot, i]) > SINGULAR:
            return np.full((n, n), np.nan)
        for j in range(n):
            left[i, j], left[pivot, j] = left[pivot, j], left[i, j]
            right[i, j], right[pivot, j] = right[pivot, j], right[i, j]
        scale = left[i, i]
        for j in range(n):
            left[i, j] /= scale
            right[i, j] /= scale
        for k in range(n):
            factor = left[k, i]
            if k != i:
                for j in range(n):
                    left[k, j] -= factor * left[i, j]
                    right[k, j] -= factor * right[i, j]
    return right


@compiled
def noise_correlation(left: Array) -> float:
    """Number of samples that count as one: 1 plus twice the sum of the autocorrelations."""
    power, total = 0.0, 1.0
    for value in left:
        power += value * value
    for lag in range(1, len(left) // 2):
        together = 0.0
        for k in range(lag, len(left)):
            together += left[k] * left[k - lag]
        if not together > LEAST_CORRELATION * power:
            break
        total += 2.0 * together / power
    return total


@compiled
def first_order(time: Series, asked: Series, delay: Series, response_time: float) -> Series:
    """Response to setpoints with a first-order lag, at the times of the samples, (N,).

    Args:
        time: (N,) times of the samples [s].
        asked: (N,) setpoints, each held from `delay` after its sample until the next one acts.
        delay: (N,) delays from a sample until its setpoint acts [s].
        response_time: time to 63 % of a step [s].
    """
    follows = np.empty(len(time))
    now, acts, value = time[0], 0, asked[0]
    for k in range(len(time)):
        while acts + 1 < len(time) and time[acts + 1] + delay[acts + 1] <= time[k]:
            then = time[acts + 1] + delay[acts + 1]
            value += (asked[acts] - value) * -math.expm1(-max(0.0, then - now) / response_time)
            now, acts = max(now, then), acts + 1
        value += (asked[acts] - value) * -math.expm1(-max(0.0, time[k] - now) / response_time)
        now = max(now, time[k])
        follows[k] = value
    return follows
