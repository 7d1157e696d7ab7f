"""Longer paths, where the shortest one is too short for the height.

The length of the shortest path leaps where another Dubins path becomes the shortest, by up to a
circle. Therefore several ways of making it longer are tried, and the one that ends up shortest is
taken.
"""

import math

from vfguide.geometry.compiled import compiled
from vfguide.paths.course_laws import Planar
from vfguide.paths.dubins import length_of, shortest_path
from vfguide.paths.path_progress import Pose, after_turn

TURNS = 4
TURN = 0.55
"""So many turns to either side are tried, each by so much more [rad]."""
STRIDE = 0.1
"""Lengths of straights are tried in steps of this, in radii, ..."""
STRIDES = 100
"""... no more of them than this."""
SHORTER = 0.01
"""A later path is taken only where it is shorter by this, in radii: rounding decides nothing."""
LENGTH_SLACK = 0.3
"""A path that flies on first has to lead on even where so much more path is needed, in radii: what
is missed by a little does not leap then."""


@compiled
def best_end(at: Planar, radius: float, distance_for_altitude: float) -> tuple[float, float]:
    """How much longer to make the straight end, and the length of the path with it [m].

    The length is infinite where no end is long enough, as straight behind the goal.

    Args:
        at: the vehicle, the origin where the straight end begins.
        radius: of the turns [m].
        distance_for_altitude: least length of the path to the origin [m].
    """
    course = math.atan2(at.vy, at.vx)
    for k in range(STRIDES):
        farther = STRIDE * radius * k
        path = shortest_path(at.x + farther, at.y, course, radius)
        length = farther + radius * length_of(path)
        if length >= distance_for_altitude:
            return farther, length
    return 0.0, math.inf


@compiled
def best_outbound(at: Planar, radius: float, distance_for_altitude: float) -> tuple[float, float]:
    """The course to fly on before the path begins [rad], and the length of the path then [m].

    Arguments of `best_end`.
    """
    begin = Pose(at.x, at.y, math.atan2(at.vy, at.vx))
    best, shortest, least = begin.course, math.inf, math.inf
    for k in range(2 * TURNS + 1):
        turn = TURN * ((k + 1) // 2)
        pose = after_turn(begin, 1.0 if k % 2 == 1 else -1.0, turn, radius)
        arc = radius * turn
        with_slack = arc + outbound_length(
            pose, radius, distance_for_altitude + LENGTH_SLACK * radius - arc
        )
        if with_slack < least - SHORTER * radius:
            best, least = pose.course, with_slack
            shortest = arc + outbound_length(pose, radius, distance_for_altitude - arc)
    return best, shortest


@compiled
def outbound_length(begin: Pose, radius: float, distance_for_altitude: float) -> float:
    """Length of a straight and the shortest path behind it that first is as long as needed [m].

    Infinite where none is, as far away towards the origin.
    """
    c, s = math.cos(begin.course), math.sin(begin.course)
    for k in range(STRIDES):
        straight = STRIDE * radius * k
        x, y = begin.x + straight * c, begin.y + straight * s
        length = straight + radius * length_of(shortest_path(x, y, begin.course, radius))
        if length >= distance_for_altitude:
            return length
    return math.inf
