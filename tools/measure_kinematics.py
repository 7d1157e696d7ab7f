#!/usr/bin/env python3
"""What the paper's law does on its own rigid body: convergence, worlds of obstacles, swarms.

    python tools/measure_kinematics.py --starts 10000 --worlds 2000 --seed 1

Start, world and swarm k of a seed are always the same; `--world K` flies one world alone.
"""

import argparse
import itertools
import math
import multiprocessing
from collections.abc import Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
from frame_jumps import FrameJumps, count_jumps
from kinematic_flights import fly
from kinematic_worlds import level_at, random_swarm, random_world, starts_in_free_space
from scipy.spatial import KDTree
from scipy.spatial.transform import Rotation

from vfguide.field.goal_frame import GoalFrame, read_goal
from vfguide.field.obstacle import Rows, obstacle_rows
from vfguide.field.robots import Spacing
from vfguide.field.swarm import fields_of_robots
from vfguide.field.swarm_control import PaperGains
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Vectors

K_V, K_W = 0.25, 3.5
NOTHING = obstacle_rows([])
SWARMS = (7, 50, 200)
SPACING = Spacing(4.0, 20.0)
LONGEST = 300.0
"""Longest time of a flight [s]; chosen."""
DECAYED = 8.0
"""Value of k_w t up to which the attitude error is compared, dimensionless; chosen."""
NEAR = 0.001
"""Distance from the goal to which robots in free space fly [m]; chosen, since at 0.05 m the field
still turns round small circles."""
CHUNK = 500
"""Number of starts that fly side by side; chosen."""


class Outcome(NamedTuple):
    """The result of the flight through one world."""

    number: int
    reached: bool
    heading: float
    """Error of the direction at the end [rad]."""
    level: float
    """Least U of an obstacle on the path."""
    jumps: FrameJumps | None


def main() -> None:
    """Fly, and print the tables."""
    options = parse()
    gains = PaperGains(K_V, K_W, 1.0 / options.rate)
    print(f"seed {options.seed}, law at {options.rate:g} Hz, k_v {K_V}, k_w {K_W} 1/s")
    if options.world is not None:
        print(fly_world(options.seed, gains, options.world + 1, options.world))
        return
    if options.starts:
        print_starts(options.seed, options.starts, gains)
    if options.worlds:
        print_worlds(options, gains)
    for count in SWARMS if options.swarms else ():
        for number in range(options.swarms):
            print_swarm(options.seed + number, count, gains)


def parse() -> argparse.Namespace:
    """The options of the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--rate", type=float, default=200.0, help="of the law [Hz]")
    parser.add_argument("--starts", type=int, default=10000, help="in free space")
    parser.add_argument("--worlds", type=int, default=2000, help="with 3 to 8 superquadrics")
    parser.add_argument("--paths", type=int, default=1000, help="worlds searched for jumps of R_a")
    parser.add_argument("--swarms", type=int, default=3, help="of each size")
    parser.add_argument("--world", type=int, help="fly this world alone")
    parser.add_argument("--workers", type=int, default=multiprocessing.cpu_count())
    return parser.parse_args()


def print_starts(seed: int, count: int, gains: PaperGains) -> None:
    """Convergence to goal and direction, and the decay of the attitude error."""
    firsts = range(0, count, CHUNK)
    chunks = [fly_starts((seed, first), min(CHUNK, count - first), gains) for first in firsts]
    stand, heading, decay = map(np.concatenate, zip(*chunks, strict=True))
    print(f"\n{count} random starts in free space, any attitude")
    row("at the goal", f"{stand.sum()}, within {NEAR:g} m")
    row("direction error [deg]", spread_of(heading / DEG))
    row("| e(t) - e(0) exp(-k_w t) | [deg]", spread_of(decay / DEG))


def fly_starts(seed: tuple[int, int], count: int, gains: PaperGains) -> tuple[Rows, Rows, Rows]:
    """Who arrived, direction errors [rad], and largest deviations from Lemma 4 [rad], (N,) each."""
    goals, start = starts_in_free_space(seed, count)
    flight = fly(goals, start, NOTHING, None, LONGEST, gains, NEAR)
    steps = min(len(flight.p_n), round(DECAYED / (gains.k_w * gains.dt)))
    path = zip(flight.p_n[:steps], flight.R_nb[:steps], strict=True)
    errors: Vectors = np.array([attitude_errors(goals, p_n, R_nb) for p_n, R_nb in path])
    decay = np.exp(-gains.k_w * gains.dt * np.arange(steps))[:, None]
    return flight.standing, flight.headings(goals), np.abs(errors - decay * errors[0]).max(axis=0)


def attitude_errors(goals: Rows, p_n: Rows, R_nb: Rows) -> Rows:
    """Angles between R and R_a, (N,) [rad]."""
    robots = np.hstack([p_n, np.zeros_like(p_n)])
    R_na = fields_of_robots(goals, robots, 0.0, NOTHING, None).R_na
    return Rotation.from_matrix(np.swapaxes(R_nb, 1, 2) @ R_na).magnitude()


def print_worlds(options: argparse.Namespace, gains: PaperGains) -> None:
    """Flights through random worlds that respect the assumptions."""
    job = partial(fly_world, options.seed, gains, options.paths)
    with multiprocessing.Pool(options.workers) as pool:
        outcomes = pool.map(job, range(options.worlds), chunksize=10)
    inside = [each.number for each in outcomes if each.level <= 1.0]
    print(f"\n{options.worlds} worlds of 3 to 8 static superquadrics, one robot of any attitude")
    lost = [each.number for each in outcomes if not each.reached]
    row("not at the goal", f"{len(lost)}, in worlds {lost}")
    row("direction error [deg]", spread_of([each.heading / DEG for each in outcomes]))
    row("least U", f"{min(each.level for each in outcomes):.4f}")
    row("penetrations", f"{len(inside)}, in worlds {inside}")
    jumps = [each.jumps for each in outcomes if each.jumps is not None]
    total = FrameJumps(*(sum(column) for column in zip(*jumps, strict=True)))
    print(f"R_a along the paths through the first {len(jumps)}")
    row("steps that turn unlike Omega_a", f"{total.suspect}, looked into")
    row("jumps where chi is zero", f"{total.at_chi_zero}, n . G changes its sign")
    row("jumps on the goal's axis", f"{total.at_axis}")
    row("jumps elsewhere", f"{total.elsewhere}")


def fly_world(seed: int, gains: PaperGains, paths: int, number: int) -> Outcome:
    """The flight through one world; jumps of R_a are counted in worlds numbered below `paths`."""
    world = random_world(seed, number)
    flight = fly(world.goals, world.start, world.obstacles, None, LONGEST, gains)
    (p_n,) = np.swapaxes(flight.p_n, 0, 1)
    watched = number < paths
    goal = goal_of(world.goals)
    jumps = count_jumps(goal, world.obstacles, p_n, gains.dt) if watched else None
    level = float(level_at(p_n, world.obstacles).min())
    (heading,), (stands,) = flight.headings(world.goals), flight.standing
    return Outcome(number, bool(stands), float(heading), level, jumps)


def goal_of(goals: Rows) -> GoalFrame:
    """The goal of a world with one robot."""
    (row,) = goals
    return read_goal(row)


def print_swarm(seed: int, count: int, gains: PaperGains) -> None:
    """One swarm, and how many of its pairs came within 2 r_c."""
    apart = 2.0 * SPACING.safety_radius
    goals, start = random_swarm(seed, count, 1.1 * SPACING.detection_range)
    flight = fly(goals, start, NOTHING, SPACING, LONGEST, gains)
    pairs, nearest = violations(flight.p_n, apart)
    hit = set(itertools.chain(*pairs))
    print(
        f"\nswarm of {count}, seed {seed}, r_c {apart / 2.0:g} m, r_d {SPACING.detection_range:g} m"
    )
    row("at the goal", f"{flight.standing.sum()}, after {gains.dt * (len(flight.p_n) - 1):.1f} s")
    row("pairs within 2 r_c", f"{len(pairs)} of {count * (count - 1) // 2}, {len(hit)} robots")
    row("least distance", f"{nearest:.2f} m")


def row(label: str, text: str) -> None:
    """Print a line of a table."""
    print(f"  {label:<34} {text}")


def spread_of(values: Sequence[float] | Rows) -> str:
    """Median, 99th percentile and greatest value, in words."""
    median, high, most = np.quantile(np.asarray(values), (0.5, 0.99, 1.0))
    return f"median {median:.4f}, 99 % {high:.4f}, most {most:.4f}"


def violations(path: Rows, apart: float) -> tuple[set[tuple[int, int]], float]:
    """Pairs of a path (T, N, 3) that came within `apart` [m], and the least distance [m]."""
    pairs: set[tuple[int, int]] = set()
    nearest = math.inf
    for p_n in path:
        tree = KDTree(p_n)
        pairs |= tree.query_pairs(apart)
        distances, _ = tree.query(p_n, k=[2])  # each is its own nearest
        nearest = min(nearest, float(np.min(distances)))
    return pairs, nearest


if __name__ == "__main__":
    main()
