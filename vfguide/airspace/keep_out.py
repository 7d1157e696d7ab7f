"""Keep-out zones of the route search: circles and polygons in the plane that may move.

Obstacles are taken as their footprints in the band of heights that is flown; a fence adds circles
and polygons of its own, to keep out of or to keep in.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from vfguide.airspace.footprint import (
    SIDE_WIDTH,
    SIDES,
    Band,
    Section,
    Side,
    crossing_times,
    is_round,
    read_side,
    section_in,
    sides_round,
)
from vfguide.field.obstacle import PlacedObstacle, Rows, read_obstacle
from vfguide.geometry.vector import Vectors
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import reader, replacing, table_of, width, writer

KEEP_OUT = 1.0
"""Sign of a zone that must be stayed out of."""
KEEP_IN = -1.0
"""Sign of a zone that must be stayed in."""


class KeepOutZone(NamedTuple):
    """A circle or a polygon in the plane, which may move."""

    sign: float
    """`KEEP_OUT` or `KEEP_IN`."""
    x: float
    """North coordinate of its centre at t = 0 [m]."""
    y: float
    """East coordinate of its centre at t = 0 [m]."""
    vx: float
    """Velocity to the north [m/s]."""
    vy: float
    """Velocity to the east [m/s]."""
    speed: float
    """Length of the velocity [m/s]."""
    bounding_radius: float
    """Radius of the circle around its centre that contains it [m]."""
    first_side: int
    """Row of its first side among the `sides` of all."""
    sides: int
    """Number of its sides, 0 for a circle."""
    since: float
    """Time from which on it counts [s]."""
    until: float
    """Time up to which it counts [s]."""
    is_convex: bool
    """Whether the distance is taken as that from the farthest side; around a footprint that is up
    to 2 % too small at the corners."""


ZONE_ROW_WIDTH = width(KeepOutZone)
"""Number of floats in the row of a `KeepOutZone`."""
read_zone_row, write_zone_row = reader(KeepOutZone), writer(KeepOutZone)
with_first_side = replacing(KeepOutZone, "first_side")


class KeepOutZones(NamedTuple):
    """Circles and polygons, and the sides of the polygons about their places."""

    table: Rows
    """One `KeepOutZone` a row."""
    sides: Rows
    """One `Side` a row, relative to the centre of its zone."""


@compiled
def obstacle_zones(obstacles: Rows, band: Band, margin: float) -> KeepOutZones:
    """Keep-out zones of obstacles in a band of heights, widened by `margin` [m] on both sides.

    A point in the band that is farther than `margin` from every zone is farther than that from
    every obstacle; a nearer point is at least as far from the obstacles as from the zones.
    """
    count = len(obstacles)
    table, sides = np.zeros((count, ZONE_ROW_WIDTH)), np.zeros((SIDES * count, SIDE_WIDTH))
    wide = Band(band.top - margin, band.bottom + margin)
    used = first = 0
    for i in range(count):
        section, (since, until) = section_in(obstacles, i, wide), crossing_times(obstacles, i, wide)
        if since > until or section.a <= 0.0 or section.b <= 0.0:
            continue
        obstacle = read_obstacle(obstacles[i])
        zone = footprint_zone(obstacle, section, since, until, sides, first)
        write_zone_row(zone, table[used])
        used, first = used + 1, first + zone.sides
    return KeepOutZones(table[:used], sides[:first])


@compiled
def footprint_zone(
    obstacle: PlacedObstacle,
    section: Section,
    since: float,
    until: float,
    sides: Rows,
    first: int,
) -> KeepOutZone:
    """The zone of a section of an obstacle, which counts from time `since` until `until` [s].

    Its sides are written into `sides` from row `first` on.
    """
    number, radius = 0, section.a
    if not is_round(section):
        number, there = SIDES, sides[first : first + SIDES]
        there[:] = sides_round(section, obstacle.heading_cos, obstacle.heading_sin)
        radius = bounding_radius_of(there)
    (x, y, _), (vx, vy, _) = obstacle.p_n, obstacle.v_n
    place = (KEEP_OUT, x, y, vx, vy, math.hypot(vx, vy))
    return KeepOutZone(*place, radius, first, number, since, until, True)


@compiled
def bounding_radius_of(sides: Rows) -> float:
    """Radius of the circle around the origin that contains the polygon [m]."""
    most = 0.0
    for k in range(len(sides)):
        corner = read_side(sides[k])
        most = max(most, math.hypot(corner.x, corner.y))
    return most


def circle(x: float, y: float, radius: float, sign: float = KEEP_OUT) -> KeepOutZones:
    """A circle of a fence around (x, y), north and east, with a `radius` [m]; it does not move.

    `sign` is `KEEP_OUT` or `KEEP_IN`.
    """
    zone = KeepOutZone(sign, x, y, 0.0, 0.0, 0.0, radius, 0, 0, -math.inf, math.inf, True)
    return KeepOutZones(table_of(KeepOutZone, (zone,)), table_of(Side, ()))


def polygon(corners: Sequence[tuple[float, float]], sign: float = KEEP_OUT) -> KeepOutZones:
    """A polygon of a fence by its corners, north and east [m], in either direction of rotation.

    `sign` is `KEEP_OUT` or `KEEP_IN`.
    """
    points: Vectors = np.array(corners, dtype=float)
    following: Vectors = np.roll(points, -1, axis=0)
    area = np.sum(points[:, 0] * following[:, 1] - points[:, 1] * following[:, 0])
    points = points[::-1].copy() if area < 0.0 else points
    centre = 0.5 * (points.min(axis=0) + points.max(axis=0))
    sides, (x, y) = sides_of(points - centre), centre
    place, radius = (sign, x, y, 0.0, 0.0, 0.0), bounding_radius_of(sides)
    zone = KeepOutZone(*place, radius, 0, len(sides), -math.inf, math.inf, False)
    return KeepOutZones(table_of(KeepOutZone, (zone,)), sides)


def sides_of(corners: Vectors) -> Rows:
    """The sides of a polygon, one `Side` a row, from its corners (N, 2) [m], clockwise."""
    along: Vectors = np.roll(corners, -1, axis=0) - corners
    normals = np.column_stack((along[:, 1], -along[:, 0]))
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-9)
    distances = np.sum(normals * corners, axis=1)
    parts = zip(normals, distances, corners, strict=True)
    return table_of(Side, (Side(nx, ny, distance, x, y) for (nx, ny), distance, (x, y) in parts))


@compiled
def joined(one: KeepOutZones, other: KeepOutZones) -> KeepOutZones:
    """The zones of both."""
    table = np.concatenate((one.table, other.table))
    for i in range(len(one.table), len(table)):
        zone = read_zone_row(table[i])
        write_zone_row(with_first_side(zone, zone.first_side + len(one.sides)), table[i])
    return KeepOutZones(table, np.concatenate((one.sides, other.sides)))


NO_FENCE = KeepOutZones(table_of(KeepOutZone, ()), table_of(Side, ()))
"""The keep-out zones of a scenario without a fence: none."""
