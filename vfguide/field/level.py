"""Level functions U of the shapes: U = 1 on the surface, with gradient and Hessian.

All are convex, so that {U <= 1} is a convex body and U grows along every ray out of it. Points
and derivatives are in the body's own axes, its centre at the origin, z down [m].

A term |w|^(2p) above FAR goes on as its Taylor quadratic: still convex and twice differentiable,
and finite at any distance that has a meaning.
"""

import math
from typing import NamedTuple

from vfguide.field.shape import EDGED, Kind, Shape
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Mat3, Vec3

FAR = 1e100
"""A term of U is the power itself up to here."""
LOG_FAR = math.log(FAR)
TIP = 0.1
"""Roundness of a cone's apex: it lies TIP / 2 of the height below the sharp one."""


class Level(NamedTuple):
    """U at a point, and its derivatives there."""

    U: float
    gradient: Vec3
    """n of the paper (n_Upsilon) [1/m]."""
    hessian: Mat3
    """[1/m^2]."""


@compiled
def shape_level(shape: Shape, x: Vec3) -> Level:
    """U, its gradient and its Hessian at `x`."""
    a, b, c = shape.semi_axes
    w = (x[0] / a, x[1] / b, x[2] / c)
    if shape.kind == Kind.SUPERQUADRIC:
        level = superquadric_level(w, shape.exponents)
    elif shape.kind == Kind.CYLINDER:
        level = cylinder_level(w)
    else:
        level = cone_level(w)
    return stretched(level, (1.0 / a, 1.0 / b, 1.0 / c))


@compiled
def superquadric_level(w: Vec3, exponents: Vec3) -> Level:
    """U = sum |w_i|^(2 p_i), the paper's second example, at x_i = a_i w_i."""
    t0, d0, dd0 = even_power(w[0], exponents[0])
    t1, d1, dd1 = even_power(w[1], exponents[1])
    t2, d2, dd2 = even_power(w[2], exponents[2])
    hessian = ((dd0, 0.0, 0.0), (0.0, dd1, 0.0), (0.0, 0.0, dd2))
    return Level(t0 + t1 + t2, (d0, d1, d2), hessian)


@compiled
def cylinder_level(w: Vec3) -> Level:
    """U = (w_x^2 + w_y^2)^4 + w_z^8."""
    rho = math.hypot(w[0], w[1])
    t, d, dd = even_power(rho, EDGED)
    tz, dz, ddz = even_power(w[2], EDGED)
    if rho == 0.0:
        return Level(tz, (0.0, 0.0, dz), ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, ddz)))
    c, s, across = w[0] / rho, w[1] / rho, d / rho
    xx, xy, yy = dd * c * c + across * s * s, (dd - across) * c * s, dd * s * s + across * c * c
    hessian = ((xx, xy, 0.0), (xy, yy, 0.0), (0.0, 0.0, ddz))
    return Level(t + tz, (d * c, d * s, dz), hessian)


@compiled
def cone_level(w: Vec3) -> Level:
    """U = max(0, s - w_z)^8 + max(0, w_z)^8 with s^2 = 4 (w_x^2 + w_y^2) + TIP^2.

    At U = 1 the first term alone is the slant rho = R (1 + w_z) / 2, the second the base
    w_z = 1; the tip is a hyperboloid's, and the edge of the base is rounded as a cylinder's is:
    U^(1/8) is the sharp cone's within 10 % at the tip and 9 % at the edge.
    """
    s = math.sqrt(4.0 * (w[0] * w[0] + w[1] * w[1]) + TIP * TIP)
    t, d, dd = even_power(max(0.0, s - w[2]), EDGED)
    tz, dz, ddz = even_power(max(0.0, w[2]), EDGED)
    sx, sy, k = 4.0 * w[0] / s, 4.0 * w[1] / s, d / s
    xx = dd * sx * sx + k * (4.0 - sx * sx)
    xy = dd * sx * sy - k * sx * sy
    yy = dd * sy * sy + k * (4.0 - sy * sy)
    hessian = ((xx, xy, -dd * sx), (xy, yy, -dd * sy), (-dd * sx, -dd * sy, dd + ddz))
    return Level(t + tz, (d * sx, d * sy, dz - d), hessian)


@compiled
def even_power(w: float, p: float) -> Vec3:
    """|w|^(2p), p >= 1, and its first two derivatives; above FAR the Taylor quadratic."""
    s = w * w
    if s <= 1.0 or p * math.log(s) <= LOG_FAR:
        q = raised(s, p - 1.0)
        return (q * s, 2.0 * p * q * w, 2.0 * p * (2.0 * p - 1.0) * q)
    edge = math.copysign(FAR ** (0.5 / p), w)
    d, dd = 2.0 * p * FAR / edge, 2.0 * p * (2.0 * p - 1.0) * FAR / (edge * edge)
    step = w - edge
    return (FAR + (d + 0.5 * dd * step) * step, d + dd * step, dd)


@compiled
def raised(s: float, k: float) -> float:
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
