"""Differences of campaigns that were flown in pairs."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import optimize, stats

from vfguide.campaign.intervals import Interval, exact_rate
from vfguide.campaign.pairs import paired_difference, rate_difference

LEVEL = 0.95


@st.composite
def tables(draw: st.DrawFn) -> tuple[int, int, int]:
    """What only the first and only the second has, and all pairs."""
    first, second = draw(st.integers(0, 200)), draw(st.integers(0, 200))
    return first, second, first + second + draw(st.integers(1, 2000))


def statistic(difference: float, first: int, second: int, pairs: int) -> float:
    """Score of a difference, with the likelihood maximised numerically."""

    def unlikely(alone: float) -> float:
        cells = (alone, alone + difference, 1.0 - difference - 2.0 * alone)
        numbers = (first, second, pairs - first - second)
        logarithms = [n * math.log(p) for n, p in zip(numbers, cells, strict=True) if n]
        return -sum(logarithms)

    ends = (max(0.0, -difference) + 1e-12, 0.5 * (1.0 - difference) - 1e-12)
    alone = optimize.minimize_scalar(
        unlikely, bounds=ends, method="bounded", options={"xatol": 1e-11}
    )
    variance = pairs * (2.0 * alone.x + difference - difference**2)
    return (second - first - pairs * difference) / math.sqrt(variance)


@pytest.mark.parametrize(
    ("table", "level", "low", "high", "digits"),
    [
        ((1, 7, 21), 0.95, 0.026, 0.517, 3),  # Fagerland, Lydersen and Laake, 2014
        ((25, 28, 618), 0.90, -0.0148, 0.0247, 4),  # PropCIs::scoreci.mp of R
    ],
)
def test_the_interval_of_a_rate_difference_is_the_published_one(table, level, low, high, digits):
    found = rate_difference(*table, level)
    assert (round(found.interval.low, digits), round(found.interval.high, digits)) == (low, high)


@pytest.mark.parametrize("table", [(1, 7, 21), (40, 20, 160), (3, 90, 1000), (5, 4, 5000)])
def test_the_ends_are_where_the_score_of_the_likeliest_rates_is_the_quantile(table):
    low, high = rate_difference(*table, LEVEL).interval
    quantile = stats.norm.ppf(0.975)
    assert statistic(low, *table) == pytest.approx(quantile, rel=1e-4)
    assert statistic(high, *table) == pytest.approx(-quantile, rel=1e-4)


@given(tables(), st.floats(0.5, 0.999))
def test_nought_is_outside_where_mcnemar_rejects_it(table, level):
    first, second, _ = table
    low, high = rate_difference(*table, level).interval
    chi2 = (second - first) ** 2 / max(first + second, 1)
    limit = stats.chi2.ppf(level, 1)
    if not math.isclose(chi2, limit, rel_tol=1e-9):
        assert (low <= 0.0 <= high) == (chi2 <= limit)


@given(tables(), st.floats(0.5, 0.99))
def test_a_rate_difference_mirrors_grows_with_level_and_moves(table, level):
    first, second, pairs = table
    found = rate_difference(first, second, pairs, level)
    low, high = found.interval
    assert -1.0 <= low <= found.difference <= high <= 1.0
    mirrored = rate_difference(second, first, pairs, level)
    assert mirrored.difference == -found.difference
    assert mirrored.interval == pytest.approx((-high, -low), abs=1e-12)
    wider = rate_difference(first, second, pairs, 0.5 * (1.0 + level)).interval
    assert wider.low < low
    assert wider.high > high
    more = rate_difference(first, second + 1, pairs, level).interval
    assert more.low > low
    assert more.high > high


def test_no_pairs_few_pairs_and_pairs_that_all_differ():
    assert rate_difference(0, 0, 0, LEVEL) == (0, 0, 0, None, Interval(-1.0, 1.0))
    assert rate_difference(0, 5, 5, LEVEL).interval.high == 1.0
    assert rate_difference(5, 0, 5, LEVEL).interval.low == -1.0
    low, high = rate_difference(0, 0, 1000, LEVEL).interval
    assert high == -low == pytest.approx(stats.chi2.ppf(LEVEL, 1) / (1000 + 3.8415), rel=1e-4)
    assert high > exact_rate(0, 1000, LEVEL).interval.high


@pytest.mark.parametrize(
    ("pairs", "first", "second"), [(50, 0.1, 0.2), (500, 0.01, 0.02), (1000, 0.003, 0.003)]
)
def test_the_interval_of_a_rate_difference_holds_it_about_as_often_as_it_says(pairs, first, second):
    cells = np.random.default_rng(1).multinomial(pairs, (first, second, 1.0 - first - second), 4000)
    drawn, numbers = np.unique(cells[:, :2], axis=0, return_counts=True)
    inside = [
        ends.low <= second - first <= ends.high
        for ends in (rate_difference(*each, pairs, LEVEL).interval for each in drawn.tolist())
    ]
    assert numbers[inside].sum() / numbers.sum() == pytest.approx(LEVEL, abs=0.02)


def test_values_are_compared_pair_by_pair():
    first = [1.0, 2.0, None, 4.0, math.nan, 6.0, math.inf]
    second = [2.0, 1.0, 3.0, None, math.nan, 8.0, math.inf]
    found = paired_difference(first, second, LEVEL, np.random.default_rng(2))
    assert (found.mean.known, found.mean.missing) == (3, 4)
    assert found.mean.value == pytest.approx(2.0 / 3.0)
    assert found.median.value == 1.0
    assert (found.median.known, found.median.missing) == (3, 4)


def test_pairs_show_what_two_campaigns_apart_would_not():
    rng = np.random.default_rng(3)
    hardness = 100.0 * rng.exponential(size=500)
    second = hardness + rng.normal(1.0, 2.0, size=500)
    found = paired_difference(hardness, second, LEVEL, rng)
    for ends in (found.mean.interval, found.median.interval):
        assert 0.5 < ends.low < 1.0 < ends.high < 1.5
