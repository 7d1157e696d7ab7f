"""Clearance of a trajectory from all hazards, by conservative advancement.

The distance from a hazard shrinks no faster than aircraft and hazard move, so that points within
the distance found are skipped (B. Mirtich, Impulse-based Dynamic Simulation, 1996).
"""

import math
from typing import NamedTuple

from vfguide.airspace.hazards import (
    Hazards,
    hazard_count,
    hazard_distance,
    hazard_speed,
    hazard_uncertainty_rate,
)
from vfguide.geometry.vector import Vectors
from vfguide.kernels.compiled import compiled

MAX_UNCERTAINTY = 12.0
"""Largest uncertainty of a position along a trajectory [m]; chosen, so that distant hazards do not
forbid everything."""


class Clearance(NamedTuple):
    """Clearance along a trajectory."""

    least: float
    """Least clearance [m]; not searched for above what is enough."""
    lost: float
    """Time from the start of the trajectory until the clearance is too little [s]; infinite if
    never."""
    hazard: int
    """Number of the nearest hazard, or of the one too near; -1 if all leave enough."""


@compiled
def clearance_along(
    hazards: Hazards,
    trajectory: Vectors,
    t: float,
    dt: float,
    speed: float,
    uncertainty_rate: float,
    enough: float,
    too_little: float,
    suspect: int,
) -> Clearance:
    """Least clearance along a trajectory, and when it falls below a limit.

    Args:
        hazards: the known hazards.
        trajectory: positions (N, 3), NED [m].
        t: time of the first position, on the clock of the obstacles [s].
        dt: time between two positions [s].
        speed: largest speed over ground along the trajectory [m/s].
        uncertainty_rate: growth of the uncertainty of the own position [m/s].
        enough: clearance above which no difference is made [m].
        too_little: clearance below which the trajectory is not flown [m]; if it equals `enough`,
            the search ends at the first place that is found, which may not be the earliest.
        suspect: number of the hazard to look at first.
    """
    count, end = hazard_count(hazards), len(trajectory)
    least, hazard = enough, -1
    for n in range(count):
        i = (suspect + n) % count
        grow = (uncertainty_rate + hazard_uncertainty_rate(hazards, i)) * dt
        closing = (speed + hazard_speed(hazards, i)) * dt + grow
        k = 0
        while k < end:
            p_n = (trajectory[k, 0], trajectory[k, 1], trajectory[k, 2])
            clearance = hazard_distance(hazards, i, p_n, t + k * dt) - min(
                k * grow, MAX_UNCERTAINTY
            )
            if not clearance >= too_little:
                end, hazard, least = k, i, min(least, clearance)
                if enough <= too_little:
                    return Clearance(least, end * dt, hazard)
                break
            if clearance < least:
                least, hazard = clearance, i
            ahead = (clearance - max(least, too_little)) / closing
            if ahead >= end - k:
                break
            k += max(1, int(ahead))
    return Clearance(least, end * dt if end < len(trajectory) else math.inf, hazard)
