"""The progress bar of a campaign, and its summary on the terminal."""

from pathlib import Path
from typing import Self

from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)
from rich.table import Table

from vfguide.campaign.campaign import Standing
from vfguide.campaign.summary import RateSummary, Summary, UntilSummary
from vfguide.terminal.console import err, out, shown

SPEED_PERIOD = 60.0
"""Time over which the rate of flights is averaged [s]; chosen."""


class CampaignDisplay:
    """Shows how many flights have ended, their rate and the time left, on a terminal."""

    def __init__(self, name: str, runs: int) -> None:
        self._progress = Progress(
            TextColumn("{task.description}", markup=False),
            BarColumn(),
            MofNCompleteColumn(),
            TextColumn("{task.fields[rate]}"),
            TimeElapsedColumn(),
            TimeRemainingColumn(),
            console=err,
            transient=True,
            disable=not err.is_terminal,
            speed_estimate_period=SPEED_PERIOD,
        )
        self._task = self._progress.add_task(shown(name), total=runs, rate="")

    def __call__(self, standing: Standing) -> None:
        """Take how far the campaign is."""
        (task,) = self._progress.tasks
        rate = f"{task.speed:.1f} flights/s" if task.speed else ""
        self._progress.update(self._task, completed=standing.flown, rate=rate)

    def __enter__(self) -> Self:
        self._progress.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._progress.stop()


SHOWN_PERCENTS = (5.0, 50.0, 95.0)
"""The percentiles that are shown [%]; the file has more."""


def print_summary(summary: Summary, folder: Path) -> None:
    """Print the rates and percentiles of a campaign, and where they are."""
    table = Table()
    heads = ("figure", "flights", "least", *(f"{each:g} %" for each in SHOWN_PERCENTS), "largest")
    for head in heads:
        table.add_column(head, justify="left" if head == "figure" else "right", overflow="fold")
    for figure in summary.figures:
        shown_values = [each.value for each in figure.percentiles if each.percent in SHOWN_PERCENTS]
        cells = (figure.least, *shown_values, figure.largest)
        table.add_row(shown(figure.column), str(figure.known), *map(number, cells))
    out.print(table)
    for rate in summary.rates:
        out.print(in_words(rate))
    if summary.until is not None:
        out.print(until_in_words(summary.until))
    out.print(f"results: {folder}")


def number(value: float | None) -> str:
    """A figure of any size."""
    return "-" if value is None else f"{value:.4g}"


def in_words(rate: RateSummary) -> str:
    """A rate with its interval."""
    if rate.rate is None:
        return f"{rate.name}: none of 0 flights"
    low, high = rate.interval
    return (
        f"{rate.name}: {rate.count} of {rate.of} flights, {rate.rate:.2%}, "
        f"with a confidence of 95 % {low:.2%} to {high:.2%}"
    )


DECISIONS = {True: "met", False: "not met", None: "not known well enough"}
"""How a condition stands, in words."""


def until_in_words(until: UntilSummary) -> str:
    """What is known of the condition of the user."""
    low, high = until.interval
    return (
        f"{until.condition}: {DECISIONS[until.is_met]}, "
        f"{until.count} of {until.of} flights, {low:.2%} to {high:.2%}"
    )
