"""All that must not be hit, as arrays, and how near a point is to each of it."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from vfguide.field.footprint import Band
from vfguide.field.near import distance_bound
from vfguide.field.obstacle import Rows, read_obstacle
from vfguide.field.shapes.cylinder import upright_distance
from vfguide.flight.outlines import BALL, COLUMNS, KEEP_OUT, Outlines
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3
from vfguide.safety.fence import Fences, fence_distance

AHEAD = 5.0
"""The search for ways takes traffic as large as it is known so much later [s]."""
MOVER_GROWTH = 0.1
"""Growth of the doubt where a moving obstacle is, as a part of its speed."""


class Intruder(NamedTuple):
    """Another aircraft: an upright cylinder that grows with the age of its report."""

    p_n: Vec3
    """At the time of the report, NED [m]."""
    v_n: Vec3
    """NED [m/s]."""
    time: float
    """Of the report, on the clock of the obstacles [s]."""
    radius: float
    half_height: float
    """Of the volume to keep out of [m]."""
    growth: float
    growth_up: float
    """Of radius and half height with the report's age [m/s]."""


class Hazards(NamedTuple):
    """Everything to keep clear of that is known."""

    obstacles: Rows
    """Of `obstacle_rows`, M rows."""
    traffic: Rows
    """(K, 11) of `traffic_rows`."""
    fences: Fences
    floor: float
    ceiling: float
    """Heights above the guidance frame's origin to stay between [m]; infinite for none."""


def traffic_rows(intruders: Sequence[Intruder]) -> Rows:
    """The intruders as an array (K, 11), its columns the fields in order."""
    rows = [(*a.p_n, *a.v_n, *a[2:]) for a in intruders]
    return np.array(rows, dtype=float).reshape(-1, 11)


@compiled
def hazard_count(hazards: Hazards) -> int:
    """How many there are: obstacles, zones of the fence, its heights as one, and traffic.

    Traffic comes and goes: it is last, so that the numbers of all others stay.
    """
    return len(hazards.obstacles) + len(hazards.traffic) + len(hazards.fences.zones) + 1


@compiled
def hazard_distance(hazards: Hazards, i: int, p_n: Vec3, t: float) -> float:
    """At most the distance of `p_n` (NED) from hazard `i` at time `t` [m], negative inside."""
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
    """Distance of `p_n` (NED) from the volume of intruder `i` at time `t` [m]."""
    age = t - traffic[i, 6]
    x = p_n[0] - traffic[i, 0] - age * traffic[i, 3]
    y = p_n[1] - traffic[i, 1] - age * traffic[i, 4]
    z = p_n[2] - traffic[i, 2] - age * traffic[i, 5]
    age = max(age, 0.0)
    radius = traffic[i, 7] + age * traffic[i, 9]
    return upright_distance(x, y, z, radius, traffic[i, 8] + age * traffic[i, 10])


@compiled
def traffic_outlines(traffic: Rows, band: Band, margin: float, t: float) -> Outlines:
    """What traffic covers of a band of heights that is wider by `margin` [m] on both sides.

    Moving circles for the search of ways, as large as the volumes `AHEAD` seconds after `t`.
    """
    table, used = np.zeros((len(traffic), COLUMNS)), 0
    for row in traffic:
        grown = max(t - row[6], 0.0) + AHEAD
        reach = row[8] + grown * row[10] + margin
        since, until = stay_in(band.top - reach - row[2], band.bottom + reach - row[2], row[5])
        if since > until:
            continue
        x, y = row[0] - row[6] * row[3], row[1] - row[6] * row[4]
        table[used, :BALL] = (KEEP_OUT, x, y, row[3], row[4], math.hypot(row[3], row[4]))
        radius = row[7] + grown * row[9]
        table[used, BALL:] = (radius, 0.0, 0.0, row[6] + since, row[6] + until, 1.0)
        used += 1
    return Outlines(table[:used], np.zeros((0, 5)))


@compiled
def stay_in(low: float, high: float, speed: float) -> tuple[float, float]:
    """From when until when speed * t is between two numbers; turned round: never."""
    if speed == 0.0:
        return (-math.inf, math.inf) if low <= 0.0 <= high else (math.inf, -math.inf)
    return min(low / speed, high / speed), max(low / speed, high / speed)


@compiled
def hazard_speed(hazards: Hazards, i: int) -> float:
    """How fast hazard `i` can come nearer to a point that stands still [m/s]."""
    if i < len(hazards.obstacles):
        return obstacle_speed(hazards.obstacles, i)
    i -= len(hazards.obstacles) + len(hazards.fences.zones) + 1
    if i >= 0:
        growth = math.hypot(hazards.traffic[i, 9], hazards.traffic[i, 10])
        return speed_in(hazards.traffic, i, 3) + growth
    return 0.0


@compiled
def hazard_growth(hazards: Hazards, i: int) -> float:
    """Growth of the doubt where hazard `i` is that is not in its distance [m/s]."""
    if i >= len(hazards.obstacles):
        return 0.0
    return MOVER_GROWTH * obstacle_speed(hazards.obstacles, i)


@compiled
def obstacle_speed(obstacles: Rows, i: int) -> float:
    """How fast row `i` moves [m/s]."""
    north, east, down = read_obstacle(obstacles[i]).v_n
    return math.sqrt(north**2 + east**2 + down**2)


@compiled
def speed_in(rows: Rows, i: int, k: int) -> float:
    """Length of the velocity that begins in column `k` of row `i` [m/s]."""
    return math.sqrt(rows[i, k] ** 2 + rows[i, k + 1] ** 2 + rows[i, k + 2] ** 2)
