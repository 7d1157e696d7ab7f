"""The result of a run: figures from the truth, and the verdict."""

import math
from collections.abc import Sequence

import numpy as np

from vfguide import __version__
from vfguide.annunciations.goal_announcement import GoalAnnouncement
from vfguide.geometry.units import DEG
from vfguide.results.clearance import min_clearances, min_levels
from vfguide.results.fence_distance import fence_clearance
from vfguide.results.field_share import field_result
from vfguide.results.goal_passages import Legs, Pass
from vfguide.results.interventions import assurance_of
from vfguide.results.record import Array, FlightRecord
from vfguide.results.result import (
    GoalResult,
    MeasuredResult,
    ObstacleResult,
    Range,
    Result,
    VehicleResult,
)
from vfguide.results.traffic_results import traffic_results
from vfguide.results.verdict import flight_reasons, min_separation, missed_goals
from vfguide.scenario.obstacles import rows_of
from vfguide.scenario.resolved import Scenario


def judge(
    scenario: Scenario,
    records: Sequence[FlightRecord],
    sim_s: float,
    wall_s: float,
    ended_early: Sequence[str] = (),
) -> Result:
    """The result of a run: figures of each vehicle, and the verdict with its reasons.

    Args:
        scenario: the scenario that was flown.
        records: the record of each vehicle, in the order of the scenario.
        sim_s: simulated time [s].
        wall_s: real time that the flight loop took [s].
        ended_early: why the run ended before 5 s after the last goal, such as "time"; empty if
            it did not.
    """
    legs = [record.legs() for record in records]
    flown = zip(records, legs, strict=True)
    vehicles = tuple(_vehicle(scenario, record, each, sim_s) for record, each in flown)
    separation = min_separation(records)
    missed = [reason for each in zip(vehicles, legs, strict=True) for reason in missed_goals(*each)]
    reasons = (*ended_early, *missed, *flight_reasons(scenario, records, vehicles, separation))
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


def _vehicle(scenario: Scenario, record: FlightRecord, legs: Legs, sim_s: float) -> VehicleResult:
    return VehicleResult(
        id=record.vehicle.id,
        goals=tuple(_goal(best, legs.believed(goal)) for goal, best in enumerate(legs.best())),
        obstacles=_obstacles(scenario, record),
        fence_clearance_m=_rounded(fence_clearance(scenario, record.p_n)),
        assurance=assurance_of(scenario, record),
        field=field_result(record),
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
    believed_miss = None if believed is None else _rounded(believed.miss)
    if best is None:
        return GoalResult(False, None, None, believed_miss, None, None)
    return GoalResult(
        best.reaches,
        _rounded(best.time),
        _rounded(best.miss),
        believed_miss,
        _rounded(best.course_error / DEG),
        _rounded(best.climb_error / DEG),
    )


def _range(values: Array) -> Range:
    return _rounded(float(values.min())), _rounded(float(values.max()))


def _rounded(number: float) -> float | None:
    """The number rounded to a millionth; None where it is not finite, which JSON cannot say."""
    return round(number, 6) if math.isfinite(number) else None
