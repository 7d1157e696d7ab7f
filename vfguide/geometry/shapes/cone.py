"""Upright cones, apex up, with a blunt tip and a rounded edge; the centre is at half the height."""

import math

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

TIP = 0.1
"""Roundness of the apex of a cone, dimensionless: the apex lies TIP / 2 of the height below the
sharp one; chosen."""
WIDEST_CONE = 0.5 ** (0.5 / EDGED)
"""Height of the widest section of a cone below its centre [half heights]."""


def cone(radius: float, height: float) -> Shape:
    """Upright cone of the radius of its base and its full height [m].

    Raises:
        ValueError: a size is not positive.
    """
    return checked(Kind.CONE, (radius, radius, 0.5 * height), (EDGED, EDGED, EDGED))


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
def cone_section(shape: Shape, w: float) -> Section:
    """The section `w` half heights below the centre."""
    a, b, _ = shape.semi_axes
    if w < TIP - 1.0 or w > 1.0:
        return Section(0.0, 0.0, 1.0, 1.0)
    s = w + (1.0 - max(0.0, w) ** (2.0 * EDGED)) ** (0.5 / EDGED)
    part = 0.5 * math.sqrt(max(s * s - TIP * TIP, 0.0))
    return Section(part * a, part * b, 1.0, 1.0)


def cone_rays(latitude: Array, longitude: Array) -> Rays:
    """Directions that crowd at the edge of the base, half as much as those of a cylinder."""
    return upright_rays(latitude, longitude, 0.5 * EDGED)


@compiled
def cone_bound(x: float, y: float, z: float, radius: float, half_height: float) -> float:
    """Lower bound of the distance of (x, y, z), in the cone's axes, from U = 1 [m].

    It is negative inside. `radius` is that of the base [m].
    """
    sharp = frustum_distance(x, y, z, radius, half_height)
    if sharp > FAR_FROM_EDGES * max(radius, half_height):
        return sharp
    return max(sharp, cone_gauge(x, y, z, radius, half_height))


@compiled
def frustum_distance(x: float, y: float, z: float, radius: float, half_height: float) -> float:
    """Distance from the cone with a sharp edge, cut off where the blunt one ends [m].

    Negative inside.
    """
    top, top_radius = (TIP - 1.0) * half_height, 0.5 * TIP * radius
    dr, dz = radius - top_radius, half_height - top
    rho, down = math.sqrt(x * x + y * y), z - top
    part = ((rho - top_radius) * dr + down * dz) / (dr * dr + dz * dz)
    part = max(0.0, min(1.0, part))
    u, w = rho - top_radius - part * dr, down - part * dz
    over = max(-down, down - dz)
    past = max(0.0, rho - (radius if 2.0 * down > dz else top_radius))
    distance = math.sqrt(min(u * u + w * w, past * past + over * over))
    return -distance if over <= 0.0 and u <= 0.0 else distance


@compiled
def cone_gauge(x: float, y: float, z: float, radius: float, half_height: float) -> float:
    """Lower bound of the distance from f = U^(1/8), as in `shapes.base` [m].

    f is convex, since U of `cone_level` is u^8 + w^8 with u and w convex and not negative. Minus
    infinity inside.
    """
    rho, down = 2.0 * math.sqrt(x * x + y * y) / radius, z / half_height
    s = math.sqrt(rho * rho + TIP * TIP)
    u, w = max(0.0, s - down), max(0.0, down)
    u7, w7 = u * u * u * u * u * u * u, w * w * w * w * w * w * w
    level = u7 * u + w7 * w
    if level <= 1.0:
        return -math.inf
    g_rho, g_z = 2.0 * u7 * rho / (s * radius), (w7 - u7) / half_height
    return edged_gauge_bound(level, g_rho * g_rho + g_z * g_z)
