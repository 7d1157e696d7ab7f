"""Whether an escape was possible in a flown world: the manoeuvre tree from the true state.

The search begins when the hazard that was hit, or came nearest, became known. It knows everything,
also hazards that are not detected yet, and how traffic is going to turn. Its aircraft is the model
of the assurance, without additional lags, in the mean wind: it meets no gusts.
"""

import math

import numpy as np
from avoidance_flights import true_distance
from avoidance_worlds import TICK, Tracks, World
from manoeuvre_tree import HOLD, LEVELS, best_escape

from vfguide.aircraft.point_mass import PointMass
from vfguide.airspace.detection import comes_into_sight
from vfguide.assurance.decision import assurance
from vfguide.field.obstacle import Rows
from vfguide.geometry.vector import Indices, Series, Vectors
from vfguide.kernels.compiled import compiled
from vfguide.results.record import FlightRecord
from vfguide.scenario.hazards import hazards_of
from vfguide.scenario.loaded import LoadedScenario
from vfguide.scenario.traffic import path_of
from vfguide.sim.traffic import motion_at

ENOUGH = 5.0
"""Distance above which the tree looks for no larger one [m]; chosen."""
AFTERWARDS = 2.0
"""Time beyond that of the least clearance to which the tree looks [s]; chosen."""
MANY, LONG = 5, 4.0
"""Number of actions and longest time of each [s], where four of 2 s end too early; chosen."""


def best_possible(loaded: LoadedScenario, record: FlightRecord) -> float:
    """The largest clearance that the tree finds [m], infinite where nothing was known before."""
    world = world_of(loaded, record)
    vehicle = record.vehicle
    limits = assurance(loaded.performance_aloft(vehicle), loaded.gains(vehicle)).limits
    distances, nearest = true_distances(world, record.p_n, record.time)
    inside = np.flatnonzero(distances <= 0.0)
    last = int(inside[0]) if inside.size else int(np.argmin(distances))
    k = known_from(loaded, record)[nearest[last]]
    if not 0 <= k <= last:
        return math.inf
    t = float(record.time[k])
    levels, hold = reach_of(float(record.time[last]) - t)
    motion = point_mass_of(record, k, world)
    return best_escape(world, world.rows, motion, t, limits, ENOUGH, levels, hold)


def reach_of(ahead: float) -> tuple[int, float]:
    """Number and length [s] of the actions that reach beyond what is `ahead` [s]."""
    if ahead + AFTERWARDS <= LEVELS * HOLD:
        return LEVELS, HOLD
    return MANY, min(LONG, max(HOLD, (ahead + AFTERWARDS) / MANY))


def point_mass_of(record: FlightRecord, k: int, world: World) -> PointMass:
    """The true point mass at sample `k`, in air that moves with the mean wind."""
    north, east, down = (float(x) for x in record.v_n[k] - world.wind_n)
    airspeed = math.sqrt(north * north + east * east + down * down)
    p_n = tuple(float(x) for x in record.p_n[k])
    bank, gamma = float(record.euler[k, 0]), math.asin(-down / airspeed)
    return PointMass(p_n, math.atan2(east, north), bank, gamma, airspeed)


def world_of(loaded: LoadedScenario, record: FlightRecord) -> World:
    """The world that was flown in; its floor is the ground, or that of the fence if higher."""
    known = hazards_of(loaded.scenario)
    assert known is not None
    avoidance = loaded.scenario.avoidance
    north, east, down = (float(x) for x in record.wind_n.mean(axis=0))
    return World(
        motion_of_start(record),
        record.vehicle.goals[-1].position_m,
        known.obstacles,
        np.zeros((len(known.obstacles), 3)),
        known.fences,
        max(known.floor, 0.0),
        known.ceiling,
        (north, east, down),
        0.0,
        np.zeros((0, 3)),
        tracks_of(loaded, float(record.time[-1]) + MANY * LONG),
        (avoidance.traffic_radius_m, avoidance.traffic_half_height_m),
    )


def motion_of_start(record: FlightRecord) -> PointMass:
    """The point mass at the start of the flight."""
    p_n = tuple(float(x) for x in record.p_n[0])
    return PointMass(p_n, float(record.euler[0, 2]), 0.0, 0.0, float(record.airspeed[0]))


def tracks_of(loaded: LoadedScenario, until: float) -> Tracks:
    """The true positions of other aircraft until a time [s], as of `World.tracks`."""
    times = np.arange(round(until / TICK) + 1) * TICK
    paths = [motion_at(path_of(each), times)[0] for each in loaded.scenario.traffic]
    return np.array(paths).reshape(len(paths), len(times), 3)


def known_from(loaded: LoadedScenario, record: FlightRecord) -> list[int]:
    """The sample at which each hazard became known; -1: none.

    In the order of `true_distance`. Fence and ground are known from the start.
    """
    known, scenario = hazards_of(loaded.scenario), loaded.scenario
    assert known is not None
    seen = [int(k) for k in first_seen(known.obstacles, record.p_n, record.time)]
    seen += [0] * (len(known.fences.zones) + 1)
    for each in scenario.traffic:
        told = np.arange(0.0, float(record.time[-1]) - each.delay_s, each.interval_s)
        arrives = np.searchsorted(record.time, told + each.delay_s - 1e-9)
        apart = motion_at(path_of(each), told)[0] - record.p_n[arrives]
        near = np.linalg.norm(apart, axis=1) <= scenario.traffic_receiver.range_m
        seen.append(int(arrives[np.argmax(near)]) if near.any() else -1)
    return seen


@compiled
def first_seen(rows: Rows, p_n: Vectors, time: Series) -> Indices:
    """Index of the first place from which each obstacle is detected, (M,); -1: none."""
    first = np.full(len(rows), -1)
    for i in range(len(rows)):
        for k in range(len(time)):
            if comes_into_sight(rows, i, (p_n[k, 0], p_n[k, 1], p_n[k, 2]), time[k]):
                first[i] = k
                break
    return first


@compiled
def true_distances(world: World, p_n: Vectors, time: Series) -> tuple[Series, Indices]:
    """Distance from the nearest surface at each place [m], and its number as of `true_distance`."""
    out, nearest = np.empty(len(time)), np.empty(len(time), np.int64)
    for k in range(len(time)):
        at = (p_n[k, 0], p_n[k, 1], p_n[k, 2])
        out[k], nearest[k] = true_distance(world, world.rows, at, time[k])
    return out, nearest
