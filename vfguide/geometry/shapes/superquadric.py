"""Superquadrics, the paper's second example: spheres, ellipsoids and boxes among them.

U = |x / a|^(2p) + |y / b|^(2q) + |z / c|^(2r) (A. H. Barr, Superquadrics and Angle-Preserving
Transformations, 1981).
"""

import math

import numpy as np

from vfguide.geometry.shapes.base import (
    EDGED,
    FAR_FROM_EDGES,
    Kind,
    Level,
    Section,
    Shape,
    checked,
    edged_gauge_bound,
    even_power,
)
from vfguide.geometry.shapes.rays import Array, Rays, root
from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled

TOO_STEEP = 300.0
"""Natural logarithm of a term of U, dimensionless, above which only the bound of the box is used;
chosen, since the powers would overflow."""


def sphere(radius: float) -> Shape:
    """Sphere of a radius [m]: U = (d / R)^2."""
    return ellipsoid((radius, radius, radius))


def ellipsoid(semi_axes: Vec3) -> Shape:
    """Ellipsoid of three semi-axes [m]: U = sum (x_i / a_i)^2."""
    return superquadric(semi_axes, (1.0, 1.0, 1.0))


def box(size: Vec3) -> Shape:
    """Box with the full edge lengths `size` [m]: a superquadric of exponents 4."""
    length, width, height = size
    return superquadric((0.5 * length, 0.5 * width, 0.5 * height), (EDGED, EDGED, EDGED))


def superquadric(semi_axes: Vec3, exponents: Vec3) -> Shape:
    """Superquadric: U = sum |x_i / a_i|^(2 p_i).

    Raises:
        ValueError: a semi-axis is not positive, or an exponent is below 1.
    """
    return checked(Kind.SUPERQUADRIC, semi_axes, exponents)


@compiled
def superquadric_level(w: Vec3, exponents: Vec3) -> Level:
    """U = sum |w_i|^(2 p_i), the paper's second example, at x_i = a_i w_i."""
    t0, d0, dd0 = even_power(w[0], exponents[0])
    t1, d1, dd1 = even_power(w[1], exponents[1])
    t2, d2, dd2 = even_power(w[2], exponents[2])
    hessian = ((dd0, 0.0, 0.0), (0.0, dd1, 0.0), (0.0, 0.0, dd2))
    return Level(t0 + t1 + t2, (d0, d1, d2), hessian)


@compiled
def superquadric_section(shape: Shape, w: float) -> Section:
    """The section `w` half heights below the centre."""
    (a, b, _), (p, q, r) = shape.semi_axes, shape.exponents
    if w < -1.0 or w > 1.0:
        return Section(0.0, 0.0, 1.0, 1.0)
    left = 1.0 - abs(w) ** (2.0 * r)
    return Section(a * left ** (0.5 / p), b * left ** (0.5 / q), p, q)


def superquadric_rays(shape: Shape, latitude: Array, longitude: Array) -> Rays:
    """Directions that end on the surface.

    |x / a|^p = cos(latitude) cos(longitude) and so on makes U a sum of squares, which is 1.
    """
    p, q, r = shape.exponents
    beside = np.cos(latitude)
    x, y = root(beside * np.cos(longitude), p), root(beside * np.sin(longitude), q)
    return x, y, root(np.sin(latitude), r)


@compiled
def superquadric_bound(x: Vec3, a: Vec3, exponents: Vec3) -> float:
    """Lower bound of the distance of `x`, in the superquadric's axes, from U = 1 [m].

    It is negative inside.
    """
    p, q, r = exponents
    if a[0] == a[1] == a[2] and p == q == r == 1.0:
        return math.sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) - a[0]
    sharp = box_distance(x[0], x[1], x[2], a)
    if p == q == r == EDGED:
        if sharp > FAR_FROM_EDGES * max(a[0], a[1], a[2]):
            return sharp
        return max(sharp, edged_gauge(x[0] / a[0], x[1] / a[1], x[2] / a[2], a))
    if p == q == r == 1.0:
        return max(sharp, ellipsoid_gauge(x[0] / a[0], x[1] / a[1], x[2] / a[2], a))
    return max(sharp, smooth_gauge(x, a, exponents))


@compiled
def box_distance(x: float, y: float, z: float, a: Vec3) -> float:
    """Distance from the box of semi-axes `a` [m], negative inside."""
    u, v, w = abs(x) - a[0], abs(y) - a[1], abs(z) - a[2]
    deepest = max(u, v, w)
    if deepest <= 0.0:
        return deepest
    u, v, w = max(u, 0.0), max(v, 0.0), max(w, 0.0)
    return math.sqrt(u * u + v * v + w * w)


@compiled
def edged_gauge(u: float, v: float, w: float, a: Vec3) -> float:
    """Lower bound of the distance from f = U^(1/8), as in `shapes.base` [m]; minus infinity inside.

    For exponents 4, at the point (u, v, w) in semi-axes.
    """
    u2, v2, w2 = u * u, v * v, w * w
    u6, v6, w6 = u2 * u2 * u2, v2 * v2 * v2, w2 * w2 * w2
    level = u6 * u2 + v6 * v2 + w6 * w2
    if level <= 1.0:
        return -math.inf
    gu, gv, gw = u6 * u / a[0], v6 * v / a[1], w6 * w / a[2]
    return edged_gauge_bound(level, gu * gu + gv * gv + gw * gw)


@compiled
def smooth_gauge(x: Vec3, a: Vec3, exponents: Vec3) -> float:
    """Lower bound of the distance of `x` from f = U^(1 / (2 p)) with the least exponent p [m].

    Minus infinity inside, and where a power would overflow.
    """
    least = min(exponents[0], exponents[1], exponents[2])
    level, steepness = 0.0, 0.0
    for k in range(3):
        w = abs(x[k]) / a[k]
        if w > 1.0 and 2.0 * exponents[k] * math.log(w) > TOO_STEEP:
            return -math.inf
        term = w ** (2.0 * exponents[k])
        level += term
        steepness += (exponents[k] * term / (w * a[k] + 1e-300)) ** 2
    if level <= 1.0:
        return -math.inf
    return least * (level - level ** (1.0 - 0.5 / least)) / math.sqrt(steepness)


@compiled
def ellipsoid_gauge(u: float, v: float, w: float, a: Vec3) -> float:
    """Lower bound of the distance from an ellipsoid from f = U^(1/2) [m]; minus infinity inside.

    At the point (u, v, w) in semi-axes.
    """
    level = u * u + v * v + w * w
    if level <= 1.0:
        return -math.inf
    gu, gv, gw = u / a[0], v / a[1], w / a[2]
    return (level - math.sqrt(level)) / math.sqrt(gu * gu + gv * gv + gw * gw)
