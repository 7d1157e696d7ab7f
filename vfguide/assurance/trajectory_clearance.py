"""How clear a trajectory stays of all hazards, looked at only where it can matter.

Between two points of the trajectory the distance from a hazard shrinks no faster than both move, so
the points in between are left out: conservative advancement.
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
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vectors

MAX_UNCERTAINTY = 12.0
"""The doubt about a position grows no further than this [m]."""


class Clearance(NamedTuple):
    """What was found along a trajectory."""

    least: float
    """Least clearance, not looked for above what was called enough [m]."""
    lost: float
    """Time from the start of the trajectory until too little is left [s]; infinite if never."""
    hazard: int
    """The one that is nearest, or lost to; -1 if all leave enough."""


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
        hazards: what to keep clear of.
        trajectory: positions (N, 3), NED [m].
        t: time of the first one, on the clock of the obstacles [s].
        dt: time between two [s].
        speed: largest over ground along the trajectory [m/s].
        uncertainty_rate: of the doubt about the own position [m/s].
        enough: a clearance above this is as good as any [m].
        too_little: the trajectory is lost below this [m]; if it is `enough`, the first loss that is
            found ends the search, and may not be the earliest.
        suspect: the hazard to look at first.
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
