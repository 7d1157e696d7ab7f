"""The shortest path of bounded curvature to a pose: Dubins' six candidates.

Each has three segments: two turns, and a straight or a third turn between them (CSC, CCC).

L. E. Dubins, On Curves of Minimal Length with a Constraint on Average Curvature, and with
Prescribed Initial and Terminal Positions and Tangents, 1957; the equations are in the normalised
form of A. M. Shkel and V. Lumelsky, Classification of the Dubins Set, 2001. Everything is in the
goal frame; lengths are in turn radii.
"""

import math
from typing import NamedTuple

from vfguide.geometry.angles import FULL_TURN
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import reader, writer

CLOSED_TURN = 0.1
"""Largest angle missing to a full circle at which a turn counts as none [rad]; chosen: it is a turn
that was complete a step earlier, and has been flown a little too far."""

SHORT_LAST_TURN = 1.1
"""Angle below which a last turn is too short for the course to settle [rad]; chosen."""
SHORT_STRAIGHT = 1.0
"""Length below which a straight is too short for the bank to settle [turn radii]; chosen."""


class DubinsPath(NamedTuple):
    """A turn, a straight or a turn, and a turn; sides are +1 right and -1 left."""

    first: float
    """Side of the first turn: +1 right, -1 left."""
    arc: float
    """Angle of the first turn [rad]."""
    middle: float
    """Side of the turn in the middle, 0 for a straight."""
    reach: float
    """Length of the middle segment [turn radii], which is the angle of a turn [rad]."""
    last: float
    """Side of the last turn."""
    end: float
    """Angle of the last turn [rad]."""


read_dubins_path, write_dubins_path = reader(DubinsPath), writer(DubinsPath)


@compiled
def length_of(path: DubinsPath) -> float:
    """Length of a Dubins path [turn radii]."""
    return path.arc + path.reach + path.end


@compiled
def turn_of(angle: float) -> float:
    """The angle of a turn between 0 and a full circle [rad]; 0 within CLOSED_TURN of a circle."""
    turned = angle % FULL_TURN
    return 0.0 if turned > FULL_TURN - CLOSED_TURN else turned


@compiled
def same_turns(d: float, alpha: float, beta: float, side: float) -> DubinsPath:
    """The path LSL or RSR, which always exists.

    Args:
        d: distance of the goal [turn radii].
        alpha: course at the start, measured from the direction towards the goal [rad].
        beta: course at the goal, measured from the same direction [rad].
        side: side of the first turn, +1 right, -1 left.
    """
    lever = side * (math.sin(alpha) - math.sin(beta))
    square = 2.0 + d * d - 2.0 * math.cos(alpha - beta) + 2.0 * d * lever
    line = math.atan2(side * (math.cos(beta) - math.cos(alpha)), d + lever)
    arc, end = turn_of(side * (line - alpha)), turn_of(side * (beta - line))
    return DubinsPath(side, arc, 0.0, math.sqrt(max(square, 0.0)), side, end)


@compiled
def opposite_turns(d: float, alpha: float, beta: float, side: float) -> DubinsPath:
    """The path LSR or RSL; infinitely long where the circles overlap.

    The arguments are those of `same_turns`.
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
    """The path LRL or RLR, the middle turn by more than half a circle; only close to the goal.

    Infinitely long where there is none. The arguments are those of `same_turns`.
    """
    lever = side * (math.sin(alpha) - math.sin(beta))
    cosine = (6.0 - d * d + 2.0 * math.cos(alpha - beta) - 2.0 * d * lever) / 8.0
    if abs(cosine) > 1.0:
        return DubinsPath(side, 0.0, -side, math.inf, side, 0.0)
    middle = FULL_TURN - math.acos(cosine)
    turned = math.atan2(-side * (math.cos(alpha) - math.cos(beta)), d + lever)
    arc = turn_of(0.5 * middle - side * (alpha - turned))
    end = turn_of(side * (beta - alpha) - arc + middle)
    return DubinsPath(side, arc, -side, middle, side, end)


@compiled
def is_hasty(path: DubinsPath) -> bool:
    """Whether a short last turn follows at once on one to the other side, too soon to settle."""
    swings = path.middle == -path.last
    crosses = path.middle == 0.0 and path.first == -path.last and path.reach < SHORT_STRAIGHT
    return path.end < SHORT_LAST_TURN and (swings or crosses)


@compiled
def shorter(path: DubinsPath, other: DubinsPath) -> DubinsPath:
    """The shorter of two Dubins paths."""
    return other if length_of(other) < length_of(path) else path


@compiled
def shortest_path(x: float, y: float, course: float, radius: float) -> DubinsPath:
    """The shortest Dubins path from (x, y) [m] and a course [rad] to the origin, course 0."""
    d, bearing = math.hypot(x, y) / radius, math.atan2(-y, -x)
    alpha, beta = course - bearing, -bearing
    path = same_turns(d, alpha, beta, 1.0)
    path = shorter(path, same_turns(d, alpha, beta, -1.0))
    for side in (1.0, -1.0):
        path = shorter(path, opposite_turns(d, alpha, beta, side))
        path = shorter(path, three_turns(d, alpha, beta, side))
    return path
