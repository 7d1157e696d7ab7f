"""What an obstacle covers of the horizontal plane in a band of heights.

A circle, or a polygon round it: the section is widest at one height of the band, and SIDES
of its tangents enclose it. Beyond the band the margin keeps the body away, so that a point
farther than the margin from the footprint is farther than that from the body.
"""

import math
from typing import NamedTuple

import numpy as np

from vfguide.field.obstacle import Rows, read_obstacle, shape_of
from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import Table, reader, width, writer
from vfguide.geometry.shapes.base import Section, Shape
from vfguide.geometry.shapes.shape import section_at, widest_at

SIDES = 16
"""Of the polygon round a section that is no circle."""
STEP = 2.0 * math.pi / SIDES
HALVINGS = 10
"""Of the angle at which a superquadric of unequal exponents is touched."""


class Band(NamedTuple):
    """Heights, down from the origin [m]."""

    top: float
    bottom: float


class Side(NamedTuple):
    """A side of a polygon about its centre."""

    nx: float
    ny: float
    """Outward unit normal, NED."""
    distance: float
    """Of the side from the centre [m]."""
    x: float
    y: float
    """The corner where it meets the side before, about the centre, NED [m]."""


SIDE_WIDTH = width(Side)
"""How many numbers the row of a side has."""
read_side, write_side = reader(Side), writer(Side)


@compiled
def widest_height(shape: Shape, band: Band) -> float:
    """Height of the widest section in the band, which is about the body's centre, half heights."""
    c = shape.semi_axes[2]
    return max(band.top / c, min(band.bottom / c, widest_at(shape)))


@compiled
def is_round(section: Section) -> bool:
    """Whether the section is a circle."""
    return section.a == section.b and section.p == 1.0 and section.q == 1.0


@compiled
def touching(section: Section, nx: float, ny: float) -> float:
    """How far the section reaches along the unit vector (nx, ny), neither of it negative [m].

    The point whose normal that is lies at some angle of x = a cos^(1/p), y = b sin^(1/q); an error
    of it counts squared.
    """
    a, b, p, q = section
    if p == q:
        dual = 2.0 * p / (2.0 * p - 1.0)
        return ((a * nx) ** dual + (b * ny) ** dual) ** (1.0 / dual)
    low, high = 0.0, 0.5 * math.pi
    for _ in range(HALVINGS):
        angle = 0.5 * (low + high)
        wx, wy = math.cos(angle) ** (1.0 / p), math.sin(angle) ** (1.0 / q)
        turned = q / b * wy ** (2.0 * q - 1.0) * nx - p / a * wx ** (2.0 * p - 1.0) * ny
        low, high = (low, angle) if turned > 0.0 else (angle, high)
    angle = 0.5 * (low + high)
    wx, wy = math.cos(angle) ** (1.0 / p), math.sin(angle) ** (1.0 / q)
    return a * wx * nx + b * wy * ny


@compiled
def sides_round(section: Section, c: float, s: float) -> Table:
    """The polygon round a section, its axes turned by the angle of cosine `c` and sine `s`.

    A `Side` a row, clockwise from above.
    """
    sides: Table = np.empty((SIDES, SIDE_WIDTH))
    quarter = np.empty(SIDES // 4 + 1)
    for k in range(len(quarter)):
        quarter[k] = touching(section, max(math.cos(k * STEP), 0.0), math.sin(k * STEP))
    for k in range(SIDES):
        nx, ny = math.cos(k * STEP), math.sin(k * STEP)
        mirrored = min(k % (SIDES // 2), -k % (SIDES // 2))
        side = Side(c * nx - s * ny, s * nx + c * ny, quarter[mirrored], 0.0, 0.0)
        write_side(side, sides[k])
    for k in range(SIDES):
        write_side(with_corner(read_side(sides[k]), read_side(sides[k - 1])), sides[k])
    return sides


@compiled
def with_corner(side: Side, before: Side) -> Side:
    """The side, `STEP` clockwise from the side before, with the corner where both meet."""
    x = (before.distance * side.ny - side.distance * before.ny) / math.sin(STEP)
    y = (side.distance * before.nx - before.distance * side.nx) / math.sin(STEP)
    return Side(side.nx, side.ny, side.distance, x, y)


@compiled
def crossing_times(obstacles: Rows, i: int, band: Band) -> tuple[float, float]:
    """From when until when row `i` reaches into the band [s]; none where the first is later."""
    obstacle = read_obstacle(obstacles[i])
    half, height, rate = obstacle.semi_axes[2], obstacle.p_n[2], obstacle.v_n[2]
    if rate == 0.0:
        reaches = band.top <= height + half and height - half <= band.bottom
        return (-math.inf, math.inf) if reaches else (math.inf, -math.inf)
    from_above = (band.top - half - height) / rate
    from_below = (band.bottom + half - height) / rate
    return min(from_above, from_below), max(from_above, from_below)


@compiled
def section_in(obstacles: Rows, i: int, band: Band) -> Section:
    """The widest section of row `i` in the band: of all its sections where it climbs or sinks."""
    obstacle = read_obstacle(obstacles[i])
    shape, height = shape_of(obstacle), obstacle.p_n[2]
    inside = Band(band.top - height, band.bottom - height)
    if obstacle.v_n[2] != 0.0:
        inside = Band(-shape.semi_axes[2], shape.semi_axes[2])
    return section_at(shape, widest_height(shape, inside))
