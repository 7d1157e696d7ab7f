"""How well rates, percentiles and means are known after a number of flights.

Every interval is two-sided and has a confidence level, such as 0.95; flights are independent draws.

- Rate, looked at once: the exact interval of Clopper and Pearson, Biometrika 26, 1934. It holds
  the rate with at least the level, whatever the rate is.
- Rate, looked at again and again: a confidence sequence. With probability of at least the level,
  none of the intervals of all looks leaves the rate out. It follows from Ville's inequality for
  the beta-binomial mixture martingale: Robbins, Ann. Math. Statist. 41, 1970; Howard, Ramdas,
  McAuliffe and Sekhon, Ann. Statist. 49, 2021.
- Percentile: the percentile interval of the bootstrap (Efron, Ann. Statist. 7, 1979). A
  resampled order statistic has a binomial distribution, so that the limit of infinitely many
  resamples is known without drawing one: Maritz and Jarrett, J. Am. Statist. Assoc. 73, 1978.
  In the tails it is too narrow: of 100 values it holds the 95th percentile 88 % of the time. It
  is widened to the interval between two values that holds the percentile of any distribution
  with at least the level: David and Nagaraja, Order Statistics, 2003, section 7.1.
- Mean: the interval BCa of the bootstrap, corrected for bias and skewness: Efron, J. Am. Statist.
  Assoc. 82, 1987. Resamples are drawn in blocks, so that memory is bounded.
"""

import math
from bisect import bisect_left
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from scipy import special

from vfguide.geometry.vector import Series

Values = Sequence[float | None] | Series
"""Numbers of flights; None and NaN stand for those that are missing."""

PRIOR = 0.5
"""Both parameters of the beta distribution over which the martingale is mixed, pure numbers;
Jeffreys' prior. A rate near 0 or 1 is known after fewer flights than with a uniform one: without
any failure it is known to be below 0.01 after 680 flights instead of 984, at level 0.95."""
RESAMPLES = 2000
"""Number of bootstrap samples of a mean; chosen, the largest that Efron and Tibshirani, An
Introduction to the Bootstrap, 1993, ask for of an interval."""
DRAWN_AT_ONCE = 1_000_000
"""Largest number of values that are drawn at once, more than one sample of them; chosen, 16 MB."""
BISECTIONS = 60
"""Number of bisections of an interval of at most 2; chosen, it leaves less than 2e-18."""
ROUNDING = 1e-9
"""Largest rounding error of a place among the values, as a ratio; chosen, far above that of two
multiplications and far below one place of a million."""


class Interval(NamedTuple):
    """Ends of a confidence interval, both included."""

    low: float
    high: float


class Rate(NamedTuple):
    """How often something happened."""

    successes: int
    trials: int
    rate: float | None
    """None: there was no trial."""
    interval: Interval


class Percentile(NamedTuple):
    """The least of the values that is not exceeded by a share of them."""

    percent: float
    value: float | None
    """None: no value is known."""
    interval: Interval | None
    known: int
    missing: int
    is_enough: bool
    """Whether the values are so many that the interval holds the percentile with the level. Of
    too few, the percentile may lie beyond the least or the largest value, where it ends."""


class Mean(NamedTuple):
    """The arithmetic mean of the values that are known."""

    value: float | None
    """None: no value is known, or one is infinite."""
    interval: Interval | None
    """None: as of the value, or there is one value only."""
    known: int
    missing: int


class Places(NamedTuple):
    """Ends of an interval, as places among the values in their order, from 1."""

    low: int
    high: int


def exact_rate(successes: int, trials: int, level: float) -> Rate:
    """A rate with the interval of Clopper and Pearson, for one look at it."""
    tail = (1.0 - level) / 2.0
    failures = trials - successes
    low = special.betaincinv(successes, failures + 1, tail) if successes else 0.0
    high = special.betainccinv(successes + 1, failures, tail) if failures else 1.0
    return Rate(successes, trials, share_of(successes, trials), Interval(float(low), float(high)))


def sequential_rate(successes: int, trials: int, level: float) -> Rate:
    """A rate with the interval of the confidence sequence, for looks as often as one likes."""
    rate = share_of(successes, trials)
    if rate is None:
        return Rate(successes, trials, rate, Interval(0.0, 1.0))

    def is_inside(each: float) -> bool:
        return not is_excluded(each, successes, trials, level)

    ends = Interval(border(is_inside, rate, 0.0), border(is_inside, rate, 1.0))
    return Rate(successes, trials, rate, ends)


def is_excluded(rate: float, successes: int, trials: int, level: float) -> bool:
    """Whether the confidence sequence leaves a rate out."""
    return bool(log_martingale(rate, successes, trials) >= -math.log1p(-level))


def log_martingale(rate: float, successes: Any, trials: Any) -> Any:
    """Logarithm of the mixture martingale, which starts at 0; of numbers, or of arrays of looks.

    Likelihood of the flights, mixed over the prior, over that of the rate:
    B(a + s, a + n - s) / (B(a, a) p^s (1 - p)^(n - s)). It is convex in p, and at most 0 at s / n.
    """
    failures = trials - successes
    mixed = special.betaln(PRIOR + successes, PRIOR + failures) - special.betaln(PRIOR, PRIOR)
    return mixed - special.xlogy(successes, rate) - special.xlog1py(failures, -rate)


def share_of(part: int, whole: int) -> float | None:
    """A part of a whole; None: the whole is nothing."""
    return part / whole if whole else None


def border(is_inside: Callable[[float], bool], inside: float, end: float) -> float:
    """The border of an interval between a point in it and an end, rounded outwards."""
    if is_inside(end):
        return end
    outside = end
    for _ in range(BISECTIONS):
        middle = 0.5 * (inside + outside)
        inside, outside = (middle, outside) if is_inside(middle) else (inside, middle)
    return outside


def percentile(values: Values, percent: float, level: float) -> Percentile:
    """A percentile, between 0 and 100, and its interval.

    It is one of the values, the first definition of Hyndman and Fan, Am. Stat. 50, 1996
    (`inverted_cdf` of NumPy); so are both ends.
    """
    ordered, missing = _known(values)
    n, share = ordered.size, percent / 100.0
    if not n:
        return Percentile(percent, None, None, 0, missing, False)
    tail, k = (1.0 - level) / 2.0, _place(n * share, n)
    drawn, any_law = _resampled_places(k, n, tail), _binomial_places(share, n, tail)
    low, high = min(drawn.low, max(any_law.low, 1)), max(drawn.high, min(any_law.high, n))
    ends = Interval(float(ordered[low - 1]), float(ordered[high - 1]))
    is_enough = any_law.low >= 1 and any_law.high <= n
    return Percentile(percent, float(ordered[k - 1]), ends, n, missing, is_enough)


def mean(values: Values, level: float, rng: np.random.Generator) -> Mean:
    """The mean and its bootstrap interval, whatever the order of the values."""
    ordered, missing = _known(values)
    n = ordered.size
    if not n or not np.isfinite(ordered).all():
        return Mean(None, None, n, missing)
    value = float(ordered.mean())
    return Mean(value, _bca(ordered, value, level, rng) if n > 1 else None, n, missing)


def _known(values: Values) -> tuple[Series, int]:
    """The values in order, without those that are missing, and how many are."""
    numbers = np.asarray(values, dtype=float)
    known = np.sort(numbers[~np.isnan(numbers)])
    return known, numbers.size - known.size


def _place(number: float, n: int) -> int:
    """The least of the places 1 to n that is not below a number, but for its rounding error."""
    return min(max(math.ceil(number * (1.0 - ROUNDING)), 1), n)


def _resampled_places(k: int, n: int, tail: float) -> Places:
    """Between which places the k-th value of a resample lies, but for a tail on either side.

    It lies at or below the j-th of the n values if k or more of the n draws are among the first j.
    """

    def at_or_below(j: int) -> float:
        return float(special.bdtrc(k - 1, n, j / n))

    places = range(1, n + 1)
    low, high = (bisect_left(places, each, key=at_or_below) for each in (tail, 1.0 - tail))
    return Places(low + 1, min(high + 1, n))


def _binomial_places(share: float, n: int, tail: float) -> Places:
    """Between which places a percentile lies, but for a tail on either side; perhaps 0 or n + 1.

    It lies at or above the j-th value if j or more of the n values are at or below it.
    """

    def at_most(number: int) -> float:
        return float(special.bdtr(number, n, share))

    numbers = range(n + 1)
    low, high = (bisect_left(numbers, each, key=at_most) for each in (tail, 1.0 - tail))
    return Places(low, high + 1)


def _bca(values: Series, value: float, level: float, rng: np.random.Generator) -> Interval:
    """The interval BCa of a mean; where all values are the same, that value."""
    if np.ptp(values) == 0.0:
        return Interval(value, value)
    means = _resampled_means(values, rng)
    below = ((means < value).sum() + 0.5 * (means == value).sum()) / RESAMPLES
    bias = float(special.ndtri(np.clip(below, 0.5 / RESAMPLES, 1.0 - 0.5 / RESAMPLES)))
    deviations = values - value
    scaled = deviations / np.abs(deviations).max()
    acceleration = float((scaled**3).sum()) / (6.0 * float((scaled**2).sum()) ** 1.5)
    shifted = bias + special.ndtri([(1.0 - level) / 2.0, (1.0 + level) / 2.0])
    shares = special.ndtr(bias + shifted / (1.0 - acceleration * shifted))
    low, high = np.quantile(means, shares).tolist()
    return Interval(low, high)


def _resampled_means(values: Series, rng: np.random.Generator) -> Series:
    n = values.size
    rows = max(1, DRAWN_AT_ONCE // n)
    sizes = [min(rows, RESAMPLES - done) for done in range(0, RESAMPLES, rows)]
    blocks = [values[rng.integers(n, size=(size, n))].mean(axis=1) for size in sizes]
    return np.concatenate(blocks)
