"""How far places and flown paths are from the hazards."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.flight.outlines import (
    BALL,
    CONVEX,
    COUNT,
    FIRST,
    SIGN,
    SINCE,
    SPEED,
    UNTIL,
    VX,
    VY,
    Outlines,
    X,
    Y,
)
from vfguide.geometry.compiled import compiled

NOTHING = -1
"""No hazard is near."""
BITS = 62
"""Of an integer, for a hazard each."""


class Nearest(NamedTuple):
    """What is nearest."""

    distance: float
    """[m], negative inside."""
    hazard: int
    """Its row, or `NOTHING`."""


@compiled
def polygon_distance(sides: NDArray[np.float64], x: float, y: float) -> float:
    """Distance of (x, y) from the border of any polygon [m], negative inside."""
    least, inside = math.inf, False
    x1, y1 = sides[0, 3], sides[0, 4]
    for k in range(len(sides) - 1, -1, -1):
        x0, y0 = x1, y1
        x1, y1 = sides[k, 3], sides[k, 4]
        ex, ey, dx, dy = x1 - x0, y1 - y0, x - x0, y - y0
        length = ex * ex + ey * ey
        part = (dx * ex + dy * ey) / length if length > 0.0 else 0.0
        part = max(0.0, min(1.0, part))
        ox, oy = dx - part * ex, dy - part * ey
        least = min(least, ox * ox + oy * oy)
        if (y0 > y) != (y1 > y) and (dx * ey - dy * ex) * ey < 0.0:
            inside = not inside
    return -math.sqrt(least) if inside else math.sqrt(least)


@compiled
def sides_distance(sides: NDArray[np.float64], x: float, y: float) -> float:
    """The same of a convex polygon; off its corners less by up to what half their turn loses."""
    most = -math.inf
    for k in range(len(sides)):
        most = max(most, sides[k, 0] * x + sides[k, 1] * y - sides[k, 2])
    return most


@compiled
def hazard_distance(
    hazards: Outlines, i: int, x: float, y: float, t: float, enough: float
) -> float:
    """Distance of (x, y) from the place of row `i` at time `t` [m], negative where one may not be.

    Where it is more than `enough`, a lower bound of it that is more, too.
    """
    row = hazards.table[i]
    dx, dy = x - row[X] - t * row[VX], y - row[Y] - t * row[VY]
    ball = math.hypot(dx, dy) - row[BALL]
    count = int(row[COUNT])
    if count == 0:
        return row[SIGN] * ball
    if row[SIGN] > 0.0 and ball > enough:
        return ball
    first = int(row[FIRST])
    sides = hazards.sides[first : first + count]
    if row[CONVEX] == 1.0:
        return row[SIGN] * sides_distance(sides, dx, dy)
    return row[SIGN] * polygon_distance(sides, dx, dy)


@compiled
def clearance_at(hazards: Outlines, x: float, y: float, t: float) -> Nearest:
    """Distance of (x, y), NED [m], from the nearest hazard at time `t` [s]."""
    least, nearest = math.inf, NOTHING
    for i in range(len(hazards.table)):
        if t < hazards.table[i, SINCE] or t > hazards.table[i, UNTIL]:
            continue
        distance = hazard_distance(hazards, i, x, y, t, least)
        if distance < least:
            least, nearest = distance, i
    return Nearest(least, nearest)


@compiled
def clearance_at_rest(hazards: Outlines, x: float, y: float) -> float:
    """Distance from the nearest hazard that does not move [m]."""
    least = math.inf
    for i in range(len(hazards.table)):
        if hazards.table[i, SPEED] == 0.0 and hazards.table[i, SINCE] == -math.inf:
            least = min(least, hazard_distance(hazards, i, x, y, 0.0, least))
    return least


@compiled
def near_hazards(hazards: Outlines, x: float, y: float, reach: float) -> int:
    """Those that can be nearer than `reach` [m] to (x, y), a bit each; all that may move."""
    near = 0
    for i in range(min(len(hazards.table), BITS)):
        row = hazards.table[i]
        away = math.hypot(x - row[X], y - row[Y]) - row[BALL]
        if away < reach or row[SPEED] > 0.0 or row[SIGN] < 0.0:
            near |= 1 << i
    return near


@compiled
def free_path(
    hazards: Outlines,
    near: int,
    x: float,
    y: float,
    t: float,
    wanted: float,
    speed: float,
    step: float,
) -> Nearest:
    """How far one may fly at `speed` [m/s] before a hazard can be nearer than `wanted` [m].

    Outlines come towards one while one flies. Negative where one is nearer. `near` are those that
    count, and all that have no bit. What is not there yet leaves at least a `step` [m].
    """
    least, nearest = math.inf, NOTHING
    for i in range(len(hazards.table)):
        row = hazards.table[i]
        if (i < BITS and (near >> i) & 1 == 0) or t > row[UNTIL]:
            continue
        closing = 1.0 + row[SPEED] / speed
        enough = least * closing + wanted
        free = (hazard_distance(hazards, i, x, y, t, enough) - wanted) / closing
        if t < row[SINCE]:
            free = max(free, speed * (row[SINCE] - t), step)
        if free < least:
            least, nearest = free, i
    return Nearest(least, nearest)
