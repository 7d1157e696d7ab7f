"""How near true paths come to violating each rule of a fence: zones, floor and ceiling."""

import math

import numpy as np

from vfguide.airspace.fence import fence_distance, fences
from vfguide.files.fence import Fence, zone_of
from vfguide.geometry.vector import Vec3, Vectors
from vfguide.results.record import Array, FlightRecord
from vfguide.scenario.resolved import Scenario


def fence_rules(fence: Fence) -> list[str]:
    """Names of the zones, floor and ceiling of a fence, in the order of `fence_distances`."""
    heights = [key for key in ("floor_m", "ceiling_m") if getattr(fence, key) is not None]
    return [
        *(f"fence.zone[{index}]" for index in range(len(fence.zone))),
        *(f"fence.{key}" for key in heights),
    ]


def fence_distances(fence: Fence, p_n: Vectors) -> Array:
    """Distances of places (n, 3), NED [m], from where each rule is violated, (n, R) [m].

    They are negative where it is violated, and NaN where the place is not finite.
    """
    zones = fences([zone_of(zone) for zone in fence.zone])
    places: list[Vec3] = [(x, y, z) for x, y, z in p_n.tolist()]
    columns = [
        [fence_distance(zones, index, place) for place in places]
        for index in range(len(fence.zone))
    ]
    height = -p_n[:, 2]
    if fence.floor_m is not None:
        columns.append((height - fence.floor_m).tolist())
    if fence.ceiling_m is not None:
        columns.append((fence.ceiling_m - height).tolist())
    values = np.array(columns, float).reshape(len(columns), len(p_n)).T
    values[~np.isfinite(p_n).all(axis=1)] = np.nan
    return values


def fence_clearance(scenario: Scenario, p_n: Array) -> float:
    """Least distance of places (n, 3), NED [m], from where the fence is violated [m].

    It is negative where the fence is violated, and infinite where there is none.
    """
    values = fence_distances(scenario.fence, p_n)
    return float(np.fmin.reduce(values, axis=None, initial=math.inf))


def fence_violations(fence: Fence, record: FlightRecord) -> list[str]:
    """In words, every rule of the fence that a flight violated, how far and since when."""
    values = fence_distances(fence, record.p_n)
    return [
        f"fence: vehicle {record.vehicle.id} {_side(fence, index)} {name} by "
        f"{-np.nanmin(each):.1f} m after {record.time[np.flatnonzero(each < 0.0)[0]]:.1f} s"
        for index, (name, each) in enumerate(zip(fence_rules(fence), values.T, strict=True))
        if (each < 0.0).any()
    ]


def _side(fence: Fence, index: int) -> str:
    """The side on which a rule is violated, as a word before its name."""
    if index < len(fence.zone):
        return "outside" if fence.zone[index].kind == "include" else "inside"
    return "below" if fence_rules(fence)[index] == "fence.floor_m" else "above"
