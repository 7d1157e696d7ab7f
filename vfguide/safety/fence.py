"""Fences: upright polygons and circles to stay in or out of, between two heights.

`fence_rows` packs them into two arrays. Heights are above the guidance frame's origin [m], so
that z down is minus the height.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from vfguide.field.obstacle import Rows
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3

Point = tuple[float, float]
"""North and east [m]."""


class Zone(NamedTuple):
    """An upright prism or cylinder."""

    inclusion: bool
    """To be stayed in; else to be stayed out of."""
    corners: tuple[Point, ...]
    """Of a polygon in order, at least three; of a circle its centre alone."""
    radius: float = 0.0
    """Of the circle [m]."""
    lowest: float = -math.inf
    highest: float = math.inf
    """Heights between which it holds [m]."""


class Fences(NamedTuple):
    """Zones as arrays."""

    zones: Rows
    """(Z, 6): inclusion, first corner, number of corners, radius, lowest, highest."""
    corners: Rows
    """(C, 2): north, east [m]."""


def fences(zones: Sequence[Zone]) -> Fences:
    """The zones as arrays.

    Raises:
        ValueError: a zone is neither a polygon nor a circle, or is upside down.
    """
    rows, corners = np.zeros((len(zones), 6)), list[Point]()
    for row, zone in zip(rows, zones, strict=True):
        count = len(zone.corners)
        if not (count >= 3 and zone.radius == 0.0) and not (count == 1 and zone.radius > 0.0):
            raise ValueError("a zone has at least three corners, or a centre and a radius")
        if not zone.lowest < zone.highest:
            raise ValueError(f"a zone must reach up from {zone.lowest}, not to {zone.highest}")
        row[:] = (zone.inclusion, len(corners), count, zone.radius, zone.lowest, zone.highest)
        corners += zone.corners
    return Fences(rows, np.array(corners, dtype=float).reshape(-1, 2))


@compiled
def fence_distance(fences: Fences, i: int, p_n: Vec3) -> float:
    """Distance of `p_n` (NED) to where zone `i` is violated [m], negative where it is."""
    zones, height = fences.zones, -p_n[2]
    flat = zone_distance(fences, i, p_n[0], p_n[1])
    upright = max(zones[i, 4] - height, height - zones[i, 5])
    if zones[i, 0] != 0.0:
        return -max(flat, upright)
    if flat <= 0.0 or upright <= 0.0:
        return max(flat, upright)
    return math.sqrt(flat * flat + upright * upright)


@compiled
def zone_distance(fences: Fences, i: int, north: float, east: float) -> float:
    """Horizontal distance from the edge of zone `i` [m], negative inside."""
    zones, corners = fences.zones, fences.corners
    first, count = int(zones[i, 1]), int(zones[i, 2])
    if count == 1:
        return math.hypot(north - corners[first, 0], east - corners[first, 1]) - zones[i, 3]
    least, inside = math.inf, False
    before = first + count - 1
    for k in range(first, first + count):
        u, v = corners[before, 0] - corners[k, 0], corners[before, 1] - corners[k, 1]
        x, y = north - corners[k, 0], east - corners[k, 1]
        part = max(0.0, min(1.0, (x * u + y * v) / max(u * u + v * v, 1e-300)))
        least = min(least, (x - part * u) ** 2 + (y - part * v) ** 2)
        if (y < 0.0) != (y < v) and (x < u * y / v):
            inside = not inside
        before = k
    return -math.sqrt(least) if inside else math.sqrt(least)
