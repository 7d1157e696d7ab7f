"""The plane of the approach: which path to fly over ground, and how far it still is.

Everything here is in the horizontal plane of the goal frame: x along the goal's course,
y to its right, courses measured from the goal's. The paper's field leads through the goal
along circles that are tangent to the x axis there; within the two circles of the smallest
flyable radius it turns too tightly, and beyond the goal it leads far away. There the
vehicle flies along a path of turns and straights instead (`path_progress`).
"""

import math
from typing import NamedTuple

from vfguide.field.navigation import navigation_field, navigation_field_rate
from vfguide.geometry.angles import wrap
from vfguide.geometry.compiled import compiled

CONVERGENCE = 1.25
"""Slope of the course onto a circle or a line, per radius of distance from it."""


class Planar(NamedTuple):
    """Position [m] and ground velocity [m/s] in the horizontal plane of the goal frame."""

    x: float
    y: float
    vx: float
    vy: float


class Course(NamedTuple):
    """A wanted direction of flight over ground."""

    chi: float
    """Course, measured from the goal's, clockwise [rad]."""
    chi_rate: float
    """Its rate of change along the present ground velocity [rad/s]."""
    remaining: float
    """Length of the path to the goal [m]."""


@compiled
def field_course(at: Planar, core: float) -> Course:
    """Direction of the navigation field, eq_VF_xyz, restricted to the plane z = 0.

    Closer than `core` [m] before the goal the field is that of a line: the angle falls
    with y alone, so that the course stays calm where the field's circles become small.
    """
    p = (min(at.x, -core), at.y, 0.0)
    v = (at.vx if at.x < -core else 0.0, at.vy, 0.0)
    F = navigation_field(p)
    dF = navigation_field_rate(p, v)
    size = F[0] * F[0] + F[1] * F[1]
    return Course(
        math.atan2(F[1], F[0]),
        (F[0] * dF[1] - F[1] * dF[0]) / size,
        arc_to_goal(at.x, at.y) if at.x < 0.0 else -at.x,
    )


@compiled
def arc_to_goal(x: float, y: float) -> float:
    """Length of the field's circle from (x, y) to the goal [m]: eq_inte_curve_rhophitheta."""
    distance = math.hypot(x, y)
    angle = math.pi - abs(math.atan2(y, x))
    return distance if angle < 1e-6 else distance * angle / math.sin(angle)


@compiled
def line_course(at: Planar, p: tuple[float, float], course: float, width: float) -> Course:
    """Course onto the line through `p` [m] along `course` [rad], over about `width` [m]."""
    c, s = math.cos(course), math.sin(course)
    u = CONVERGENCE * (c * (at.y - p[1]) - s * (at.x - p[0])) / width
    u_rate = CONVERGENCE * (c * at.vy - s * at.vx) / width
    return Course(wrap(course - math.atan(u)), -u_rate / (1.0 + u * u), math.inf)


@compiled
def loiter_course(at: Planar, side: float, radius: float) -> Course:
    """Course round a circle about the origin: converges smoothly and never tighter than it."""
    distance = max(math.hypot(at.x, at.y), 1e-3)
    distance_rate = (at.x * at.vx + at.y * at.vy) / distance
    bearing = math.atan2(-at.y, -at.x)
    bearing_rate = (at.x * at.vy - at.y * at.vx) / (distance * distance)
    u = CONVERGENCE * (distance - radius) / radius
    u_rate = CONVERGENCE * distance_rate / radius
    chi = wrap(bearing - side * (0.5 * math.pi - math.atan(u)))
    return Course(chi, bearing_rate + side * u_rate / (1.0 + u * u), math.inf)
