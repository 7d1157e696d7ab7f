"""The report of a campaign: one HTML file that needs nothing beside it."""

import math
import re
from pathlib import Path

from vfguide.campaign.intervals import Interval
from vfguide.campaign.results.figures import Shown, campaign_pictures
from vfguide.campaign.results.flown import FlownCampaign, read_flown
from vfguide.campaign.results.worst import (
    MARKED_SHARE,
    SHOWN,
    other_figures,
    worst_figure,
    worst_first,
    worst_flights,
)
from vfguide.campaign.summary import PERCENTS, Summary
from vfguide.files.atomic import write_atomically
from vfguide.files.errors import InputError
from vfguide.report.report import NO_VALUE, page_environment

REPORT = "report.html"
"""Name of the file."""


def write_report(folder: Path, summary: Summary) -> None:
    """Write `report.html` of the flights in a folder; nothing where there is none.

    Raises:
        InputError: the flights cannot be read, or the report cannot be written.
    """
    if not summary.flown:
        return
    page = render(summary, read_flown(folder))
    try:
        write_atomically(folder / REPORT, page)
    except OSError as error:
        raise InputError(
            f"{folder / REPORT}: cannot be written: {error.strerror or error}"
        ) from error


def render(summary: Summary, flown: FlownCampaign) -> str:
    """The report as HTML."""
    figure = worst_figure(flown)
    order = worst_first(flown, figure)
    judged = order[flown.verdicts[order] != "failed"]
    marked = judged[: min(SHOWN, math.ceil(MARKED_SHARE * judged.size))]
    environment = page_environment()
    environment.filters["share"] = share
    environment.filters["shares"] = shares
    return environment.get_template("campaign/results/report.html.j2").render(
        summary=summary,
        parts=parts,
        shown=SHOWN,
        percents=PERCENTS,
        pictures=campaign_pictures(Shown(flown, figure, marked)),
        figure=figure,
        flights=worst_flights(flown, figure, order[:SHOWN]),
        varied=flown.varied,
        figures=other_figures(flown, figure),
    )


def share(value: float | None) -> str:
    """A rate in percent; a dash where there is none."""
    return NO_VALUE if value is None else f"{value:.2%}".replace("%", " %")


def shares(ends: Interval) -> str:
    """An interval of rates in percent."""
    return f"{share(ends.low)} to {share(ends.high)}"


def parts(name: str) -> list[str]:
    """The parts of a name after each of which a line may end."""
    return re.split(r"(?<=[._])", name)
