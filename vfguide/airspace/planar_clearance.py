"""How far places and flown paths are from the hazards."""

import math
from typing import NamedTuple

from vfguide.airspace.footprint import read_side
from vfguide.airspace.keep_out import KEEP_IN, KEEP_OUT, KeepOutZone, KeepOutZones, read_zone_row
from vfguide.field.obstacle import Rows
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
def polygon_distance(sides: Rows, x: float, y: float) -> float:
    """Distance of (x, y) from the border of any polygon [m], negative inside."""
    least, inside = math.inf, False
    side = read_side(sides[0])
    for k in range(len(sides) - 1, -1, -1):
        x0, y0 = side.x, side.y
        side = read_side(sides[k])
        x1, y1 = side.x, side.y
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
def sides_distance(sides: Rows, x: float, y: float) -> float:
    """The same of a convex polygon; off its corners less by up to what half their turn loses."""
    most = -math.inf
    for k in range(len(sides)):
        side = read_side(sides[k])
        most = max(most, side.nx * x + side.ny * y - side.distance)
    return most


@compiled
def zone_row_distance(
    outline: KeepOutZone, sides: Rows, x: float, y: float, t: float, enough: float
) -> float:
    """Distance of (x, y) from an outline at time `t` [m], negative where one may not be.

    Where it is more than `enough`, a lower bound of it that is more, too.
    """
    dx, dy = x - outline.x - t * outline.vx, y - outline.y - t * outline.vy
    beyond = math.hypot(dx, dy) - outline.bounding_radius
    if outline.sides == 0:
        return outline.sign * beyond
    if outline.sign == KEEP_OUT and beyond > enough:
        return beyond
    own = sides[outline.first_side : outline.first_side + outline.sides]
    if outline.is_convex:
        return outline.sign * sides_distance(own, dx, dy)
    return outline.sign * polygon_distance(own, dx, dy)


@compiled
def clearance_at(hazards: KeepOutZones, x: float, y: float, t: float) -> Nearest:
    """Distance of (x, y), NED [m], from the nearest hazard at time `t` [s]."""
    least, nearest = math.inf, NOTHING
    for i in range(len(hazards.table)):
        outline = read_zone_row(hazards.table[i])
        if t < outline.since or t > outline.until:
            continue
        distance = zone_row_distance(outline, hazards.sides, x, y, t, least)
        if distance < least:
            least, nearest = distance, i
    return Nearest(least, nearest)


@compiled
def clearance_at_rest(hazards: KeepOutZones, x: float, y: float) -> float:
    """Distance from the nearest hazard that does not move [m]."""
    least = math.inf
    for i in range(len(hazards.table)):
        outline = read_zone_row(hazards.table[i])
        if outline.speed == 0.0 and outline.since == -math.inf:
            least = min(least, zone_row_distance(outline, hazards.sides, x, y, 0.0, least))
    return least


@compiled
def near_hazards(hazards: KeepOutZones, x: float, y: float, reach: float) -> int:
    """Those that can be nearer than `reach` [m] to (x, y), a bit each; all that may move."""
    near = 0
    for i in range(min(len(hazards.table), BITS)):
        outline = read_zone_row(hazards.table[i])
        away = math.hypot(x - outline.x, y - outline.y) - outline.bounding_radius
        if away < reach or outline.speed > 0.0 or outline.sign == KEEP_IN:
            near |= 1 << i
    return near


@compiled
def free_path(
    hazards: KeepOutZones,
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
        outline = read_zone_row(hazards.table[i])
        if (i < BITS and (near >> i) & 1 == 0) or t > outline.until:
            continue
        closing = 1.0 + outline.speed / speed
        enough = least * closing + wanted
        distance = zone_row_distance(outline, hazards.sides, x, y, t, enough)
        free = (distance - wanted) / closing
        if t < outline.since:
            free = max(free, speed * (outline.since - t), step)
        if free < least:
            least, nearest = free, i
    return Nearest(least, nearest)
