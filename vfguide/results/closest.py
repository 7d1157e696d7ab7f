"""Who came closest to an obstacle in a run."""

from typing import NamedTuple

from vfguide.results.result import Result


class Closest(NamedTuple):
    """The least clearance of a run."""

    clearance: float
    """[m], negative inside."""
    vehicle: int
    """Its id."""
    obstacle: str
    """Its name."""


def closest(result: Result) -> Closest | None:
    """The least clearance of all vehicles from all obstacles; None if there is none."""
    each = [
        Closest(each.min_clearance_m, vehicle.id, each.name)
        for vehicle in result.vehicles
        for each in vehicle.obstacles
        if each.min_clearance_m is not None
    ]
    return min(each, default=None)
