"""The shortest path of bounded curvature to a pose: Dubins' six candidates.

Each has three pieces: two turns, and a straight or a third turn between them (L. E. Dubins, On
curves of minimal length with a constraint on average curvature, 1957; in the normalised form of
Shkel and Lumelsky, Classification of the Dubins set, 2001). Goal frame; lengths in turn radii.
"""

import math
from typing import NamedTuple

from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import reader, writer

FULL = 2.0 * math.pi
CLOSED = 0.1
"""A turn that lacks no more than this to a full circle is none: a step earlier it was [rad]."""

SHORT_LAST_TURN = 1.1
"""A last turn of less than this is short [rad]."""
SHORT_STRAIGHT = 1.0
"""A straight of less than this is short [turn radii]."""


class DubinsPath(NamedTuple):
    """A turn, a straight or a turn, and a turn."""

    first: float
    """Side of the first turn: +1 right, -1 left."""
    arc: float
    """Of the first turn [rad]."""
    middle: float
    """Side of the turn in the middle, 0 where it is straight."""
    reach: float
    """Of the middle segment [turn radii, or rad]."""
    last: float
    """Side of the last turn."""
    end: float
    """Arc of the last turn [rad]."""


read_dubins_path, write_dubins_path = reader(DubinsPath), writer(DubinsPath)


@compiled
def length_of(path: DubinsPath) -> float:
    """[turn radii]."""
    return path.arc + path.reach + path.end


@compiled
def turn_of(angle: float) -> float:
    """A turn by `angle` as 0 to a full circle [rad]."""
    turned = angle % FULL
    return 0.0 if turned > FULL - CLOSED else turned


@compiled
def same_turns(d: float, alpha: float, beta: float, side: float) -> DubinsPath:
    """Both turns to the same side; there always is one.

    Args:
        d: distance of the goal [turn radii].
        alpha: course, from the direction towards the goal [rad].
        beta: the goal's course, from the same direction [rad].
        side: of the first turn.
    """
    lever = side * (math.sin(alpha) - math.sin(beta))
    square = 2.0 + d * d - 2.0 * math.cos(alpha - beta) + 2.0 * d * lever
    line = math.atan2(side * (math.cos(beta) - math.cos(alpha)), d + lever)
    arc, end = turn_of(side * (line - alpha)), turn_of(side * (beta - line))
    return DubinsPath(side, arc, 0.0, math.sqrt(max(square, 0.0)), side, end)


@compiled
def opposite_turns(d: float, alpha: float, beta: float, side: float) -> DubinsPath:
    """The second turn to the other side; infinitely long where the circles overlap.

    Arguments of `same_turns`.
    """
    lever = side * (math.sin(alpha) + math.sin(beta))
    square = d * d - 2.0 + 2.0 * math.cos(alpha - beta) + 2.0 * d * lever
    if square < 0.0:
        return DubinsPath(side, 0.0, 0.0, math.inf, -side, 0.0)
    straight = math.sqrt(square)
    line = math.atan2(-side * (math.cos(alpha) + math.cos(beta)), d + lever)
    line -= math.atan2(-2.0 * side, straight)
    arc, end = turn_of(side * (line - alpha)), turn_of(side * (line - beta))
    return DubinsPath(side, arc, 0.0, straight, -side, end)


@compiled
def three_turns(d: float, alpha: float, beta: float, side: float) -> DubinsPath:
    """To one side, to the other by more than half a circle, and back; only close to the goal.

    Arguments of `same_turns`.
    """
    lever = side * (math.sin(alpha) - math.sin(beta))
    cosine = (6.0 - d * d + 2.0 * math.cos(alpha - beta) - 2.0 * d * lever) / 8.0
    if abs(cosine) > 1.0:
        return DubinsPath(side, 0.0, -side, math.inf, side, 0.0)
    middle = FULL - math.acos(cosine)
    turned = math.atan2(-side * (math.cos(alpha) - math.cos(beta)), d + lever)
    arc = turn_of(0.5 * middle - side * (alpha - turned))
    end = turn_of(side * (beta - alpha) - arc + middle)
    return DubinsPath(side, arc, -side, middle, side, end)


@compiled
def is_hasty(path: DubinsPath) -> bool:
    """Whether a short last turn follows at once on one to the other side: no time to settle."""
    swings = path.middle == -path.last
    crosses = path.middle == 0.0 and path.first == -path.last and path.reach < SHORT_STRAIGHT
    return path.end < SHORT_LAST_TURN and (swings or crosses)


@compiled
def shorter(path: DubinsPath, other: DubinsPath) -> DubinsPath:
    """The shorter of two Dubins paths."""
    return other if length_of(other) < length_of(path) else path


@compiled
def shortest_path(x: float, y: float, course: float, radius: float) -> DubinsPath:
    """The shortest Dubins path from (x, y) [m] and a course [rad] to the origin along x."""
    d, bearing = math.hypot(x, y) / radius, math.atan2(-y, -x)
    alpha, beta = course - bearing, -bearing
    path = same_turns(d, alpha, beta, 1.0)
    path = shorter(path, same_turns(d, alpha, beta, -1.0))
    for side in (1.0, -1.0):
        path = shorter(path, opposite_turns(d, alpha, beta, side))
        path = shorter(path, three_turns(d, alpha, beta, side))
    return path
