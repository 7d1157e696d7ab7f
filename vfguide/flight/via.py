"""Via poses: where a way passes a hazard closely, along its border."""

import math

import numpy as np
from numpy.typing import NDArray

from vfguide.flight.clearance import clearance_at_rest
from vfguide.flight.hop_check import SHORTEST_STEP
from vfguide.flight.outlines import (
    BALL,
    CONVEX,
    COUNT,
    FIRST,
    SIGN,
    VX,
    VY,
    Outlines,
    X,
    Y,
)
from vfguide.flight.way import Pose, after_turn
from vfguide.geometry.compiled import compiled

BEARINGS = 16
"""Directions in which a way passes a hazard."""
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

Poses = NDArray[np.float64]
"""(N, 3): x, y [m], course [rad]."""


@compiled
def support(hazards: Outlines, i: int, nx: float, ny: float) -> tuple[float, float]:
    """The point of row `i` farthest along (nx, ny), about its place [m]."""
    row = hazards.table[i]
    if row[COUNT] == 0.0:
        return row[BALL] * nx, row[BALL] * ny
    first, most, best = int(row[FIRST]), -math.inf, 0
    for k in range(first, first + int(row[COUNT])):
        along = hazards.sides[k, 3] * nx + hazards.sides[k, 4] * ny
        if along > most:
            most, best = along, k
    return hazards.sides[best, 3], hazards.sides[best, 4]


@compiled
def checked(wanted: float) -> float:
    """Clearance that a check asks for where one is wanted [m]."""
    return wanted + 0.5 * SHORTEST_STEP * wanted


@compiled
def add_via(
    hazards: Outlines, vias: Poses, used: int, x: float, y: float, course: float, wanted: float
) -> int:
    """Adds a pose and the opposite one where they are clear of all that does not move.

    Returns how many there are.
    """
    if clearance_at_rest(hazards, x, y) < checked(wanted) or used + 2 > len(vias):
        return used
    vias[used] = (x, y, course)
    vias[used + 1] = (x, y, course + math.pi)
    return used + 2


@compiled
def round_convex(hazards: Outlines, i: int, t: float, wanted: float, vias: Poses, used: int) -> int:
    """Adds via poses round a convex hazard where it is at time `t`; returns how many there are.

    They touch its outline grown by the wanted clearance; round a circle to keep in, from inside.
    """
    row = hazards.table[i]
    apart = row[SIGN] * (checked(wanted) + AMPLE)
    for k in range(BEARINGS):
        bearing = 2.0 * math.pi * k / BEARINGS
        nx, ny = math.cos(bearing), math.sin(bearing)
        sx, sy = support(hazards, i, nx, ny)
        x = row[X] + t * row[VX] + sx + apart * nx
        y = row[Y] + t * row[VY] + sy + apart * ny
        used = add_via(hazards, vias, used, x, y, bearing + 0.5 * math.pi, wanted)
    return used


@compiled
def round_corners(hazards: Outlines, i: int, wanted: float, vias: Poses, used: int) -> int:
    """Adds via poses round the corners of a polygon that point at where one may be."""
    row = hazards.table[i]
    first, count = int(row[FIRST]), int(row[COUNT])
    corners = hazards.sides[first : first + count, 3:]
    apart = checked(wanted) + AMPLE
    for k in range(count):
        bx, by = corners[k] - corners[k - 1]
        ax, ay = corners[(k + 1) % count] - corners[k]
        if row[SIGN] * (bx * ay - by * ax) <= 0.0:
            continue
        bisector = outward(bx, by, ax, ay, row[SIGN])
        for j in range(FANNED):
            bearing = bisector + FAN * (2.0 * j / (FANNED - 1) - 1.0)
            x = row[X] + corners[k, 0] + apart * math.cos(bearing)
            y = row[Y] + corners[k, 1] + apart * math.sin(bearing)
            used = add_via(hazards, vias, used, x, y, bearing + 0.5 * math.pi, wanted)
    return used


@compiled
def outward(bx: float, by: float, ax: float, ay: float, sign: float) -> float:
    """Bearing away from the polygon at a corner between two sides (inwards for `KEEP_IN`)."""
    before, after = math.hypot(bx, by), math.hypot(ax, ay)
    tx, ty = bx / before + ax / after, by / before + ay / after
    return math.atan2(-sign * tx, sign * ty)


@compiled
def add_vias(hazards: Outlines, i: int, t: float, wanted: float, vias: Poses, used: int) -> int:
    """Adds via poses round row `i` where it is at time `t`; returns how many there are."""
    row = hazards.table[i]
    if row[COUNT] == 0.0 or row[CONVEX] == 1.0:
        return round_convex(hazards, i, t, wanted, vias, used)
    return round_corners(hazards, i, wanted, vias, used)


@compiled
def add_fan(end: Pose, ahead: float, radius: float, vias: Poses, used: int) -> int:
    """Adds poses that are reached by a straight and a turn from one of the ends.

    `ahead` is 1 for the start; for the goal it is -1, and they are those from which it is reached.
    Returns how many there are.
    """
    for run in STRAIGHTS:
        gone = ahead * run * radius
        x, y = end.x + gone * math.cos(end.course), end.y + gone * math.sin(end.course)
        for arc in ARCS:
            if used < len(vias):
                side, turned = math.copysign(1.0, arc), ahead * abs(arc)
                there = after_turn(Pose(x, y, end.course), side, turned, radius)
                vias[used] = (there.x, there.y, there.course)
                used += 1
    return used
