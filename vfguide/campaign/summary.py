"""What a campaign shows: rates and percentiles with their intervals, `summary.json`."""

import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from vfguide import __version__
from vfguide.campaign.condition import Condition
from vfguide.campaign.intervals import Interval, Percentile, exact_rate, percentile, sequential_rate
from vfguide.campaign.looks import Looks
from vfguide.campaign.plan import CampaignPlan
from vfguide.campaign.schema import simple_columns
from vfguide.campaign.table import TABLE
from vfguide.files.atomic import write_atomically
from vfguide.files.errors import InputError

LEVEL = 0.95
"""Confidence of all intervals, a number; chosen, that of the contract."""
PERCENTS = (1.0, 5.0, 25.0, 50.0, 75.0, 95.0, 99.0)
"""The percentiles that are told [%]; chosen."""
NOT_FIGURES = frozenset({"index", "seed"})
"""Names of the columns of numbers that measure nothing."""
UNREPEATABLE = frozenset({"wall_s", "realtime_factor", "worker"})
"""Names of the columns that differ when the same flight is flown again."""


@dataclass(frozen=True)
class RateSummary:
    """How often something was so."""

    name: str
    count: int
    of: int
    rate: float | None
    interval: Interval
    """At 95 %, of Clopper and Pearson."""


@dataclass(frozen=True)
class PercentileSummary:
    """A percentile, and its interval at 95 %; None where no value is known."""

    percent: float
    value: float | None
    interval: Interval | None
    is_enough: bool
    """Whether the flights are so many that the interval has its level."""


@dataclass(frozen=True)
class FigureSummary:
    """How a figure is distributed over the flights."""

    column: str
    known: int
    """Number of flights that have it."""
    missing: int
    """Number of flights that have none, as those that failed."""
    least: float | None
    largest: float | None
    percentiles: tuple[PercentileSummary, ...]


@dataclass(frozen=True)
class UntilSummary:
    """The condition of the user, and what is known of it."""

    condition: str
    count: int
    """Number of flights that count."""
    of: int
    """Number of flights that were looked at."""
    rate: float | None
    interval: Interval
    """At the level of the condition, valid however often one looks."""
    is_met: bool | None
    """None: it is not known well enough."""


@dataclass(frozen=True)
class Summary:
    """What `summary.json` holds."""

    name: str
    version: str
    seed: int
    runs: int
    """Number of flights that were asked for."""
    flown: int
    """Number of flights in the table, from the first on."""
    rates: tuple[RateSummary, ...]
    figures: tuple[FigureSummary, ...]
    processors: tuple[str, ...]
    """Kinds of the processors that flew."""
    until: UntilSummary | None
    """None: no condition was given."""

    def to_json(self) -> str:
        """As strict JSON."""
        return json.dumps(asdict(self), indent=2, allow_nan=False) + "\n"


def summarize(folder: Path, plan: CampaignPlan, runs: int, looks: Looks) -> Summary:
    """Make the summary of the flights in a folder, and write it there.

    Raises:
        InputError: the folder cannot be read or written.
    """
    try:
        return _summarize(folder, plan, runs, looks)
    except (OSError, pa.ArrowException) as error:
        raise InputError(f"{folder}: cannot be read or written: {error}") from error


def _summarize(folder: Path, plan: CampaignPlan, runs: int, looks: Looks) -> Summary:
    with pq.ParquetFile(folder / TABLE) as file:
        table = file.read(simple_columns(file.schema_arrow))
    kinds = {str(each) for each in table.column("processor").to_pylist()}
    summary = Summary(
        name=plan.name,
        version=__version__,
        seed=plan.seed,
        runs=runs,
        flown=table.num_rows,
        rates=tuple(rates_of(table)),
        figures=tuple(figures_of(table)),
        processors=tuple(sorted(kinds - {""})),
        until=None if looks.condition is None else until_summary(looks.condition, looks),
    )
    write_atomically(folder / "summary.json", summary.to_json())
    return summary


def until_summary(condition: Condition, looks: Looks) -> UntilSummary:
    """What the looks have shown of a condition."""
    rate = sequential_rate(looks.successes, looks.trials, condition.level)
    return UntilSummary(
        str(condition), rate.successes, rate.trials, rate.rate, rate.interval, looks.is_met
    )


def rates_of(table: pa.Table) -> Iterator[RateSummary]:
    """How many flights were good, reached all goals, and failed."""
    verdicts = table.column("verdict").to_pylist()
    yield rate_summary("good", verdicts.count("good"), len(verdicts))
    yield rate_summary("reached", table.column("reached").to_pylist().count(True), len(verdicts))
    yield rate_summary("failed", verdicts.count("failed"), len(verdicts))


def rate_summary(name: str, count: int, of: int) -> RateSummary:
    """How often something was so."""
    rate = exact_rate(count, of, LEVEL)
    return RateSummary(name, count, of, rate.rate, rate.interval)


def figures_of(table: pa.Table) -> Iterator[FigureSummary]:
    """The distributions of all figures that at least one flight has."""
    for name in table.column_names:
        column = table.column(name)
        if name not in NOT_FIGURES and pa.types.is_floating(column.type):
            values = column.to_numpy().astype(float)
            if not np.isnan(values).all():
                yield figure_summary(name, values)


def figure_summary(name: str, values: np.ndarray) -> FigureSummary:
    """How the values of a figure are distributed; those that are not numbers are missing."""
    known = int(np.isfinite(values).sum())
    return FigureSummary(
        column=name,
        known=known,
        missing=values.size - known,
        least=float(np.nanmin(values)),
        largest=float(np.nanmax(values)),
        percentiles=tuple(
            percentile_summary(percentile(values, percent, LEVEL)) for percent in PERCENTS
        ),
    )


def percentile_summary(found: Percentile) -> PercentileSummary:
    """A percentile as it is written."""
    return PercentileSummary(found.percent, found.value, found.interval, found.is_enough)
