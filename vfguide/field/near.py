"""Lower bounds of the distance from an obstacle, for what must be asked often and never wrongly.

Two bounds are good in different places, and the larger one is taken. Near the surface it is the
gauge's: f = U^(1/m), m twice the least exponent, is convex for every shape here (the norm of
convex functions), so nothing of the body is nearer than (f - 1) / |grad f|. Far away, and inside,
it is the sharp body in which the body lies: the box, the upright cylinder or the cone's frustum.
"""

import math

from vfguide.field.level import TIP
from vfguide.field.obstacle import Rows, read_obstacle
from vfguide.field.shape import EDGED, Kind
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3

BESIDE = 0.5
"""Beyond this part of the size the rounding of an edge is no longer looked at."""
TOO_STEEP = 300.0
"""Above this logarithm of the level only the box is asked: the powers would overflow."""


@compiled
def distance_bound(obstacles: Rows, i: int, p_n: Vec3, t: float) -> float:
    """At most the distance of `p_n` (NED) from the surface of row `i` at time `t` [m].

    Exact for spheres from outside, within a few per cent of the size for the other shapes, and
    tight at the surface from outside; negative inside, and there at most a size too low.
    """
    body = read_obstacle(obstacles[i])
    p_o, v_o, c, s = body.p_n, body.v_n, body.heading_cos, body.heading_sin
    x = p_n[0] - p_o[0] - t * v_o[0]
    y = p_n[1] - p_o[1] - t * v_o[1]
    z = p_n[2] - p_o[2] - t * v_o[2]
    x, y = c * x + s * y, c * y - s * x
    if body.kind == Kind.CYLINDER:
        return cylinder_bound(x, y, z, body.semi_axes[0], body.semi_axes[2])
    if body.kind == Kind.CONE:
        return cone_bound(x, y, z, body.semi_axes[0], body.semi_axes[2])
    return superquadric_bound((x, y, z), body.semi_axes, body.exponents)


@compiled
def superquadric_bound(x: Vec3, a: Vec3, exponents: Vec3) -> float:
    """At most the distance of `x` from a superquadric, in its axes [m]."""
    p, q, r = exponents
    if a[0] == a[1] == a[2] and p == q == r == 1.0:
        return math.sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) - a[0]
    sharp = box_distance(x[0], x[1], x[2], a)
    if p == q == r == EDGED:
        if sharp > BESIDE * max(a[0], a[1], a[2]):
            return sharp
        return max(sharp, edged_gauge(x[0] / a[0], x[1] / a[1], x[2] / a[2], a))
    if p == q == r == 1.0:
        return max(sharp, ellipsoid_gauge(x[0] / a[0], x[1] / a[1], x[2] / a[2], a))
    return max(sharp, smooth_gauge(x, a, exponents))


@compiled
def cylinder_bound(x: float, y: float, z: float, radius: float, half_height: float) -> float:
    """At most the distance from an upright cylinder of the level functions, in its axes [m]."""
    sharp = upright_distance(x, y, z, radius, half_height)
    if sharp > BESIDE * max(radius, half_height):
        return sharp
    return max(sharp, cylinder_gauge(x, y, z, radius, half_height))


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
def upright_distance(x: float, y: float, z: float, radius: float, half_height: float) -> float:
    """Distance from the upright cylinder with sharp edges [m], negative inside."""
    u, w = math.sqrt(x * x + y * y) - radius, abs(z) - half_height
    if max(u, w) <= 0.0:
        return max(u, w)
    u, w = max(u, 0.0), max(w, 0.0)
    return math.sqrt(u * u + w * w)


@compiled
def cone_bound(x: float, y: float, z: float, radius: float, half_height: float) -> float:
    """At most the distance from an upright cone of the level functions, in its axes [m]."""
    sharp = frustum_distance(x, y, z, radius, half_height)
    if sharp > BESIDE * max(radius, half_height):
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
def cylinder_gauge(x: float, y: float, z: float, radius: float, half_height: float) -> float:
    """The gauge's bound of a cylinder [m]; no bound inside: minus infinity."""
    u, w = (x * x + y * y) / (radius * radius), z / half_height
    w2 = w * w
    u4, w8 = u * u * u * u, w2 * w2 * w2 * w2
    level = u4 + w8
    if level <= 1.0:
        return -math.inf
    gu, gw = u4 / (math.sqrt(u) * radius + 1e-300), w8 / (abs(w) * half_height + 1e-300)
    return (level - eighth_root(level) ** 7) / math.sqrt(gu * gu + gw * gw)


@compiled
def cone_gauge(x: float, y: float, z: float, radius: float, half_height: float) -> float:
    """The gauge's bound of a cone [m]; minus infinity inside.

    U of `level.cone_level` is u^8 + w^8; u and w are convex and not negative.
    """
    rho, down = 2.0 * math.sqrt(x * x + y * y) / radius, z / half_height
    s = math.sqrt(rho * rho + TIP * TIP)
    u, w = max(0.0, s - down), max(0.0, down)
    u7, w7 = u * u * u * u * u * u * u, w * w * w * w * w * w * w
    level = u7 * u + w7 * w
    if level <= 1.0:
        return -math.inf
    g_rho, g_z = 2.0 * u7 * rho / (s * radius), (w7 - u7) / half_height
    return (level - eighth_root(level) ** 7) / math.sqrt(g_rho * g_rho + g_z * g_z)


@compiled
def edged_gauge(u: float, v: float, w: float, a: Vec3) -> float:
    """The gauge's bound of exponents 4 at (u, v, w) semi-axes [m]; minus infinity inside."""
    u2, v2, w2 = u * u, v * v, w * w
    u6, v6, w6 = u2 * u2 * u2, v2 * v2 * v2, w2 * w2 * w2
    level = u6 * u2 + v6 * v2 + w6 * w2
    if level <= 1.0:
        return -math.inf
    gu, gv, gw = u6 * u / a[0], v6 * v / a[1], w6 * w / a[2]
    return (level - eighth_root(level) ** 7) / math.sqrt(gu * gu + gv * gv + gw * gw)


@compiled
def eighth_root(level: float) -> float:
    """level^(1/8)."""
    return math.sqrt(math.sqrt(math.sqrt(level)))


@compiled
def smooth_gauge(x: Vec3, a: Vec3, exponents: Vec3) -> float:
    """The gauge's bound of any superquadric at `x` [m]; minus infinity inside."""
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
    """The gauge's bound of an ellipsoid [m]; minus infinity inside."""
    level = u * u + v * v + w * w
    if level <= 1.0:
        return -math.inf
    gu, gv, gw = u / a[0], v / a[1], w / a[2]
    return (level - math.sqrt(level)) / math.sqrt(gu * gu + gv * gv + gw * gw)
