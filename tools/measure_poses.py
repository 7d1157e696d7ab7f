#!/usr/bin/env python3
"""Random starts to one goal pose, flown over MAVLink and judged by the truth.

    python tools/measure_poses.py --runs 100 --wind 5
    python tools/measure_poses.py --runs 50 --aircraft easystar --wind 3.7

Start k of seed S is drawn from (S, k) alone: any row can be flown alone with --only K.

Lengths are drawn in turn radii R = V^2 / (g tan bank), with the cruise and the largest bank of the
aircraft's file, so that every aircraft gets the same geometry: as many as make 100 to 1000 m of
distance and 30 m of height for the Aerosonde (R = 53.5 m). The goal is 150 m above the ground,
or higher by the same ratio.
"""

import argparse
import math
import tempfile
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path

import numpy as np
from dubins import dubins_length

from vfguide.aircraft.envelope import turn_radius
from vfguide.files.aircraft_file import Aircraft, load_aircraft
from vfguide.files.data import find_aircraft, find_scenario
from vfguide.preflight.load import load_scenario
from vfguide.results.judge import judge
from vfguide.results.record import FlightRecord
from vfguide.runs.lockstep import fly_scenario
from vfguide.runs.models import model_of
from vfguide.scenario.loaded import LoadedScenario
from vfguide.sim.bench import Bench
from vfguide.sim.trim import TrimError, trim

FIRST = "first-flight"
GOAL_HEIGHT = 150.0
"""Height of the goal above the ground [m], or more for large aircraft; chosen."""
HEADING_DEG = 30.0
SMOOTHED_S = 5.0
"""Time over which the true wind is smoothed before an estimate is compared with it [s]; chosen."""
MOST_COURSE_DEG, MOST_BANK_DEG, LOADS, MARGIN, MOST_BELOW = 3.0, 55.0, (0.3, 2.2), 1.2, 50.0
"""Limits: course error and bank [deg], load factor, airspeed over that of the stall, depth [m]."""


@dataclass(frozen=True)
class Frame:
    """The scale of random starts for one aircraft."""

    changes: tuple[str, ...]
    """Overrides that put the aircraft into the scenario."""
    airspeed: float
    """True airspeed of cruise [m/s]."""
    radius: float
    """The turn radius R to which lengths are scaled [m]."""
    scale: float
    """Ratio of R to that of the Aerosonde."""
    stall: float
    """True airspeed of the slowest level flight at the goal's altitude, the 1-g stall [m/s]."""
    goal: tuple[float, float, float]
    """Position of the goal, NED [m]."""

    @property
    def most_miss(self) -> float:
        """Largest miss that is allowed: 2 % of the turn radius, and half a metre [m]."""
        return 0.02 * self.radius + 0.5


@cache
def frame_of(name: str, scenario: str = FIRST) -> Frame:
    """The frame of an aircraft, found as the scenario finds it."""
    aircraft = load_aircraft(find_aircraft(name, find_scenario(scenario)))
    radius = cruise_radius(aircraft)
    scale = radius / cruise_radius(load_aircraft(find_aircraft("aerosonde")))
    height = GOAL_HEIGHT * max(1.0, scale)
    cruise = aircraft.airspeed.cruise_mps
    changes = (f'vehicle.0.aircraft="{name}"', f"vehicle.0.airspeed_mps={cruise}")
    loaded = load_scenario(scenario, changes)
    bench = Bench(model_of(loaded, name), loaded.scenario.origin.altitude_m + height)
    goal = (0.0, 0.0, -round(height, 3))
    return Frame(changes, cruise, radius, scale, slowest(bench, cruise), goal)


def cruise_radius(aircraft: Aircraft) -> float:
    """Radius of a level turn in still air at cruise and the largest bank [m]."""
    bank = math.radians(aircraft.limits.bank_max_deg)
    return turn_radius(aircraft.airspeed.cruise_mps, 0.0, bank, 1.0)


def slowest(bench: Bench, cruise: float) -> float:
    """Slowest airspeed at which the model flies level [m/s], to 0.05 m/s."""
    low, high = 0.2 * cruise, cruise
    while high - low > 0.05:
        middle = 0.5 * (low + high)
        try:
            trim(bench, middle)
            high = middle
        except TrimError:
            low = middle
    return high


@dataclass(frozen=True)
class Outcome:
    """One flight."""

    number: int
    changes: tuple[str, ...]
    reached: bool
    passes: int
    time_s: float
    miss_m: float
    course_deg: float
    climb_deg: float
    bank_deg: float
    load: tuple[float, float]
    airspeed: tuple[float, float]
    length: float
    """Ratio of the length of the path to the goal to the reference."""
    circles: float
    """Number of circles of the reference by which the path is longer."""
    error_m: float
    """Error of the position that guidance was given, at the pass."""
    beyond_m: float
    """Distance of that position from the goal: the miss that its error does not explain."""
    wind_sigmas: float
    """99 % quantile of the estimated wind less the smoothed true one, in standard deviations."""
    wind_mps: float
    """Median error of the estimated wind."""
    speed_mps: float
    """Median error of the estimated airspeed."""
    below_m: float
    """Greatest depth below the lower one of start and goal."""
    rate_hz: float


def draw(seed: int, number: int, args: argparse.Namespace) -> tuple[str, ...]:
    """The changes to the scenario that make one random start."""
    rng = np.random.default_rng([seed, number])
    frame = frame_of(args.aircraft, args.scenario)
    scale = frame.scale
    distance = scale * rng.uniform(args.nearest, args.farthest)
    bearing, heading, wind_from = rng.uniform(0.0, 360.0, 3)
    height = scale * rng.uniform(-args.height, args.height)
    north = distance * math.cos(math.radians(bearing))
    east = distance * math.sin(math.radians(bearing))
    return (
        *frame.changes,
        f"vehicle.0.position_m=[{north:.3f}, {east:.3f}, {frame.goal[2] + height:.3f}]",
        f"vehicle.0.heading_deg={heading:.3f}",
        f"wind.from_deg={wind_from:.3f}",
        f"wind.speed_mps={args.wind}",
        f'wind.turbulence="{args.turbulence}"',
        f"vehicle.0.goal.0.position_m={list(frame.goal)}",
        f"vehicle.0.goal.0.heading_deg={HEADING_DEG}",
        f"seed={number + 1}",
        f"duration_s={300.0 * max(1.0, scale):.0f}",
        f"link.delay_ms={args.delay_ms}",
        *(["sensors={}"] if args.sensors else []),
        *(["autopilot.wind_message=false"] if args.no_wind_message else []),
        *(["autopilot.airspeed_fails_at_s=0"] if args.no_airspeed else []),
        *args.set,
    )


def fly(number: int, args: argparse.Namespace) -> Outcome:
    """Fly one start."""
    changes = draw(args.seed, number, args)
    loaded = load_scenario(args.scenario, changes)
    with tempfile.TemporaryDirectory() as folder:
        flight = fly_scenario(loaded, Path(folder))
    result = judge(loaded.scenario, flight.records, flight.sim_s, flight.wall_s)
    vehicle, record = result.vehicles[0], flight.records[0]
    goal = vehicle.goals[0]
    lowest = max(record.p_n[0, 2], loaded.scenario.vehicles[0].goals[0].position_m[2])
    nan = math.nan
    return Outcome(
        number,
        changes,
        goal.reached,
        len(record.legs().passes[0]),
        goal.time_s if goal.time_s is not None else nan,
        goal.miss_m if goal.miss_m is not None else nan,
        goal.course_error_deg if goal.course_error_deg is not None else nan,
        goal.climb_error_deg if goal.climb_error_deg is not None else nan,
        vehicle.max_bank_deg or nan,
        (vehicle.load_factor[0] or nan, vehicle.load_factor[1] or nan),
        (vehicle.airspeed_mps[0] or nan, vehicle.airspeed_mps[1] or nan),
        *over_reference(loaded, record, goal.time_s),
        *beyond(record, goal.time_s, frame_of(args.aircraft, args.scenario).goal),
        *believed(record),
        float(record.p_n[:, 2].max() - lowest),
        vehicle.setpoint_rate_hz or nan,
    )


def beyond(record: FlightRecord, time: float | None, goal: Sequence[float]) -> tuple[float, float]:
    """Error of the position given to guidance at the pass, and that position's miss [m]."""
    if time is None or record.position_error_n is None:
        return math.nan, math.nan
    columns = np.hstack((record.p_n, record.position_error_n)).T
    p_n, error = np.split(np.array([np.interp(time, record.time, each) for each in columns]), 2)
    # Between samples the path bends: only the plane across it counts.
    along = np.array([np.interp(time, record.time, each) for each in record.v_n.T])
    along /= np.linalg.norm(along)
    off = p_n + error - np.array(goal)
    return float(np.linalg.norm(error)), float(np.linalg.norm(off - along * (off @ along)))


def believed(record: FlightRecord) -> tuple[float, float, float]:
    """Errors of estimates: wind in deviations (99 %) and m/s (median), airspeed in m/s (median)."""
    if (air := record.air) is None:
        return math.nan, math.nan, math.nan
    steps = max(1, round(SMOOTHED_S / (record.time[1] - record.time[0])))
    weights = np.ones(steps) / steps
    wind = np.column_stack(
        [np.convolve(each, weights)[: len(each)] for each in record.wind_n.T[:2]]
    )
    late = slice(steps, None)
    believed = np.column_stack((air.wind_north, air.wind_east))[late]
    error = np.abs(believed - wind[late]).max(axis=1)
    sigma = air.wind_sigma[late]
    known = sigma > 0.0
    if not known.any():
        return math.nan, math.nan, math.nan
    speed = np.abs(air.airspeed[late] - record.airspeed[late])[known]
    deviations = np.quantile(error[known] / sigma[known], 0.99)
    return float(deviations), float(np.median(error[known])), float(np.median(speed))


def over_reference(
    loaded: LoadedScenario, record: FlightRecord, time: float | None
) -> tuple[float, float]:
    """The path until `time` [s] against the longer of Dubins' and what the height needs.

    Returns its ratio, and by how many circles of the reference it is longer.
    """
    if time is None:
        return math.nan, math.nan
    vehicle = loaded.scenario.vehicles[0]
    speed, performance = loaded.scenario.airspeed_of(vehicle), loaded.performance(vehicle)
    radius = turn_radius(speed, 0.0, performance.bank_max, 1.0)
    start, goal = record.p_n[0], vehicle.goals[0]
    level = dubins_length(
        (start[0], start[1], math.radians(vehicle.euler_deg[2])),
        (*goal.position_m[:2], math.radians(goal.heading_deg)),
        radius,
    )
    climb = float(start[2]) - goal.position_m[2]
    steepest = performance.climb_max if climb > 0.0 else performance.descent_max
    reference = max(level, abs(climb) / math.tan(steepest))
    steps = np.diff(record.p_n[record.time <= time], axis=0)
    flown = float(np.linalg.norm(steps, axis=1).sum())
    return flown / reference, (flown - reference) / (2.0 * math.pi * radius)


def spread(values: list[float]) -> str:
    """Median, 95th percentile and greatest of some values, in words."""
    known = np.array([value for value in values if math.isfinite(value)])
    if not known.size:
        return "none"
    median, most_of_them = np.quantile(known, (0.5, 0.95))
    return f"median {median:.3f}  95 % {most_of_them:.3f}  most {known.max():.3f}"


def show(outcomes: list[Outcome], args: argparse.Namespace) -> None:
    """Print the table."""
    reached = sum(outcome.reached for outcome in outcomes)
    frame = frame_of(args.aircraft, args.scenario)
    near, far, height = (frame.scale * size for size in (args.nearest, args.farthest, args.height))
    print(f"{args.aircraft} at {frame.airspeed:g} m/s, turn radius {frame.radius:.1f} m")
    print(f"seed {args.seed}, {len(outcomes)} starts, {near:.4g} to {far:.4g} m away, ")
    print(f"height +-{height:.3g} m, wind {args.wind:g} m/s, turbulence {args.turbulence}")
    print(f"reached     {reached} of {len(outcomes)}")
    print(f"miss [m]    {spread([o.miss_m for o in outcomes])}")
    if any(o.error_m > 0.0 for o in outcomes):
        print(f"  error of the given position {spread([o.error_m for o in outcomes])}")
        print(f"  miss beyond it {spread([o.beyond_m for o in outcomes])}")
        print(f"  miss less it   {spread([max(0.0, o.miss_m - o.error_m) for o in outcomes])}")
    print(f"wind error [m/s] {spread([o.wind_mps for o in outcomes])}")
    print(f"  in deviations {spread([o.wind_sigmas for o in outcomes])}")
    print(f"airspeed error [m/s] {spread([o.speed_mps for o in outcomes])}")
    print(f"course [deg] {spread([o.course_deg for o in outcomes])}")
    print(f"climb [deg] {spread([o.climb_deg for o in outcomes])}")
    print(f"time [s]    {spread([o.time_s for o in outcomes])}")
    print(f"length / reference {spread([o.length for o in outcomes])}")
    print(f"  circles above it {spread([o.circles for o in outcomes])}")
    print(f"  more than one: {sum(o.circles > 1.0 for o in outcomes)}")
    print(f"bank [deg]  most {max(o.bank_deg for o in outcomes):.1f}")
    least, most = min(o.load[0] for o in outcomes), max(o.load[1] for o in outcomes)
    print(f"load factor {least:.2f} to {most:.2f}")
    least, most = min(o.airspeed[0] for o in outcomes), max(o.airspeed[1] for o in outcomes)
    print(f"airspeed    {least:.1f} to {most:.1f} m/s, least {least / frame.stall:.2f} x stall")
    print(f"below the lower of start and goal: most {max(o.below_m for o in outcomes):.1f} m")
    print(f"setpoints   {min(o.rate_hz for o in outcomes):.2f} Hz at least")
    print(f"more than one pass: {sum(o.passes > 1 for o in outcomes)}")
    show_row(outcomes, frame)
    worst = sorted(outcomes, key=lambda o: (o.reached, -o.miss_m))[: args.worst]
    for o in worst:
        print(
            f"  start {o.number}: reached {o.reached} passes {o.passes} time {o.time_s:.1f} "
            f"length {o.length:.2f} miss {o.miss_m:.3f} course {o.course_deg:.2f} "
            f"climb {o.climb_deg:.2f} bank {o.bank_deg:.0f} n {o.load[0]:.2f}..{o.load[1]:.2f} "
            f"below {o.below_m:.1f}"
        )


def show_row(outcomes: list[Outcome], frame: Frame) -> None:
    """Print for each limit the number of starts in which it does not hold."""
    broken = {
        "not reached": sum(not o.reached for o in outcomes),
        f"miss above {frame.most_miss:.2f} m": sum(
            not o.miss_m <= frame.most_miss for o in outcomes
        ),
        f"course above {MOST_COURSE_DEG:g} deg": sum(
            not o.course_deg <= MOST_COURSE_DEG for o in outcomes
        ),
        f"bank above {MOST_BANK_DEG:g} deg": sum(o.bank_deg > MOST_BANK_DEG for o in outcomes),
        f"load factor outside {LOADS[0]:g} to {LOADS[1]:g}": sum(
            o.load[0] < LOADS[0] or o.load[1] > LOADS[1] for o in outcomes
        ),
        f"airspeed below {MARGIN:g} x {frame.stall:.1f} m/s": sum(
            o.airspeed[0] < MARGIN * frame.stall for o in outcomes
        ),
        f"more than {MOST_BELOW:g} m below": sum(o.below_m > MOST_BELOW for o in outcomes),
    }
    for what, count in broken.items():
        print(f"  {what}: {count} of {len(outcomes)}")
    print(f"the row {'does not hold' if any(broken.values()) else 'holds'}")


def main() -> None:
    """Fly all starts and print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--aircraft", default="aerosonde")
    parser.add_argument("--scenario", default=FIRST, help="beside it are aircraft of your own")
    parser.add_argument("--only", type=int, help="fly this start alone")
    parser.add_argument("--wind", type=float, default=0.0, help="[m/s]")
    parser.add_argument("--turbulence", default="none")
    parser.add_argument("--delay-ms", type=float, default=0.0, help="from autopilot to companion")
    parser.add_argument("--nearest", type=float, default=100.0, help="[m] for the Aerosonde")
    parser.add_argument("--farthest", type=float, default=1000.0, help="[m] for the Aerosonde")
    parser.add_argument("--height", type=float, default=30.0, help="[m] for the Aerosonde")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--worst", type=int, default=5)
    parser.add_argument("--sensors", action="store_true", help="errors of measurement")
    parser.add_argument("--no-wind-message", action="store_true", help="the wind is estimated")
    parser.add_argument("--no-airspeed", action="store_true", help="there is no airspeed sensor")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    args = parser.parse_args()
    if args.only is not None:
        numbers = [args.only]
        print(
            f"vfguide run {args.scenario} "
            + " ".join(f"--set '{c}'" for c in draw(args.seed, args.only, args))
        )
    else:
        numbers = list(range(args.runs))
    with ProcessPoolExecutor(args.workers) as pool:
        show(list(pool.map(partial(fly, args=args), numbers, chunksize=4)), args)


if __name__ == "__main__":
    main()
