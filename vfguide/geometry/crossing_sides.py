"""Whether the sides of a polygon cross, so that it has no inside that everybody agrees on."""

from collections.abc import Sequence
from itertools import combinations

Corner = tuple[float, float]
"""North and east [m]."""
CornerPair = tuple[Corner, Corner]
"""From one corner to the next."""


def crossing_sides(corners: Sequence[Corner]) -> tuple[int, int] | None:
    """The first two sides of a polygon that cross or touch, counted from 1; None: it has none.

    A side begins at the corner of its number. Corners that are repeated have no side.
    """
    around = zip(corners, [*corners[1:], *corners[:1]], strict=True)
    sides = [(number, side) for number, side in enumerate(around, 1) if side[0] != side[1]]
    pairs = combinations(sides, 2)
    return next(((i, j) for (i, one), (j, other) in pairs if _clash(one, other)), None)


def _clash(one: CornerPair, other: CornerPair) -> bool:
    """Whether two sides have more in common than a corner between them."""
    (a, b), (c, d) = one, other
    if b == c and d == a:
        return True
    if b == c:
        return _folds_back(a, b, d)
    if d == a:
        return _folds_back(c, d, b)
    return _meet(one, other)


def _side_of(side: CornerPair, p: Corner) -> float:
    """On which side of its line a point is, by the sign; 0: on it."""
    ((ax, ay), (bx, by)), (px, py) = side, p
    return (bx - ax) * (py - ay) - (by - ay) * (px - ax)


def _along(a: Corner, b: Corner, p: Corner) -> float:
    """(p - a) . (b - a) [m^2]."""
    (ax, ay), (bx, by), (px, py) = a, b, p
    return (px - ax) * (bx - ax) + (py - ay) * (by - ay)


def _folds_back(a: Corner, b: Corner, c: Corner) -> bool:
    """Whether the side from `b` to `c` leads back along the one from `a` to `b`."""
    return _side_of((a, b), c) == 0.0 and _along(b, a, c) > 0.0


def _on(side: CornerPair, p: Corner) -> bool:
    """Whether a point is on a side."""
    a, b = side
    return _side_of(side, p) == 0.0 and 0.0 <= _along(a, b, p) <= _along(a, b, b)


def _meet(one: CornerPair, other: CornerPair) -> bool:
    """Whether two sides have a point in common."""
    (a, b), (c, d) = one, other
    apart = _side_of(one, c) * _side_of(one, d) >= 0.0
    if not apart and _side_of(other, a) * _side_of(other, b) < 0.0:
        return True
    return _on(one, c) or _on(one, d) or _on(other, a) or _on(other, b)
