"""What a coarse search keeps clear of: circles and polygons in the plane that may move.

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
from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import reader, replacing, table_of, width, writer
from vfguide.geometry.vector import Vectors

KEEP_OUT, KEEP_IN = 1.0, -1.0
"""Sign of an outline: one may not be inside it, or not outside it."""


class KeepOutZone(NamedTuple):
    """A circle or a polygon in the plane, which may move."""

    sign: float
    """`KEEP_OUT` or `KEEP_IN`."""
    x: float
    y: float
    """Its place at t = 0, NED [m]."""
    vx: float
    vy: float
    """Its velocity, NED [m/s]."""
    speed: float
    """[m/s]."""
    bounding_radius: float
    """Of the circle about its place that holds it [m]; of a circle its own."""
    first_side: int
    """Row of its first side among the `sides` of all."""
    sides: int
    """How many sides it has, none for a circle."""
    since: float
    until: float
    """When it is there [s]."""
    is_convex: bool
    """Whether its farthest side is its distance, as it is round a footprint but for a fiftieth."""


ZONE_ROW_WIDTH = width(KeepOutZone)
"""How many numbers the row of an outline has."""
read_zone_row, write_zone_row = reader(KeepOutZone), writer(KeepOutZone)
with_first_side = replacing(KeepOutZone, "first_side")


class KeepOutZones(NamedTuple):
    """Circles and polygons, and the sides of the polygons about their places."""

    table: Rows
    """An `KeepOutZone` a row."""
    sides: Rows
    """A `Side` a row, about the place of its outline."""


@compiled
def hazards_of(obstacles: Rows, band: Band, margin: float) -> KeepOutZones:
    """What obstacles cover of a band of heights that is wider by `margin` [m] on both sides.

    A point in the band that is farther than `margin` from all of it is farther than that from
    every obstacle; nearer ones are at least as far from the obstacles as from it.
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
        outline = footprint_zone(obstacle, section, since, until, sides, first)
        write_zone_row(outline, table[used])
        used, first = used + 1, first + outline.sides
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
    """The outline of a section of an obstacle; its sides are written from row `first` on."""
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
    """Radius of the circle round the origin that holds the polygon [m]."""
    most = 0.0
    for k in range(len(sides)):
        corner = read_side(sides[k])
        most = max(most, math.hypot(corner.x, corner.y))
    return most


def circle(x: float, y: float, radius: float, sign: float = KEEP_OUT) -> KeepOutZones:
    """A circle of a fence at (x, y), NED [m]."""
    outline = KeepOutZone(sign, x, y, 0.0, 0.0, 0.0, radius, 0, 0, -math.inf, math.inf, True)
    return KeepOutZones(table_of(KeepOutZone, (outline,)), table_of(Side, ()))


def polygon(corners: Sequence[tuple[float, float]], sign: float = KEEP_OUT) -> KeepOutZones:
    """A polygon of a fence by its corners, NED [m], either way round."""
    points: Vectors = np.array(corners, dtype=float)
    following: Vectors = np.roll(points, -1, axis=0)
    area = np.sum(points[:, 0] * following[:, 1] - points[:, 1] * following[:, 0])
    points = points[::-1].copy() if area < 0.0 else points
    centre = 0.5 * (points.min(axis=0) + points.max(axis=0))
    sides, (x, y) = sides_of(points - centre), centre
    place, radius = (sign, x, y, 0.0, 0.0, 0.0), bounding_radius_of(sides)
    outline = KeepOutZone(*place, radius, 0, len(sides), -math.inf, math.inf, False)
    return KeepOutZones(table_of(KeepOutZone, (outline,)), sides)


def sides_of(corners: Vectors) -> Rows:
    """Sides of a polygon from its corners (N, 2), a `Side` a row."""
    along: Vectors = np.roll(corners, -1, axis=0) - corners
    normals = np.column_stack((along[:, 1], -along[:, 0]))
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-9)
    distances = np.sum(normals * corners, axis=1)
    parts = zip(normals, distances, corners, strict=True)
    return table_of(Side, (Side(nx, ny, distance, x, y) for (nx, ny), distance, (x, y) in parts))


@compiled
def joined(one: KeepOutZones, other: KeepOutZones) -> KeepOutZones:
    """The hazards of both."""
    table = np.concatenate((one.table, other.table))
    for i in range(len(one.table), len(table)):
        outline = read_zone_row(table[i])
        write_zone_row(with_first_side(outline, outline.first_side + len(one.sides)), table[i])
    return KeepOutZones(table, np.concatenate((one.sides, other.sides)))


NO_FENCE = KeepOutZones(table_of(KeepOutZone, ()), table_of(Side, ()))
"""Nothing to keep clear of."""
