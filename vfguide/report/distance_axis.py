"""A vertical axis on which near and far distances are legible at once."""

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FixedLocator, NullLocator, StrMethodFormatter

TICK_SPACING = 0.25
"""Least distance between two numbers on the axis [inch]."""


def make_near_large(axes: Axes, scale: float) -> None:
    """Make the axis even near zero, and logarithmic above about `scale` [m].

    Everything is drawn and the limits are set before: they say how many numbers there is room for.
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
