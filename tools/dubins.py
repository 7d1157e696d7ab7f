"""Dubins' shortest path between two poses in the plane, with which approaches are compared.

L. E. Dubins, "On curves of minimal length with a constraint on average curvature", 1957; the six
words in the normalised form of Shkel and Lumelsky, 2001.
"""

import math
from collections.abc import Iterator

Pose = tuple[float, float, float]
"""Position north and east [m], and course [rad]."""
FULL = 2.0 * math.pi
ROUNDING = 1e-12
"""Largest amount by which a square may be negative by rounding and count as zero, dimensionless."""
CLOSED = 1e-6
"""Largest amount by which a turn may be short of a full circle, by rounding, and count as none
[rad]."""


def dubins_length(start: Pose, end: Pose, radius: float) -> float:
    """Length of the shortest path of curvature up to 1 / radius [m]."""
    north, east = end[0] - start[0], end[1] - start[1]
    d, bearing = math.hypot(north, east) / radius, math.atan2(east, north)
    return radius * min(words(d, start[2] - bearing, end[2] - bearing))


def words(d: float, alpha: float, beta: float) -> Iterator[float]:
    """Lengths of the words that exist [radii].

    `d` is the distance of the poses [radii]; `alpha` and `beta` are their courses relative to the
    bearing of the second pose from the first [rad].
    """
    ca, sa, cb, sb = math.cos(alpha), math.sin(alpha), math.cos(beta), math.sin(beta)
    cab = math.cos(alpha - beta)
    for side in (1.0, -1.0):  # the same turns at both ends
        along, across = d + side * (sa - sb), side * (cb - ca)
        middle = math.atan2(across, along)
        first, last = side * (middle - alpha), side * (beta - middle)
        yield turn(first) + math.hypot(along, across) + turn(last)
    for side in (1.0, -1.0):  # opposite turns
        square = d * (d + 2.0 * side * (sa + sb)) - (2.0 * math.sin(0.5 * (alpha - beta))) ** 2
        if square >= -ROUNDING:
            p = math.sqrt(max(square, 0.0))
            middle = math.atan2(-side * (ca + cb), d + side * (sa + sb))
            middle -= math.atan2(-2.0 * side, p)
            first, last = side * (middle - alpha), side * (middle - beta)
            yield turn(first) + p + turn(last)
    for side in (1.0, -1.0):  # three turns, the middle one the longer way
        cosine = (6.0 - d * d + 2.0 * cab + 2.0 * side * d * (sa - sb)) / 8.0
        if abs(cosine) <= 1.0:
            p = FULL - math.acos(cosine)
            turned = math.atan2(side * (ca - cb), d - side * (sa - sb))
            first = side * (alpha - turned) + 0.5 * p
            yield turn(first) + p + turn(side * (alpha - beta) - first + p)


def turn(angle: float) -> float:
    """The angle of a turn, from 0 to a full circle [rad]."""
    turned = angle % FULL
    return 0.0 if turned > FULL - CLOSED else turned
