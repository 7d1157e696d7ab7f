"""The fence as figures show it: zones from above, floor and ceiling from the side."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, Patch, Polygon

from vfguide.files.fence import Fence, ZoneEntry
from vfguide.geometry.vector import Vector, Vectors

INSIDE_COLOUR = "#00674a"
"""Colour of the border of a zone to stay in."""
OUTSIDE_COLOUR = "#a83c00"
"""Colour of the border of a zone to stay out of."""
BORDER_LINE: Any = {"linewidth": 1.4, "linestyle": (0, (7, 2))}
"""Style of the border of a zone."""
HEIGHT_LINE: Any = {"color": INSIDE_COLOUR, **BORDER_LINE}
"""Style of the lines at floor and ceiling."""
RING_POINTS = 32
"""Number of points on a circle of the fence from which the limits of the view are made; chosen."""


def draw_zones(axes: Axes, fence: Fence) -> None:
    """Draw the zones from above, east to the right, north up; those to stay out of are hatched."""
    for zone in fence.zone:
        axes.add_patch(_outline(zone))


def draw_heights(axes: Axes, fence: Fence) -> None:
    """Draw floor and ceiling from the side."""
    for height in (fence.floor_m, fence.ceiling_m):
        if height is not None:
            axes.axhline(height, zorder=1.1, **HEIGHT_LINE)


def zone_marks(fence: Fence) -> list[Patch]:
    """Entries of a legend for what `draw_zones` draws."""
    names = {"include": "Fence, stay inside", "exclude": "Fence, stay out"}
    kinds = {zone.kind: None for zone in fence.zone}
    return [Patch(label=names[kind], **_look(kind)) for kind in kinds]


def height_marks(fence: Fence) -> list[Line2D]:
    """Entries of a legend for what `draw_heights` draws."""
    named = (("Floor", fence.floor_m), ("Ceiling", fence.ceiling_m))
    names = [name for name, height in named if height is not None]
    label = " and ".join(names).capitalize()
    return [Line2D([], [], label=f"{label} of the fence", **HEIGHT_LINE)] if names else []


def places_of(fence: Fence, p_n: Vector) -> Vectors:
    """Places (k, 3), NED [m], that show how far the fence reaches.

    Those of zones have the height of `p_n`; those of floor and ceiling are above and below it.
    """
    places = [(x, y, p_n[2]) for zone in fence.zone for x, y in _border(zone)]
    heights = [height for height in (fence.floor_m, fence.ceiling_m) if height is not None]
    places += [(p_n[0], p_n[1], -height) for height in heights]
    return np.array(places, float).reshape(-1, 3)


def _border(zone: ZoneEntry) -> list[tuple[float, float]]:
    if zone.polygon_m is not None:
        return zone.polygon_m
    (north, east), radius = zone.centre_m or (0.0, 0.0), zone.radius_m or 0.0
    angles = np.linspace(0.0, 2.0 * np.pi, RING_POINTS)
    return [(north + radius * np.cos(a), east + radius * np.sin(a)) for a in angles]


def _outline(zone: ZoneEntry) -> Patch:
    look: Any = {"zorder": 1.1, **_look(zone.kind)}
    if zone.polygon_m is not None:
        return Polygon([(east, north) for north, east in zone.polygon_m], closed=True, **look)
    north, east = zone.centre_m or (0.0, 0.0)
    return Circle((east, north), zone.radius_m or 0.0, **look)


def _look(kind: str) -> dict[str, Any]:
    if kind == "include":
        return {"facecolor": "none", "edgecolor": INSIDE_COLOUR, **BORDER_LINE}
    return {"facecolor": "#fbeee6", "edgecolor": OUTSIDE_COLOUR, "hatch": "///", **BORDER_LINE}
