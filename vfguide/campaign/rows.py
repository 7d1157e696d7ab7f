"""The row of a flight in the table of a campaign: what was drawn, and how the flight went."""

from collections.abc import Iterable
from dataclasses import asdict, dataclass
from typing import Any, Literal, NamedTuple

from vfguide.campaign.draws import Draw
from vfguide.results.result import Range, Result, VehicleResult


@dataclass(frozen=True)
class FlightRow:
    """One flight; figures of several goals, obstacles or vehicles are the worst of them.

    They are those of `result.json`, and None where there is none, as of a flight that failed.
    """

    index: int
    """Number of the flight in the campaign, from 0."""
    seed: int
    """Seed of its scenario."""
    verdict: Literal["good", "bad", "failed"]
    """Failed: it could not be flown to its end."""
    reasons: tuple[str, ...]
    worker: str
    """Who flew it."""
    processor: str
    """Kind of its processor; the bytes of a flight are the same on one kind only."""
    reached: bool = False
    """Whether every goal was reached."""
    goals_reached: int = 0
    miss_m: float | None = None
    course_error_deg: float | None = None
    climb_error_deg: float | None = None
    min_clearance_m: float | None = None
    fence_clearance_m: float | None = None
    min_separation_m: float | None = None
    max_bank_deg: float | None = None
    load_factor_least: float | None = None
    load_factor_most: float | None = None
    airspeed_least_mps: float | None = None
    airspeed_most_mps: float | None = None
    altitude_least_m: float | None = None
    altitude_most_m: float | None = None
    sim_s: float | None = None
    wall_s: float | None = None
    realtime_factor: float | None = None
    vehicles: tuple[VehicleResult, ...] = ()
    """What `result.json` says of each vehicle."""


def row_of(draw: Draw, result: Result, worker: str, processor: str) -> FlightRow:
    """The row of a flight that was judged."""
    vehicles = result.vehicles
    goals = [goal for vehicle in vehicles for goal in vehicle.goals]
    obstacles = [obstacle for vehicle in vehicles for obstacle in vehicle.obstacles]
    load_factor = span(vehicle.load_factor for vehicle in vehicles)
    airspeed = span(vehicle.airspeed_mps for vehicle in vehicles)
    altitude = span(vehicle.altitude_m for vehicle in vehicles)
    return FlightRow(
        index=draw.index,
        seed=draw.seed,
        verdict=result.verdict,
        reasons=result.reasons,
        reached=all(goal.reached for goal in goals),
        goals_reached=sum(goal.reached for goal in goals),
        miss_m=largest(goal.miss_m for goal in goals),
        course_error_deg=largest(goal.course_error_deg for goal in goals),
        climb_error_deg=largest(goal.climb_error_deg for goal in goals),
        min_clearance_m=least(obstacle.min_clearance_m for obstacle in obstacles),
        fence_clearance_m=least(vehicle.fence_clearance_m for vehicle in vehicles),
        min_separation_m=result.min_separation_m,
        max_bank_deg=largest(vehicle.max_bank_deg for vehicle in vehicles),
        load_factor_least=load_factor.least,
        load_factor_most=load_factor.most,
        airspeed_least_mps=airspeed.least,
        airspeed_most_mps=airspeed.most,
        altitude_least_m=altitude.least,
        altitude_most_m=altitude.most,
        sim_s=result.sim_s,
        wall_s=result.wall_s,
        realtime_factor=result.realtime_factor,
        worker=worker,
        processor=processor,
        vehicles=vehicles,
    )


def failed_row(draw: Draw, reason: str, worker: str, processor: str) -> FlightRow:
    """The row of a flight that could not be flown to its end, and why."""
    return FlightRow(draw.index, draw.seed, "failed", (reason,), worker, processor)


def columns_of(row: FlightRow, draw: Draw, command: str) -> dict[str, Any]:
    """The row with its column names, those of what was drawn and of the command among them."""
    return {**asdict(row), "command": command, **dict(draw.values)}


class Span(NamedTuple):
    """The least and the most of several ranges."""

    least: float | None
    most: float | None


def span(ranges: Iterable[Range]) -> Span:
    """The least and the most of all ranges."""
    lows, highs = zip(*ranges, strict=True)
    return Span(least(lows), largest(highs))


def largest(values: Iterable[float | None]) -> float | None:
    """The largest value by its amount; None where there is none, or one is missing."""
    known = list(values)
    if not known or None in known:
        return None
    return max((value for value in known if value is not None), key=abs)


def least(values: Iterable[float | None]) -> float | None:
    """The least value; None where there is none, or one is missing."""
    known = list(values)
    if not known or None in known:
        return None
    return min(value for value in known if value is not None)
