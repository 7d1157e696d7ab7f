"""How clear a track stays of all hazards, looked at only where it can matter.

Between two points of the track the distance from a hazard shrinks no faster than both move, so
the points in between are left out: conservative advancement.
"""

import math
from typing import NamedTuple

from vfguide.airspace.hazards import (
    Hazards,
    hazard_count,
    hazard_distance,
    hazard_growth,
    hazard_speed,
)
from vfguide.field.obstacle import Rows
from vfguide.geometry.compiled import compiled

MOST_GROWTH = 12.0
"""The doubt about a position grows no further than this [m]."""


class Clearance(NamedTuple):
    """What was found along a track."""

    least: float
    """Least clearance, not looked for above what was called enough [m]."""
    lost: float
    """Time from the start of the track until too little is left [s]; infinite if never."""
    hazard: int
    """The one that is nearest, or lost to; -1 if all leave enough."""


@compiled
def clearance_along(
    hazards: Hazards,
    track: Rows,
    t: float,
    dt: float,
    speed: float,
    growth: float,
    enough: float,
    too_little: float,
    suspect: int,
) -> Clearance:
    """Least clearance along a track, and when it falls below a limit.

    Args:
        hazards: what to keep clear of.
        track: positions (N, 3), NED [m].
        t: time of the first one, on the clock of the obstacles [s].
        dt: time between two [s].
        speed: largest over ground along the track [m/s].
        growth: of the doubt about the own position [m/s].
        enough: a clearance above this is as good as any [m].
        too_little: the track is lost below this [m]; if it is `enough`, the first loss that is
            found ends the search, and may not be the earliest.
        suspect: the hazard to look at first.
    """
    count, end = hazard_count(hazards), len(track)
    least, hazard = enough, -1
    for n in range(count):
        i = (suspect + n) % count
        grow = (growth + hazard_growth(hazards, i)) * dt
        closing = (speed + hazard_speed(hazards, i)) * dt + grow
        k = 0
        while k < end:
            p_n = (track[k, 0], track[k, 1], track[k, 2])
            clearance = hazard_distance(hazards, i, p_n, t + k * dt) - min(k * grow, MOST_GROWTH)
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
    return Clearance(least, end * dt if end < len(track) else math.inf, hazard)
