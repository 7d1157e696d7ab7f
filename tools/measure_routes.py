#!/usr/bin/env python3
"""Random routes of several poses, flown over MAVLink and judged by the truth.

    python tools/measure_routes.py --runs 50 --wind 6

Route k of seed S is drawn from (S, k) alone: any one can be flown alone with --only K.
"""

import argparse
import math
import tempfile
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

from vfguide.preflight.load import load_scenario
from vfguide.results.judge import judge
from vfguide.runs.lockstep import fly_scenario

START = (-300.0, 0.0, -200.0)
MOST_MISS_M, MOST_ANGLE_DEG = 1.0, 2.0
"""Limits of miss [m] and of the errors of course and climb [deg] at every pose."""


@dataclass(frozen=True)
class Outcome:
    """One route."""

    number: int
    reached: int
    """Number of poses that were reached."""
    miss_m: tuple[float, ...]
    angle_deg: tuple[float, ...]
    """The larger error of course and climb at each pose."""
    passes: int
    """Number of passes of all poses together."""
    time_s: float


def draw(seed: int, number: int, args: argparse.Namespace) -> tuple[str, ...]:
    """The changes to the scenario that make one random route."""
    rng = np.random.default_rng([seed, number])
    north, east, down = 0.0, 0.0, START[2]
    goals: list[str] = []
    for _ in range(args.poses):
        place = f"position_m=[{north:.3f}, {east:.3f}, {down:.3f}]"
        goals.append(f"{{{place}, heading_deg={rng.uniform(0.0, 360.0):.3f}}}")
        apart, bearing = rng.uniform(args.nearest, args.farthest), rng.uniform(0.0, 2.0 * math.pi)
        north, east = north + apart * math.cos(bearing), east + apart * math.sin(bearing)
        down = START[2] + rng.uniform(-args.height, args.height)
    return (
        f"vehicle.0.position_m={list(START)}",
        f"vehicle.0.heading_deg={rng.uniform(0.0, 360.0):.3f}",
        f"vehicle.0.goal=[{', '.join(goals)}]",
        f"wind.speed_mps={args.wind}",
        f"wind.from_deg={rng.uniform(0.0, 360.0):.3f}",
        f'wind.turbulence="{args.turbulence}"',
        f"seed={number + 1}",
        f"duration_s={200 * args.poses}",
        *args.set,
    )


def fly(number: int, args: argparse.Namespace) -> Outcome:
    """Fly one route."""
    loaded = load_scenario("first-flight", draw(args.seed, number, args))
    with tempfile.TemporaryDirectory() as folder:
        flight = fly_scenario(loaded, Path(folder))
    result = judge(loaded.scenario, flight.records, flight.sim_s, flight.wall_s)
    goals, nan = result.vehicles[0].goals, math.nan
    return Outcome(
        number,
        sum(goal.reached for goal in goals),
        tuple(nan if goal.miss_m is None else goal.miss_m for goal in goals),
        tuple(
            max(abs(goal.course_error_deg or nan), abs(goal.climb_error_deg or nan))
            for goal in goals
        ),
        sum(map(len, flight.records[0].legs().passes)),
        flight.sim_s,
    )


def show(outcomes: list[Outcome], args: argparse.Namespace) -> None:
    """Print the table."""
    miss = np.array([value for o in outcomes for value in o.miss_m])
    angle = np.array([value for o in outcomes for value in o.angle_deg])
    poses = args.poses * len(outcomes)
    near = (miss <= MOST_MISS_M) & (angle <= MOST_ANGLE_DEG)
    print(
        f"seed {args.seed}, {len(outcomes)} routes of {args.poses} poses, wind {args.wind:g} m/s,"
    )
    print(
        f"turbulence {args.turbulence}, {args.nearest:g} to {args.farthest:g} m from pose to pose"
    )
    print(f"reached     {sum(o.reached for o in outcomes)} of {poses}")
    print(f"within {MOST_MISS_M:g} m and {MOST_ANGLE_DEG:g} deg  {near.sum()} of {poses}")
    for name, values in (("miss [m]", miss), ("angle [deg]", angle)):
        known = values[np.isfinite(values)]
        median, most = np.quantile(known, (0.5, 0.95))
        print(f"{name:12}median {median:.3f}  95 % {most:.3f}  most {known.max():.3f}")
    print(f"passes {sum(o.passes for o in outcomes)}, time {sum(o.time_s for o in outcomes):.0f} s")
    for o in sorted(outcomes, key=lambda o: (o.reached, -max(o.miss_m)))[: args.worst]:
        figures = "  ".join(
            f"{m:.2f} m {a:.2f} deg" for m, a in zip(o.miss_m, o.angle_deg, strict=True)
        )
        print(f"  route {o.number}: reached {o.reached}  {figures}")


def main() -> None:
    """Fly all routes and print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=50)
    parser.add_argument("--poses", type=int, default=5)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="fly this route alone")
    parser.add_argument("--wind", type=float, default=6.0, help="[m/s]")
    parser.add_argument("--turbulence", default="none")
    parser.add_argument("--nearest", type=float, default=100.0, help="[m] from pose to pose")
    parser.add_argument("--farthest", type=float, default=800.0, help="[m]")
    parser.add_argument("--height", type=float, default=40.0, help="[m]")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--worst", type=int, default=5)
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    args = parser.parse_args()
    numbers = list(range(args.runs)) if args.only is None else [args.only]
    if args.only is not None:
        changes = draw(args.seed, args.only, args)
        print("vfguide run first-flight " + " ".join(f"--set '{change}'" for change in changes))
    with ProcessPoolExecutor(args.workers) as pool:
        show(list(pool.map(partial(fly, args=args), numbers, chunksize=2)), args)


if __name__ == "__main__":
    main()
