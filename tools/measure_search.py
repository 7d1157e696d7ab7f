#!/usr/bin/env python3
"""The coarse search in random worlds: found, length over a reference, time.

    python tools/measure_search.py --fields 100 --dead-ends 200 --reference-s 1

World k of seed S is drawn from (S, k) alone; fields and dead ends are numbered separately. The
reference is BIT* with a clearance of 5 m where ompl is installed; worlds in which it finds no route
either are counted apart.
"""

import argparse
import math
import time
from dataclasses import dataclass

import numpy as np
from reference_path import MISSING, is_installed, reference_length
from search_worlds import HEIGHT, World, draw

from vfguide.airspace.footprint import Band
from vfguide.airspace.keep_out import NO_FENCE, obstacle_zones
from vfguide.paths.dubins import length_of
from vfguide.paths.edge import next_path
from vfguide.planning.collision_check import Air, Task, route_is_clear
from vfguide.planning.route_search import FoundRoute, find_route

LEVEL = Band(-HEIGHT, -HEIGHT)
REPEATS = 3
"""Number of runs of which the fastest counts; chosen."""
REFERENCE_CLEARANCE = 5.0


@dataclass(frozen=True)
class Outcome:
    """One world."""

    number: int
    kind: str
    following: FoundRoute
    free: float
    """Length without obstacles [m]."""
    reference: float
    """Length by BIT* [m]; infinite where it found no route, NaN where it was not asked."""
    time_ms: float
    check_us: float
    """Time of one check of the whole route."""


def seconds_of(function, *args) -> float:
    """Time of the fastest of some calls [s]."""
    least = math.inf
    for _ in range(REPEATS):
        begin = time.perf_counter()
        function(*args)
        least = min(least, time.perf_counter() - begin)
    return least


def measure(world: World, number: int, args: argparse.Namespace) -> Outcome:
    """Search one world."""
    air = Air(args.airspeed, args.wind, 0.0)
    task = Task(world.start, world.goal, args.radius, air, 0.0)
    asked = (world.obstacles, NO_FENCE, LEVEL, task)
    following = find_route(*asked)
    free = args.radius * length_of(next_path(world.start, world.goal, args.radius, -1.0))
    reference = math.nan
    if args.reference_s > 0.0 and is_installed():
        reference = reference_length(
            world, args.radius, REFERENCE_CLEARANCE, args.reference_s, number
        )
    hazards = obstacle_zones(world.obstacles, LEVEL, following.clearance)
    progress = (hazards, task, following.clearance, following.route_edges, 0, 0, 0.0)
    route_is_clear(*progress)
    seconds = seconds_of(find_route, *asked)
    return Outcome(
        number,
        world.kind,
        following,
        free,
        reference,
        1e3 * seconds,
        1e6 * seconds_of(route_is_clear, *progress),
    )


def figures(values: list[float], quantiles: tuple[float, ...]) -> str:
    """Quantiles and number of some values, in words."""
    if not values:
        return "none"
    found = np.quantile(values, quantiles)
    return "  ".join(f"{v:.3f}" for v in found) + f"  ({len(values)})"


def show(name: str, outcomes: list[Outcome]) -> None:
    """Print what was found in worlds of one kind."""
    found = [o for o in outcomes if len(o.following.route_edges) > 0]
    missed = [o for o in outcomes if len(o.following.route_edges) == 0]
    hopeless = [o for o in missed if o.reference == math.inf]
    both = [o for o in found if math.isfinite(o.reference)]
    print(f"{name}: {len(outcomes)} worlds, {len(found)} found, {len(hopeless)} by neither")
    print(f"  missed though there is a route: {[o.number for o in missed if o not in hopeless]}")
    print(f"  found here alone: {sum(o.reference == math.inf for o in found)}")
    ratios = [o.following.length / o.reference for o in both]
    print(f"  length over the reference, 50 90 100 %: {figures(ratios, (0.5, 0.9, 1.0))}")
    ratios = [o.following.length / o.free for o in found]
    print(f"  length over that without obstacles:     {figures(ratios, (0.5, 0.9, 1.0))}")
    times = [o.time_ms for o in outcomes]
    print(f"  time of a search [ms], 50 95 100 %:     {figures(times, (0.5, 0.95, 1.0))}")
    times = [o.check_us for o in found]
    print(f"  a look at the route [us], 50 95 100 %:  {figures(times, (0.5, 0.95, 1.0))}")
    kept = sorted({o.following.clearance for o in found}, reverse=True)
    counts = ", ".join(f"{c:g} m: {sum(o.following.clearance == c for o in found)}" for c in kept)
    most = max((len(o.following.route_edges) for o in found), default=0)
    print(f"  clearance {counts}; most edges {most}")
    for o in sorted(both, key=lambda o: -o.following.length / o.reference)[:3]:
        print(f"    world {o.number}: {o.following.length:.0f} m, reference {o.reference:.0f} m")


def main() -> None:
    """Search all worlds and print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--fields", type=int, default=100)
    parser.add_argument("--dead-ends", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--radius", type=float, default=80.0, help="of turns [m]")
    parser.add_argument("--airspeed", type=float, default=25.0, help="[m/s]")
    parser.add_argument("--wind", type=float, default=0.0, help="towards north [m/s]")
    parser.add_argument("--reference-s", type=float, default=1.0, help="for BIT*; 0 for none")
    args = parser.parse_args()
    reference = f"the reference is BIT* of {args.reference_s:g} s" if is_installed() else MISSING
    print(f"seed {args.seed}, turn radius {args.radius:g} m; {reference}")
    for kind, count in (("field", args.fields), ("dead end", args.dead_ends)):
        worlds = [draw(kind, args.seed, k) for k in range(count)]
        outcomes = [measure(world, k, args) for k, world in enumerate(worlds)]
        for name in dict.fromkeys(o.kind for o in outcomes):
            show(name, [o for o in outcomes if o.kind == name])


if __name__ == "__main__":
    main()
