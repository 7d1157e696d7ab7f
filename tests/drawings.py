"""Figures of the report, drawn as for a file."""

from collections.abc import Callable

from matplotlib.figure import Figure

from vfguide.report.drawing import Flights


def drawn(draw: Callable[[Figure, Flights], object], flights: Flights) -> Figure:
    figure = Figure()
    draw(figure, flights)
    figure.draw_without_rendering()
    return figure
