"""The figures of a campaign: how its figures are distributed, and where the worst flights lie."""

import math
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator

from vfguide.campaign.results.flown import FlownCampaign
from vfguide.campaign.results.worst import WorstFigure
from vfguide.geometry.vector import Indices, Mask, Series
from vfguide.report.drawing import COLOURS, GOAL_COLOUR, to_png
from vfguide.report.figures import Picture
from vfguide.report.panels import FIGURE_WIDTH, make_near_large

HISTOGRAMS = 4
"""Number of histograms beside each other; chosen, so that their numbers can be read."""
SCATTERS = 3
"""Number of scatters beside each other; chosen, as that of histograms."""
PANEL_ROW = {HISTOGRAMS: 1.5, SCATTERS: 2.4}
"""Height of a row of as many panels [inch]; chosen."""
LEGEND_HEIGHT = 0.35
"""Height of the legend [inch]."""
NAME_WIDTH = {HISTOGRAMS: 25, SCATTERS: 34}
"""Number of characters of a name that fit on a line of as many panels."""
LEAST_BARS = 8
"""Least number of bars of a histogram; chosen."""
MOST_BARS = 30
"""Largest number of bars of a histogram; chosen."""
BARS_REACH = 5.0
"""Largest distance of a bar from the quartiles, a number of distances between them; chosen, so
that one stray flight does not press all others into one bar."""
STRAY = 0.01
"""Largest share of the flights that lies beyond the bars on either side; chosen."""
WIDE = 20.0
"""Ratio of the largest amount to the median above which an axis becomes logarithmic far from zero,
so that the many near it can be told apart; chosen."""
EVEN = 4.0
"""Ratio of the amount from which on such an axis is logarithmic to the median; chosen, so that
half of the flights lie where it is even."""
ROOM = 0.05
"""Room on an axis beyond the values, as a share of what they span; chosen."""
CROWD = 300
"""Number of flights from which on their marks become paler; chosen."""
GOOD_MARK: Any = {"color": COLOURS[0], "marker": ".", "markersize": 6, "linestyle": "none"}
"""Marks of good flights."""
BAD_MARK: Any = {"color": COLOURS[1], "marker": "o", "markersize": 4, "linestyle": "none", "mew": 0}
"""Marks of bad flights."""
UNKNOWN_MARK: Any = {"color": GOAL_COLOUR, "marker": "x", "markersize": 5, "linestyle": "none"}
"""Marks of flights without the figure, as those that failed."""

WORST_MARK: Any = {"color": COLOURS[1], "marker": "^", "markersize": 4.5, "linestyle": "none"}
"""Marks of the worst flights below a histogram."""


@dataclass(frozen=True)
class Shown:
    """What the figures show."""

    flown: FlownCampaign
    figure: WorstFigure
    """By which the worst are."""
    worst: Indices
    """Numbers of the worst flights among those that have figures."""

    @cached_property
    def spread(self) -> list[str]:
        """Names of the figures that are not the same in all flights."""
        return [name for name in self.flown.figures if has_spread(self.flown.values(name))]


class CampaignPictures(NamedTuple):
    """The figures of a campaign; None where there is nothing to draw."""

    distributions: Picture | None
    where: Picture | None


def campaign_pictures(shown: Shown) -> CampaignPictures:
    """Draw the figures that there is something to draw in."""
    return CampaignPictures(
        distributions(shown) if shown.spread else None, where(shown) if shown.flown.varied else None
    )


def distributions(shown: Shown) -> Picture:
    """The histograms of what differs between flights."""
    return Picture(
        "distributions",
        "Number of flights by each figure that is not the same in all of them. Triangles are the "
        f"{len(shown.worst)} worst flights that did not fail. The bars at either end count what "
        "lies beyond as well.",
        to_png(draw_distributions, shown),
    )


def where(shown: Shown) -> Picture:
    """The worst figure over the drawn values."""
    return Picture(
        "where",
        f"{shown.figure.column}, by which the worst are told, over each value that was drawn. Its "
        "scale is even near zero and, where that is needed, logarithmic far from it.",
        to_png(draw_where, shown),
    )


def has_spread(values: Series) -> bool:
    """Whether the values that are known are not all the same."""
    known = values[np.isfinite(values)]
    return bool(known.size) and float(np.ptp(known)) > 0.0


def draw_distributions(figure: Figure, shown: Shown) -> None:
    """A histogram of each figure that has spread, the worst flights marked below it."""
    for axes, name in zip(panels(figure, len(shown.spread), HISTOGRAMS), shown.spread, strict=True):
        values = shown.flown.values(name)
        known = values[np.isfinite(values)]
        low, high = bars_between(known)
        bars = min(max(round(2.0 * math.sqrt(known.size)), LEAST_BARS), MOST_BARS)
        axes.hist(np.clip(known, low, high), bars, range=(low, high), color=COLOURS[0])
        mark_below(axes, np.clip(values[shown.worst], low, high))
        axes.set_title(broken_name(name, HISTOGRAMS), fontsize=8.5, fontweight="normal")
        axes.xaxis.set_major_locator(MaxNLocator(3))
        axes.yaxis.set_major_locator(MaxNLocator(3, integer=True))
        axes.ticklabel_format(axis="x", useOffset=False)
        axes.tick_params(labelsize=7.5)


def bars_between(known: Series) -> tuple[float, float]:
    """The ends of the first and the last bar."""
    low, high = float(known.min()), float(known.max())
    lower, upper = np.quantile(known, (0.25, 0.75)).tolist()
    reach = BARS_REACH * (upper - lower)
    if not reach:
        return low, high
    first, last = np.quantile(known, (STRAY, 1.0 - STRAY)).tolist()
    return max(low, min(first, lower - reach)), min(high, max(last, upper + reach))


def mark_below(axes: Axes, worst: Series) -> None:
    """Mark the values of the worst flights on the edge below a histogram, those that are known."""
    known = worst[np.isfinite(worst)]
    if known.size:  # what is empty has no extent, of which the layout of matplotlib makes nothing
        axes.plot(known, np.zeros_like(known), **WORST_MARK, clip_on=False, zorder=3)


def draw_where(figure: Figure, shown: Shown) -> None:
    """The figure by which the worst are, over each drawn value; bad and failed flights marked."""
    flown = shown.flown
    values = flown.values(shown.figure.column)
    grid = panels(figure, len(flown.varied), SCATTERS)
    good = flown.verdicts == "good"
    known = np.isfinite(values)
    groups = ((known & good, GOOD_MARK), (known & ~good, BAD_MARK))
    for axes, key in zip(grid, flown.varied, strict=True):
        drawn = flown.values(key)
        for group, style in groups:
            axes.plot(drawn[group], values[group], **style, alpha=paleness(int(group.sum())))
        if not known.all():
            mark_unknown(axes, drawn[~known], is_below=shown.figure.is_least)
        axes.set_xlabel(broken_name(key, SCATTERS), fontsize=8.5)
        axes.xaxis.set_major_locator(MaxNLocator(5))
        axes.tick_params(labelsize=8)
    share_axis(grid, shown.figure.column, values[known])
    figure.legend(handles=legend(~known), loc="outside lower center", ncols=3)


def mark_unknown(axes: Axes, drawn: Series, *, is_below: bool) -> None:
    """Mark flights without the figure on the edge where the worst are."""
    edge = np.full(drawn.shape, 0.0 if is_below else 1.0)
    across = axes.get_xaxis_transform()
    axes.plot(
        drawn,
        edge,
        **UNKNOWN_MARK,
        alpha=paleness(drawn.size),
        transform=across,
        clip_on=False,
        zorder=3,
    )


def paleness(number: int) -> float:
    """Opacity of the marks of so many flights."""
    return max(0.15, min(1.0, math.sqrt(CROWD / max(number, 1))))


def share_axis(grid: Sequence[Axes], name: str, known: Series) -> None:
    """One vertical axis for panels beside each other, logarithmic far from zero if it is wide."""
    low, high = (float(known.min()), float(known.max())) if known.size else (0.0, 1.0)
    middle = float(np.median(np.abs(known))) if known.size else 0.0
    is_wide = 0.0 < WIDE * middle < max(-low, high)
    for place, axes in enumerate(grid):
        room = ROOM * (high - low) or 0.5
        axes.set_ylim(low - room, high + room)
        if is_wide:
            axes.set_ylim(min(low, 0.0) * (1.0 + ROOM) - middle * ROOM, high * (1.0 + 4.0 * ROOM))
            make_near_large(axes, EVEN * middle)
        if place % SCATTERS == 0:
            axes.set_ylabel(name)
        else:
            axes.tick_params(labelleft=False)


def legend(unknown: Mask) -> list[Line2D]:
    """What the marks of a scatter mean."""
    entries = [Line2D([], [], **GOOD_MARK, label="good"), Line2D([], [], **BAD_MARK, label="bad")]
    if unknown.any():
        entries.append(
            Line2D(
                [], [], **UNKNOWN_MARK, label="without the figure, as where it failed: on the edge"
            )
        )
    return entries


def panels(figure: Figure, number: int, columns: int) -> list[Axes]:
    """Empty axes in rows of so many columns."""
    rows = math.ceil(number / columns)
    figure.set_layout_engine("constrained")
    figure.set_size_inches(FIGURE_WIDTH, PANEL_ROW[columns] * rows + LEGEND_HEIGHT)
    grid: list[Axes] = [*figure.subplots(rows, columns, squeeze=False).ravel()]
    for axes in grid[number:]:
        axes.set_axis_off()
    return grid[:number]


def broken_name(name: str, columns: int) -> str:
    """A name on as many lines as it takes beside so many panels."""
    return textwrap.fill(name, NAME_WIDTH[columns])
