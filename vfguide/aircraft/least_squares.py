"""Least squares with standard errors, for errors that last.

In loops of its own, not by LAPACK: setpoints follow from the result, and a replay on another
machine has to find the same.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Series

Array = NDArray[np.float64]

TIMES: Series = np.geomspace(0.01, 2.0, 54)
"""Response times that are tried, (54,), 10 % apart [s]."""
SINGULAR = 1e-9
"""Regressors of length 1 with less than this of their own, squared, are not told apart."""
FADED = 0.05
"""Errors are correlated until the autocorrelation falls below this part of their power."""


class Fit(NamedTuple):
    """y = A x by least squares."""

    x: Array
    """(n,)."""
    covariance: Array
    """(n, n); no numbers where the regressors cannot be told apart."""
    squares: float
    """Sum of what is left, squared."""
    variance: float
    """Of one sample of it, as if all were independent."""

    def sigma(self, *weights: float) -> float:
        """Standard error of a sum of the estimates, so weighted."""
        square = sum(
            v * w * self.covariance[i, j]
            for i, v in enumerate(weights)
            for j, w in enumerate(weights)
            if v and w
        )
        return math.sqrt(square) if square >= 0.0 else math.inf


def fitted(A: Array, y: Array, instruments: Array | None = None) -> Fit:
    """Least squares, or what the instruments make of y = A x.

    Args:
        A: (N, n) regressors.
        y: (N,).
        instruments: (N, n), what the regressors go with that no error does; None: they themselves.
    """
    x, spread, left = solved(A, y, A if instruments is None else instruments)
    squares = float(np.sum(left**2))
    variance = squares / max(1, len(y) - len(x)) * noise_correlation(left)
    return Fit(x, variance * spread, squares, variance)


def best_time(regressors: Callable[[float], Array], y: Array) -> tuple[float, float, Fit]:
    """The response time [s] that leaves least, its standard error, and the fit with it.

    Args:
        regressors: (N, n) for a response time [s].
        y: (N,).
    """
    squares: list[float] = []
    for time in TIMES.tolist():
        A = regressors(time)
        squares.append(float(np.sum(solved(A, y, A)[2] ** 2)))
    best = int(np.argmin(squares))
    time, fit = float(TIMES[best]), fitted(regressors(float(TIMES[best])), y)
    if not 0 < best < len(TIMES) - 1:
        return time, math.inf, fit
    # The parabola through three sums, over the logarithm of the time.
    before, least, after = squares[best - 1 : best + 2]
    step, bend = math.log(TIMES[1] / TIMES[0]), before - 2.0 * least + after
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
    """Solution x of Z^T A x = Z^T y, its covariance for errors of size 1, what is left of y."""
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
    """The inverse by Gauss and Jordan with pivots, no numbers where there is none."""
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
    """How many samples in a row tell the same: 1 and twice the sum of the autocorrelations."""
    power, total = 0.0, 1.0
    for value in left:
        power += value * value
    for lag in range(1, len(left) // 2):
        together = 0.0
        for k in range(lag, len(left)):
            together += left[k] * left[k - lag]
        if not together > FADED * power:
            break
        total += 2.0 * together / power
    return total


@compiled
def first_order(time: Series, asked: Series, delay: Series, response_time: float) -> Series:
    """What follows setpoints with a lag of first order, at the times of the samples, (N,).

    Args:
        time: (N,) of the samples [s].
        asked: (N,) setpoints, each held from `delay` after its sample until the next one acts.
        delay: (N,) [s].
        response_time: 63 % of a step [s].
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
