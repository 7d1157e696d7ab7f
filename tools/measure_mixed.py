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
from typing import Any

import numpy as np
import tomli_w
from numpy.random import Generator

from vfguide.results.fence_distance import fence_clearance
from vfguide.results.result import TOUCH, judge
from vfguide.runs.lockstep import fly_scenario
from vfguide.scenario.load import load_scenario

AIRCRAFT = {"aerosonde": 25.0, "easystar": 10.5, "c172p": 50.0}
"""Airspeeds by the names of the aircraft [m/s]."""
TURN = 1.6
"""Room for turns, over V^2 / g, by which everything is scaled; chosen."""
MOST_WIND = 0.48
"""Largest wind over the airspeed, a ratio."""
Table = dict[str, Any]


@dataclass(frozen=True)
class Outcome:
    """One flight."""

    number: int
    aircraft: str
    turbulence: str
    goals: int
    reached: int
    clearance_m: float
    """Least, of all obstacles, the fence and the ground."""
    reasons: tuple[str, ...]


def world_of(seed: int, number: int) -> Table:
    """World `number`, from (seed, number) alone."""
    rng = np.random.default_rng([seed, number, 16])
    aircraft = rng.choice(list(AIRCRAFT))
    speed = AIRCRAFT[aircraft]
    unit = TURN * speed**2 / 9.81 + 20.0
    goals = route(rng, unit, int(rng.integers(2, 5)))
    north = min(g["position_m"][0] for g in goals), max(g["position_m"][0] for g in goals)
    east = min(g["position_m"][1] for g in goals), max(g["position_m"][1] for g in goals)
    world: Table = {
        "name": f"mixed {number}",
        "seed": number + 1,
        "duration_s": round(60.0 + 45.0 * len(goals) * (2.0 + 12.0 * unit / speed / 45.0)),
        "wind": {
            "speed_mps": round(float(rng.uniform(0.0, MOST_WIND)) * speed, 2),
            "from_deg": round(float(rng.uniform(0.0, 360.0)), 1),
            "turbulence": str(rng.choice(["none", "light", "moderate"])),
        },
        "vehicle": [
            {
                "id": 1,
                "aircraft": str(aircraft),
                "airspeed_mps": speed,
                "position_m": [0.0, 0.0, goals[0]["position_m"][2]],
                "heading_deg": round(float(rng.uniform(0.0, 360.0)), 1),
                "goal": goals,
            }
        ],
        "obstacle": obstacles(rng, unit, speed, goals),
        "fence": fence(
            (min(north[0], 0.0), max(north[1], 0.0)), (min(east[0], 0.0), max(east[1], 0.0)), unit
        ),
    }
    if rng.random() < 0.5:
        world["sensors"] = {}
    return world


def route(rng: Generator, unit: float, number: int) -> list[Table]:
    """Poses some turns apart, each somewhere ahead of the one before."""
    at, course, goals = np.zeros(2), rng.uniform(0.0, 2.0 * math.pi), []
    low = -round(float(rng.uniform(120.0, 180.0)), 1)
    for _ in range(number):
        toward = course + rng.uniform(-1.2, 1.2)
        at = at + rng.uniform(4.0, 9.0) * unit * np.array([math.cos(toward), math.sin(toward)])
        course = toward + rng.uniform(-1.5, 1.5)
        height = low - round(float(rng.uniform(0.0, 0.25)) * unit, 1)
        goals.append(
            {
                "position_m": [round(float(at[0]), 1), round(float(at[1]), 1), height],
                "heading_deg": round(math.degrees(course) % 360.0, 1),
                "tolerance_m": 5.0,
                "tolerance_deg": 10.0,
            }
        )
    return goals


def obstacles(rng: Generator, unit: float, speed: float, goals: Sequence[Table]) -> list[Table]:
    """Bodies that stand and move, clear of the start and the goals for a turn."""
    kept, places = [], [np.zeros(2), *(np.array(g["position_m"][:2]) for g in goals)]
    for _ in range(int(rng.integers(0, 7))):
        k = int(rng.integers(1, len(places)))
        share, aside = rng.uniform(0.2, 0.8), rng.uniform(-1.5, 1.5) * unit
        way = places[k] - places[k - 1]
        across = np.array([-way[1], way[0]]) / np.linalg.norm(way)
        centre = places[k - 1] + share * way + aside * across
        radius = float(rng.uniform(0.1, 0.7)) * unit
        if min(np.linalg.norm(centre - p) for p in places) < radius + 2.0 * unit:
            continue
        kept.append(standing(rng, centre, radius))
    for _ in range(int(rng.integers(0, 3))):
        course, pace = rng.uniform(0.0, 2.0 * math.pi), rng.uniform(0.1, 0.9) * speed
        meets, when = rng.uniform(0.2, 0.8), rng.uniform(10.0, 60.0)
        velocity = pace * np.array([math.cos(course), math.sin(course)])
        centre = meets * places[1] - velocity * when
        if np.linalg.norm(centre) < 6.0 * unit:
            continue
        height = goals[0]["position_m"][2]
        kept.append(
            {
                "shape": "sphere",
                "radius_m": round(float(rng.uniform(10.0, 30.0)), 1),
                "position_m": [*np.round(centre, 1).tolist(), height],
                "velocity_mps": [*np.round(velocity, 2).tolist(), 0.0],
                "visible_from_m": round(max(600.0, 12.0 * unit), 1),
            }
        )
    return kept


def standing(rng: Generator, centre: np.ndarray, radius: float) -> Table:
    """A sphere, a cylinder or a box with about a radius [m]."""
    north, east = np.round(centre, 1).tolist()
    kind = str(rng.choice(["sphere", "cylinder", "box"]))
    if kind == "sphere":
        return {"shape": kind, "radius_m": round(radius, 1), "position_m": [north, east, -150.0]}
    place = {"position_m": [north, east, -150.0], "heading_deg": float(rng.integers(0, 180))}
    if kind == "cylinder":
        return {"shape": kind, "radius_m": round(radius, 1), "height_m": 300.0, **place}
    return {"shape": kind, "size_m": [round(radius, 1), round(1.6 * radius, 1), 300.0], **place}


def fence(north: tuple[float, float], east: tuple[float, float], unit: float) -> Table:
    """A rectangle with room for turns around a route, a floor and a ceiling."""
    room = 8.0 * unit
    south, far, west, right = north[0] - room, north[1] + room, east[0] - room, east[1] + room
    corners = [[south, west], [far, west], [far, right], [south, right]]
    zone = {"kind": "include", "polygon_m": [[round(x, 1), round(y, 1)] for x, y in corners]}
    return {"floor_m": 40.0, "ceiling_m": round(400.0 + unit, 1), "zone": [zone]}


def fly(number: int, seed: int, changes: Sequence[str]) -> Outcome:
    """Fly one world."""
    table = world_of(seed, number)
    with tempfile.TemporaryDirectory() as name:
        path = Path(name) / "world.toml"
        path.write_text(tomli_w.dumps(table))
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
        table["vehicle"][0]["aircraft"],
        table["wind"]["turbulence"],
        len(vehicle.goals),
        sum(goal.reached for goal in vehicle.goals),
        min((c for c in clearances if c is not None), default=math.inf),
        result.reasons,
    )


def show(outcomes: Sequence[Outcome]) -> None:
    """Print the table, and the flights that were not good."""
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
    """Fly them all."""
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
