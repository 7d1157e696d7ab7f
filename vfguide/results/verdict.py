"""The reasons for a bad verdict: goals that were not reached, and what went wrong in flight."""

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from vfguide.annunciations.goal_announcement import GoalOutcome
from vfguide.geometry.polyline import nearest_to_origin
from vfguide.results.fence_distance import fence_violations
from vfguide.results.goal_passages import Legs
from vfguide.results.record import FlightRecord
from vfguide.results.result import VehicleResult
from vfguide.results.traffic_results import traffic_reasons
from vfguide.scenario.resolved import Scenario

TOUCH = 0.3
"""Height of an aircraft's centre at which it has touched the ground [m]; chosen as the size of a
small airframe."""
FAR_AWAY = 1e7
"""Coordinate beyond which a flight is bad, and that of rigid bodies ends [m]; chosen, because the
paper's field leads away on the far side of the goal, with a speed that grows with the distance."""
BELIEVED_ONLY = ", though its companion announced it as reached, {miss:.1f} m off"
"""Words added to the reason for a goal that only the companion believed to be reached."""


def min_separation(records: Sequence[FlightRecord]) -> float | None:
    """Least distance between the centres of two vehicles [m]; None with fewer than two.

    Between samples both move on straight lines.
    """
    pairs = combinations(records, 2)
    return min(
        (nearest_to_origin(one.p_n - other.p_n).distance for one, other in pairs), default=None
    )


def in_words(reason: str) -> str:
    """A reason for a bad verdict as the operator reads it."""
    return f"{reason}: duration_s was over first" if reason == "time" else reason


def missed_goals(vehicle: VehicleResult, legs: Legs) -> list[str]:
    """A reason for each goal not reached, with the companion's belief where it was another one."""
    reasons: list[str] = []
    for index, goal in enumerate(vehicle.goals):
        if goal.reached:
            continue
        reason, said = (
            f"goal {index + 1} of vehicle {vehicle.id} not reached",
            legs.left_behind(index),
        )
        if said is not None and said.outcome is GoalOutcome.REACHED:
            reason += BELIEVED_ONLY.format(miss=said.miss)
        reasons.append(reason)
    return reasons


def flight_reasons(
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
