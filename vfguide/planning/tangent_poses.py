"""Tangent poses: where a route passes a hazard closely, along its border."""

import math

from vfguide.airspace.footprint import read_side
from vfguide.airspace.keep_out import KeepOutZone, KeepOutZones, read_zone_row
from vfguide.airspace.planar_clearance import clearance_at_rest
from vfguide.field.obstacle import Rows
from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import Table
from vfguide.paths.path_progress import Pose, after_turn, write_pose
from vfguide.planning.collision_check import SHORTEST_STEP

BEARINGS = 16
"""Directions in which a route passes a hazard."""
FANNED = 5
"""Directions in which it passes one corner of a fence."""
FAN = 0.45
"""Between the first of those and the bisector [rad]."""
AMPLE = 1.0
"""Beyond the clearance that a check asks for [m]."""
STRAIGHTS = 0.0, 1.0, 2.0
"""From the ends before turns [radii] ..."""
ARCS = 0.5 * math.pi, math.pi, -0.5 * math.pi, -math.pi
"""... of so much, positive to the right [rad]."""

Poses = Table
"""A `Pose` a row."""


@compiled
def support(outline: KeepOutZone, sides: Rows, nx: float, ny: float) -> tuple[float, float]:
    """The point of an outline farthest along (nx, ny), about its place [m]."""
    if outline.sides == 0:
        return outline.bounding_radius * nx, outline.bounding_radius * ny
    most, x, y = -math.inf, 0.0, 0.0
    for k in range(outline.first_side, outline.first_side + outline.sides):
        corner = read_side(sides[k])
        along = corner.x * nx + corner.y * ny
        if along > most:
            most, x, y = along, corner.x, corner.y
    return x, y


@compiled
def checked(wanted: float) -> float:
    """Clearance that a check asks for where one is wanted [m]."""
    return wanted + 0.5 * SHORTEST_STEP * wanted


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
    """Adds a pose and the opposite one where they are clear of all that does not move.

    Returns how many there are.
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
    """Adds tangent poses round a convex hazard where it is at time `t`; returns how many there are.

    They touch its outline grown by the wanted clearance; round a circle to keep in, from inside.
    """
    outline = read_zone_row(hazards.table[i])
    apart = outline.sign * (checked(wanted) + AMPLE)
    for k in range(BEARINGS):
        bearing = 2.0 * math.pi * k / BEARINGS
        nx, ny = math.cos(bearing), math.sin(bearing)
        sx, sy = support(outline, hazards.sides, nx, ny)
        x = outline.x + t * outline.vx + sx + apart * nx
        y = outline.y + t * outline.vy + sy + apart * ny
        used = add_tangent_pose(hazards, tangents, used, x, y, bearing + 0.5 * math.pi, wanted)
    return used


@compiled
def round_corners(hazards: KeepOutZones, i: int, wanted: float, tangents: Poses, used: int) -> int:
    """Adds tangent poses round the corners of a polygon that point at where one may be."""
    outline = read_zone_row(hazards.table[i])
    sides = hazards.sides[outline.first_side : outline.first_side + outline.sides]
    apart = checked(wanted) + AMPLE
    for k in range(len(sides)):
        corner, last = read_side(sides[k]), read_side(sides[k - 1])
        following = read_side(sides[(k + 1) % len(sides)])
        bx, by = corner.x - last.x, corner.y - last.y
        ax, ay = following.x - corner.x, following.y - corner.y
        if outline.sign * (bx * ay - by * ax) <= 0.0:
            continue
        bisector = outward(bx, by, ax, ay, outline.sign)
        for j in range(FANNED):
            bearing = bisector + FAN * (2.0 * j / (FANNED - 1) - 1.0)
            x = outline.x + corner.x + apart * math.cos(bearing)
            y = outline.y + corner.y + apart * math.sin(bearing)
            used = add_tangent_pose(hazards, tangents, used, x, y, bearing + 0.5 * math.pi, wanted)
    return used


@compiled
def outward(bx: float, by: float, ax: float, ay: float, sign: float) -> float:
    """Bearing away from the polygon at a corner between two sides (inwards for `KEEP_IN`)."""
    before, after = math.hypot(bx, by), math.hypot(ax, ay)
    tx, ty = bx / before + ax / after, by / before + ay / after
    return math.atan2(-sign * tx, sign * ty)


@compiled
def add_tangent_poses(
    hazards: KeepOutZones, i: int, t: float, wanted: float, tangents: Poses, used: int
) -> int:
    """Adds tangent poses round row `i` where it is at time `t`; returns how many there are."""
    outline = read_zone_row(hazards.table[i])
    if outline.sides == 0 or outline.is_convex:
        return round_convex(hazards, i, t, wanted, tangents, used)
    return round_corners(hazards, i, wanted, tangents, used)


@compiled
def add_fan(end: Pose, ahead: float, radius: float, tangents: Poses, used: int) -> int:
    """Adds poses that are reached by a straight and a turn from one of the ends.

    `ahead` is 1 for the start; for the goal it is -1, and they are those from which it is reached.
    Returns how many there are.
    """
    for run in STRAIGHTS:
        travelled = ahead * run * radius
        x, y = end.x + travelled * math.cos(end.course), end.y + travelled * math.sin(end.course)
        for arc in ARCS:
            if used < len(tangents):
                side, turned = math.copysign(1.0, arc), ahead * abs(arc)
                there = after_turn(Pose(x, y, end.course), side, turned, radius)
                write_pose(there, tangents[used])
                used += 1
    return used
