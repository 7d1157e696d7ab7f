"""What all shapes share: their record, and the terms that level functions are made of.

A level function U is 1 on the surface. All are convex, so that {U <= 1} is a convex body and U
grows along every ray out of it. Points and derivatives are in the body's own axes, its centre at
the origin, z down [m].

A term |w|^(2p) above FAR goes on as its Taylor quadratic: still convex and twice differentiable,
and finite at any distance that has a meaning.

The functions `..._gauge` bound the distance of a point x outside from below. For a convex f that is
1 on the surface, f(y) >= f(x) + grad f(x) . (y - x), so that the nearest point of the surface is at
least (f(x) - 1) / |grad f(x)| away (R. T. Rockafellar, Convex Analysis, 1970). They take
f = U^(1 / (2 p)), which is the gauge of the body or near it.
"""

import math
from enum import IntEnum
from typing import NamedTuple

from vfguide.geometry.vector import Mat3, Vec3
from vfguide.kernels.compiled import compiled

EDGED = 4.0
"""Exponent p of the powers |x|^(2p) in boxes, cylinders and cones; chosen: their edges are rounded
by 8 % of the size."""
FAR = 1e100
"""Largest value of a term of U that is computed as a power; chosen so that sums and products stay
finite."""
LOG_FAR = math.log(FAR)
"""Natural logarithm of the value `FAR`."""
FAR_FROM_EDGES = 0.5
"""Distance from the body with sharp edges, as a share of its largest semi-axis, beyond which the
lower bound of the distance neglects the rounding of the edges; chosen."""


class Kind(IntEnum):
    """Families of level functions."""

    SUPERQUADRIC = 0
    CYLINDER = 1
    CONE = 2


class Shape(NamedTuple):
    """A convex body about its own centre; what depends on its kind is in `shape`."""

    kind: int
    """A `Kind`."""
    semi_axes: Vec3
    """Half the size along each of the body's axes, z down [m]."""
    exponents: Vec3
    """p, q, r of a superquadric, at least 1; `EDGED` for a cylinder or a cone. Of every shape
    U >= |x_i / a_i|^(2 p_i) on each axis."""


class Level(NamedTuple):
    """U at a point, and its derivatives there."""

    U: float
    gradient: Vec3
    """n of the paper (n_Upsilon) [1/m]."""
    hessian: Mat3
    """[1/m^2]."""


class Section(NamedTuple):
    """A horizontal section in the body's axes: the sizes and exponents of a superquadric.

    Both sizes are zero where there is none.
    """

    a: float
    b: float
    """Half the size along x and y [m]."""
    p: float
    q: float
    """Exponents along x and y."""


def checked(kind: Kind, semi_axes: Vec3, exponents: Vec3) -> Shape:
    """The shape of these sizes, all of them floats.

    Raises:
        ValueError: a semi-axis is not positive, or an exponent is below 1, where the gradient or
            the Hessian does not exist on the axes.
    """
    if not all(0.0 < a < math.inf for a in semi_axes):
        raise ValueError(f"sizes of an obstacle must be positive, not {semi_axes}")
    if not all(1.0 <= p < math.inf for p in exponents):
        raise ValueError(f"exponents of a superquadric must be at least 1, not {exponents}")
    a, b, c = semi_axes
    p, q, r = exponents
    return Shape(int(kind), (float(a), float(b), float(c)), (float(p), float(q), float(r)))


@compiled
def even_power(w: float, p: float) -> Vec3:
    """|w|^(2p), p >= 1, and its first two derivatives; above FAR the Taylor quadratic."""
    s = w * w
    if s <= 1.0 or p * math.log(s) <= LOG_FAR:
        q = power_of(s, p - 1.0)
        return (q * s, 2.0 * p * q * w, 2.0 * p * (2.0 * p - 1.0) * q)
    edge = math.copysign(FAR ** (0.5 / p), w)
    d, dd = 2.0 * p * FAR / edge, 2.0 * p * (2.0 * p - 1.0) * FAR / (edge * edge)
    step = w - edge
    return (FAR + (d + 0.5 * dd * step) * step, d + dd * step, dd)


@compiled
def power_of(s: float, k: float) -> float:
    """s^k for s >= 0, the usual exponents without a logarithm."""
    if k == 0.0:
        return 1.0
    if k == EDGED - 1.0:
        return s * s * s
    return s**k


@compiled
def stretched(level: Level, k: Vec3) -> Level:
    """The level as a function of x, from that of w_i = k_i x_i."""
    (g0, g1, g2), (h0, h1, h2) = level.gradient, level.hessian
    return Level(
        level.U,
        (k[0] * g0, k[1] * g1, k[2] * g2),
        (
            (k[0] * k[0] * h0[0], k[0] * k[1] * h0[1], k[0] * k[2] * h0[2]),
            (k[1] * k[0] * h1[0], k[1] * k[1] * h1[1], k[1] * k[2] * h1[2]),
            (k[2] * k[0] * h2[0], k[2] * k[1] * h2[1], k[2] * k[2] * h2[2]),
        ),
    )


@compiled
def edged_gauge_bound(level: float, square: float) -> float:
    """The gauge's bound of the distance from a shape of eighth powers [m], from outside.

    f = U^(1/8) is convex, so that nothing of the body is nearer than (f - 1) / |grad f|. `square`
    is |grad U|^2 / 64 [1/m^2].
    """
    root = math.sqrt(math.sqrt(math.sqrt(level)))
    return (level - root**7) / math.sqrt(square)
