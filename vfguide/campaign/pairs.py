"""How well the difference of two campaigns is known that were flown in pairs, seed by seed.

- Of two rates: the score interval of Tango, Stat. Med. 17, 1998. It leaves 0 out exactly where
  McNemar's test rejects equality, and keeps a width where no pair differs, as most flights of two
  versions do. Those of Wald and of Newcombe (Stat. Med. 17, 1998) can shrink to nothing there, and
  one that is exact given the number of pairs that differ takes that number for known. The level
  is approximate; Fagerland, Lydersen and Laake, Stat. Med. 33, 2014, compare it with others.
- Of values: mean and median of the differences, with the bootstrap intervals of
  `vfguide.campaign.intervals`.
"""

import math
from typing import NamedTuple

import numpy as np
from scipy import special

from vfguide.campaign.intervals import Interval, Mean, Percentile, Values, border, mean, percentile


class RateDifference(NamedTuple):
    """The rate of the second campaign less that of the first, flown in pairs."""

    only_first: int
    only_second: int
    pairs: int
    difference: float | None
    """None: there was no pair."""
    interval: Interval


class PairedDifference(NamedTuple):
    """Values of the second campaign less those of the first, flown in pairs."""

    mean: Mean
    median: Percentile


def rate_difference(only_first: int, only_second: int, pairs: int, level: float) -> RateDifference:
    """The difference of two rates, of the pairs in which one campaign alone had what is counted."""
    if not pairs:
        return RateDifference(0, 0, 0, None, Interval(-1.0, 1.0))
    difference = (only_second - only_first) / pairs
    quantile = float(special.ndtri((1.0 + level) / 2.0))

    def is_inside(each: float) -> bool:
        excess = only_second - only_first - pairs * each
        variance = _score_variance(each, only_first, only_second, pairs)
        return excess * excess <= quantile * quantile * variance

    ends = Interval(border(is_inside, difference, -1.0), border(is_inside, difference, 1.0))
    return RateDifference(only_first, only_second, pairs, difference, ends)


def paired_difference(
    first: Values, second: Values, level: float, rng: np.random.Generator
) -> PairedDifference:
    """Mean and median of the differences; a pair with a missing value is missing."""
    with np.errstate(invalid="ignore"):  # of two infinite values nothing is known
        differences = np.asarray(second, dtype=float) - np.asarray(first, dtype=float)
    return PairedDifference(mean(differences, level, rng), percentile(differences, 50.0, level))


def _score_variance(difference: float, only_first: int, only_second: int, pairs: int) -> float:
    """Variance of the score of a difference, with the most likely share of the first alone.

    That share solves 2 n q^2 + B q - c d (1 - d) = 0 (Tango, 1998, with b of the second and c of
    the first alone), and the variance is n (2 q + d (1 - d)).
    """
    spread = difference * (1.0 - difference)
    linear = (2 * pairs - only_second + only_first) * difference - only_second - only_first
    root = math.sqrt(max(linear * linear + 8.0 * pairs * only_first * spread, 0.0))
    return pairs * (2.0 * (root - linear) / (4.0 * pairs) + spread)
