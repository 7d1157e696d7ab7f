"""Panels one below the other, over one time axis."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, NullLocator, StrMethodFormatter

from vfguide.report.drawing import (
    GOAL_COLOUR,
    LEGEND_COLUMNS,
    MUTED_COLOUR,
    Flights,
    line_of,
    vehicle_lines,
)
from vfguide.results.record import Array, FlightRecord

LIMIT_LINE: Any = {"color": MUTED_COLOUR, "linestyle": (0, (4, 3)), "linewidth": 1.2}
"""Style of the lines at limits."""
WANTED_LINE: Any = {"color": GOAL_COLOUR, "linewidth": 0.9}
"""Style of the lines of commanded values."""
FIGURE_WIDTH = 8.6
"""Width of the figures [inch]; chosen."""
PANEL_HEIGHT = 1.75
"""Height of one of several panels [inch]; chosen."""
TICK_SPACING = 0.25
"""Least distance between two numbers on the vertical axis [inch]; chosen."""


@dataclass(frozen=True)
class Panel:
    """What is drawn over time in one pair of axes."""

    label: str
    """Label of the vertical axis, which names the unit of all values."""
    values: Callable[[FlightRecord], Array]
    """What was flown, (n,)."""
    limits: Sequence[float] = ()
    """Values at which lines mark limits."""
    wanted: Callable[[FlightRecord], Array] | None = None
    """What was commanded, (n,), drawn beside what was flown; None: nothing."""
    span: float = 0.0
    """Least range of the vertical axis, in the unit of the label, so that a difference that does
    not matter does not fill it."""
    around: bool = False
    """Whether the vertical axis shows angles from 0 to 360 degrees."""


def draw_panels(
    figure: Figure, flights: Flights, title: str, panels: Sequence[Panel], marks: Sequence[Artist]
) -> Sequence[Axes]:
    """Draw panels, with a legend of the vehicles and `marks` below; returns their axes."""
    legend = [*(vehicle_lines(flights) if flights.several else ()), *marks]
    grid = lay_out(figure, title, len(panels), legend)
    for axes, panel in zip(grid, panels, strict=True):
        _draw_panel(axes, panel, flights)
    return grid


def lay_out(
    figure: Figure, title: str, rows: int, legend: Sequence[Artist], row: float = PANEL_HEIGHT
) -> Sequence[Axes]:
    """Empty axes below each other, `rows` of the height `row` [inch], and the legend below them."""
    columns = _columns(legend)
    bottom = 0.55 + 0.24 * math.ceil(len(legend) / columns)
    height = 0.4 + row * rows + bottom
    figure.set_size_inches(FIGURE_WIDTH, height)
    figure.subplots_adjust(0.1, bottom / height, 0.97, 1.0 - 0.4 / height, hspace=0.13)
    grid: list[Axes] = [*figure.subplots(rows, 1, sharex=True, squeeze=False).ravel()]
    grid[0].set_title(title)
    grid[-1].set_xlabel("Time [s]")
    if legend:
        figure.legend(handles=legend, loc="lower center", ncols=columns)
    return grid


def _columns(legend: Sequence[Artist]) -> int:
    """Number of entries of the legend that have room beside each other."""
    longest = max((len(str(entry.get_label())) for entry in legend), default=0)
    return max(1, min(len(legend), LEGEND_COLUMNS, int(FIGURE_WIDTH / (0.67 + 0.084 * longest))))


def name_axis(axes: Axes, label: str) -> None:
    """Set the label of the vertical axis, at the same distance in all panels, and the margins."""
    axes.set_ylabel(label)
    axes.yaxis.set_label_coords(-0.08, 0.5)
    axes.margins(x=0.01, y=0.12)


def show_no_less_than(axes: Axes, span: float) -> None:
    """Widen the vertical axis about its middle where it shows less than `span`."""
    low, high = axes.get_ylim()
    more = 0.5 * (span - (high - low))
    if more > 0.0:
        axes.set_ylim(low - more, high + more)


def _draw_panel(axes: Axes, panel: Panel, flights: Flights) -> None:
    for limit in panel.limits:
        axes.axhline(limit, **LIMIT_LINE)
    for index, record in enumerate(flights.records):
        axes.plot(record.time, panel.values(record), **line_of(index))
        if panel.wanted is not None:
            axes.plot(record.time, panel.wanted(record), **WANTED_LINE)
    name_axis(axes, panel.label)
    show_no_less_than(axes, panel.span)
    if panel.around:
        axes.set(ylim=(-10.0, 370.0), yticks=range(0, 361, 90))


def make_near_large(axes: Axes, scale: float) -> None:
    """Make the vertical axis linear near zero and logarithmic above about `scale` [m].

    Call this when everything is drawn and the limits are set: they tell how many numbers of the
    axis there is room for.
    """
    even = scale / 4.0
    axes.set_yscale("asinh", linear_width=even)
    figure: Any = axes.figure
    height = axes.get_position().height * figure.get_figheight()
    low, high = np.arcsinh(np.array(axes.get_ylim()) / even)
    apart = TICK_SPACING * (high - low) / height
    powers = 10.0 ** np.arange(math.floor(math.log10(even)), 10)
    values = np.outer(powers, (1, 2, 5) if apart < math.log(2.0) else (1,)).ravel()
    values = values[np.arcsinh(values / even) >= apart]
    axes.yaxis.set_major_locator(FixedLocator([*-values, 0.0, *values]))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
