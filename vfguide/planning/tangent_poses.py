"""Tangent poses: where a route passes a hazard closely, along its border."""

import math

from vfguide.airspace.footprint import read_side
from vfguide.airspace.keep_out import KeepOutZone, KeepOutZones, read_zone_row
from vfguide.airspace.planar_clearance import clearance_at_rest
from vfguide.field.obstacle import Rows
from vfguide.geometry.angles import FULL_TURN
from vfguide.geometry.se2 import Pose, after_turn, straight_on, write_pose
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Table
from vfguide.planning.collision_check import STEP_SHARE

BEARINGS = 16
"""Number of directions in which a route may pass a convex hazard; chosen."""
CORNER_BEARINGS = 5
"""Number of directions in which a route may pass a corner of a fence; chosen."""
CORNER_FAN = 0.45
"""Angle between the bisector of a corner of a fence and the outermost direction in which a route
may pass it [rad]; chosen."""
EXTRA_CLEARANCE = 1.0
"""Clearance of tangent poses beyond the one that the collision check asks for [m]; chosen."""
STRAIGHTS = 0.0, 1.0, 2.0
"""Lengths of straights between an end of the route and a turn of the fan [turn radii]; chosen."""
ARCS = 0.5 * math.pi, math.pi, -0.5 * math.pi, -math.pi
"""Angles of the turns of the fan, positive to the right [rad]; chosen."""

Poses = Table
"""A table with one `Pose` a row."""


@compiled
def support(zone: KeepOutZone, sides: Rows, nx: float, ny: float) -> tuple[float, float]:
    """The point of a zone farthest along (nx, ny), relative to its centre [m]."""
    if zone.sides == 0:
        return zone.bounding_radius * nx, zone.bounding_radius * ny
    most, x, y = -math.inf, 0.0, 0.0
    for k in range(zone.first_side, zone.first_side + zone.sides):
        corner = read_side(sides[k])
        along = corner.x * nx + corner.y * ny
        if along > most:
            most, x, y = along, corner.x, corner.y
    return x, y


@compiled
def checked(wanted: float) -> float:
    """Clearance that a point needs to pass the collision check for a clearance `wanted` [m]."""
    return wanted + 0.5 * STEP_SHARE * wanted


@compiled
def add_tangent_pose(
    hazards: KeepOutZones,
    tangents: Poses,
    used: int,
    x: float,
    y: float,
    course: float,
    wanted: float,
) -> int:
    """Adds the pose at (x, y) [m] on a course [rad], and the opposite one, where they are clear.

    They are where all hazards that do not move are farther than the clearance `wanted` [m], with
    the reserve of the collision check. Returns the number of poses.
    """
    if clearance_at_rest(hazards, x, y) < checked(wanted) or used + 2 > len(tangents):
        return used
    write_pose(Pose(x, y, course), tangents[used])
    write_pose(Pose(x, y, course + math.pi), tangents[used + 1])
    return used + 2


@compiled
def round_convex(
    hazards: KeepOutZones, i: int, t: float, wanted: float, tangents: Poses, used: int
) -> int:
    """Adds tangent poses around a convex hazard at its place of time `t` [s].

    They touch its zone, grown by the wanted clearance [m]; a circle to stay in, from inside.
    Returns the number of poses.
    """
    zone = read_zone_row(hazards.table[i])
    apart = zone.sign * (checked(wanted) + EXTRA_CLEARANCE)
    for k in range(BEARINGS):
        bearing = FULL_TURN * k / BEARINGS
        nx, ny = math.cos(bearing), math.sin(bearing)
        sx, sy = support(zone, hazards.sides, nx, ny)
        x = zone.x + t * zone.vx + sx + apart * nx
        y = zone.y + t * zone.vy + sy + apart * ny
        used = add_tangent_pose(hazards, tangents, used, x, y, bearing + 0.5 * math.pi, wanted)
    return used


@compiled
def round_corners(hazards: KeepOutZones, i: int, wanted: float, tangents: Poses, used: int) -> int:
    """Adds tangent poses around the corners of a polygon that point into the free space.

    Returns the number of poses.
    """
    zone = read_zone_row(hazards.table[i])
    sides = hazards.sides[zone.first_side : zone.first_side + zone.sides]
    apart = checked(wanted) + EXTRA_CLEARANCE
    for k in range(len(sides)):
        corner, last = read_side(sides[k]), read_side(sides[k - 1])
        following = read_side(sides[(k + 1) % len(sides)])
        bx, by = corner.x - last.x, corner.y - last.y
        ax, ay = following.x - corner.x, following.y - corner.y
        if zone.sign * (bx * ay - by * ax) <= 0.0:
            continue
        bisector = outward(bx, by, ax, ay, zone.sign)
        for j in range(CORNER_BEARINGS):
            bearing = bisector + CORNER_FAN * (2.0 * j / (CORNER_BEARINGS - 1) - 1.0)
            x = zone.x + corner.x + apart * math.cos(bearing)
            y = zone.y + corner.y + apart * math.sin(bearing)
            used = add_tangent_pose(hazards, tangents, used, x, y, bearing + 0.5 * math.pi, wanted)
    return used


@compiled
def outward(bx: float, by: float, ax: float, ay: float, sign: float) -> float:
    """Bearing [rad] away from a polygon along the bisector of a corner (inwards for `KEEP_IN`).

    (bx, by) is the side before the corner, (ax, ay) the one after it [m].
    """
    before, after = math.hypot(bx, by), math.hypot(ax, ay)
    tx, ty = bx / before + ax / after, by / before + ay / after
    return math.atan2(-sign * tx, sign * ty)


@compiled
def add_tangent_poses(
    hazards: KeepOutZones, i: int, t: float, wanted: float, tangents: Poses, used: int
) -> int:
    """Adds tangent poses around the zone of row `i` at time `t` [s]; returns their number."""
    zone = read_zone_row(hazards.table[i])
    if zone.sides == 0 or zone.is_convex:
        return round_convex(hazards, i, t, wanted, tangents, used)
    return round_corners(hazards, i, wanted, tangents, used)


@compiled
def add_fan(end: Pose, ahead: float, radius: float, tangents: Poses, used: int) -> int:
    """Adds poses that are joined to one of the ends by a straight and a turn.

    `ahead` is 1 for poses reached from the start, -1 for those from which the goal is reached.
    Returns the number of poses.
    """
    for run in STRAIGHTS:
        begin = straight_on(end, ahead * run * radius)
        for arc in ARCS:
            if used < len(tangents):
                side, turned = math.copysign(1.0, arc), ahead * abs(arc)
                write_pose(after_turn(begin, side, turned, radius), tangents[used])
                used += 1
    return used
