"""What a coarse search keeps clear of: circles and polygons in the plane that may move.

Obstacles are taken as their footprints in the band of heights that is flown; a fence adds circles
and polygons of its own, to keep out of or to keep in.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.field.footprint import (
    SIDES,
    Band,
    crossing_times,
    is_round,
    section_in,
    sides_round,
)
from vfguide.field.obstacle import Rows
from vfguide.geometry.compiled import compiled

KEEP_OUT, KEEP_IN = 1.0, -1.0
SIGN, X, Y, VX, VY, SPEED, BALL, FIRST, COUNT, SINCE, UNTIL, CONVEX = range(12)
"""Columns of a hazard: `KEEP_OUT` or `KEEP_IN`; place at t = 0 [m] and velocity [m/s], NED; speed;
radius of a circle that holds it; its sides, none for a circle; from when until when it is there;
whether its farthest side is its distance, as it is round a footprint but for a fiftieth."""
COLUMNS = 12


class Outlines(NamedTuple):
    """Circles and polygons, and the sides of the polygons about their places."""

    table: Rows
    """(M, COLUMNS)."""
    sides: Rows
    """(N, 5): outward unit normal and distance from the place, corner with the side before, NED."""


@compiled
def hazards_of(obstacles: Rows, band: Band, margin: float) -> Outlines:
    """What obstacles cover of a band of heights that is wider by `margin` [m] on both sides.

    A point in the band that is farther than `margin` from all of it is farther than that from
    every obstacle; nearer ones are at least as far from the obstacles as from it.
    """
    count = len(obstacles)
    table, sides = np.zeros((count, COLUMNS)), np.zeros((SIDES * count, 5))
    wide = Band(band.top - margin, band.bottom + margin)
    used = points = 0
    for i in range(count):
        section, row = section_in(obstacles, i, wide), obstacles[i]
        since, until = crossing_times(obstacles, i, wide)
        if since > until or section.a <= 0.0 or section.b <= 0.0:
            continue
        speed = math.hypot(row[4], row[5])
        table[used, :BALL] = (KEEP_OUT, row[1], row[2], row[4], row[5], speed)
        table[used, BALL:] = (section.a, float(points), 0.0, since, until, 1.0)
        if not is_round(section):
            there = sides[points : points + SIDES]
            there[:] = sides_round(section, row[7], row[8])
            table[used, BALL], table[used, COUNT] = ball_of(there), SIDES
            points += SIDES
        used += 1
    return Outlines(table[:used], sides[:points])


@compiled
def ball_of(sides: NDArray[np.float64]) -> float:
    """Radius of the circle round the origin that holds the polygon [m]."""
    most = 0.0
    for k in range(len(sides)):
        most = max(most, math.hypot(sides[k, 3], sides[k, 4]))
    return most


def circle(x: float, y: float, radius: float, sign: float = KEEP_OUT) -> Outlines:
    """A circle of a fence at (x, y), NED [m]."""
    row = (sign, x, y, 0.0, 0.0, 0.0, radius, 0.0, 0.0, -math.inf, math.inf, 1.0)
    return Outlines(np.array([row]), np.zeros((0, 5)))


def polygon(corners: Sequence[tuple[float, float]], sign: float = KEEP_OUT) -> Outlines:
    """A polygon of a fence by its corners, NED [m], either way round."""
    points = np.array(corners, dtype=float)
    following = np.roll(points, -1, axis=0)
    area = np.sum(points[:, 0] * following[:, 1] - points[:, 1] * following[:, 0])
    points = points[::-1].copy() if area < 0.0 else points
    centre = 0.5 * (points.min(axis=0) + points.max(axis=0))
    sides = sides_of(points - centre)
    place = (sign, *centre, 0.0, 0.0, 0.0)
    row = (*place, ball_of(sides), 0.0, len(points), -math.inf, math.inf, 0.0)
    return Outlines(np.array([row]), sides)


def sides_of(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """Sides of a polygon from its corners (N, 2)."""
    along = np.roll(corners, -1, axis=0) - corners
    normals = np.column_stack((along[:, 1], -along[:, 0]))
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-9)
    return np.column_stack((normals, np.sum(normals * corners, axis=1), corners))


@compiled
def joined(one: Outlines, other: Outlines) -> Outlines:
    """The hazards of both."""
    table = np.concatenate((one.table, other.table))
    table[len(one.table) :, FIRST] += len(one.sides)
    return Outlines(table, np.concatenate((one.sides, other.sides)))


NO_FENCE = Outlines(np.zeros((0, COLUMNS)), np.zeros((0, 5)))
"""Nothing to keep clear of."""
