"""Obstacles in the world, and the array that takes them into compiled code.

An obstacle is a shape turned by a heading about the vertical that moves at a constant velocity.
`obstacle_rows` packs obstacles once into an array (M, COLUMNS); what is called often takes this
array, the number of a row and the time.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.field.distance import signed_distance
from vfguide.field.dual import Dual, Dual3
from vfguide.field.level import shape_level
from vfguide.field.shape import Shape
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3, add, dot, matvec, scale, sub

Rows = NDArray[np.float64]
"""A table of numbers, one thing a row."""

COLUMNS = 18
"""Of a row: kind; position at t = 0 and velocity, NED; cosine and sine of the heading; semi-axes;
exponents; reactive level; reach, the radius of a ball that holds the reactive area; the distance
from the surface beyond which nobody knows of it, infinite where it is beyond the reach."""
POSITION, VELOCITY, SEMI_AXES = slice(1, 4), slice(4, 7), slice(9, 12)
REACTIVE_LEVEL, REACH, VISIBLE_FROM = 15, 16, 17
OUT_OF_SIGHT = 1e9
"""An obstacle that is not known yet counts as so far to the north [m]."""
HIGHEST_LEVEL = 1e30
"""Up to this reactive level products of the fields stay finite."""


class Obstacle(NamedTuple):
    """A body to keep out of."""

    shape: Shape
    p_n: Vec3
    """Its centre at t = 0, NED [m]."""
    heading: float = 0.0
    """Turns its axes about the vertical, clockwise seen from above [rad]."""
    v_n: Vec3 = (0.0, 0.0, 0.0)
    """Its velocity, NED [m/s]."""
    reactive_level: float = 4.0
    """c-bar of the paper: the obstacle acts on the field where U is below it."""
    visible_from: float = math.inf
    """Farther than this from its surface a robot does not know of it [m]."""


class Surface(NamedTuple):
    """The level function of an obstacle as a moving point sees it."""

    U: Dual
    n: Dual3
    """n_Upsilon, the gradient of U, NED [1/m]."""


def obstacle_rows(obstacles: Sequence[Obstacle]) -> Rows:
    """The obstacles as an array (M, COLUMNS).

    Raises:
        ValueError: a reactive level is not above 1 or too high.
    """
    rows = np.zeros((len(obstacles), COLUMNS))
    for row, obstacle in zip(rows, obstacles, strict=True):
        shape, level = obstacle.shape, obstacle.reactive_level
        if not 1.0 < level <= HIGHEST_LEVEL:
            raise ValueError(f"a reactive level must be in (1, {HIGHEST_LEVEL:g}], not {level}")
        sizes = zip(shape.semi_axes, shape.exponents, strict=True)
        heading = (math.cos(obstacle.heading), math.sin(obstacle.heading))
        row[:9] = (shape.kind, *obstacle.p_n, *obstacle.v_n, *heading)
        row[9:REACTIVE_LEVEL] = (*shape.semi_axes, *shape.exponents)
        row[REACTIVE_LEVEL] = level
        row[REACH] = math.hypot(*(a * level ** (0.5 / p) for a, p in sizes))
        row[VISIBLE_FROM] = (
            math.inf if obstacle.visible_from >= row[REACH] else obstacle.visible_from
        )
    return rows


@compiled
def obstacle_shape(obstacles: Rows, i: int) -> Shape:
    """The shape in row `i`."""
    o = obstacles[i]
    return Shape(int(o[0]), (o[9], o[10], o[11]), (o[12], o[13], o[14]))


@compiled
def from_centre(obstacles: Rows, i: int, p: Dual3, t: float) -> Dual3:
    """Position relative to the centre of row `i` at time `t`, NED [m]."""
    o = obstacles[i]
    v_n = (o[4], o[5], o[6])
    p_n = add((o[1], o[2], o[3]), scale(t, v_n))
    return Dual3(sub(p.value, p_n), sub(p.rate, v_n))


@compiled
def into_axes(obstacles: Rows, i: int, a_n: Vec3) -> Vec3:
    """The vector `a_n` (NED) in the axes of row `i`."""
    c, s = obstacles[i, 7], obstacles[i, 8]
    return (c * a_n[0] + s * a_n[1], c * a_n[1] - s * a_n[0], a_n[2])


@compiled
def out_of_axes(obstacles: Rows, i: int, a_o: Vec3) -> Vec3:
    """The vector `a_o` in the axes of row `i`, in NED."""
    c, s = obstacles[i, 7], obstacles[i, 8]
    return (c * a_o[0] - s * a_o[1], s * a_o[0] + c * a_o[1], a_o[2])


@compiled
def obstacle_surface(obstacles: Rows, i: int, p: Dual3, t: float) -> Surface:
    """U and n of row `i` at the moving point `p`, NED: n_Upsilon and the equation after it.

    The obstacle's velocity enters through the relative velocity: U depends on p - p_o alone.
    """
    d = from_centre(obstacles, i, p, t)
    v_o = into_axes(obstacles, i, d.rate)
    level = shape_level(obstacle_shape(obstacles, i), into_axes(obstacles, i, d.value))
    n = out_of_axes(obstacles, i, level.gradient)
    n_rate = out_of_axes(obstacles, i, matvec(level.hessian, v_o))
    return Surface(Dual(level.U, dot(level.gradient, v_o)), Dual3(n, n_rate))


@compiled
def obstacle_distance(obstacles: Rows, i: int, p_n: Vec3, t: float) -> float:
    """Distance of `p_n` (NED) from the surface of row `i` at time `t` [m], negative inside."""
    d = from_centre(obstacles, i, Dual3(p_n, (0.0, 0.0, 0.0)), t)
    return signed_distance(obstacle_shape(obstacles, i), into_axes(obstacles, i, d.value))


@compiled
def is_known(obstacles: Rows, i: int, p_n: Vec3, t: float) -> bool:
    """Whether a robot at `p_n` (NED) knows of row `i` at time `t`."""
    visible_from = obstacles[i, VISIBLE_FROM]
    return visible_from == math.inf or obstacle_distance(obstacles, i, p_n, t) <= visible_from
