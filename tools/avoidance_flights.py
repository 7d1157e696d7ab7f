"""Flights of a point mass through a world by the worst command there is: straight to the goal."""

import math
from typing import NamedTuple

import numpy as np
from avoidance_worlds import TICK, Turning, World

from vfguide.aircraft.point_mass import Dynamics, PointMass, advance
from vfguide.airspace.distance_bound import distance_bound
from vfguide.airspace.fence import fence_distance
from vfguide.airspace.hazards import INTRUDER_WIDTH, Hazards
from vfguide.assurance.decision import (
    Assurance,
    BackupManoeuvre,
    Decision,
    Reason,
    assure,
    no_backup,
)
from vfguide.field.obstacle import (
    PlacedObstacle,
    Rows,
    obstacle_distance,
    read_obstacle,
    write_obstacle,
)
from vfguide.geometry.angles import wrap
from vfguide.geometry.shapes.cylinder import upright_distance
from vfguide.geometry.units import G0
from vfguide.geometry.vector import Vec3, add, scale, sub
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Row, reader, replacing, width, writer

read_turning = reader(Turning)
with_motion = replacing(PlacedObstacle, "p_n", "v_n")
ROLLING = 1.15
"""Ratio of the lags of the aircraft that is flown to those that the assurance believes; chosen."""
REACHED = 60.0
"""Distance from the goal at which the aircraft turns back to the start, and again [m]; chosen."""


class Logged(NamedTuple):
    """What was decided at one tick, and of what."""

    time: float
    """Time since the start [s]."""
    motion: PointMass
    command: tuple[float, float]
    """Bank and path angle [rad]."""
    backup: BackupManoeuvre
    """What the decision before stored."""
    decision: Decision
    distance: float
    """Distance from the nearest surface [m], as of `true_distance`."""
    nearest: int
    """Number of that surface, as of `true_distance`."""
    known: int
    """Number of obstacles that were known."""


LOGGED_WIDTH = width(Logged)
"""Number of floats in the row of a `Logged`."""
read_logged, write_logged = reader(Logged), writer(Logged)


class Flown(NamedTuple):
    """The result of one flight."""

    least: float
    """Least distance from any surface [m]; negative if one was entered."""
    when: float
    """Time of the least distance [s]."""
    hazard: int
    """Number of the surface at the least distance, as of `true_distance`."""
    escapes: int
    """Number of ticks on which guidance was not followed."""
    best_effort: int
    """Number of ticks on which nothing was clear."""
    first_bad: float
    """Time of the first tick on which nothing was clear [s]; infinite: there was none."""
    unclear_start: bool
    """Whether nothing was clear at the start."""
    legs: int
    """Number of times that the goal or the start was reached."""


@compiled
def command_for(motion: PointMass, goal: Vec3, limits: Dynamics) -> tuple[float, float]:
    """Bank towards the goal and path angle towards its height [rad], within the limits."""
    north, east = goal[0] - motion.p_n[0], goal[1] - motion.p_n[1]
    error = wrap(math.atan2(east, north) - motion.azimuth)
    bank = math.atan(motion.airspeed * error / G0)
    gamma = (motion.p_n[2] - goal[2]) / max(math.hypot(north, east), 60.0)
    bank = max(-limits.bank_max, min(limits.bank_max, bank))
    return bank, max(-limits.descent_max, min(limits.climb_max, gamma))


@compiled
def move_obstacles(rows: Rows, turning: Rows, t: float) -> None:
    """Turn the velocities of the obstacles that turn at the time `t` [s]; positions at `t` stay."""
    for i in range(len(rows)):
        turn = read_turning(turning[i])
        if turn.rate != 0.0 and t >= turn.begin:
            write_obstacle(turned(read_obstacle(rows[i]), turn, t), rows[i])


@compiled
def turned(obstacle: PlacedObstacle, turn: Turning, t: float) -> PlacedObstacle:
    """The obstacle with its velocity turned for one more tick; its position at `t` [s] stays."""
    c, s = math.cos(turn.rate * TICK), math.sin(turn.rate * TICK)
    north, east, _ = obstacle.v_n
    v_n = (c * north - s * east, s * north + c * east, turn.sinking)
    p_n = add(obstacle.p_n, scale(t, sub(obstacle.v_n, v_n)))
    return with_motion(obstacle, p_n, v_n)


@compiled
def come_in_sight(rows: Rows, p_n: Vec3, t: float, known: Rows) -> bool:
    """Mark in `known` the obstacles detected from `p_n`; returns whether there is a new one."""
    new = False
    for i in range(len(rows)):
        far = read_obstacle(rows[i]).visible_from
        if known[i] == 0.0 and (far == math.inf or obstacle_distance(rows, i, p_n, t) <= far):
            known[i], new = 1.0, True
    return new


@compiled
def true_distance(world: World, rows: Rows, p_n: Vec3, t: float) -> tuple[float, int]:
    """Distance from the nearest obstacle, zone, floor, ceiling or cylinder [m], and its number.

    Numbers are in the order of obstacles, zones of the fence, floor and ceiling as one, and
    cylinders on tracks.
    """
    least = min(-p_n[2] - world.floor, world.ceiling + p_n[2])
    nearest = len(rows) + len(world.fences.zones)
    for i in range(len(world.tracks)):
        ticks = max(0.0, min(t / TICK, world.tracks.shape[1] - 1.0))
        k = min(int(ticks), world.tracks.shape[1] - 2)
        at, after = world.tracks[i, k], world.tracks[i, k + 1]
        x = p_n[0] - at[0] - (ticks - k) * (after[0] - at[0])
        y = p_n[1] - at[1] - (ticks - k) * (after[1] - at[1])
        z = p_n[2] - at[2] - (ticks - k) * (after[2] - at[2])
        distance = upright_distance(x, y, z, world.volume[0], world.volume[1])
        if distance < least:
            least, nearest = distance, len(rows) + len(world.fences.zones) + 1 + i
    for i in range(len(world.fences.zones)):
        distance = fence_distance(world.fences, i, p_n)
        if distance < least:
            least, nearest = distance, len(rows) + i
    for i in range(len(rows)):
        if distance_bound(rows, i, p_n, t) < min(least, 30.0):
            distance = obstacle_distance(rows, i, p_n, t)
            if distance < least:
                least, nearest = distance, i
    return least, nearest


@compiled
def slowed(limits: Dynamics) -> Dynamics:
    """The dynamics of the aircraft that is flown, slower by ROLLING than `limits`."""
    return Dynamics(
        limits.bank_max,
        limits.climb_max,
        limits.descent_max,
        limits.roll_rate / ROLLING,
        limits.bank_lag * ROLLING,
        limits.path_lag * ROLLING,
    )


@compiled
def hazards_among(world: World, rows: Rows) -> Hazards:
    """The obstacles in `rows` and the fence of a world, without traffic."""
    nobody = np.zeros((0, INTRUDER_WIDTH))
    return Hazards(rows, nobody, world.fences, world.floor, world.ceiling)


@compiled
def fly(world: World, aircraft: Assurance, assured: bool, log: Rows) -> Flown:
    """Fly for as many ticks as `log` has rows, and write a `Logged` into each."""
    rows, motion, goal = world.rows.copy(), world.start, world.goal
    known, limits, backup = np.zeros(len(rows)), aircraft.limits, no_backup()
    slow = slowed(limits)
    least, when, hazard, escapes, bad, first_bad, legs = math.inf, 0.0, -1, 0, 0, math.inf, 0
    for k in range(len(log)):
        t = k * TICK
        move_obstacles(rows, world.turning, t)
        come_in_sight(rows, motion.p_n, t, known)
        hazards = hazards_among(world, rows[known > 0.0])
        command = command_for(motion, goal, limits)
        before = backup
        decision = Decision(command[0], command[1], Reason.NOMINAL.value, 0.0, 0.0, -1)
        if assured:
            decision, backup = assure(
                motion, command, world.wind_n, world.gust, hazards, t, TICK, aircraft, backup
            )
        escapes += decision.reason != Reason.NOMINAL.value
        if decision.reason == Reason.BEST_EFFORT.value:
            bad, first_bad = bad + 1, min(first_bad, t)
        distance, nearest = true_distance(world, rows, motion.p_n, t)
        seen = len(hazards.obstacles)
        write_logged(Logged(t, motion, command, before, decision, distance, nearest, seen), log[k])
        if distance < least:
            least, when, hazard = distance, t, nearest
        gust = (world.gusts_n[k, 0], world.gusts_n[k, 1], world.gusts_n[k, 2])
        motion = advance(motion, decision.bank, decision.gamma, add(world.wind_n, gust), slow, TICK)
        if math.hypot(motion.p_n[0] - goal[0], motion.p_n[1] - goal[1]) < REACHED:
            goal = (world.goal[0] - goal[0], world.goal[1] - goal[1], goal[2])
            legs += 1
    unclear = read_logged(log[0]).decision.reason == Reason.BEST_EFFORT.value
    return Flown(least, when, hazard, escapes, bad, first_bad, unclear, legs)


@compiled
def repeat_decision(world: World, aircraft: Assurance, row: Row, times: int) -> float:
    """Repeat the decision of one row of a log, all obstacles known; returns the sum of banks."""
    hazards, total = hazards_among(world, world.rows), 0.0
    logged = read_logged(row)
    for _ in range(times):
        decision, _ = assure(
            logged.motion,
            logged.command,
            world.wind_n,
            world.gust,
            hazards,
            logged.time,
            TICK,
            aircraft,
            logged.backup,
        )
        total += decision.bank
    return total
