"""All hazards as arrays, and the distance of a point from each of them.

Hazards are numbered: obstacles, zones of the fence, floor and ceiling together, traffic.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from vfguide.airspace.distance_bound import distance_bound
from vfguide.airspace.fence import Fences, fence_distance
from vfguide.airspace.footprint import SIDE_WIDTH, Band, times_in
from vfguide.airspace.keep_out import (
    KEEP_OUT,
    ZONE_ROW_WIDTH,
    KeepOutZone,
    KeepOutZones,
    write_zone_row,
)
from vfguide.field.obstacle import Rows, read_obstacle
from vfguide.geometry.shapes.cylinder import upright_distance
from vfguide.geometry.vector import Vec3, norm, scale, sub
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import reader, table_of, width

TRAFFIC_LOOKAHEAD = 5.0
"""Time by which the route search grows the volumes of traffic beyond the present [s]; chosen."""
MOVER_UNCERTAINTY = 0.1
"""Growth of the position uncertainty of a moving obstacle, as a ratio to its speed; chosen."""


class Intruder(NamedTuple):
    """Another aircraft: an upright cylinder that grows with the age of its report."""

    p_n: Vec3
    """Position at the time of the report, NED [m]."""
    v_n: Vec3
    """Velocity, NED [m/s]."""
    time: float
    """Time of the report on the clock of the obstacles [s]."""
    radius: float
    """Radius of the volume to keep out of [m]."""
    half_height: float
    """Half height of that volume [m]."""
    uncertainty_rate: float
    """Growth of the radius with the age of the report [m/s]."""
    uncertainty_rate_up: float
    """Growth of the half height with the age of the report [m/s]."""


INTRUDER_WIDTH = width(Intruder)
"""Number of floats in the row of an `Intruder`."""
read_intruder = reader(Intruder)


class Hazards(NamedTuple):
    """Everything known that must be kept clear of."""

    obstacles: Rows
    """Table of `obstacle_rows`, M rows."""
    traffic: Rows
    """One `Intruder` a row."""
    fences: Fences
    """Zones of the geofence."""
    floor: float
    """Least height above the guidance frame's origin [m], minus infinity for none."""
    ceiling: float
    """Greatest height above the guidance frame's origin [m], infinite for none."""


def traffic_rows(intruders: Sequence[Intruder]) -> Rows:
    """The intruders as a table, one `Intruder` a row."""
    return table_of(Intruder, intruders)


@compiled
def hazard_count(hazards: Hazards) -> int:
    """Number of hazards: obstacles, zones of the fence, its heights as one, and traffic.

    Traffic comes last, because it comes and goes: so the numbers of all others stay.
    """
    return len(hazards.obstacles) + len(hazards.traffic) + len(hazards.fences.zones) + 1


@compiled
def hazard_distance(hazards: Hazards, i: int, p_n: Vec3, t: float) -> float:
    """Lower bound of the distance of `p_n` (NED) from hazard `i` at `t` [m], negative inside."""
    if i < len(hazards.obstacles):
        return distance_bound(hazards.obstacles, i, p_n, t)
    i -= len(hazards.obstacles)
    zones = len(hazards.fences.zones)
    if i < zones:
        return fence_distance(hazards.fences, i, p_n)
    if i == zones:
        return min(-p_n[2] - hazards.floor, hazards.ceiling + p_n[2])
    return traffic_distance(hazards.traffic, i - zones - 1, p_n, t)


@compiled
def traffic_distance(traffic: Rows, i: int, p_n: Vec3, t: float) -> float:
    """Distance of `p_n` (NED) [m] from the volume of intruder `i` at time `t` [s], in [m]."""
    intruder = read_intruder(traffic[i])
    age = t - intruder.time
    x, y, z = sub(sub(p_n, intruder.p_n), scale(age, intruder.v_n))
    age = max(age, 0.0)
    radius = intruder.radius + age * intruder.uncertainty_rate
    return upright_distance(
        x, y, z, radius, intruder.half_height + age * intruder.uncertainty_rate_up
    )


@compiled
def traffic_zones(traffic: Rows, band: Band, margin: float, t: float) -> KeepOutZones:
    """Keep-out zones of traffic in a band of heights, widened by `margin` [m] on both sides.

    They are moving circles for the route search, as large as the volumes will be
    `TRAFFIC_LOOKAHEAD` after `t` [s].
    """
    table, used = np.zeros((len(traffic), ZONE_ROW_WIDTH)), 0
    for row in traffic:
        zone = traffic_zone(read_intruder(row), band, margin, t)
        if zone.since <= zone.until:
            write_zone_row(zone, table[used])
            used += 1
    return KeepOutZones(table[:used], np.zeros((0, SIDE_WIDTH)))


@compiled
def traffic_zone(intruder: Intruder, band: Band, margin: float, t: float) -> KeepOutZone:
    """The keep-out zone of one intruder; it ends before it begins if the band is never reached.

    Args:
        intruder: its last report.
        band: heights of the route, as z of NED [m].
        margin: height by which the band is widened on both sides [m].
        t: present time on the clock of the obstacles [s].
    """
    (north, east, down), (vx, vy, sinking), time = intruder.p_n, intruder.v_n, intruder.time
    grown = max(t - time, 0.0) + TRAFFIC_LOOKAHEAD
    reach = intruder.half_height + grown * intruder.uncertainty_rate_up + margin
    since, until = times_in(band, down, reach, sinking)
    x, y, radius = (
        north - time * vx,
        east - time * vy,
        intruder.radius + grown * intruder.uncertainty_rate,
    )
    place = (KEEP_OUT, x, y, vx, vy, math.hypot(vx, vy))
    return KeepOutZone(*place, radius, 0, 0, time + since, time + until, True)


@compiled
def hazard_velocity(hazards: Hazards, i: int) -> Vec3:
    """Velocity of hazard `i`, NED [m/s]."""
    if i < len(hazards.obstacles):
        return read_obstacle(hazards.obstacles[i]).v_n
    i -= len(hazards.obstacles) + len(hazards.fences.zones) + 1
    if i >= 0:
        return read_intruder(hazards.traffic[i]).v_n
    return 0.0, 0.0, 0.0


@compiled
def hazard_speed(hazards: Hazards, i: int) -> float:
    """Largest closing speed of hazard `i` towards a fixed point [m/s]."""
    if i < len(hazards.obstacles):
        return obstacle_speed(hazards.obstacles, i)
    i -= len(hazards.obstacles) + len(hazards.fences.zones) + 1
    if i >= 0:
        return intruder_speed(read_intruder(hazards.traffic[i]))
    return 0.0


@compiled
def intruder_speed(intruder: Intruder) -> float:
    """Largest closing speed of the volume of an intruder towards a fixed point [m/s]."""
    uncertainty_rate = math.hypot(intruder.uncertainty_rate, intruder.uncertainty_rate_up)
    return norm(intruder.v_n) + uncertainty_rate


@compiled
def hazard_uncertainty_rate(hazards: Hazards, i: int) -> float:
    """Growth of the position uncertainty of hazard `i` that its distance does not contain [m/s]."""
    if i >= len(hazards.obstacles):
        return 0.0
    return MOVER_UNCERTAINTY * obstacle_speed(hazards.obstacles, i)


@compiled
def obstacle_speed(obstacles: Rows, i: int) -> float:
    """Speed of the obstacle of row `i` [m/s]."""
    return norm(read_obstacle(obstacles[i]).v_n)
