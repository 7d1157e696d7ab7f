"""Which vehicle came closest to which obstacle in a run."""

from typing import NamedTuple

from vfguide.results.result import Result


class Closest(NamedTuple):
    """The least clearance of a run."""

    clearance: float
    """Distance from the surface of the obstacle [m], negative inside."""
    vehicle: int
    """Id of the vehicle."""
    obstacle: str
    """Name of the obstacle."""


def closest(result: Result) -> Closest | None:
    """The least clearance of all vehicles from all obstacles; None if no clearance is known."""
    each = [
        Closest(each.min_clearance_m, vehicle.id, each.name)
        for vehicle in result.vehicles
        for each in vehicle.obstacles
        if each.min_clearance_m is not None
    ]
    return min(each, default=None)
