"""Distance of a point from the surface U = 1 of a shape.

The surface is convex. From outside, the nearest point is the only one whose tangent plane is
square to the line to it; from inside there can be several, and the descent starts on every side.
Newton's method on the surface, each step shortened until the distance falls; the tangent plane
bounds the error, because the body lies behind it. Positions are in the body's own axes [m].
"""

import math

from vfguide.geometry.shapes.base import Level, Shape
from vfguide.geometry.shapes.shape import shape_level
from vfguide.geometry.vector import Vec3, add, cross, dot, matvec, norm, scale, sub, unit
from vfguide.kernels.compiled import compiled

PRECISION = 1e-4
"""Ratio of the error to the distance from outside at which the iteration ends; chosen."""
AT_CENTRE = 1e-200
"""Distance from the centre, as a share of the size, below which a point counts as the centre;
chosen near the smallest float."""
MAX_ITERATIONS = 60
"""Largest number of Newton steps; chosen."""
LEAST_STEP_SHARE = 1e-4
"""Share of a Newton step below which it is not shortened further; chosen."""


@compiled
def signed_distance(shape: Shape, x: Vec3) -> float:
    """Distance of `x` from the surface [m], negative inside.

    Right to 1e-4 of itself from outside; from inside to 1e-3, or 1e-3 of the body's size.
    """
    if shape_level(shape, x).U >= 1.0:
        return distance_from(shape, x, onto_surface(shape, x))
    a, b, c = shape.semi_axes
    a, b, c = math.copysign(a, x[0]), math.copysign(b, x[1]), math.copysign(c, x[2])
    starts = (x, (a, 0.0, 0.0), (0.0, b, 0.0), (0.0, 0.0, c), (0.0, 0.0, -c), (a, b, c))
    least = math.inf
    for start in starts:
        least = min(least, distance_from(shape, x, onto_surface(shape, start)))
    return -least


@compiled
def distance_from(shape: Shape, x: Vec3, y: Vec3) -> float:
    """Least distance of `x` from the surface that a descent from its point `y` finds [m]."""
    distance = norm(sub(x, y))
    for _ in range(MAX_ITERATIONS):
        step, towards = newton_step(shape_level(shape, y), sub(x, y))
        if distance - abs(towards) <= PRECISION * distance:
            break
        y, nearer = nearer_point(shape, x, y, step)
        if nearer >= distance:
            break
        distance = nearer
    return distance


@compiled
def nearer_point(shape: Shape, x: Vec3, y: Vec3, step: Vec3) -> tuple[Vec3, float]:
    """The surface point that a step from `y` leads to, and its distance from `x` [m].

    The step is halved until the point is nearer to `x` than `y` is; if none is, `y` is returned.
    """
    distance = norm(sub(x, y))
    part = 1.0
    while part > LEAST_STEP_SHARE:
        z = onto_surface(shape, add(y, scale(part, step)))
        nearer = norm(sub(x, z))
        if nearer < distance:
            return z, nearer
        part *= 0.5
    return y, distance


@compiled
def newton_step(level: Level, r: Vec3) -> tuple[Vec3, float]:
    """Newton's step along the surface towards the point at `r` from here, and the part r.n of r.

    The Hessian of half the squared distance on the surface is I + (r.n) S, with S the surface's
    curvature; where it is not positive (from inside), the step is the gradient's.
    """
    slope = norm(level.gradient)
    n = scale(1.0 / slope, level.gradient)
    e1 = unit(perpendicular(n))
    e2 = cross(n, e1)
    towards, r1, r2 = dot(r, n), dot(r, e1), dot(r, e2)
    k = towards / slope
    s1, s2 = matvec(level.hessian, e1), matvec(level.hessian, e2)
    m11, m12, m22 = 1.0 + k * dot(s1, e1), k * dot(s1, e2), 1.0 + k * dot(s2, e2)
    determinant = m11 * m22 - m12 * m12
    if m11 > 0.0 and determinant > 1e-9 * m11 * m22:
        r1, r2 = (m22 * r1 - m12 * r2) / determinant, (m11 * r2 - m12 * r1) / determinant
    return add(scale(r1, e1), scale(r2, e2)), towards


@compiled
def perpendicular(n: Vec3) -> Vec3:
    """A vector perpendicular to `n`, not short."""
    x, y, z = n
    if abs(x) < abs(y):
        return (0.0, z, -y) if abs(x) < abs(z) else (y, -x, 0.0)
    return (z, 0.0, -x) if abs(y) < abs(z) else (y, -x, 0.0)


@compiled
def onto_surface(shape: Shape, y: Vec3) -> Vec3:
    """The point of the surface on the ray from the centre through `y`.

    Newton's method on log U over the logarithm of the scale, which is straight or nearly so.
    """
    a, b, c = shape.semi_axes
    size = max(abs(y[0] / a), abs(y[1] / b), abs(y[2] / c))
    if size <= AT_CENTRE:
        y, size = (a, 0.0, 0.0), 1.0
    y = scale(1.0 / size, y)
    for _ in range(MAX_ITERATIONS):
        level = shape_level(shape, y)
        step = -math.log(level.U) * level.U / dot(level.gradient, y)
        y = scale(math.exp(step), y)
        if abs(step) <= 1e-12:
            break
    return y
