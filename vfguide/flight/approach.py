"""The plane of the approach: which way to fly over ground, and how far it still is.

Everything here is in the horizontal plane of the goal frame: x along the goal's course,
y to its right, courses measured from the goal's. The paper's field leads through the goal
along circles that are tangent to the x axis there; within the two circles of the smallest
flyable radius it turns too tightly, and beyond the goal it leads far away. There the
vehicle flies along the tangent onto one of those two circles instead.
"""

import math
from typing import NamedTuple

from vfguide.field.navigation import navigation_field, navigation_field_rate
from vfguide.geometry.angles import wrap
from vfguide.geometry.compiled import compiled

ROLL_IN = 0.5
"""Time that the aircraft takes to roll into a turn [s]."""
LINEAR = 0.03
"""Where the attraction to a circle is linear, in radii."""


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
def circle_course(at: Planar, side: float, radius: float) -> Course:
    """Tangent onto the goal circle of `side` (+1: a right-hand turn), then round it.

    The turn rate is that of the circle; it sets in on the last `ROLL_IN` of the tangent,
    since the roll takes that long.
    """
    dx, dy = -at.x, side * radius - at.y
    distance = max(math.hypot(dx, dy), 1e-3)
    tangent = math.sqrt(max(distance * distance - radius * radius, 0.0))
    speed = max(math.hypot(at.vx, at.vy), 1e-3)
    onset = max(0.0, 1.0 - tangent / (speed * ROLL_IN))
    chi = wrap(math.atan2(dy, dx) - side * (0.5 * math.pi - inward_angle(distance, radius)))
    arc = (-side * chi) % (2.0 * math.pi)
    along = max(0.0, at.vx * math.cos(chi) + at.vy * math.sin(chi))
    return Course(chi, side * onset * along / radius, tangent + radius * arc)


@compiled
def inward_angle(distance: float, radius: float) -> float:
    """Angle of the wanted course inward from the circle's own direction [rad].

    Outside it is that of the tangent, next to the circle linear: the tangent's has no bound
    on its slope there.
    """
    near = (1.0 + LINEAR) * radius
    if distance >= near:
        return math.acos(radius / distance)
    if distance >= radius:
        return math.acos(radius / near) * (distance - radius) / (near - radius)
    return max(-1.0, 2.0 * (distance - radius) / radius)


@compiled
def loiter_course(at: Planar, side: float, radius: float) -> Course:
    """Course round a circle about the origin: converges smoothly and never tighter than it."""
    distance = max(math.hypot(at.x, at.y), 1e-3)
    distance_rate = (at.x * at.vx + at.y * at.vy) / distance
    bearing = math.atan2(-at.y, -at.x)
    bearing_rate = (at.x * at.vy - at.y * at.vx) / (distance * distance)
    u = 1.25 * (distance - radius) / radius
    u_rate = 1.25 * distance_rate / radius
    chi = wrap(bearing - side * (0.5 * math.pi - math.atan(u)))
    return Course(chi, bearing_rate + side * u_rate / (1.0 + u * u), math.inf)
