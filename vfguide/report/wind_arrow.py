"""Arrows of the wind in the figure from above: at the beginning, and after each change."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.transforms import ScaledTranslation, Transform

from vfguide.files.simulation_entry import Wind
from vfguide.geometry.units import DEG
from vfguide.report.drawing import MUTED_COLOUR
from vfguide.results.record import Array

ARROW_SPACING = 84.0
"""Distance from one arrow to the next below it [pt]; chosen."""


def draw_wind(figure: Figure, axes: Axes, wind: Wind, drawn: Array) -> None:
    """Draw arrows that point where the wind blows to, with speed and direction, in a corner.

    They are one below the other in the order of time, in the corner that is farthest from the
    points `drawn`, (n, 2), east and north [m].
    """
    corner = _emptiest_corner(axes, drawn)
    highest = 52.0 + (1.0 - corner[1]) * ARROW_SPACING * (len(wind.stages) - 1)
    centre = np.array((42.0, highest)) * (1.0 - 2.0 * np.array(corner)) + (0.0, 12.0 * corner[1])
    for row, (time, speed, from_deg) in enumerate(wind.stages):
        here = centre - (0.0, ARROW_SPACING * row)
        text = f"Wind {speed:g} m/s\nfrom {from_deg % 360.0:03.0f}°" + f"\nat {time:g} s" * (
            row > 0
        )
        below = _points_from(figure, axes, here - (0.0, 20.0))
        axes.annotate(
            text, corner, xycoords=below, ha="center", va="top", color=MUTED_COLOUR, fontsize=9
        )
        if speed > 0.0:
            _draw_arrow(figure, axes, corner, here, from_deg)


def _draw_arrow(
    figure: Figure, axes: Axes, corner: tuple[float, float], centre: Array, from_deg: float
) -> None:
    """Draw an arrow with its middle at the offset `centre`, (2,), from a corner of the axes."""
    toward = (from_deg + 180.0) * DEG
    half = 17.0 * np.array((np.sin(toward), np.cos(toward)))
    axes.annotate(
        "",
        corner,
        corner,
        xycoords=_points_from(figure, axes, centre + half),
        textcoords=_points_from(figure, axes, centre - half),
        arrowprops={"arrowstyle": "-|>", "color": MUTED_COLOUR, "lw": 2.2, "mutation_scale": 16},
    )


def _points_from(figure: Figure, axes: Axes, offset: Array) -> Transform:
    """The transform of fractions of the axes that adds an `offset`, (2,) [pt], 1/72 inch."""
    x, y = offset / 72.0
    return axes.transAxes + ScaledTranslation(x, y, figure.dpi_scale_trans)


def _emptiest_corner(axes: Axes, drawn: Array) -> tuple[float, float]:
    """The corner that is farthest from the points `drawn`, as fractions of the axes."""
    (west, east), (south, north) = axes.get_xlim(), axes.get_ylim()
    seen = (drawn - (west, south)) / (east - west, north - south)

    def room(corner: tuple[float, float]) -> float:
        return float(np.nanmin(np.hypot(*(seen - corner).T)))

    return max(((x, y) for x in (0.0, 1.0) for y in (0.0, 1.0)), key=room)
