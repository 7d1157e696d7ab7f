"""SE(2): poses of the horizontal plane, and motions along straights and turns.

A pose is a frame too: its x axis lies along its course, its y axis to the right of it. Angles are
clockwise, as courses are where x is north and y is east.

J. Sola, J. Deray and D. Atchuthan, A micro Lie theory for state estimation in robotics, 2018:
composition and exponential map of SE(2).
"""

import math
from typing import NamedTuple

from vfguide.geometry.angles import wrap
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import reader, writer

Vec2 = tuple[float, float]
"""A vector of the plane."""


class Pose(NamedTuple):
    """A position and a course in the horizontal plane."""

    x: float
    """Position along the first axis [m]."""
    y: float
    """Position along the second axis, to the right of the first [m]."""
    course: float
    """Course, clockwise from the first axis [rad]."""


ORIGIN = Pose(0.0, 0.0, 0.0)
"""The pose of the axes themselves: position 0 [m], course 0 [rad]."""
read_pose, write_pose = reader(Pose), writer(Pose)


@compiled
def rotated(x: float, y: float, c: float, s: float) -> Vec2:
    """R (x, y), where R turns clockwise by the angle with cosine `c` and sine `s`.

    It takes components along the axes of a frame to those along the axes in which it is given.
    """
    return c * x - s * y, s * x + c * y


@compiled
def unrotated(x: float, y: float, c: float, s: float) -> Vec2:
    """R^T (x, y), the inverse of `rotated`: the components along the axes of a frame."""
    return c * x + s * y, c * y - s * x


@compiled
def composed(frame: Pose, pose: Pose) -> Pose:
    """T_nf T_fp: a pose given in the axes of `frame`, in the axes in which `frame` is given.

    Its course is the sum of both courses, not wrapped.
    """
    x, y = rotated(pose.x, pose.y, math.cos(frame.course), math.sin(frame.course))
    return Pose(frame.x + x, frame.y + y, frame.course + pose.course)


@compiled
def seen_from(frame: Pose, pose: Pose) -> Pose:
    """T_nf^-1 T_np: a pose in the axes of `frame`, its course between -pi and pi."""
    x, y = point_from(frame, pose.x, pose.y)
    return Pose(x, y, wrap(pose.course - frame.course))


@compiled
def point_from(frame: Pose, x: float, y: float) -> Vec2:
    """A point (x, y) in the axes of `frame` [m]."""
    c, s = math.cos(frame.course), math.sin(frame.course)
    return unrotated(x - frame.x, y - frame.y, c, s)


@compiled
def distance_between(one: Pose, other: Pose) -> float:
    """Distance of two positions [m]."""
    return math.hypot(one.x - other.x, one.y - other.y)


@compiled
def straight_on(begin: Pose, distance: float) -> Pose:
    """The pose after a straight of a length [m], backwards if it is negative."""
    x = begin.x + distance * math.cos(begin.course)
    return Pose(x, begin.y + distance * math.sin(begin.course), begin.course)


@compiled
def centre_beside(begin: Pose, side: float, radius: float) -> Vec2:
    """Centre of a turn from a pose [m]: `side` is +1 to the right, -1 to the left."""
    turn = side * radius
    return begin.x - turn * math.sin(begin.course), begin.y + turn * math.cos(begin.course)


@compiled
def after_turn(begin: Pose, side: float, arc: float, radius: float) -> Pose:
    """The pose after a turn by `arc` [rad] with a `radius` [m]; `side` as for `centre_beside`."""
    x, y = centre_beside(begin, side, radius)
    course, turn = begin.course + side * arc, side * radius
    return Pose(x + turn * math.sin(course), y - turn * math.cos(course), course)
