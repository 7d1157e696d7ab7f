#!/usr/bin/env python3
"""Flights among obstacles in random worlds, over MAVLink on JSBSim, judged by the truth.

    python tools/measure_avoidance.py --kind field --runs 100
    python tools/measure_avoidance.py --kind popup --runs 100 --tree near
    python tools/measure_avoidance.py --kind movers --only 12 --out /tmp/flight

World k of a kind is drawn from (seed, k) alone. Half of them have moderate turbulence; the wind
is 0 to 8 m/s. Where something was hit, a tree of all hard manoeuvres tells whether it could be
missed from the moment at which it became known.
"""

import argparse
import math
import shutil
import tempfile
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
import tomli_w
from dubins import dubins_length
from flown_escapes import best_possible
from flown_worlds import DRAWN, Table, fenced, scenario_of
from reference_path import HEIGHT, MISSING, is_installed, reference_length
from search_worlds import World

from vfguide.aircraft.envelope import turn_radius
from vfguide.field.obstacle import PlacedObstacle
from vfguide.geometry.se2 import Pose
from vfguide.kernels.rows import place
from vfguide.preflight.load import load_scenario
from vfguide.results.fence_distance import fence_clearance
from vfguide.results.field_share import FieldResult
from vfguide.results.judge import judge
from vfguide.results.record import FlightRecord
from vfguide.results.verdict import TOUCH
from vfguide.runs.lockstep import fly_scenario
from vfguide.runs.steps import STEPS, Steps
from vfguide.scenario.loaded import LoadedScenario
from vfguide.scenario.obstacles import rows_of

TREE = {"hit": 0.0, "near": 12.0, "all": math.inf, "none": -math.inf}
"""Clearance up to which the tree is asked [m], by the names of the option."""
CLOSE = 5.0
"""Where the tree finds no escape, the largest depth below its best that is allowed [m]; chosen."""


@dataclass(frozen=True)
class Outcome:
    """One flight."""

    number: int
    reached: bool
    miss_m: float
    angle_deg: float
    clearance_m: float
    """Least clearance from obstacles, other aircraft, the fence and the ground."""
    time_s: float
    wall_s: float
    acting: float
    """Share of the setpoints that the assurance chose."""
    length_m: float
    """Length of the path to the goal."""
    reference_m: float
    """Length of the shortest path by BIT*; infinite: it finds none, NaN: not asked for."""
    free_m: float
    """Length of the shortest path without obstacles, by Dubins."""
    best_m: float
    """Least clearance that was possible by the tree; NaN where it was not asked for."""
    reasons: tuple[str, ...]
    field: FieldResult | None = None
    """What law field followed; None: another law was flown."""

    @property
    def meets(self) -> bool:
        """Whether the goal was reached within 5 m and 5 deg."""
        return self.reached and self.miss_m <= 5.0 and self.angle_deg <= 5.0

    @property
    def hits(self) -> bool:
        """Whether an obstacle, a volume, the fence or the ground was entered."""
        return self.clearance_m <= 0.0

    @property
    def allowed(self) -> bool:
        """Whether nothing was entered, or nothing that was avoidable, by the tree and CLOSE."""
        return not self.hits or (self.best_m <= 0.0 and self.clearance_m >= self.best_m - CLOSE)


def fly(number: int, args: argparse.Namespace) -> Outcome:
    """Fly one world of a kind; all have a fence, a floor and a ceiling."""
    return fly_table(fenced(scenario_of(args.kind, args.seed, number)), number, args)


def fly_table(table: Table, number: int, args: argparse.Namespace, steps: Steps = STEPS) -> Outcome:
    """Fly the world of a scenario table."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        path = folder / "world.toml"
        path.write_text(tomli_w.dumps(table))
        loaded = load_scenario(path, args.set)
        flight = fly_scenario(loaded, folder, steps=steps)
        if args.out is not None:
            shutil.copy(path, args.out)
    record = flight.records[0]
    result = judge(loaded.scenario, flight.records, flight.sim_s, flight.wall_s)
    vehicle = result.vehicles[0]
    goal = vehicle.goals[0]
    clearances = [each.min_clearance_m for each in (*vehicle.obstacles, *vehicle.traffic)]
    clearances.append(fence_clearance(loaded.scenario, record.p_n))
    if loaded.scenario.plant == "jsbsim":
        clearances.append(float(record.height_above_ground.min()) - TOUCH)
    clearance = min((c for c in clearances if c is not None), default=math.inf)
    asks = clearance <= TREE[args.tree]
    return Outcome(
        number,
        goal.reached,
        np.inf if goal.miss_m is None else goal.miss_m,
        max(abs(goal.course_error_deg or 0.0), abs(goal.climb_error_deg or 0.0)),
        clearance,
        goal.time_s or np.nan,
        flight.wall_s,
        0.0 if record.decisions is None else float(np.mean(record.decisions.reason > 0.0)),
        flown_length(record, goal.time_s),
        reference(loaded, number, args) if args.reference_s > 0.0 else np.nan,
        free_length(loaded),
        best_possible(loaded, record) if asks else np.nan,
        result.reasons,
        result.vehicles[0].field,
    )


def flown_length(record: FlightRecord, until: float | None) -> float:
    """Length of the path to the goal [m]."""
    flown = record.p_n[record.time <= (until or np.inf)]
    return float(np.linalg.norm(np.diff(flown, axis=0), axis=1).sum())


def reference(loaded: LoadedScenario, number: int, args: argparse.Namespace) -> float:
    """Shortest path at the goal's height with 5 m of clearance [m].

    Its turns are those in still air, or those that can be flown over the ground on any course.
    """
    goal, rows = loaded.scenario.vehicles[0].goals[0], rows_of(loaded.scenario.obstacles)
    rows[:, place(PlacedObstacle, "p_n.2")] -= goal.position_m[2] + HEIGHT
    wind = loaded.scenario.wind.speed_mps if args.reference_in_wind else 0.0
    start, end, radius = ends_between(loaded, wind)
    world = World("flown", start, end, rows)
    return reference_length(world, radius, 5.0, args.reference_s, number)


def free_length(loaded: LoadedScenario) -> float:
    """Shortest path in the plane with turns in still air, without obstacles [m]."""
    start, end, radius = ends_between(loaded, 0.0)
    return dubins_length(tuple(start)[:3], tuple(end)[:3], radius)


def ends_between(loaded: LoadedScenario, wind: float) -> tuple[Pose, Pose, float]:
    """Start and goal in the plane, and the radius of turns [m] in a wind of a speed [m/s]."""
    vehicle = loaded.scenario.vehicles[0]
    goal, gains = vehicle.goals[0], loaded.gains(vehicle)
    start = Pose(*vehicle.position_m[:2], math.radians(vehicle.euler_deg[2]))
    end = Pose(*goal.position_m[:2], math.radians(goal.heading_deg))
    return start, end, turn_radius(gains.airspeed, wind, gains.bank_max, 1.0)


def show(outcomes: Sequence[Outcome], args: argparse.Namespace) -> None:
    """Print the row of the table, and the worst flights."""
    n = len(outcomes)
    within = [
        sum(o.reached and o.miss_m <= miss and o.angle_deg <= angle for o in outcomes)
        for miss, angle in ((5.0, 5.0), (2.0, 3.0))
    ]
    hit = [o for o in outcomes if o.hits]
    print(f"{args.kind}: seed {args.seed}, {n} worlds")
    print(f"penetrations {len(hit)}, least clearance {min(o.clearance_m for o in outcomes):.2f} m")
    if hit:
        none = [o for o in hit if o.best_m <= 0.0]
        close = sum(o.allowed for o in none)
        print(f"  of these without an escape {len(none)}, as deep as the best but 5 m {close}")
    print(f"reached within 5 m, 5 deg {within[0]} ({100.0 * within[0] / n:.1f} %)")
    print(f"reached within 2 m, 3 deg {within[1]} ({100.0 * within[1] / n:.1f} %)")
    print(f"time [s] median {np.nanmedian([o.time_s for o in outcomes]):.1f}")
    print(f"assurance acting [%] mean {100.0 * np.mean([o.acting for o in outcomes]):.2f}")
    over = [o.length_m / o.reference_m for o in outcomes if o.reached and o.reference_m < np.inf]
    if over:
        median, high, most = np.quantile(over, (0.5, 0.9, 1.0))
        print(
            f"length over BIT* median {median:.3f}, 90 % {high:.3f}, most {most:.3f} ({len(over)})"
        )
    print(f"wall time of a flight [s] mean {np.mean([o.wall_s for o in outcomes]):.2f}")
    show_failures(outcomes)


def show_failures(outcomes: Sequence[Outcome]) -> None:
    """Print the flights in which something was hit or the goal was not reached."""
    for o in outcomes:
        if o.hits or not o.meets:
            print(
                f"  world {o.number}: reached {o.reached}, miss {o.miss_m:.2f} m,"
                f" {o.angle_deg:.2f} deg, clearance {o.clearance_m:.2f} m, best {o.best_m:.2f} m,"
                f" acting {100.0 * o.acting:.1f} %: {'; '.join(o.reasons)}"
            )


def main() -> None:
    """Fly all worlds and print the table."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--kind", choices=list(DRAWN), default="field")
    parser.add_argument("--runs", type=int, default=100)
    parser.add_argument("--first", type=int, default=0, help="number of the first world")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="fly this world alone")
    parser.add_argument("--out", type=Path, help="folder for its scenario")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--reference-s", type=float, default=0.0, help="given to BIT* (ompl)")
    parser.add_argument(
        "--reference-in-wind", action="store_true", help="turns of BIT* as wide as downwind"
    )
    parser.add_argument(
        "--tree", choices=list(TREE), default="hit", help="flights that the manoeuvre tree judges"
    )
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    args = parser.parse_args()
    if args.reference_s > 0.0 and not is_installed():
        parser.error(MISSING)
    numbers = [args.only] if args.only is not None else range(args.first, args.first + args.runs)
    with ProcessPoolExecutor(args.workers) as pool:
        show(list(pool.map(partial(fly, args=args), numbers)), args)


if __name__ == "__main__":
    main()
