"""Flies the Cessna among obstacles of many sizes that stand and move, at two detection ranges.

python tools/measure_detection.py --worlds 100
"""

import argparse
import math
import tempfile
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import tomli_w

from vfguide.files.errors import InputError
from vfguide.preflight.load import load_scenario
from vfguide.results.judge import judge
from vfguide.runs.lockstep import fly_scenario

Table = dict[str, Any]
AIRSPEED = 50.0
"""True airspeed [m/s]; chosen near the fastest, where turns are widest."""
HEIGHT = 400.0
"""Height of starts and goals above the origin [m]; chosen."""
LEG = (3000.0, 5000.0)
"""Least and greatest distance from the start to the goal [m]; chosen."""
SIZES = (20.0, 500.0)
"""Least and greatest radius of an obstacle at rest [m]; chosen. Its logarithm is drawn evenly."""
FREE = 600.0
"""Least distance of surfaces from start and goal [m]; chosen, two turn radii and some more."""
BEFORE = 300.0
"""Detection range of every plan before it was made to follow the aircraft [m]."""


class Outcome(NamedTuple):
    """The result of one flight."""

    clearance: float
    """Least clearance from an obstacle [m]."""
    reached: int
    goals: int


def along(place: np.ndarray, angle: float, distance: float) -> np.ndarray:
    """The place at a distance [m] in a direction [rad] from another place."""
    return place + distance * np.array((math.cos(angle), math.sin(angle)))


def standing(rng: np.random.Generator, begin: np.ndarray, end: np.ndarray) -> Table:
    """An obstacle at rest near the straight line between two places."""
    radius = float(np.exp(rng.uniform(*np.log(SIZES))))
    at = begin + rng.uniform(0.2, 0.8) * (end - begin) + rng.normal(0.0, 0.5 * radius + 30.0, 2)
    place = [*map(float, at), -HEIGHT]
    if rng.random() < 0.5:
        return {
            "shape": "cylinder", "radius_m": radius, "height_m": 1000.0, "position_m": place
        }  # fmt: skip
    return {
        "shape": "box",
        "size_m": [2.0 * radius, 2.0 * radius * rng.uniform(0.1, 1.0), 1000.0],
        "heading_deg": rng.uniform(0.0, 360.0),
        "position_m": place,
    }


def moving(rng: np.random.Generator, begin: np.ndarray, end: np.ndarray, speed: float) -> Table:
    """An obstacle that would meet a vehicle that flies straight from the start at `speed` [m/s]."""
    part, course, own = rng.uniform(0.3, 0.8), rng.uniform(0.0, 2.0 * math.pi), rng.uniform(5, 35)
    when = part * float(np.linalg.norm(end - begin)) / speed
    at = along(begin + part * (end - begin), course, -own * when)
    return {
        "shape": "sphere",
        "radius_m": rng.uniform(20.0, 150.0),
        "position_m": [*map(float, at), -HEIGHT],
        "velocity_mps": [own * math.cos(course), own * math.sin(course), 0.0],
    }


def distance(table: Table, place: np.ndarray) -> float:
    """Lower bound of the horizontal distance of a place from the surface of an obstacle [m]."""
    length, width, _ = table.get("size_m", (0.0, 0.0, 0.0))
    radius = table.get("radius_m", math.hypot(length, width) / 2.0)
    north, east, _ = table["position_m"]
    return float(np.linalg.norm(np.array((north, east)) - place)) - radius


def world(seed: int) -> Table:
    """The scenario, with a goal behind obstacles, that a seed draws."""
    rng = np.random.default_rng(seed)
    start, course = np.array((0.0, 0.0)), rng.uniform(0.0, 2.0 * math.pi)
    places = (start, along(start, course, rng.uniform(*LEG)))
    bodies = [standing(rng, *places) for _ in range(rng.integers(1, 5))]
    bodies += [moving(rng, *places, AIRSPEED) for _ in range(rng.integers(1, 4))]
    goal = {
        "position_m": [*map(float, places[1]), -HEIGHT],
        "heading_deg": math.degrees(course) + rng.uniform(-90.0, 90.0) - 360.0 * (course > math.pi),
    }
    vehicle = {
        "id": 1,
        "aircraft": "c172p",
        "airspeed_mps": AIRSPEED,
        "position_m": [*map(float, start), -HEIGHT],
        "heading_deg": math.degrees(course),
        "goal": [goal],
    }
    wind = {"speed_mps": rng.uniform(0.0, 12.0), "from_deg": rng.uniform(0.0, 360.0)}
    free = [each for each in bodies if min(distance(each, at) for at in places) > FREE]
    return {
        "name": f"detection-{seed}",
        "seed": seed,
        "duration_s": 250.0,
        "wind": wind,
        "vehicle": [vehicle],
        "obstacle": free,
    }


def fly(table: Table) -> Outcome | None:
    """The outcome of a scenario; None where the checks refuse it."""
    with tempfile.TemporaryDirectory() as name:
        file = Path(name) / "world.toml"
        file.write_text(tomli_w.dumps(table))
        try:
            loaded = load_scenario(file)
        except InputError:
            return None
        flight = fly_scenario(loaded, Path(name))
    result = judge(loaded.scenario, flight.records, flight.sim_s, flight.wall_s)
    (vehicle,) = result.vehicles
    clearances = [each.min_clearance_m for each in vehicle.obstacles]
    least = min((each for each in clearances if each is not None), default=math.inf)
    return Outcome(least, sum(goal.reached for goal in vehicle.goals), len(vehicle.goals))


def show(name: str, outcomes: list[Outcome]) -> None:
    """Print one row of the table."""
    hits = [each.clearance for each in outcomes if each.clearance <= 0.0]
    reached, goals = sum(each.reached for each in outcomes), sum(each.goals for each in outcomes)
    deepest = f", the deepest {min(hits):.1f} m" if hits else ""
    least = min(each.clearance for each in outcomes)
    print(
        f"{name}: {len(outcomes)} worlds, {len(hits)} hits{deepest}, least clearance {least:.1f} m,"
        f" {reached} of {goals} goals"
    )


def main() -> None:
    """Fly every world at both detection ranges, and print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--worlds", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    before, after = list[Outcome](), list[Outcome]()
    seed = args.seed
    while len(after) < args.worlds:
        table, seed = world(seed), seed + 1
        if not table["obstacle"]:
            continue
        there = fly(table)
        here = fly({**table, "avoidance": {"detection_range_m": BEFORE}})
        if there is not None and here is not None:
            after.append(there)
            before.append(here)
            print(seed - 1, here, there, flush=True)
    show(f"at {BEFORE:g} m", before)
    show("at the range that the aircraft needs", after)


if __name__ == "__main__":
    main()
