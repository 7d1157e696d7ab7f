"""Obstacles in the world, and the table that passes them to compiled code.

An obstacle is a shape, turned about the vertical by a heading, that moves at a constant velocity.
`obstacle_rows` packs obstacles into a table once, one `PlacedObstacle` a row. Functions that are
called often take this table, the number of a row and the time.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

from vfguide.geometry.dual import Dual, Dual3
from vfguide.geometry.se2 import rotated, unrotated
from vfguide.geometry.shapes.base import Shape
from vfguide.geometry.shapes.distance import signed_distance
from vfguide.geometry.shapes.shape import shape_level
from vfguide.geometry.vector import Vec3, add, dot, matvec, scale, sub
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Row, Table, reader, replacing, table_of, writer

Rows = Table
"""A table of numbers, one thing a row."""

OUT_OF_SIGHT = 1e9
"""North coordinate to which an undetected obstacle is moved [m], chosen beyond every flight."""
HIGHEST_LEVEL = 1e30
"""Largest reactive level (a value of U, dimensionless) that is accepted; chosen so that products of
the fields stay finite."""


class Obstacle(NamedTuple):
    """A body to keep clear of."""

    shape: Shape
    """Its shape in its own axes, z down."""
    p_n: Vec3
    """Its centre at t = 0, NED [m]."""
    heading: float = 0.0
    """Turns its axes about the vertical, clockwise seen from above [rad]."""
    v_n: Vec3 = (0.0, 0.0, 0.0)
    """Its velocity, NED [m/s]."""
    reactive_level: float = 4.0
    """c-bar of the paper: the obstacle acts on the field where U is below it."""
    visible_from: float = math.inf
    """Distance from its surface beyond which it is not detected [m]."""


class PlacedObstacle(NamedTuple):
    """The row of an obstacle, as compiled code reads it."""

    kind: int
    """A `Kind` of shape."""
    p_n: Vec3
    """Its centre at t = 0, NED [m]."""
    v_n: Vec3
    """Its velocity, NED [m/s]."""
    heading_cos: float
    """Cosine of the angle by which its axes are turned about the vertical."""
    heading_sin: float
    """Sine of that angle."""
    semi_axes: Vec3
    """Half extents of its shape along its axes [m]."""
    exponents: Vec3
    """Exponents of the powers in its level function."""
    reactive_level: float
    """It acts on the field where U is below this."""
    reach: float
    """Radius of a ball around its centre that contains the reactive area [m]."""
    visible_from: float
    """Distance from its surface beyond which it is not detected [m]; infinite where that is beyond
    the reach."""


read_obstacle, write_obstacle = reader(PlacedObstacle), writer(PlacedObstacle)
at_place = replacing(PlacedObstacle, "p_n")


class Surface(NamedTuple):
    """The level function of an obstacle as a moving point sees it."""

    U: Dual
    n: Dual3
    """n_Upsilon, the gradient of U, NED [1/m]."""


def obstacle_rows(obstacles: Sequence[Obstacle]) -> Rows:
    """The obstacles as a table of `PlacedObstacle`, a row each.

    Raises:
        ValueError: a reactive level is not above 1 or too high.
    """
    return table_of(PlacedObstacle, map(placed, obstacles))


def placed(obstacle: Obstacle) -> PlacedObstacle:
    """The row of an obstacle, with its reach.

    Where U <= c-bar, |x_i| <= a_i c-bar^(1 / (2 p_i)); the reach is the radius of the ball round
    that box.

    Raises:
        ValueError: the reactive level is not above 1 or too high.
    """
    shape, level = obstacle.shape, obstacle.reactive_level
    if not 1.0 < level <= HIGHEST_LEVEL:
        raise ValueError(f"a reactive level must be in (1, {HIGHEST_LEVEL:g}], not {level}")
    sizes = zip(shape.semi_axes, shape.exponents, strict=True)
    reach = math.hypot(*(a * level ** (0.5 / p) for a, p in sizes))
    return PlacedObstacle(
        shape.kind,
        obstacle.p_n,
        obstacle.v_n,
        math.cos(obstacle.heading),
        math.sin(obstacle.heading),
        shape.semi_axes,
        shape.exponents,
        level,
        reach,
        math.inf if obstacle.visible_from >= reach else obstacle.visible_from,
    )


@compiled
def put_out_of_sight(row: Row) -> None:
    """Move the obstacle of a row north by `OUT_OF_SIGHT`, where nothing meets it."""
    obstacle = read_obstacle(row)
    _, east, down = obstacle.p_n
    write_obstacle(at_place(obstacle, (OUT_OF_SIGHT, east, down)), row)


@compiled
def shape_of(obstacle: PlacedObstacle) -> Shape:
    """The shape of an obstacle in its own axes."""
    return Shape(obstacle.kind, obstacle.semi_axes, obstacle.exponents)


@compiled
def from_centre(obstacle: PlacedObstacle, p: Dual3, t: float) -> Dual3:
    """Position relative to the obstacle's centre at time `t`, NED [m]."""
    p_n = add(obstacle.p_n, scale(t, obstacle.v_n))
    return Dual3(sub(p.value, p_n), sub(p.rate, obstacle.v_n))


@compiled
def into_axes(obstacle: PlacedObstacle, a_n: Vec3) -> Vec3:
    """The vector `a_n` (NED) in the obstacle's axes."""
    c, s = obstacle.heading_cos, obstacle.heading_sin
    x, y = unrotated(a_n[0], a_n[1], c, s)
    return x, y, a_n[2]


@compiled
def out_of_axes(obstacle: PlacedObstacle, a_o: Vec3) -> Vec3:
    """The vector `a_o` in the obstacle's axes, in NED."""
    c, s = obstacle.heading_cos, obstacle.heading_sin
    x, y = rotated(a_o[0], a_o[1], c, s)
    return x, y, a_o[2]


@compiled
def obstacle_surface(obstacles: Rows, i: int, p: Dual3, t: float) -> Surface:
    """U and n of row `i` at the moving point `p`, NED: n_Upsilon and the equation after it.

    The obstacle's velocity enters through the relative velocity: U depends on p - p_o alone.
    """
    obstacle = read_obstacle(obstacles[i])
    d = from_centre(obstacle, p, t)
    v_o = into_axes(obstacle, d.rate)
    level = shape_level(shape_of(obstacle), into_axes(obstacle, d.value))
    n = out_of_axes(obstacle, level.gradient)
    n_rate = out_of_axes(obstacle, matvec(level.hessian, v_o))
    return Surface(Dual(level.U, dot(level.gradient, v_o)), Dual3(n, n_rate))


@compiled
def obstacle_distance(obstacles: Rows, i: int, p_n: Vec3, t: float) -> float:
    """Distance of `p_n` (NED) from the surface of row `i` at time `t` [m], negative inside."""
    obstacle = read_obstacle(obstacles[i])
    d = from_centre(obstacle, Dual3(p_n, (0.0, 0.0, 0.0)), t)
    return signed_distance(shape_of(obstacle), into_axes(obstacle, d.value))


@compiled
def is_known(obstacles: Rows, i: int, p_n: Vec3, t: float) -> bool:
    """Whether the obstacle of row `i` is detected from `p_n` (NED) [m] at time `t` [s]."""
    visible_from = read_obstacle(obstacles[i]).visible_from
    return visible_from == math.inf or obstacle_distance(obstacles, i, p_n, t) <= visible_from
