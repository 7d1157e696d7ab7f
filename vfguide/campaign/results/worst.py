"""The worst flights of a campaign, and the figure by which they are."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from vfguide.campaign.results.flown import FlightTexts, FlownCampaign
from vfguide.geometry.vector import Indices, Series

SHOWN = 20
"""Largest number of flights in a table of the report or of a comparison; chosen, a page."""
MARKED_SHARE = 0.1
"""Largest share of the flights that is marked in a figure as the worst; chosen."""
RANK = {"failed": 0, "bad": 1, "good": 2}
"""Place of each verdict among them, the worst first."""


class WorstFigure(NamedTuple):
    """The figure by which flights are compared."""

    column: str
    words: str
    is_least: bool
    """Whether its least value is the worst, else its largest."""


CLEARANCE = WorstFigure("min_clearance_m", "least clearance", True)
"""The figure where there are obstacles."""
MISS = WorstFigure("miss_m", "largest miss", False)
"""The figure where there is none."""


@dataclass(frozen=True)
class WorstFlight:
    """One of the worst flights."""

    index: int
    seed: int
    verdict: str
    worst: float | None
    """The figure by which it is compared; None: it has none."""
    texts: FlightTexts
    drawn: tuple[float, ...]
    """In the order of the varied keys."""
    figures: tuple[float | None, ...]
    """The other figures, in their order; None: it has none."""


def worst_figure(flown: FlownCampaign) -> WorstFigure:
    """The figure by which the flights of a campaign are compared."""
    return CLEARANCE if CLEARANCE.column in flown.figures else MISS


def worst_first(flown: FlownCampaign, figure: WorstFigure) -> Indices:
    """The numbers of all flights: first those that failed, then the bad ones, the worst first."""
    ranks = np.array([RANK[verdict] for verdict in flown.verdicts], dtype=float)
    return np.lexsort(np.stack((goodness(flown.values(figure.column), figure), ranks)))


def goodness(values: Series, figure: WorstFigure) -> Series:
    """How good a figure is, the larger the better; worse than all where there is none."""
    signed = values if figure.is_least else -values
    return np.where(np.isnan(signed), -np.inf, signed)


def other_figures(flown: FlownCampaign, figure: WorstFigure) -> list[str]:
    """Names of the figures beside that by which flights are compared."""
    return [name for name in flown.figures if name != figure.column]


def worst_flights(flown: FlownCampaign, figure: WorstFigure, places: Indices) -> list[WorstFlight]:
    """What the report tells of some flights, in their order."""
    texts = flown.texts(places.tolist())
    others = other_figures(flown, figure)
    numbers = flown.columns.take(places).to_pylist()
    return [
        WorstFlight(
            row["index"],
            row["seed"],
            row["verdict"],
            row[figure.column],
            texts[place],
            tuple(row[key] for key in flown.varied),
            tuple(row[name] for name in others),
        )
        for place, row in zip(places.tolist(), numbers, strict=True)
    ]
