#!/usr/bin/env python3
"""Flights with random lies on the link, judged by the truth, as a table.

    python tools/measure_altered.py --runs 100

Flight k of seed S is drawn from (S, k) alone: 60 s from a random start to the goal of the shipped
first flight, in calm air that moves with up to 0.45 of the airspeed. One to four lies are told:
wrong yaw, ground velocity, wind, airspeed or body rates, at once or as a ramp; messages that are
kept back, late, out of order, repeated or lost, up to a second of silence; a wrong counter or date,
answers to questions that nobody asked, heartbeats of a stranger under the autopilot's numbers.
Roll, pitch and position stay true. What must hold: bank 55 degrees, load factor 0 to
2.6, airspeed 1.1 x stall, 50 m of height, and no setpoint in a phase in which none may go out.
"""

import argparse
import tempfile
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from altered import fly_altered
from frame_lies import draw_lies, seeded, through

DURATION = 60.0
"""Longest time of a flight [s]; chosen."""
MOST_BANK, LOADS, MOST_LOST, STALL_RATIO = 55.0, (0.0, 2.6), 50.0, 1.1
"""Limits of bank [deg], load factor, height lost [m] and airspeed over that of the stall."""
STALL = 17.5
"""Stalling speed of the Aerosonde [m/s]."""


@dataclass(frozen=True)
class Outcome:
    """One flight."""

    number: int
    lies: tuple[str, ...]
    bank: float
    load: tuple[float, float]
    airspeed: float
    """Ratio of the least airspeed to that of the stall."""
    lost: float
    """Height lost below the lower one of start and goal [m]."""
    unpermitted: int
    """Number of setpoints in a phase in which none may go out."""
    reached: bool

    @property
    def is_inside(self) -> bool:
        """Whether everything holds that must hold."""
        return (
            self.bank <= MOST_BANK
            and LOADS[0] <= self.load[0]
            and self.load[1] <= LOADS[1]
            and self.airspeed >= STALL_RATIO
            and self.lost <= MOST_LOST
            and self.unpermitted == 0
        )


def fly(number: int, seed: int) -> Outcome:
    """One flight."""
    rng = seeded(seed, number)
    north, east, heading, toward = rng.uniform((-600, -600, 0, 0), (600, 600, 360, 360))
    lies = draw_lies(rng, 0.7 * DURATION)
    changes = (
        f"duration_s={DURATION}",
        f"vehicle.0.position_m=[{north:.1f}, {east:.1f}, -120.0]",
        f"vehicle.0.heading_deg={heading:.1f}",
        f"wind.speed_mps={rng.uniform(0.0, 0.45 * 25.0):.2f}",
        f"wind.from_deg={toward:.1f}",
    )
    told = list(lies.values())
    with tempfile.TemporaryDirectory() as folder:
        flight = fly_altered(Path(folder), lambda t, m: list(through(told, t, m)), *changes)
    return Outcome(
        number,
        tuple(sorted(lies)),
        flight.bank,
        flight.load,
        float(flight.record.airspeed.min()) / STALL,
        flight.lost,
        flight.unpermitted,
        flight.result.vehicles[0].goals[0].reached,
    )


def line_of(each: Outcome) -> str:
    """A flight as a line of the table."""
    load = f"{each.load[0]:5.2f} {each.load[1]:5.2f}"
    words = " + ".join(each.lies)
    figures = f"{each.bank:5.1f} {load} {each.airspeed:5.2f} {each.lost:6.1f} {each.unpermitted:3}"
    return f"{each.number:6} {figures}  {words}"


def main() -> None:
    """Fly, and print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=100)
    parser.add_argument("--first", type=int, default=0, help="number of the first flight")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--show", type=int, default=30, help="lines of the table")
    chosen = parser.parse_args()
    numbers = range(chosen.first, chosen.first + chosen.runs)
    with ProcessPoolExecutor(chosen.jobs) as pool:
        seen = list(pool.map(partial(fly, seed=chosen.seed), numbers, chunksize=8))
    outside = [each for each in seen if not each.is_inside]
    told = Counter(lie for each in outside for lie in each.lies)
    print(f"{len(seen)} flights, {len(outside)} outside, {sum(s.reached for s in seen)} reached")
    print(f"lies of those outside: {dict(told.most_common())}")
    print(f"{sum(s.unpermitted for s in seen)} setpoints in a phase in which none may go out")
    print("flight  bank  load factor  airspeed  lost  setpoints  lies")
    worst = sorted(outside, key=lambda each: (-each.lost, each.load[0]))
    print("\n".join(line_of(each) for each in worst[: chosen.show]))
    inside = [each.load for each in seen if each.is_inside]
    print(f"load factor of the others: {np.min(inside):.2f} to {np.max(inside):.2f}")


if __name__ == "__main__":
    main()
