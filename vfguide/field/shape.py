"""Shapes of obstacles, and the constructors that check their sizes."""

import math
from enum import IntEnum
from typing import NamedTuple

from vfguide.geometry.vector import Vec3

EDGED = 4.0
"""Exponent of boxes, cylinders and cones: |x|^8, an edge rounded by 8 % of the size."""


class Kind(IntEnum):
    """Families of level functions."""

    SUPERQUADRIC = 0
    CYLINDER = 1
    CONE = 2


class Shape(NamedTuple):
    """A convex body about its own centre; `vfguide.field.level` has its level function U."""

    kind: int
    """A `Kind`."""
    semi_axes: Vec3
    """Half the size along each of the body's axes, z down [m]."""
    exponents: Vec3
    """p, q, r of a superquadric, at least 1; `EDGED` for a cylinder or a cone."""


def sphere(radius: float) -> Shape:
    """Sphere: U = (d / R)^2."""
    return ellipsoid((radius, radius, radius))


def ellipsoid(semi_axes: Vec3) -> Shape:
    """Ellipsoid: U = sum (x_i / a_i)^2."""
    return superquadric(semi_axes, (1.0, 1.0, 1.0))


def box(size: Vec3) -> Shape:
    """Box of the full edge lengths `size`: a superquadric of exponents 4."""
    length, width, height = size
    return superquadric((0.5 * length, 0.5 * width, 0.5 * height), (EDGED, EDGED, EDGED))


def superquadric(semi_axes: Vec3, exponents: Vec3) -> Shape:
    """Superquadric: U = sum |x_i / a_i|^(2 p_i), the paper's second example.

    Raises:
        ValueError: a semi-axis is not positive, or an exponent is below 1, where the gradient or
            the Hessian does not exist on the axes.
    """
    return _shape(Kind.SUPERQUADRIC, semi_axes, exponents)


def cylinder(radius: float, height: float) -> Shape:
    """Upright cylinder: U = ((x^2 + y^2) / R^2)^4 + (2 z / h)^8."""
    return _shape(Kind.CYLINDER, (radius, radius, 0.5 * height), (EDGED, EDGED, EDGED))


def cone(radius: float, height: float) -> Shape:
    """Upright cone, apex up, its centre at half the height: U of `level.cone_level`."""
    return _shape(Kind.CONE, (radius, radius, 0.5 * height), (EDGED, EDGED, EDGED))


def _shape(kind: Kind, semi_axes: Vec3, exponents: Vec3) -> Shape:
    if not all(0.0 < a < math.inf for a in semi_axes):
        raise ValueError(f"sizes of an obstacle must be positive, not {semi_axes}")
    if not all(1.0 <= p < math.inf for p in exponents):
        raise ValueError(f"exponents of a superquadric must be at least 1, not {exponents}")
    a, b, c = semi_axes
    p, q, r = exponents
    return Shape(int(kind), (float(a), float(b), float(c)), (float(p), float(q), float(r)))
