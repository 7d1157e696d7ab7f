"""The result of a run: figures from the truth, and the verdict; `result.json`."""

import json
import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from itertools import combinations
from pathlib import Path
from typing import Literal

import numpy as np

from vfguide import __version__
from vfguide.annunciations.goal_announcement import GoalAnnouncement, Outcome
from vfguide.files.atomic import write_atomically
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Vectors
from vfguide.results.clearance import min_clearances, min_levels
from vfguide.results.fence_distance import fence_clearance, fence_violations
from vfguide.results.goal_passages import Legs, Pass
from vfguide.results.interventions import AssuranceResult, assurance_of
from vfguide.results.record import Array, FlightRecord
from vfguide.results.traffic_results import TrafficResult, traffic_reasons, traffic_results
from vfguide.scenario.obstacles import rows_of
from vfguide.scenario.resolved import Scenario

TOUCH = 0.3
"""Height of an aircraft's centre at which it has touched the ground [m]; chosen as the size of a
small airframe."""
FAR_AWAY = 1e7
"""Coordinate beyond which a flight ends [m]; chosen, because the paper's field leads away on the
far side of the goal, with a speed that grows with the distance."""
BELIEVED_ONLY = ", though its companion announced it as reached, {miss:.1f} m off"
"""End of the reason for a goal that was reached in the companion's belief only."""

Range = tuple[float | None, float | None]


@dataclass(frozen=True)
class GoalResult:
    """How a goal was met; None where the flight had no pass of it."""

    reached: bool
    time_s: float | None
    miss_m: float | None
    told_miss_m: float | None
    """What the companion announced of the pass; None: nothing."""
    course_error_deg: float | None
    climb_error_deg: float | None


@dataclass(frozen=True)
class ObstacleResult:
    """How near an obstacle came."""

    name: str
    min_level: float | None
    min_clearance_m: float | None


@dataclass(frozen=True)
class MeasuredResult:
    """A number of the aircraft file as the test flight has shown it; None: it has not."""

    key: str
    value: float | None
    sigma: float | None
    used: bool


@dataclass(frozen=True)
class VehicleResult:
    """How one vehicle flew; ranges are (least, most)."""

    id: int
    goals: tuple[GoalResult, ...]
    obstacles: tuple[ObstacleResult, ...]
    fence_clearance_m: float | None
    """None: there is no fence."""
    assurance: AssuranceResult | None
    """None: there is nothing to keep clear of."""
    max_bank_deg: float | None
    load_factor: Range
    airspeed_mps: Range
    altitude_m: Range
    setpoints: int
    setpoint_rate_hz: float | None
    traffic: tuple[TrafficResult, ...] = ()
    identified: tuple[MeasuredResult, ...] = ()
    """Empty: no test flight went before the first goal."""


@dataclass(frozen=True)
class Result:
    """What `result.json` holds."""

    name: str
    version: str
    seed: int
    verdict: Literal["good", "bad"]
    reasons: tuple[str, ...]
    sim_s: float
    wall_s: float
    realtime_factor: float | None
    min_separation_m: float | None
    vehicles: tuple[VehicleResult, ...]

    def to_json(self) -> str:
        """As strict JSON."""
        return json.dumps(asdict(self), indent=2, allow_nan=False) + "\n"


def judge(
    scenario: Scenario,
    records: Sequence[FlightRecord],
    sim_s: float,
    wall_s: float,
    ended_early: Sequence[str] = (),
) -> Result:
    """The result of a run.

    Args:
        scenario: that was flown.
        records: one of each vehicle, in its order.
        sim_s: simulated time.
        wall_s: time that the flight loop took.
        ended_early: why the run ended before 5 s after the last goal, such as "time"; empty if
            it did not.
    """
    legs = [record.legs() for record in records]
    flown = zip(records, legs, strict=True)
    vehicles = tuple(_vehicle(scenario, record, each, sim_s) for record, each in flown)
    separation = min_separation(records)
    missed = [reason for each in zip(vehicles, legs, strict=True) for reason in _missed(*each)]
    reasons = (*ended_early, *missed, *_reasons(scenario, records, vehicles, separation))
    return Result(
        name=scenario.name,
        version=__version__,
        seed=scenario.seed,
        verdict="bad" if reasons else "good",
        reasons=reasons,
        sim_s=round(sim_s, 6),
        wall_s=round(wall_s, 6),
        realtime_factor=_rounded(sim_s / wall_s) if wall_s > 0.0 else None,
        min_separation_m=None if separation is None else _rounded(separation),
        vehicles=vehicles,
    )


def write_result(result: Result, path: Path) -> None:
    """Write `result.json`."""
    write_atomically(path, result.to_json())


def min_separation(records: Sequence[FlightRecord]) -> float | None:
    """Least distance between the centres of two vehicles [m]; None with fewer than two.

    Between samples both move on straight lines.
    """
    pairs = combinations(records, 2)
    return min((_least_norm(one.p_n - other.p_n) for one, other in pairs), default=None)


def _least_norm(path: Vectors) -> float:
    """Least distance from zero of the line through the points of `path`, (n, 3)."""
    steps = np.diff(path, axis=0)
    lengths = np.maximum(np.einsum("ij,ij->i", steps, steps), np.finfo(float).tiny)
    along = np.clip(-np.einsum("ij,ij->i", path[:-1], steps) / lengths, 0.0, 1.0)
    nearest = np.vstack((path[:1], path[:-1] + along[:, None] * steps))
    return float(np.linalg.norm(nearest, axis=1).min())


def _vehicle(scenario: Scenario, record: FlightRecord, legs: Legs, sim_s: float) -> VehicleResult:
    return VehicleResult(
        id=record.vehicle.id,
        goals=tuple(_goal(best, legs.believed(goal)) for goal, best in enumerate(legs.best())),
        obstacles=_obstacles(scenario, record),
        fence_clearance_m=_rounded(fence_clearance(scenario, record.p_n)),
        assurance=assurance_of(scenario, record),
        max_bank_deg=_rounded(float(np.abs(record.euler[:, 0]).max()) / DEG),
        load_factor=_range(record.load_factor),
        airspeed_mps=_range(record.airspeed),
        altitude_m=_range(record.altitude),
        setpoints=record.setpoints,
        setpoint_rate_hz=_rounded(record.setpoints / sim_s) if sim_s > 0.0 else None,
        traffic=traffic_results(scenario, record),
        identified=_measured(record),
    )


def _measured(record: FlightRecord) -> tuple[MeasuredResult, ...]:
    found = () if record.identified is None else record.identified.estimates
    return tuple(
        MeasuredResult(
            f"{each.table}.{each.key}", _rounded(each.value), _rounded(each.sigma), each.used
        )
        for each in found
    )


def _obstacles(scenario: Scenario, record: FlightRecord) -> tuple[ObstacleResult, ...]:
    rows = rows_of(scenario.obstacles)
    figures = zip(
        scenario.obstacles, min_levels(record, rows), min_clearances(record, rows), strict=True
    )
    return tuple(
        ObstacleResult(obstacle.name, _rounded(float(level)), _rounded(float(clearance)))
        for obstacle, level, clearance in figures
    )


def _goal(best: Pass | None, believed: GoalAnnouncement | None) -> GoalResult:
    told = None if believed is None else _rounded(believed.miss)
    if best is None:
        return GoalResult(False, None, None, told, None, None)
    return GoalResult(
        best.reaches,
        _rounded(best.time),
        _rounded(best.miss),
        told,
        _rounded(best.course_error / DEG),
        _rounded(best.climb_error / DEG),
    )


def _missed(vehicle: VehicleResult, legs: Legs) -> list[str]:
    """The goals that were not reached, and which of them the companion believed to be."""
    reasons: list[str] = []
    for index, goal in enumerate(vehicle.goals):
        if goal.reached:
            continue
        reason, said = (
            f"goal {index + 1} of vehicle {vehicle.id} not reached",
            legs.left_behind(index),
        )
        if said is not None and said.outcome is Outcome.REACHED:
            reason += BELIEVED_ONLY.format(miss=said.miss)
        reasons.append(reason)
    return reasons


def _reasons(
    scenario: Scenario,
    records: Sequence[FlightRecord],
    vehicles: Sequence[VehicleResult],
    separation: float | None,
) -> list[str]:
    """What is wrong with the flight beside its goals; empty if nothing is."""
    reasons = [
        f"penetration: vehicle {vehicle.id} in {each.name}, {each.min_clearance_m:.2f} m"
        for vehicle in vehicles
        for each in vehicle.obstacles
        if each.min_clearance_m is not None and each.min_clearance_m <= 0.0
    ]
    for vehicle in vehicles:
        reasons += traffic_reasons(vehicle.id, vehicle.traffic)
    for record in records:
        reasons += fence_violations(scenario.fence, record)
        low = np.flatnonzero(record.height_above_ground <= TOUCH)
        if low.size:
            reasons.append(f"ground: vehicle {record.vehicle.id} after {record.time[low[0]]:.1f} s")
        away = np.flatnonzero((np.abs(record.p_n) > FAR_AWAY).any(axis=1))
        if away.size:
            reasons.append(f"away: vehicle {record.vehicle.id} after {record.time[away[0]]:.1f} s")
        if not (np.isfinite(record.p_n).all() and np.isfinite(record.v_n).all()):
            reasons.append(f"numbers: the state of vehicle {record.vehicle.id} is not finite")
    apart = 2.0 * scenario.avoidance.safety_radius_m
    if separation is not None and scenario.avoidance.between_vehicles and not separation > apart:
        reasons.append(f"separation: {separation:.1f} m, not more than {apart:g} m")
    return reasons


def _range(values: Array) -> Range:
    return _rounded(float(values.min())), _rounded(float(values.max()))


def _rounded(number: float) -> float | None:
    """To a millionth; None where JSON has no number for it."""
    return round(number, 6) if math.isfinite(number) else None
