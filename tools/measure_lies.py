#!/usr/bin/env python3
"""Random sequences of lies on the link, and what the aircraft does meanwhile, as a table.

    python tools/measure_lies.py --sequences 100000

Each sequence is 2 to 10 s of a point-mass aeroplane that the control loop flies to a pose in wind.
Roll, pitch and position stay true. Up to four lies begin and end at random times, at
once or as a ramp: a wrong yaw, ground velocity, wind, airspeed or body rate; wind or airspeed not
told; ground velocity and wind from up to 2 s ago; no frame at all for up to 1 s; each frame twice;
a leap of the clock by up to 2 s. The truth is judged: bank 55 degrees, load factor 0 to 2.6, 50 m
of height below start and goal. A sequence ends where roll or pitch are doubted, since nothing is
sent from then on. Printed are the sequences outside of the limits, by the lies in them.
"""

import argparse
import math
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from functools import partial

from lie_sequences import NAMES, Extremes, fly_sequences, random_lies

from vfguide.companion.plan import Plan
from vfguide.geometry.units import DEG
from vfguide.guidance.laws import Law, crossing
from vfguide.loop.legs import Goal, leg_rows
from vfguide.loop.state import fresh_state, row_of_state
from vfguide.preflight.load import load_scenario
from vfguide.scenario.plans import plan_of

BANK_LIMIT = 55.0 * DEG
"""Largest bank that is allowed [rad]; chosen."""
LOAD_LIMITS = (0.0, 2.6)
"""Least and largest load factor that are allowed, dimensionless; chosen."""
HEIGHT_LIMIT = 50.0
"""Largest depth below start and goal that is allowed [m]; chosen."""


def plan_for(aircraft: str) -> Plan:
    """The plan of the shipped first flight with an aircraft and a goal at the origin."""
    loaded = load_scenario("first-flight", (f"vehicle.0.aircraft={aircraft!r}",))
    return plan_of(loaded, loaded.scenario.vehicles[0])


def measure(first: int, number: int, aircraft: str) -> list[Extremes]:
    """The extremes of `number` sequences, from seed `first` on."""
    plan = plan_for(aircraft)
    goal = Goal((0.0, 0.0, -130.0), 90.0 * DEG, 0.0, 5.0, 10.0 * DEG)
    legs = leg_rows((goal,), plan.loiter_side, plan.loiter_radius)
    fresh = row_of_state(fresh_state(0))
    return fly_sequences(first, number, legs, law_for(plan), plan.vehicle_row, fresh, -130.0)


def law_for(plan: Plan) -> Law:
    """The law of a plan, as the step takes it."""
    return crossing(plan.law) or plan.law


def is_outside(seen: Extremes) -> bool:
    """Whether a sequence left the envelope."""
    least, most = LOAD_LIMITS
    return not (
        seen.bank <= BANK_LIMIT
        and seen.least_load >= least
        and seen.most_load <= most
        and seen.lost <= HEIGHT_LIMIT
        and seen.is_finite
    )


def lies_of(seed: int) -> str:
    """The lies of a sequence in words."""
    _, lies = random_lies(seed)
    return " + ".join(sorted(NAMES[lie.kind] for lie in lies if math.isfinite(lie.begin)))


def main() -> None:
    """Fly the sequences, and print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sequences", type=int, default=10_000)
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--aircraft", default="aerosonde")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--chunk", type=int, default=1000)
    parser.add_argument("--show", type=int, default=20, help="lines of each table")
    chosen = parser.parse_args()
    starts = range(chosen.first, chosen.first + chosen.sequences, chosen.chunk)
    flown = partial(measure, number=chosen.chunk, aircraft=chosen.aircraft)
    outside, seen = list[tuple[int, Extremes]](), list[Extremes]()
    with ProcessPoolExecutor(chosen.jobs) as pool:
        for start, found in zip(starts, pool.map(flown, starts), strict=True):
            seen += found
            outside += [(start + k, each) for k, each in enumerate(found) if is_outside(each)]
    silent = sum(math.isfinite(each.silent_from) for each in seen)
    print(f"{len(seen)} sequences, {len(outside)} outside, {silent} ended by a doubt")
    loads = min(s.least_load for s in seen), max(s.most_load for s in seen)
    bank, lost = max(each.bank for each in seen) / DEG, max(each.lost for each in seen)
    print(f"bank up to {bank:.1f} deg, load {loads[0]:.2f} to {loads[1]:.2f}, {lost:.0f} m lost")
    for lies, number in Counter(lies_of(seed) for seed, _ in outside).most_common(chosen.show):
        print(f"{number:6} {lies}")
    for seed, each in outside[: chosen.show]:
        load = f"{each.least_load:5.2f} {each.most_load:5.2f}"
        print(f"{seed:8} {each.bank / DEG:5.1f} {load} {each.lost:5.0f}  {lies_of(seed)}")


if __name__ == "__main__":
    main()
