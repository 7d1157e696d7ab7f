"""The comparison of two campaigns on the terminal."""

import json
from collections.abc import Iterator

from rich.table import Table

from vfguide.campaign.intervals import Interval
from vfguide.campaign.results.comparison import (
    ChangedFlight,
    Comparison,
    FigureComparison,
    Outcome,
    RateComparison,
    Side,
)
from vfguide.campaign.results.worst import SHOWN
from vfguide.results.verdict import in_words
from vfguide.terminal.campaign_display import number
from vfguide.terminal.console import out, shown

RATE_HEADS = ("rate", "A", "B", "B - A", "from", "to", "in A alone", "in B alone")
"""Heads of the table of rates."""
FIGURE_HEADS = ("figure", "pairs", "median A", "median B", "median B - A", "mean B - A")
"""Heads of the table of figures."""
DIGESTS = {
    "sha256": "the scenario files differ",
    "aircraft_sha256": "the files of the aircraft differ",
}
"""What is told where digests in `campaign.json` differ, by their keys."""


def print_comparison(comparison: Comparison) -> None:
    """Print what differs between two campaigns."""
    out.print(side("A", comparison.a))
    out.print(side("B", comparison.b))
    for line in told_differences(comparison):
        out.print(line)
    out.print(f"flights in pairs: {comparison.pairs}; intervals have a confidence of 95 %")
    out.print(table(RATE_HEADS, map(rate_cells, comparison.rates)))
    out.print(table(FIGURE_HEADS, map(figure_cells, comparison.figures)))
    for line in changes(comparison):
        out.print(line)


def side(name: str, campaign: Side) -> str:
    """Which campaign it is."""
    told = campaign.campaign
    scenario, version = told.get("scenario"), told.get("version")
    return f"{name}: {campaign.folder}, {campaign.flights} flights of {scenario}, vfguide {version}"


def told_differences(comparison: Comparison) -> Iterator[str]:
    """What the campaigns say of themselves that is not the same."""
    a, b = comparison.a.campaign, comparison.b.campaign
    keys = [key for key in {**a, **b} if a.get(key) != b.get(key)]
    for key in keys:
        if key in DIGESTS:
            yield DIGESTS[key]
        else:
            yield f"{key}: {json.dumps(a.get(key))} in A, {json.dumps(b.get(key))} in B"
    if not keys:
        yield "version, scenario and --set are the same"


def table(heads: tuple[str, ...], rows: Iterator[tuple[str, ...]]) -> Table:
    """A table whose first column has words, the others numbers."""
    made = Table()
    for place, head in enumerate(heads):
        justify = "right" if place else "left"
        made.add_column(head, justify=justify, no_wrap=not place, overflow="fold")
    for row in rows:
        made.add_row(*row)
    return made


def rate_cells(rate: RateComparison) -> tuple[str, ...]:
    """A row of the table of rates."""
    differences = (rate.difference, *rate.interval)
    return (
        rate.name,
        *("-" if each.rate is None else f"{each.rate:.2%}" for each in (rate.a, rate.b)),
        *("-" if each is None else f"{each:+.2%}" for each in differences),
        str(rate.only_a),
        str(rate.only_b),
    )


def figure_cells(figure: FigureComparison) -> tuple[str, ...]:
    """A row of the table of figures."""
    median, mean = figure.median_difference, figure.mean_difference
    return (
        shown(figure.column),
        str(figure.pairs),
        number(figure.median_a.value),
        number(figure.median_b.value),
        within(median.value, median.interval) + ("" if median.is_enough else "\ntoo few"),
        within(mean.value, mean.interval),
    )


def within(value: float | None, interval: Interval | None) -> str:
    """A difference, and its interval on a line below."""
    if value is None or interval is None:
        return number(value)
    low, high = signed(interval.low, 3), signed(interval.high, 3)
    return f"{signed(value, 4)}\n{low} to {high}"


def signed(value: float, digits: int) -> str:
    """A difference with its sign; no difference has none."""
    return f"{value:+.{digits}g}" if value else "0"


def changes(comparison: Comparison) -> Iterator[str]:
    """Which flights changed sides."""
    changed = comparison.changed
    worse = sum(flight.a.verdict == "good" for flight in changed)
    yield (
        f"flights that changed sides: {len(changed)}; good in A alone {worse}, "
        f"in B alone {len(changed) - worse}"
    )
    for flight in changed[:SHOWN]:
        yield from change(flight)
    if len(changed) > SHOWN:
        yield f"{len(changed) - SHOWN} more: --out DIR writes all into DIR/compare.json"


def change(flight: ChangedFlight) -> Iterator[str]:
    """How a flight changed sides."""
    yield f"flight {flight.index}, seed {flight.seed}:"
    for name, outcome in (("A", flight.a), ("B", flight.b)):
        yield f"  {name}: {told(outcome)}"
        yield f"     {outcome.command}"


def told(outcome: Outcome) -> str:
    """A verdict with its reasons."""
    reasons = "; ".join(map(in_words, outcome.reasons))
    return f"{outcome.verdict}: {reasons}" if reasons else outcome.verdict
