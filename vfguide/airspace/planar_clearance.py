"""Planar clearance: distances of points and flown paths from the keep-out zones."""

import math
from typing import NamedTuple

from vfguide.airspace.footprint import read_side
from vfguide.airspace.keep_out import KEEP_IN, KEEP_OUT, KeepOutZone, KeepOutZones, read_zone_row
from vfguide.field.obstacle import Rows
from vfguide.geometry.polygon import side_from, signed_root
from vfguide.kernels.compiled import compiled

NO_HAZARD = -1
"""Row number that stands for no hazard."""
MASK_BITS = 62
"""Number of hazards that have a bit in a mask of nearby hazards: the bits of an integer of 64 that
are safe to shift."""


class NearestHazard(NamedTuple):
    """The nearest hazard."""

    distance: float
    """Distance from it [m], negative inside."""
    hazard: int
    """Row of its zone, or `NO_HAZARD`."""


@compiled
def polygon_distance(sides: Rows, x: float, y: float) -> float:
    """Distance of (x, y) from the border of any polygon [m], negative inside."""
    least, inside = math.inf, False
    side = read_side(sides[0])
    for k in range(len(sides) - 1, -1, -1):
        x0, y0 = side.x, side.y
        side = read_side(sides[k])
        seen = side_from(x0, y0, side.x, side.y, x, y)
        least, inside = min(least, seen.square), inside != seen.crosses
    return signed_root(least, inside)


@compiled
def sides_distance(sides: Rows, x: float, y: float) -> float:
    """Lower bound of the distance of (x, y) from a convex polygon [m], negative inside.

    It is the distance from the farthest side, too small only where a corner is the nearest point.
    """
    most = -math.inf
    for k in range(len(sides)):
        side = read_side(sides[k])
        most = max(most, side.nx * x + side.ny * y - side.distance)
    return most


@compiled
def zone_row_distance(
    zone: KeepOutZone, sides: Rows, x: float, y: float, t: float, enough: float
) -> float:
    """Distance of (x, y) [m] from a zone at time `t` [s], negative where the zone is violated.

    Where the distance is more than `enough`, a lower bound of it may be returned that also is.
    """
    dx, dy = x - zone.x - t * zone.vx, y - zone.y - t * zone.vy
    beyond = math.hypot(dx, dy) - zone.bounding_radius
    if zone.sides == 0:
        return zone.sign * beyond
    if zone.sign == KEEP_OUT and beyond > enough:
        return beyond
    own = sides[zone.first_side : zone.first_side + zone.sides]
    if zone.is_convex:
        return zone.sign * sides_distance(own, dx, dy)
    return zone.sign * polygon_distance(own, dx, dy)


@compiled
def clearance_at(hazards: KeepOutZones, x: float, y: float, t: float) -> NearestHazard:
    """Distance of (x, y), NED [m], from the nearest hazard at time `t` [s]."""
    least, nearest = math.inf, NO_HAZARD
    for i in range(len(hazards.table)):
        zone = read_zone_row(hazards.table[i])
        if t < zone.since or t > zone.until:
            continue
        distance = zone_row_distance(zone, hazards.sides, x, y, t, least)
        if distance < least:
            least, nearest = distance, i
    return NearestHazard(least, nearest)


@compiled
def clearance_at_rest(hazards: KeepOutZones, x: float, y: float) -> float:
    """Distance of (x, y) from the nearest hazard that does not move [m], negative inside."""
    least = math.inf
    for i in range(len(hazards.table)):
        zone = read_zone_row(hazards.table[i])
        if zone.speed == 0.0 and zone.since == -math.inf:
            least = min(least, zone_row_distance(zone, hazards.sides, x, y, 0.0, least))
    return least


@compiled
def near_hazards(hazards: KeepOutZones, x: float, y: float, reach: float) -> int:
    """Mask of the hazards that can be nearer than `reach` [m] to (x, y), one bit each.

    Hazards that move and zones to stay in are always among them.
    """
    near = 0
    for i in range(min(len(hazards.table), MASK_BITS)):
        zone = read_zone_row(hazards.table[i])
        away = math.hypot(x - zone.x, y - zone.y) - zone.bounding_radius
        if away < reach or zone.speed > 0.0 or zone.sign == KEEP_IN:
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
) -> NearestHazard:
    """Length that can be flown from (x, y) before a hazard can be nearer than `wanted` [m].

    Negative where a hazard is nearer already. Zones are taken to approach while the path is flown.

    Args:
        hazards: the keep-out zones.
        near: mask of `near_hazards`; zones without a bit always count.
        x: north coordinate [m].
        y: east coordinate [m].
        t: time [s].
        wanted: clearance to keep [m].
        speed: speed over ground [m/s].
        step: least length that a zone leaves free before it begins to count [m].
    """
    least, nearest = math.inf, NO_HAZARD
    for i in range(len(hazards.table)):
        zone = read_zone_row(hazards.table[i])
        if (i < MASK_BITS and (near >> i) & 1 == 0) or t > zone.until:
            continue
        closing = 1.0 + zone.speed / speed
        enough = least * closing + wanted
        distance = zone_row_distance(zone, hazards.sides, x, y, t, enough)
        free = (distance - wanted) / closing
        if t < zone.since:
            free = max(free, speed * (zone.since - t), step)
        if free < least:
            least, nearest = free, i
    return NearestHazard(least, nearest)
