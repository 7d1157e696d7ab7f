#!/usr/bin/env python3
"""The run-time assurance in closed loop with a point mass, behind the worst planner there is.

    python tools/measure_assurance.py --runs 300
    python tools/measure_assurance.py --kind popup --runs 1000 --seed 2
    python tools/measure_assurance.py --kind popup --only 144
    python tools/measure_assurance.py --cost

The command is a turn towards the goal whatever is in between. World k of a kind is drawn from
(seed, k) alone. The aircraft's lags are 15 % longer than the assurance believes. Worlds in which
nothing is clear at the start are counted apart. Where something was hit, a tree of all hard
manoeuvres tells whether it could be missed from each moment at which an obstacle came in sight.
"""

import argparse
import time
from dataclasses import dataclass

import numpy as np
from avoidance_flights import (
    LOGGED_WIDTH,
    Flown,
    Logged,
    fly,
    read_logged,
    repeat_decision,
    slowed,
)
from avoidance_worlds import DRAWN, TICK, World, draw_world
from manoeuvre_tree import best_escape

from vfguide.aircraft.performance import Gains
from vfguide.assurance.decision import Assurance, Reason, assurance
from vfguide.files.aircraft_file import load_aircraft
from vfguide.files.data import find_aircraft
from vfguide.kernels.rows import Table, columns

REPEATS = 20
ENOUGH = 5.0
"""Distance above which the tree looks for no larger one [m]; chosen."""


@dataclass(frozen=True)
class Outcome:
    """One world."""

    number: int
    without: Flown
    assured: Flown
    best: float
    """Least distance that was possible by the tree [m], where something was hit."""


def the_aircraft() -> Assurance:
    """The Aerosonde at 25 m/s."""
    aircraft = load_aircraft(find_aircraft("aerosonde")).performance()
    return assurance(aircraft, Gains(aircraft.airspeed_cruise))


def best_possible(world: World, log: Table, aircraft: Assurance) -> float:
    """The least, over all moments at which an obstacle is detected, of what the tree finds [m].

    It says nothing in worlds with obstacles that turn, since the tree takes them as going straight.
    """
    moments = [0, *(np.flatnonzero(np.diff(columns(Logged, log).known) > 0) + 1)]
    best = ENOUGH
    for k in moments:
        motion = read_logged(log[k]).motion
        limits = slowed(aircraft.limits)
        best = min(best, best_escape(world, world.rows, motion, k * TICK, limits, ENOUGH))
    return best


def try_world(kind: str, number: int, args: argparse.Namespace) -> Outcome:
    """Fly one world with and without the assurance."""
    world, aircraft = draw_world(kind, args.seed, number, args.duration), the_aircraft()
    log = np.zeros((round(args.duration / TICK), LOGGED_WIDTH))
    without = fly(world, aircraft, False, log)
    assured = fly(world, aircraft, True, log)
    hit = assured.least < 0.0 and not assured.unclear_start
    return Outcome(number, without, assured, best_possible(world, log, aircraft) if hit else ENOUGH)


def show(kind: str, outcomes: list[Outcome], args: argparse.Namespace) -> None:
    """Print one line of the table, and each world in which something was hit."""
    flown = [o for o in outcomes if not o.assured.unclear_start]
    hit = [o for o in flown if o.assured.least < 0.0]
    ticks = len(flown) * round(args.duration / TICK)
    print(
        f"{kind:10} {len(outcomes):6} {len(outcomes) - len(flown):8}"
        f" {sum(o.without.least < 0.0 for o in flown):8}"
        f" {len(hit):8} {sum(o.best <= 0.0 for o in hit):10}"
        f" {min(o.assured.least for o in flown):9.2f}"
        f" {100.0 * sum(o.assured.escapes for o in flown) / ticks:8.1f}"
        f" {100.0 * sum(o.assured.best_effort for o in flown) / ticks:8.2f}"
        f" {np.mean([o.assured.legs for o in flown]):8.2f}",
        flush=True,
    )
    for o in hit:
        a = o.assured
        print(
            f"  world {o.number}: {-a.least:.2f} m into {a.hazard} at {a.when:.2f} s,"
            f" the best possible {o.best:.2f} m"
        )


def show_cost(args: argparse.Namespace) -> None:
    """Print the processor time of decisions, at states along flights among 15 obstacles."""
    aircraft, took = the_aircraft(), list[float]()
    number = 0
    while len(took) < args.runs * 100:
        world, number = draw_world("static", args.seed, number, args.duration), number + 1
        if len(world.rows) != 15:
            continue
        log: Table = np.zeros((round(args.duration / TICK), LOGGED_WIDTH))
        fly(world, aircraft, True, log)
        repeat_decision(world, aircraft, log[0], 1)
        for row in log[::10]:
            began = time.process_time()
            repeat_decision(world, aircraft, row, 1)
            once = time.process_time()
            repeat_decision(world, aircraft, row, 1 + REPEATS)
            took.append((time.process_time() - once - (once - began)) / REPEATS * 1e6)
    median, high, most = np.quantile(took, (0.5, 0.99, 1.0))
    print(f"seed {args.seed}, {len(took)} decisions among 15 obstacles [us]:")
    print(f"median {median:.1f}  99 % {high:.1f}  most {most:.1f}")


def show_flight(kind: str, args: argparse.Namespace) -> None:
    """Print decisions of one flight, four a second, while the assurance acts."""
    world = draw_world(kind, args.seed, args.only, args.duration)
    log: Table = np.zeros((round(args.duration / TICK), LOGGED_WIDTH))
    print(fly(world, the_aircraft(), True, log))
    print("time, position, azimuth, bank, path angle | commands, reason, margin | distance, to")
    for row in log[:: round(0.25 / TICK)]:
        logged = read_logged(row)
        motion, decision = logged.motion, logged.decision
        if decision.reason != Reason.NOMINAL:
            at = (logged.time, *motion.p_n, motion.azimuth, motion.bank, motion.gamma)
            chosen = (decision.bank, decision.gamma, decision.reason, decision.margin)
            print(*(f"{x:.2f}" for x in at), "|", *(f"{x:.2f}" for x in chosen), end=" | ")
            print(f"{logged.distance:.2f} {logged.nearest}")


def main() -> None:
    """Fly all worlds and print the table."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--kind", choices=list(DRAWN), action="append", help="default: all")
    parser.add_argument("--runs", type=int, default=300, help="worlds of each kind")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="show the flight in this world")
    parser.add_argument("--duration", type=float, default=60.0, help="of a flight [s]")
    parser.add_argument("--cost", action="store_true", help="the time that a decision takes")
    args = parser.parse_args()
    if args.cost:
        show_cost(args)
        return
    kinds: list[str] = args.kind or list(DRAWN)
    if args.only is not None:
        show_flight(kinds[0], args)
        return
    print(f"seed {args.seed}, {args.runs} worlds of each kind, {args.duration:g} s, ticks in %")
    print(
        "kind       worlds no start  without     with  no escape"
        "     least   acting   nothing    legs"
    )
    for kind in kinds:
        show(kind, [try_world(kind, k, args) for k in range(args.runs)], args)


if __name__ == "__main__":
    main()
