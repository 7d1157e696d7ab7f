"""Polygons of the horizontal plane, and the upright bodies above such outlines."""

import math
from typing import NamedTuple

import numpy as np

from vfguide.geometry.vector import Series
from vfguide.kernels.compiled import compiled


class Seen(NamedTuple):
    """A side of a polygon, seen from a point."""

    square: float
    """Square of its distance [m^2]."""
    crosses: bool
    """Whether a ray from the point along the first axis crosses it: a point is inside where the
    ray crosses an odd number of sides."""


@compiled
def side_from(x0: float, y0: float, x1: float, y1: float, x: float, y: float) -> Seen:
    """The side from (x0, y0) to (x1, y1), seen from (x, y) [m]; its ends may coincide."""
    ex, ey, dx, dy = x1 - x0, y1 - y0, x - x0, y - y0
    length = ex * ex + ey * ey
    share = (dx * ex + dy * ey) / length if length > 0.0 else 0.0
    share = max(0.0, min(1.0, share))
    ox, oy = dx - share * ex, dy - share * ey
    crosses = (y0 > y) != (y1 > y) and (dx * ey - dy * ex) * ey < 0.0
    return Seen(ox * ox + oy * oy, crosses)


@compiled
def signed_root(square: float, inside: bool) -> float:
    """Distance [m], negative inside, from its `square` [m^2]."""
    return -math.sqrt(square) if inside else math.sqrt(square)


@compiled
def prism_distance(beside: float, above: float) -> float:
    """Distance from an upright body with sharp edges, a prism or a cylinder [m], negative inside.

    `beside` is the horizontal distance from its outline, negative inside it, and `above` the
    vertical distance beyond the nearer of its two ends, negative between them [m].
    """
    if max(beside, above) <= 0.0:
        return max(beside, above)
    u, w = max(beside, 0.0), max(above, 0.0)
    return math.sqrt(u * u + w * w)


@compiled
def prism_distances(beside: Series, above: Series) -> Series:
    """`prism_distance` of many points, (n,) [m]."""
    distances = np.empty(len(beside))
    for i in range(len(beside)):
        distances[i] = prism_distance(beside[i], above[i])
    return distances
