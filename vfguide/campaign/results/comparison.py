"""The comparison of two campaigns that were flown in pairs: what differs, and how surely."""

import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from vfguide.campaign.intervals import Interval, percentile
from vfguide.campaign.pairs import paired_difference, rate_difference
from vfguide.campaign.results.flown import FlightTexts, FlownCampaign
from vfguide.campaign.results.pairing import Identity, PairedCampaigns
from vfguide.campaign.summary import (
    LEVEL,
    PercentileSummary,
    RateSummary,
    percentile_summary,
    rate_summary,
)
from vfguide.files.atomic import write_atomically
from vfguide.files.errors import InputError
from vfguide.geometry.vector import Mask, Series

COMPARISON = "compare.json"
"""Name of the file."""
BOOTSTRAP_SEED = 1
"""Seed of the bootstrap samples, a number; chosen. One that never changes gives the same intervals
for the same campaigns."""


@dataclass(frozen=True)
class Side:
    """One of the two campaigns."""

    folder: str
    flights: int
    """Number of its flights, those without a partner too."""
    campaign: Identity


@dataclass(frozen=True)
class RateComparison:
    """How often something was so in either campaign, among the pairs."""

    name: str
    a: RateSummary
    b: RateSummary
    only_a: int
    """Number of pairs in which it was so in the first campaign alone."""
    only_b: int
    difference: float | None
    """Of the second less the first."""
    interval: Interval
    """Of the difference, at 95 %."""


@dataclass(frozen=True)
class MeanDifference:
    """The mean of the differences of the pairs, the second less the first."""

    value: float | None
    interval: Interval | None
    """At 95 %; None: there is one pair only."""


@dataclass(frozen=True)
class FigureComparison:
    """A figure of either campaign, over the pairs in which both have it."""

    column: str
    pairs: int
    """Number of pairs in which both have it."""
    median_a: PercentileSummary
    median_b: PercentileSummary
    mean_difference: MeanDifference
    median_difference: PercentileSummary
    """The median of the differences of the pairs, the second less the first."""


@dataclass(frozen=True)
class Outcome:
    """How a flight went in one of the campaigns."""

    verdict: str
    reasons: tuple[str, ...]
    command: str
    """The command line that flies it alone."""


@dataclass(frozen=True)
class ChangedFlight:
    """A flight that was good in one campaign, bad or failed in the other."""

    index: int
    seed: int
    a: Outcome
    b: Outcome


@dataclass(frozen=True)
class Comparison:
    """What `compare.json` holds."""

    a: Side
    b: Side
    pairs: int
    """Number of flights that both campaigns have."""
    rates: tuple[RateComparison, ...]
    figures: tuple[FigureComparison, ...]
    changed: tuple[ChangedFlight, ...]
    """Those that were good in the first campaign first."""

    def to_json(self) -> str:
        """As strict JSON."""
        return json.dumps(asdict(self), indent=2, allow_nan=False) + "\n"


def compare(pairs: PairedCampaigns) -> Comparison:
    """Compare two campaigns."""
    a, b = pairs.a, pairs.b
    return Comparison(
        Side(str(a.folder), pairs.flights_a, pairs.identity_a),
        Side(str(b.folder), pairs.flights_b, pairs.identity_b),
        pairs.number,
        tuple(rate_comparisons(a, b)),
        tuple(figure_comparisons(a, b)),
        tuple(changed_flights(a, b)),
    )


def rate_comparisons(a: FlownCampaign, b: FlownCampaign) -> Iterator[RateComparison]:
    """How many flights were good, reached all goals, and failed."""
    yield rate_comparison("good", a.verdicts == "good", b.verdicts == "good")
    yield rate_comparison("reached", a.reached, b.reached)
    yield rate_comparison("failed", a.verdicts == "failed", b.verdicts == "failed")


def rate_comparison(name: str, a: Mask, b: Mask) -> RateComparison:
    """How often something was so in either campaign."""
    only_a, only_b = int((a & ~b).sum()), int((b & ~a).sum())
    found = rate_difference(only_a, only_b, a.size, LEVEL)
    return RateComparison(
        name,
        rate_summary(name, int(a.sum()), a.size),
        rate_summary(name, int(b.sum()), b.size),
        only_a,
        only_b,
        found.difference,
        found.interval,
    )


def figure_comparisons(a: FlownCampaign, b: FlownCampaign) -> Iterator[FigureComparison]:
    """All figures that both campaigns have in at least one pair."""
    for name in a.figures:
        if name in b.figures:
            both = a.known(name) & b.known(name)
            if both.any():
                yield figure_comparison(name, a.values(name)[both], b.values(name)[both])


def figure_comparison(name: str, a: Series, b: Series) -> FigureComparison:
    """A figure of the pairs in which both campaigns have it."""
    found = paired_difference(a, b, LEVEL, np.random.default_rng(BOOTSTRAP_SEED))
    return FigureComparison(
        name,
        a.size,
        percentile_summary(percentile(a, 50.0, LEVEL)),
        percentile_summary(percentile(b, 50.0, LEVEL)),
        MeanDifference(found.mean.value, found.mean.interval),
        percentile_summary(found.median),
    )


def changed_flights(a: FlownCampaign, b: FlownCampaign) -> Iterator[ChangedFlight]:
    """The flights that are good in one campaign alone."""
    good_a, good_b = a.verdicts == "good", b.verdicts == "good"
    only_a, only_b = (np.flatnonzero(good) for good in (good_a & ~good_b, good_b & ~good_a))
    places = [*only_a.tolist(), *only_b.tolist()]
    texts_a, texts_b = a.texts(places), b.texts(places)
    seeds = a.columns.column("seed")
    for place in places:
        yield ChangedFlight(
            place,
            seeds[place].as_py(),
            outcome(a.verdicts[place], texts_a[place]),
            outcome(b.verdicts[place], texts_b[place]),
        )


def outcome(verdict: str, texts: FlightTexts) -> Outcome:
    """How a flight went."""
    return Outcome(str(verdict), texts.reasons, texts.command)


def write_comparison(folder: Path, comparison: Comparison) -> None:
    """Write `compare.json`.

    Raises:
        InputError: it cannot be written.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        write_atomically(folder / COMPARISON, comparison.to_json())
    except OSError as error:
        raise InputError(f"--out {folder}: cannot be written: {error.strerror or error}") from error
