"""Shapes, and points on them and around them."""

import numpy as np
import pytest

from vfguide.geometry.shapes import shape
from vfguide.geometry.shapes.distance import signed_distance
from vfguide.geometry.shapes.shape import Shape, shape_level
from vfguide.geometry.vector import Series, Vectors, vec3
from vfguide.kernels.compiled import compiled

SHAPES = {
    "sphere": shape.sphere(40.0),
    "ellipsoid": shape.ellipsoid((60.0, 25.0, 10.0)),
    "superquadric": shape.superquadric((30.0, 50.0, 20.0), (1.5, 2.0, 5.0)),
    "steep": shape.superquadric((12.0, 8.0, 30.0), (8.0, 8.0, 8.0)),
    "box": shape.box((20.0, 60.0, 100.0)),
    "cylinder": shape.cylinder(15.0, 120.0),
    "cone": shape.cone(50.0, 80.0),
}
MORE_SHAPES = SHAPES | {
    "needle": shape.ellipsoid((2.0, 1.0, 90.0)),
    "disc": shape.superquadric((50.0, 30.0, 1.0), (1.0, 3.0, 8.0)),
    "sharp box": shape.superquadric((30.0, 10.0, 20.0), (40.0, 40.0, 40.0)),
    "tower": shape.cylinder(5.0, 200.0),
    "spire": shape.cone(5.0, 100.0),
    "heap": shape.cone(80.0, 10.0),
}

every_shape = pytest.mark.parametrize("body", SHAPES.values(), ids=SHAPES)
every_odd_shape = pytest.mark.parametrize("body", MORE_SHAPES.values(), ids=MORE_SHAPES)


def floats(a):
    return tuple(map(float, a))


def random_shape(rng):
    """Any kind of shape, each semi-axis 5 to 50 m, exponents 1 to 5."""
    a = floats(10.0 ** rng.uniform(0.7, 1.7, 3))
    return (
        shape.sphere(a[0]),
        shape.ellipsoid(a),
        shape.superquadric(a, floats(rng.uniform(1.0, 5.0, 3))),
        shape.box(a),
        shape.cylinder(a[0], a[1]),
        shape.cone(a[0], a[1]),
    )[rng.integers(6)]


def random_directions(rng, count):
    a = rng.normal(size=(count, 3))
    return a / np.linalg.norm(a, axis=1, keepdims=True)


def surface_points(body, count=20_000):
    """Points all over the surface, found by bisection of the level function."""
    rng = np.random.default_rng(2)
    a = rng.normal(size=(count, 3))
    a[::3] = np.sign(a[::3]) * np.abs(a[::3]) ** 3  # more of them near edges and poles
    directions = a * body.semi_axes
    low, high = np.zeros(count), np.full(count, 1e4)
    for _ in range(70):
        middle = 0.5 * (low + high)
        outside = levels_at(body, middle[:, None] * directions) > 1.0
        low, high = np.where(outside, low, middle), np.where(outside, middle, high)
    return high[:, None] * directions


def points_around(body):
    """Points from deep inside to ten sizes away, many of them on planes of symmetry."""
    rng = np.random.default_rng(3)
    x = rng.normal(size=(600, 3)) * body.semi_axes * 10.0 ** rng.uniform(-1.5, 1.0, (600, 1))
    x[::5, 0] = x[::7, 1] = x[::3, 2] = 0.0
    x[0] = 0.0
    return x


@compiled
def levels_at(body: Shape, x: Vectors) -> Series:
    """U at points (n, 3)."""
    U = np.empty(len(x))
    for i in range(len(x)):
        U[i] = shape_level(body, vec3(x[i])).U
    return U


@compiled
def distances_at(body: Shape, x: Vectors) -> Series:
    """Distances from the surface of points (n, 3), negative inside [m]."""
    distance = np.empty(len(x))
    for i in range(len(x)):
        distance[i] = signed_distance(body, vec3(x[i]))
    return distance
