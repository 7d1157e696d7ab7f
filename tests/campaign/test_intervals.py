"""Intervals against published values, SciPy, and flights whose rates are known."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import special, stats

from vfguide.campaign.intervals import (
    Interval,
    exact_rate,
    is_excluded,
    log_martingale,
    mean,
    percentile,
    sequential_rate,
)

LEVEL = 0.95
LEVELS = st.floats(0.5, 0.999)


@st.composite
def counts(draw: st.DrawFn) -> tuple[int, int]:
    """Successes and trials."""
    trials = draw(st.integers(1, 3000))
    return draw(st.integers(0, trials)), trials


@pytest.mark.parametrize(
    ("successes", "trials", "low", "high"),
    [
        (81, 263, 0.2527, 0.3676),
        (15, 148, 0.0578, 0.1617),
        (0, 20, 0.0, 0.1684),
        (1, 29, 0.0009, 0.1776),
    ],
)
def test_the_exact_interval_is_that_of_newcombe_1998_table_1_method_5(successes, trials, low, high):
    found = exact_rate(successes, trials, LEVEL)
    assert found.rate == successes / trials
    assert found.interval == pytest.approx((low, high), abs=5e-5)


@settings(max_examples=40)
@given(counts(), LEVELS)
def test_the_exact_interval_is_that_of_scipy(some, level):
    oracle = stats.binomtest(*some).proportion_ci(level, method="exact")
    assert exact_rate(*some, level).interval == pytest.approx((oracle.low, oracle.high), rel=1e-9)


@pytest.mark.parametrize("rate_of", [exact_rate, sequential_rate])
def test_none_and_all_are_at_the_ends(rate_of):
    assert rate_of(0, 50, LEVEL).interval.low == 0.0
    assert rate_of(50, 50, LEVEL).interval.high == 1.0
    assert rate_of(0, 0, LEVEL) == (0, 0, None, Interval(0.0, 1.0))


@pytest.mark.parametrize("rate_of", [exact_rate, sequential_rate])
@settings(max_examples=50)
@given(counts(), LEVELS)
def test_an_interval_grows_with_level_moves_with_successes_and_mirrors(rate_of, some, level):
    successes, trials = some
    low, high = rate_of(successes, trials, level).interval
    assert 0.0 <= low <= successes / trials <= high <= 1.0
    wider = rate_of(successes, trials, 0.5 * (1.0 + level)).interval
    assert wider.low <= low
    assert wider.high >= high
    more = rate_of(successes + 1, trials + 1, level).interval
    assert more.low >= low
    assert more.high >= high
    other = rate_of(trials - successes, trials, level).interval
    assert (1.0 - other.high, 1.0 - other.low) == pytest.approx((low, high), abs=1e-12)


@pytest.mark.parametrize(("trials", "rate"), [(10, 0.1), (100, 0.01), (100, 0.5), (1000, 0.003)])
def test_the_exact_interval_holds_the_rate_with_the_level(trials, rate):
    successes = np.arange(trials + 1)
    inside = [
        ends.low <= rate <= ends.high
        for ends in (exact_rate(each, trials, LEVEL).interval for each in successes.tolist())
    ]
    assert stats.binom.pmf(successes, trials, rate)[inside].sum() >= LEVEL


@given(counts(), st.floats(0.001, 0.999))
def test_what_the_sequence_rests_on_is_a_martingale(some, rate):
    successes, trials = some
    now = log_martingale(rate, successes, trials)
    after = [log_martingale(rate, successes + each, trials + 1) - now for each in (0, 1)]
    assert (1.0 - rate) * np.exp(after[0]) + rate * np.exp(after[1]) == pytest.approx(1.0, rel=1e-8)
    assert log_martingale(rate, 0, 0) == 0.0


@given(counts())
def test_the_regret_of_the_prior_is_that_of_krichevsky_and_trofimov_1981(some):
    successes, trials = some
    regret = -log_martingale(successes / trials, successes, trials)
    assert -1e-9 <= regret <= math.log(2.0) + 0.5 * math.log(trials) + 1e-9


TRIALS = np.arange(1, 1001)


def walks(rate: float) -> np.ndarray:
    """Successes of 2,000 campaigns after each of 1,000 flights."""
    flights = np.random.default_rng(18).random((2000, TRIALS.size)) < rate
    return flights.cumsum(axis=1)


def exact_excludes(rate: float, successes: np.ndarray, trials: np.ndarray) -> np.ndarray:
    """Whether an exact interval, made for one look, leaves the rate out."""
    too_many = special.bdtrc(successes - 1, trials, rate)
    return np.minimum(too_many, special.bdtr(successes, trials, rate)) < (1.0 - LEVEL) / 2.0


def sequence_excludes(rate: float, successes: np.ndarray, trials: np.ndarray) -> np.ndarray:
    """Whether the confidence sequence does."""
    return log_martingale(rate, successes, trials) >= -math.log(1.0 - LEVEL)


@pytest.mark.parametrize("rate", [0.01, 0.1, 0.5])
def test_the_sequence_holds_the_rate_at_all_looks_together_and_the_exact_interval_does_not(rate):
    successes = walks(rate)
    table = np.minimum(np.arange(successes.max() + 1)[:, None], TRIALS)
    sequence = sequence_excludes(rate, table, TRIALS)[successes, TRIALS - 1]
    assert 0.0 < sequence.any(axis=1).mean() <= 1.0 - LEVEL
    exact = exact_excludes(rate, table, TRIALS)[successes, TRIALS - 1]
    assert exact.any(axis=1).mean() > 2.0 * (1.0 - LEVEL)


def test_what_the_walks_are_judged_by_is_the_intervals():
    rate = 0.1
    for trials in (1, 10, 100, 1000):
        for successes in range(min(trials, 150) + 1):
            low, high = exact_rate(successes, trials, LEVEL).interval
            assert exact_excludes(rate, successes, trials) == (not low <= rate <= high)
            low, high = sequential_rate(successes, trials, LEVEL).interval
            assert sequence_excludes(rate, successes, trials) == (not low <= rate <= high)
            assert is_excluded(rate, successes, trials, LEVEL) == (not low <= rate <= high)


@settings(max_examples=50)
@given(counts(), LEVELS)
def test_the_ends_of_the_sequence_are_where_the_martingale_reaches_its_limit(some, level):
    low, high = sequential_rate(*some, level).interval
    for end in {low, high} - {0.0, 1.0}:
        assert log_martingale(end, *some) == pytest.approx(-math.log(1.0 - level), rel=1e-6)


def test_a_rate_of_nought_is_known_as_soon_as_the_constants_docstring_says():
    assert not is_excluded(0.01, 0, 679, LEVEL)
    assert is_excluded(0.01, 0, 680, LEVEL)


def test_percentiles_are_those_of_numpy():
    values = np.random.default_rng(1).normal(size=1000)
    for percent in (0.1, 1, 5, 25, 50, 75, 90, 95, 99, 99.85):
        oracle = np.percentile(values, percent, method="inverted_cdf")
        assert percentile(values, percent, LEVEL).value == oracle


def test_a_place_is_not_rounded_up_for_an_error_of_rounding():
    assert 1000 * (99.9 / 100.0) > 999.0
    assert percentile(np.arange(1.0, 1001.0), 99.9, LEVEL).value == 999.0


@pytest.mark.parametrize(("n", "percent"), [(15, 50.0), (40, 10.0), (100, 95.0)])
def test_the_interval_of_a_percentile_is_that_of_its_resamples_or_of_any_distribution(n, percent):
    """Each end is a quantile of 20,000 resamples, or that of a binomial distribution."""
    rng = np.random.default_rng(2)
    values = np.sort(rng.exponential(size=n))
    resampled = np.percentile(
        values[rng.integers(n, size=(20_000, n))], percent, axis=1, method="inverted_cdf"
    )
    drawn = np.quantile(resampled, (0.025, 0.975), method="inverted_cdf")
    places = stats.binom.ppf((0.025, 0.975), n, percent / 100.0) + np.array((0, 1))
    any_law = values[np.clip(places, 1, n).astype(int) - 1]
    ends = (min(drawn[0], any_law[0]), max(drawn[1], any_law[1]))
    assert percentile(values, percent, LEVEL).interval == ends


@pytest.mark.parametrize("percent", [1.0, 5.0, 25.0, 50.0, 90.0, 95.0, 99.0])
@pytest.mark.parametrize("n", [20, 100, 1000, 100_000])
def test_where_the_values_are_enough_the_interval_of_a_percentile_holds_it(n, percent):
    """Places hold the percentile of any continuous distribution with a known probability."""
    found = percentile(np.arange(1.0, n + 1.0), percent, LEVEL)
    low, high = found.interval
    law = stats.binom(n, percent / 100.0)
    below, above = law.cdf(low - 1.0), law.sf(high - 1.0)
    if found.is_enough:
        assert 1.0 - below - above >= LEVEL
    else:
        assert max(law.pmf(0), law.pmf(n)) > (1.0 - LEVEL) / 2.0
    if n == 100_000:
        assert 1.0 - below - above == pytest.approx(LEVEL, abs=0.01)


def test_missing_values_are_left_out_and_counted():
    found = percentile([3.0, None, 1.0, math.nan, 2.0], 50.0, LEVEL)
    assert found == (50.0, 2.0, Interval(1.0, 3.0), 3, 2, False)
    assert percentile([None, None], 50.0, LEVEL) == (50.0, None, None, 0, 2, False)
    assert percentile([], 50.0, LEVEL) == (50.0, None, None, 0, 0, False)
    assert percentile([1.0, math.inf, math.inf], 90.0, LEVEL).value == math.inf
    rng = np.random.default_rng(3)
    assert mean([3.0, None, 1.0, math.nan], LEVEL, rng)[2:] == (2, 2)
    assert mean([None], LEVEL, rng) == (None, None, 0, 1)
    assert mean([1.0, math.inf], LEVEL, rng) == (None, None, 2, 0)
    assert mean([7.0], LEVEL, rng) == (7.0, None, 1, 0)


@settings(max_examples=40)
@given(st.lists(st.floats(-1e6, 1e6), min_size=1), st.floats(0.1, 99.9), LEVELS, st.randoms())
def test_a_percentile_is_in_its_interval_whatever_the_order(values, percent, level, random):
    found = percentile(values, percent, level)
    assert found.interval.low <= found.value <= found.interval.high
    assert {*found.interval, found.value} <= set(values)
    random.shuffle(values)
    assert percentile(values, percent, level) == found


@pytest.mark.parametrize("scale", [1.0, 1e-6, 1e6])
def test_the_interval_of_a_mean_is_that_of_scipy(scale):
    values = scale * np.random.default_rng(4).exponential(size=60)
    oracle = stats.bootstrap(
        (values,), np.mean, n_resamples=20_000, method="BCa", rng=np.random.default_rng(5)
    )
    found = mean(values, LEVEL, np.random.default_rng(6))
    assert found.value == pytest.approx(values.mean())
    ends = oracle.confidence_interval
    tolerance = 0.15 * oracle.standard_error
    assert found.interval == pytest.approx((ends.low, ends.high), abs=tolerance)


def test_the_interval_of_a_mean_holds_it_about_as_often_as_it_says():
    rng = np.random.default_rng(7)
    samples = rng.exponential(size=(300, 50))
    ends = [mean(values, LEVEL, rng).interval for values in samples]
    assert np.mean([low <= 1.0 <= high for low, high in ends]) == pytest.approx(LEVEL, abs=0.03)


def test_the_interval_of_a_mean_is_reproducible_whatever_the_order():
    values = np.random.default_rng(8).normal(size=3000)
    found = mean(values, LEVEL, np.random.default_rng(9))
    assert mean(values[::-1], LEVEL, np.random.default_rng(9)) == found
    assert mean(values, LEVEL, np.random.default_rng(10)).interval != found.interval


@pytest.mark.parametrize("value", [0.0, 0.1, -1e9])
@pytest.mark.parametrize("n", [2, 3, 1000])
def test_the_mean_of_one_value_again_and_again_is_that_value(n, value):
    found = mean([value] * n, LEVEL, np.random.default_rng(11))
    assert (found.value, *found.interval) == pytest.approx((value, value, value))


@settings(max_examples=50)
@given(st.lists(st.floats(-1e6, 1e6), min_size=2, max_size=20), st.floats(0.5, 0.99))
def test_the_interval_of_any_mean_is_within_its_values(values, level):
    low, high = mean(values, level, np.random.default_rng(12)).interval
    rounding = 1e-9 * max(map(abs, values))
    assert min(values) - rounding <= low <= high <= max(values) + rounding
