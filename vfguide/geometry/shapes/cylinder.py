"""Upright cylinders with rounded edges: U = ((x^2 + y^2) / R^2)^4 + (2 z / h)^8."""

import math

from vfguide.geometry.polygon import prism_distance
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
from vfguide.geometry.shapes.rays import Array, Rays, upright_rays
from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled


def cylinder(radius: float, height: float) -> Shape:
    """Upright cylinder of a radius and a full height [m].

    Raises:
        ValueError: a size is not positive.
    """
    return checked(Kind.CYLINDER, (radius, radius, 0.5 * height), (EDGED, EDGED, EDGED))


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
def cylinder_section(shape: Shape, w: float) -> Section:
    """The section `w` half heights below the centre."""
    (a, b, _), (_, _, r) = shape.semi_axes, shape.exponents
    if w < -1.0 or w > 1.0:
        return Section(0.0, 0.0, 1.0, 1.0)
    left = 1.0 - abs(w) ** (2.0 * r)
    part = left ** (0.5 / EDGED)
    return Section(part * a, part * b, 1.0, 1.0)


def cylinder_rays(latitude: Array, longitude: Array) -> Rays:
    """Directions that end on the surface."""
    return upright_rays(latitude, longitude, EDGED)


@compiled
def cylinder_bound(x: float, y: float, z: float, radius: float, half_height: float) -> float:
    """Lower bound of the distance of (x, y, z), in the cylinder's axes, from U = 1 [m].

    It is negative inside.
    """
    sharp = upright_distance(x, y, z, radius, half_height)
    if sharp > FAR_FROM_EDGES * max(radius, half_height):
        return sharp
    return max(sharp, cylinder_gauge(x, y, z, radius, half_height))


@compiled
def upright_distance(x: float, y: float, z: float, radius: float, half_height: float) -> float:
    """Distance from the upright cylinder with sharp edges [m], negative inside."""
    return prism_distance(math.sqrt(x * x + y * y) - radius, abs(z) - half_height)


@compiled
def cylinder_gauge(x: float, y: float, z: float, radius: float, half_height: float) -> float:
    """Lower bound of the distance from f = U^(1/8), as in `shapes.base` [m].

    Minus infinity inside.
    """
    u, w = (x * x + y * y) / (radius * radius), z / half_height
    w2 = w * w
    u4, w8 = u * u * u * u, w2 * w2 * w2 * w2
    level = u4 + w8
    if level <= 1.0:
        return -math.inf
    gu, gw = u4 / (math.sqrt(u) * radius + 1e-300), w8 / (abs(w) * half_height + 1e-300)
    return edged_gauge_bound(level, gu * gu + gw * gw)
