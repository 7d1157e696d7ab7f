"""Distances of other aircraft, from the truth."""

import math
from dataclasses import dataclass

import numpy as np

from vfguide.files.scenario_file import Avoidance
from vfguide.geometry.polygon import prism_distances
from vfguide.geometry.polyline import points_at
from vfguide.geometry.vector import Series, Vectors
from vfguide.results.record import Array, FlightRecord
from vfguide.scenario.resolved import Scenario
from vfguide.scenario.traffic import path_of
from vfguide.sim.traffic import motion_at

LONGEST_INTERVAL = 0.02
"""Longest time between two compared positions [s]; chosen, 2 m at 100 m/s."""


@dataclass(frozen=True)
class TrafficResult:
    """How near one other aircraft came."""

    name: str
    closest_m: float
    """Least distance between the centres."""
    closest_s: float
    """Time of the least distance, since the start of the run."""
    min_horizontal_m: float | None
    """Least horizontal distance while it was within the half height of the volume; None: never."""
    min_vertical_m: float | None
    """Least vertical distance while it was within the radius; None: never."""
    min_clearance_m: float
    """Least distance from the volume, negative inside."""


def traffic_results(scenario: Scenario, record: FlightRecord) -> tuple[TrafficResult, ...]:
    """How near each of the other aircraft came to a vehicle."""
    if not scenario.traffic:
        return ()
    time, p_n = finely(record.time, record.p_n)
    radius = scenario.avoidance.traffic_radius_m
    half_height = scenario.avoidance.traffic_half_height_m
    results: list[TrafficResult] = []
    for each in scenario.traffic:
        other_n, _ = motion_at(path_of(each), time)
        apart = other_n - p_n
        horizontal, vertical = np.hypot(apart[:, 0], apart[:, 1]), np.abs(apart[:, 2])
        distance = np.hypot(horizontal, vertical)
        nearest = int(np.nan_to_num(distance, nan=np.inf).argmin())
        beside, level = horizontal[vertical <= half_height], vertical[horizontal <= radius]
        results.append(
            TrafficResult(
                each.name,
                _rounded(distance[nearest]),
                _rounded(time[nearest]),
                _least(beside),
                _least(level),
                _rounded(volume_distance(scenario.avoidance, apart).min()),
            )
        )
    return tuple(results)


def volume_distance(avoidance: Avoidance, apart: Vectors) -> Series:
    """Distances (n,) of a vehicle from the volume around another aircraft [m], negative inside.

    `apart`, (n, 3), are the positions of the one relative to the other, NED [m].
    """
    beside = np.hypot(apart[:, 0], apart[:, 1]) - avoidance.traffic_radius_m
    return prism_distances(beside, np.abs(apart[:, 2]) - avoidance.traffic_half_height_m)


def finely(time: Series, p_n: Vectors) -> tuple[Series, Vectors]:
    """Times (m,) [s] and positions (m, 3) of a path, no more than LONGEST_INTERVAL apart.

    The path has its positions (n, 3) at equally spaced times (n,), and is straight between them.
    """
    if len(time) < 2:
        return time, p_n
    parts = math.ceil((time[1] - time[0]) / LONGEST_INTERVAL - 1e-9)
    fine = np.linspace(time[0], time[-1], parts * (len(time) - 1) + 1)
    return fine, points_at(fine, time, p_n)


def traffic_reasons(vehicle: int, results: tuple[TrafficResult, ...]) -> list[str]:
    """The volumes of other aircraft that a vehicle entered, one reason each."""
    return [
        f"traffic: vehicle {vehicle} in the volume of {each.name}, {each.min_clearance_m:.2f} m"
        for each in results
        if each.min_clearance_m <= 0.0
    ]


def _least(values: Array) -> float | None:
    return _rounded(values.min()) if values.size else None


def _rounded(number: float) -> float:
    return round(float(number), 6)
