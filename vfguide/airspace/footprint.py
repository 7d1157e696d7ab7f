"""Footprint of an obstacle: what it covers of the horizontal plane in a band of heights.

The footprint is the widest horizontal section in the band, a circle or the polygon that `SIDES` of
its tangents form. The band is widened by the margin, so that a point farther than the margin from
the footprint is farther than the margin from the body.
"""

import math
from typing import NamedTuple

import numpy as np

from vfguide.field.obstacle import Rows, read_obstacle, shape_of
from vfguide.geometry.angles import FULL_TURN
from vfguide.geometry.se2 import rotated
from vfguide.geometry.shapes.base import Section, Shape
from vfguide.geometry.shapes.shape import section_at, widest_at
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Table, reader, width, writer

SIDES = 16
"""Number of sides of the polygon that circumscribes a section that is not a circle; chosen: more
cost search time, fewer cover more ground."""
SIDE_ANGLE = FULL_TURN / SIDES
"""Angle between the normals of two neighbouring sides [rad]."""
HALVINGS = 10
"""Number of bisections of the angle at which a superquadric of unequal exponents touches a side;
chosen: ten leave 0.0015 rad, and the error of the distance is of second order."""


class Band(NamedTuple):
    """A range of heights, counted downwards from the origin, as z of NED is [m]."""

    top: float
    """The smaller z."""
    bottom: float
    """The larger z."""


class Side(NamedTuple):
    """A side of a polygon, relative to the polygon's centre."""

    nx: float
    """North component of the outward unit normal."""
    ny: float
    """East component of the outward unit normal."""
    distance: float
    """Distance of the side from the centre [m]."""
    x: float
    """Offset to the north of the corner shared with the previous side [m]."""
    y: float
    """Offset to the east of that corner [m]."""


SIDE_WIDTH = width(Side)
"""Number of floats in the row of a `Side`."""
read_side, write_side = reader(Side), writer(Side)


@compiled
def widest_height(shape: Shape, band: Band) -> float:
    """Height of the widest section in the band, z down from the centre [half heights].

    The band is relative to the centre of the body.
    """
    c = shape.semi_axes[2]
    return max(band.top / c, min(band.bottom / c, widest_at(shape)))


@compiled
def is_round(section: Section) -> bool:
    """Whether the section is a circle."""
    return section.a == section.b and section.p == 1.0 and section.q == 1.0


@compiled
def touching(section: Section, nx: float, ny: float) -> float:
    """Support function: how far the section reaches along the unit vector (nx, ny) [m].

    Neither component is negative. The point with that normal is x = a cos^(1/p), y = b sin^(1/q) of
    some angle, which is found by bisection; an error of the angle enters the result squared.
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
    """The polygon that circumscribes a section, one `Side` a row, clockwise seen from above.

    The axes of the section are turned by the heading of cosine `c` and sine `s`.
    """
    sides: Table = np.empty((SIDES, SIDE_WIDTH))
    quarter = np.empty(SIDES // 4 + 1)
    for k in range(len(quarter)):
        quarter[k] = touching(section, max(math.cos(k * SIDE_ANGLE), 0.0), math.sin(k * SIDE_ANGLE))
    for k in range(SIDES):
        nx, ny = math.cos(k * SIDE_ANGLE), math.sin(k * SIDE_ANGLE)
        mirrored = min(k % (SIDES // 2), -k % (SIDES // 2))
        normal_x, normal_y = rotated(nx, ny, c, s)
        write_side(Side(normal_x, normal_y, quarter[mirrored], 0.0, 0.0), sides[k])
    for k in range(SIDES):
        write_side(with_corner(read_side(sides[k]), read_side(sides[k - 1])), sides[k])
    return sides


@compiled
def with_corner(side: Side, before: Side) -> Side:
    """The side with the corner where it meets `before`, which lies `SIDE_ANGLE` anticlockwise."""
    x = (before.distance * side.ny - side.distance * before.ny) / math.sin(SIDE_ANGLE)
    y = (side.distance * before.nx - before.distance * side.nx) / math.sin(SIDE_ANGLE)
    return Side(side.nx, side.ny, side.distance, x, y)


@compiled
def times_in(band: Band, height: float, half_height: float, rate: float) -> tuple[float, float]:
    """The first and the last time at which a moving body reaches into a band [s].

    Where it never does, the first is later than the last.

    Args:
        band: the heights.
        height: z of its centre at time 0 [m].
        half_height: half of its height [m].
        rate: its velocity down [m/s].
    """
    low, high = band.top - half_height - height, band.bottom + half_height - height
    if rate == 0.0:
        return (-math.inf, math.inf) if low <= 0.0 <= high else (math.inf, -math.inf)
    return min(low / rate, high / rate), max(low / rate, high / rate)


@compiled
def crossing_times(obstacles: Rows, i: int, band: Band) -> tuple[float, float]:
    """The first and the last time at which row `i` reaches into the band [s], as `times_in`."""
    obstacle = read_obstacle(obstacles[i])
    return times_in(band, obstacle.p_n[2], obstacle.semi_axes[2], obstacle.v_n[2])


@compiled
def section_in(obstacles: Rows, i: int, band: Band) -> Section:
    """The widest section of row `i` in the band, or of the whole body if it climbs or descends."""
    obstacle = read_obstacle(obstacles[i])
    shape, height = shape_of(obstacle), obstacle.p_n[2]
    inside = Band(band.top - height, band.bottom - height)
    if obstacle.v_n[2] != 0.0:
        inside = Band(-shape.semi_axes[2], shape.semi_axes[2])
    return section_at(shape, widest_height(shape, inside))
