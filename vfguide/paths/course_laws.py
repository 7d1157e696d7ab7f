"""Course laws: the course over ground along the paper's field, a line or a circle.

Everything here is in the horizontal plane of the goal frame: x along the goal's course, y to its
right, courses measured from the goal's. The paper's field leads through the goal along circles
that are tangent to the x axis there. Within the two circles of the smallest flyable radius it turns
too tightly, and beyond the goal it leads far away: there the vehicle flies along a Dubins path
instead (`path_progress`).

Lines and circles are followed by the vector fields of D. R. Nelson, D. B. Barber, T. W. McLain and
R. W. Beard, Vector Field Path Following for Miniature Air Vehicles, 2007.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.state import FlightState
from vfguide.field.navigation import navigation_field, navigation_field_rate
from vfguide.geometry.angles import wrap
from vfguide.geometry.se2 import Pose, unrotated
from vfguide.kernels.compiled import compiled

CONVERGENCE_GAIN = 1.25
"""Gain from the distance beside a circle or line, in radii, to the tangent of the course angle
towards it, dimensionless: k of Beard and McLain (2012, chapter 10), whose value was chosen with
point-mass flights."""


class PlanarState(NamedTuple):
    """Position and ground velocity of the vehicle in the horizontal plane."""

    x: float
    """Position along the first axis, in the goal frame along the goal's course [m]."""
    y: float
    """Position along the second axis, to the right of the first [m]."""
    vx: float
    """Velocity along the first axis [m/s]."""
    vy: float
    """Velocity along the second axis [m/s]."""


@compiled
def planar_from(frame: Pose, at: PlanarState) -> PlanarState:
    """Position and velocity of the vehicle in the axes of a pose."""
    c, s = math.cos(frame.course), math.sin(frame.course)
    x, y = unrotated(at.x - frame.x, at.y - frame.y, c, s)
    vx, vy = unrotated(at.vx, at.vy, c, s)
    return PlanarState(x, y, vx, vy)


@compiled
def planar_of(state: FlightState) -> PlanarState:
    """Position and velocity of the vehicle in the horizontal plane, NED."""
    return PlanarState(state.p_n[0], state.p_n[1], state.v_n[0], state.v_n[1])


@compiled
def course_of(at: PlanarState) -> float:
    """Course over ground, clockwise from the first axis [rad]."""
    return math.atan2(at.vy, at.vx)


@compiled
def pose_at(at: PlanarState) -> Pose:
    """The pose of the vehicle along its course over ground."""
    return Pose(at.x, at.y, course_of(at))


@compiled
def speed_of(at: PlanarState) -> float:
    """Speed over ground [m/s]."""
    return math.hypot(at.vx, at.vy)


class Course(NamedTuple):
    """A wanted direction of flight over ground."""

    chi: float
    """Course, measured from the goal's, clockwise [rad]."""
    chi_rate: float
    """Its rate of change along the present ground velocity [rad/s]."""
    remaining: float
    """Length of the path to the goal [m]."""


@compiled
def field_course(at: PlanarState, core: float) -> Course:
    """Direction of the navigation field, eq_VF_xyz, restricted to the plane z = 0.

    Closer than `core` [m] before the goal the field is that of a line: there the course depends on
    y alone, so that it stays steady where the field's circles become small.
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
def line_course(at: PlanarState, line: Pose, width: float) -> Course:
    """Course onto the line through a pose along its course, chi = course - atan(k e / width).

    e is the distance to the right of the line [m], `width` the scale of the approach to it [m].
    """
    beside = planar_from(line, at)
    u, u_rate = CONVERGENCE_GAIN * beside.y / width, CONVERGENCE_GAIN * beside.vy / width
    return Course(wrap(line.course - math.atan(u)), -u_rate / (1.0 + u * u), math.inf)


@compiled
def loiter_course(at: PlanarState, side: float, radius: float) -> Course:
    """Course onto a circle around the origin that never turns more tightly than the circle.

    `side` is +1 for a circle to the right, -1 to the left; `radius` is in m.
    """
    distance = max(math.hypot(at.x, at.y), 1e-3)
    distance_rate = (at.x * at.vx + at.y * at.vy) / distance
    bearing = math.atan2(-at.y, -at.x)
    bearing_rate = (at.x * at.vy - at.y * at.vx) / (distance * distance)
    u = CONVERGENCE_GAIN * (distance - radius) / radius
    u_rate = CONVERGENCE_GAIN * distance_rate / radius
    chi = wrap(bearing - side * (0.5 * math.pi - math.atan(u)))
    return Course(chi, bearing_rate + side * u_rate / (1.0 + u * u), math.inf)
