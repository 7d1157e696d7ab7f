#!/usr/bin/env python3
"""Flights of routes among obstacles that stand and move, inside a fence, judged by the truth.

    python tools/measure_mixed.py --runs 100

World k is drawn from (seed, k) alone: one of three aircraft flies a route of two to four poses, at
two heights, among up to six obstacles that stand and two that move, inside a fence. The wind blows
with up to 0.48 of the airspeed; there are no, light or moderate gusts, and half of the worlds have
noisy sensors. No obstacle is near the start or a goal, and what moves keeps to a straight path.
Printed are the worlds in which something was entered, the share of goals that were reached by the
truth, and each flight that was not good.
"""

import argparse
import math
import tempfile
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import tomli_w
from numpy.random import Generator

from vfguide.preflight.load import load_scenario
from vfguide.results.fence_distance import fence_clearance
from vfguide.results.judge import judge
from vfguide.results.verdict import TOUCH
from vfguide.runs.lockstep import fly_scenario

AIRCRAFT = {"aerosonde": 25.0, "easystar": 10.5, "c172p": 50.0}
"""Airspeeds by the names of the aircraft [m/s]."""
TURN = 1.6
"""Ratio of the room for turns, by which everything is scaled, to V^2 / g; chosen."""
MOST_WIND = 0.48
"""Largest ratio of the wind to the airspeed; chosen."""
Table = dict[str, Any]


class Pose(NamedTuple):
    """A goal: its position, NED [m], and its course [deg]."""

    north: float
    east: float
    down: float
    course: float


@dataclass(frozen=True)
class Outcome:
    """One flight."""

    number: int
    aircraft: str
    turbulence: str
    goals: int
    reached: int
    clearance_m: float
    """Least clearance from obstacles, the fence and the ground."""
    reasons: tuple[str, ...]


def world_of(seed: int, number: int) -> Table:
    """World `number`, from (seed, number) alone."""
    rng = np.random.default_rng([seed, number, 16])
    aircraft = str(rng.choice(list(AIRCRAFT)))
    speed = AIRCRAFT[aircraft]
    unit = TURN * speed**2 / 9.81 + 20.0
    poses = route(rng, unit, int(rng.integers(2, 5)))
    low = poses[0].down
    flying = 12.0 * unit / speed + 90.0
    world: Table = {
        "name": f"mixed {number}",
        "seed": number + 1,
        "duration_s": round(60.0 + flying * len(poses)),
        "wind": {
            "speed_mps": round(float(rng.uniform(0.0, MOST_WIND)) * speed, 2),
            "from_deg": round(float(rng.uniform(0.0, 360.0)), 1),
            "turbulence": str(rng.choice(["none", "light", "moderate"])),
        },
        "vehicle": [
            {
                "id": 1,
                "aircraft": aircraft,
                "airspeed_mps": speed,
                "position_m": [0.0, 0.0, low],
                "heading_deg": round(float(rng.uniform(0.0, 360.0)), 1),
                "goal": [goal_of(pose) for pose in poses],
            }
        ],
        "obstacle": obstacles(rng, unit, speed, poses),
        "fence": fence(poses, unit),
    }
    if rng.random() < 0.5:
        world["sensors"] = {}
    return world


def route(rng: Generator, unit: float, number: int) -> list[Pose]:
    """`number` poses, 4 to 9 `unit` [m] apart, each somewhere ahead of the one before."""
    north, east, course = 0.0, 0.0, rng.uniform(0.0, 2.0 * math.pi)
    low, poses = -round(float(rng.uniform(120.0, 180.0)), 1), list[Pose]()
    for _ in range(number):
        toward, far = course + rng.uniform(-1.2, 1.2), rng.uniform(4.0, 9.0) * unit
        north, east = north + far * math.cos(toward), east + far * math.sin(toward)
        course = toward + rng.uniform(-1.5, 1.5)
        height = low - round(float(rng.uniform(0.0, 0.25)) * unit, 1)
        poses.append(Pose(round(north, 1), round(east, 1), height, math.degrees(course) % 360.0))
    return poses


def goal_of(pose: Pose) -> Table:
    """The goal at a pose."""
    return {
        "position_m": [pose.north, pose.east, pose.down],
        "heading_deg": round(pose.course, 1),
        "tolerance_m": 5.0,
        "tolerance_deg": 10.0,
    }


def obstacles(rng: Generator, unit: float, speed: float, poses: Sequence[Pose]) -> list[Table]:
    """Obstacles at rest and moving, two `unit` [m] clear of the start and the goals."""
    kept, places = [], [np.zeros(2), *(np.array((p.north, p.east)) for p in poses)]
    for _ in range(int(rng.integers(0, 7))):
        k = int(rng.integers(1, len(places)))
        along = places[k] - places[k - 1]
        north, east = along / np.linalg.norm(along)
        across = np.array([east, -north])
        share, aside = rng.uniform(0.2, 0.8), rng.uniform(-1.5, 1.5) * unit
        centre = places[k - 1] + share * along + aside * across
        radius = float(rng.uniform(0.1, 0.7)) * unit
        if min(np.linalg.norm(centre - place) for place in places) >= radius + 2.0 * unit:
            kept.append(standing(rng, centre, radius))
    for _ in range(int(rng.integers(0, 3))):
        course, pace = rng.uniform(0.0, 2.0 * math.pi), rng.uniform(0.1, 0.9) * speed
        velocity = pace * np.array([math.cos(course), math.sin(course)])
        centre = rng.uniform(0.2, 0.8) * places[1] - velocity * rng.uniform(10.0, 60.0)
        if np.linalg.norm(centre) >= 6.0 * unit:
            kept.append(mover(rng, centre, velocity, poses[0].down, unit))
    return kept


def mover(
    rng: Generator, centre: np.ndarray, velocity: np.ndarray, down: float, unit: float
) -> Table:
    """A sphere that moves straight on."""
    return {
        "shape": "sphere",
        "radius_m": round(float(rng.uniform(10.0, 30.0)), 1),
        "position_m": [*np.round(centre, 1).tolist(), down],
        "velocity_mps": [*np.round(velocity, 2).tolist(), 0.0],
        "visible_from_m": round(max(600.0, 12.0 * unit), 1),
    }


def standing(rng: Generator, centre: np.ndarray, radius: float) -> Table:
    """A sphere, a cylinder or a box of about a radius [m]."""
    north, east = np.round(centre, 1).tolist()
    kind = str(rng.choice(["sphere", "cylinder", "box"]))
    if kind == "sphere":
        return {"shape": kind, "radius_m": round(radius, 1), "position_m": [north, east, -150.0]}
    place = {"position_m": [north, east, -150.0], "heading_deg": float(rng.integers(0, 180))}
    if kind == "cylinder":
        return {"shape": kind, "radius_m": round(radius, 1), "height_m": 300.0, **place}
    return {"shape": kind, "size_m": [round(radius, 1), round(1.6 * radius, 1), 300.0], **place}


def fence(poses: Sequence[Pose], unit: float) -> Table:
    """A rectangle with room for turns around start and route, a floor and a ceiling."""
    room = 8.0 * unit
    norths, easts = [0.0, *(p.north for p in poses)], [0.0, *(p.east for p in poses)]
    south, north = round(min(norths) - room, 1), round(max(norths) + room, 1)
    west, east = round(min(easts) - room, 1), round(max(easts) + room, 1)
    corners = [[south, west], [north, west], [north, east], [south, east]]
    zone = {"kind": "include", "polygon_m": corners}
    return {"floor_m": 40.0, "ceiling_m": round(400.0 + unit, 1), "zone": [zone]}


def fly(number: int, seed: int, changes: Sequence[str]) -> Outcome:
    """Fly one world."""
    with tempfile.TemporaryDirectory() as name:
        path = Path(name) / "world.toml"
        path.write_text(tomli_w.dumps(world_of(seed, number)))
        loaded = load_scenario(path, changes)
        flight = fly_scenario(loaded, Path(name))
    record = flight.records[0]
    result = judge(loaded.scenario, flight.records, flight.sim_s, flight.wall_s)
    vehicle = result.vehicles[0]
    clearances = [each.min_clearance_m for each in vehicle.obstacles]
    clearances.append(fence_clearance(loaded.scenario, record.p_n))
    clearances.append(float(record.height_above_ground.min()) - TOUCH)
    return Outcome(
        number,
        loaded.scenario.vehicles[0].aircraft,
        loaded.scenario.wind.turbulence,
        len(vehicle.goals),
        sum(goal.reached for goal in vehicle.goals),
        min((c for c in clearances if c is not None), default=math.inf),
        result.reasons,
    )


def show(outcomes: Sequence[Outcome]) -> None:
    """Print the table, and the flights with a bad verdict."""
    groups = [("all", outcomes)]
    groups += [(name, [o for o in outcomes if o.aircraft == name]) for name in AIRCRAFT]
    kinds = ("none", "light", "moderate")
    groups += [(name, [o for o in outcomes if o.turbulence == name]) for name in kinds]
    for name, some in groups:
        goals, reached = sum(o.goals for o in some), sum(o.reached for o in some)
        hit = sum(o.clearance_m <= 0.0 for o in some)
        least = min((o.clearance_m for o in some), default=math.inf)
        print(
            f"{name:10} {len(some):4} worlds, entered {hit}, least clearance {least:.2f} m, "
            f"goals {reached} of {goals} ({100.0 * reached / max(goals, 1):.1f} %)"
        )
    for o in outcomes:
        if o.clearance_m <= 0.0 or o.reached < o.goals:
            print(
                f"  world {o.number}: {o.aircraft}, {o.turbulence}, reached {o.reached} of "
                f"{o.goals}, clearance {o.clearance_m:.2f} m: {'; '.join(o.reasons)}"
            )


def main() -> None:
    """Fly all worlds and print the table."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--runs", type=int, default=100)
    parser.add_argument("--first", type=int, default=0, help="number of the first world")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="fly this world alone, and print it")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    args = parser.parse_args()
    numbers = [args.only] if args.only is not None else range(args.first, args.first + args.runs)
    if args.only is not None:
        print(tomli_w.dumps(world_of(args.seed, args.only)))
    with ProcessPoolExecutor(args.workers) as pool:
        show(list(pool.map(partial(fly, seed=args.seed, changes=args.set), numbers)))


if __name__ == "__main__":
    main()
