"""Geofence: upright prisms and cylinders to stay in or out of, between two heights.

`fences` packs them into two arrays. Heights are above the guidance frame's origin [m], so that z
(down) is minus the height.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from vfguide.field.obstacle import Rows
from vfguide.geometry.polygon import prism_distance, side_from, signed_root
from vfguide.geometry.vector import Vec3, Vectors
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import reader, table_of

Point = tuple[float, float]
"""North and east [m]."""


class Zone(NamedTuple):
    """An upright prism or cylinder."""

    inclusion: bool
    """Whether it must be stayed in; else it must be stayed out of."""
    corners: tuple[Point, ...]
    """Corners of a polygon in order, at least three, or the centre of a circle alone."""
    radius: float = 0.0
    """Radius of the circle [m], 0 for a polygon."""
    lowest: float = -math.inf
    """Least height at which it holds [m]."""
    highest: float = math.inf
    """Greatest height at which it holds [m]."""


class PackedZone(NamedTuple):
    """A zone whose corners are among those of all zones."""

    inclusion: bool
    """Whether it must be stayed in."""
    first_corner: int
    """Row of its first corner among those of all zones."""
    corners: int
    """Number of its corners, 1 for a circle."""
    radius: float
    """Radius of the circle [m], 0 for a polygon."""
    lowest: float
    """Least height at which it holds [m]."""
    highest: float
    """Greatest height at which it holds [m]."""


read_zone = reader(PackedZone)


class Fences(NamedTuple):
    """Zones as arrays."""

    zones: Rows
    """One `PackedZone` a row."""
    corners: Vectors
    """Corners of all zones, (C, 2): north, east [m]."""


def fences(zones: Sequence[Zone]) -> Fences:
    """The zones as arrays.

    Raises:
        ValueError: a zone is neither a polygon nor a circle, or is upside down.
    """
    packed, corners = list[PackedZone](), list[Point]()
    for zone in zones:
        check_zone(zone)
        count, heights = len(zone.corners), (zone.lowest, zone.highest)
        packed.append(PackedZone(zone.inclusion, len(corners), count, zone.radius, *heights))
        corners += zone.corners
    return Fences(table_of(PackedZone, packed), np.array(corners, dtype=float).reshape(-1, 2))


def check_zone(zone: Zone) -> None:
    """Check that a zone is a polygon or a circle, and that its heights are in order.

    Raises:
        ValueError: it is neither, or the heights are not.
    """
    count = len(zone.corners)
    if not (count >= 3 and zone.radius == 0.0) and not (count == 1 and zone.radius > 0.0):
        raise ValueError("a zone has at least three corners, or a centre and a radius")
    if not zone.lowest < zone.highest:
        raise ValueError(f"a zone must reach up from {zone.lowest}, not to {zone.highest}")


@compiled
def fence_distance(fences: Fences, i: int, p_n: Vec3) -> float:
    """Distance of `p_n` (NED) from violating zone `i` [m], negative where it is violated."""
    zone, height = read_zone(fences.zones[i]), -p_n[2]
    flat = zone_distance(zone, fences.corners, p_n[0], p_n[1])
    upright = max(zone.lowest - height, height - zone.highest)
    if zone.inclusion:
        return -max(flat, upright)
    return prism_distance(flat, upright)


@compiled
def zone_distance(zone: PackedZone, corners: Vectors, north: float, east: float) -> float:
    """Horizontal distance from the edge of a zone [m], negative inside."""
    first, count = zone.first_corner, zone.corners
    if count == 1:
        return math.hypot(north - corners[first, 0], east - corners[first, 1]) - zone.radius
    least, inside = math.inf, False
    x0, y0 = corners[first + count - 1, 0], corners[first + count - 1, 1]
    for k in range(first, first + count):
        x1, y1 = corners[k, 0], corners[k, 1]
        seen = side_from(x0, y0, x1, y1, north, east)
        least, inside = min(least, seen.square), inside != seen.crosses
        x0, y0 = x1, y1
    return signed_root(least, inside)
