"""Leg start: along the final approach, the field or the shortest path, or away from the goal.

A path that is too short for its change of height gets full circles. What is missing and is less
than a circle is added by a longer final approach, or by flying away from the goal first. A descent
that takes more than the path is flown faster, in wider turns, with more drag.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.performance import Gains
from vfguide.geometry.angles import FULL_TURN
from vfguide.kernels.compiled import compiled
from vfguide.paths.course_laws import PlanarState, course_of
from vfguide.paths.dubins import DubinsPath, is_hasty, length_of, shortest_path
from vfguide.paths.field_capture import begins_in_field, is_lined_up
from vfguide.paths.leg import (
    FIELD,
    ON_PATH,
    OUTBOUND,
    Leg,
    before_end,
    in_phase,
    moved,
    with_final_approach,
    with_radius,
)
from vfguide.paths.path_progress import TURN_IN, begin_path
from vfguide.paths.path_stretching import best_end, best_outbound

HASTY_FINAL_APPROACH = 0.9
"""Length of the final approach where a short last turn follows at once on one to the other side
[turn radii]; chosen longer than the ordinary 0.6, since the course has to settle."""
SHORTEST_FINAL_APPROACH = 0.3
"""Least length of the final approach [turn radii]; chosen."""
LEAP = 5.0
"""Difference of length above which one path counts as a leap longer than another [turn radii];
chosen below a full circle."""
APPROACH_STEPS = 6
"""Number of steps in which shorter final approaches are tried; chosen."""


class Paths(NamedTuple):
    """Lengths of path over ground that the rest of the change of height takes."""

    needed: float
    """Length with turns of the leg's radius [m]."""
    radius_factor: float
    """Factor by which the turns of a faster descent are wider; 1 if there is none."""
    needed_wide: float
    """Length with turns that are wider by that factor [m]."""


class LegStart(NamedTuple):
    """A leg that has just started."""

    leg: Leg
    length: float
    """Length of the path to the goal [m]."""


@compiled
def begin_leg(leg: Leg, at: PlanarState, paths: Paths, gains: Gains) -> Leg:
    """The leg from here, with wider turns where a faster descent makes it shorter.

    Args:
        leg: a leg in phase NEW.
        at: the vehicle in the plane of the goal frame.
        paths: lengths of path that the change of height takes.
        gains: gains of the guidance.
    """
    level = start_here(leg, at, paths.needed, gains)
    if paths.radius_factor > 1.0 and paths.needed_wide < paths.needed:
        wide = with_radius(leg, paths.radius_factor * leg.radius)
        descent = start_here(wide, at, paths.needed_wide, gains)
        if descent.length < level.length:
            return descent.leg
    return level.leg


@compiled
def start_here(leg: Leg, at: PlanarState, distance_for_altitude: float, gains: Gains) -> LegStart:
    """The leg from here, with turns of its radius.

    Args:
        leg: a leg in phase NEW or OUTBOUND.
        at: the vehicle in the plane of the goal frame.
        distance_for_altitude: path length that the remaining change of height takes [m].
        gains: gains of the guidance.
    """
    final_approach = gains.final_approach * leg.radius
    fresh = with_final_approach(leg, final_approach)
    entry = before_end(fresh, at)
    if is_lined_up(fresh, entry) and distance_for_altitude <= final_approach - entry.x:
        return LegStart(in_phase(fresh, FIELD, leg.progress), final_approach - entry.x)
    begin = PlanarState(entry.x + TURN_IN * at.vx, entry.y + TURN_IN * at.vy, at.vx, at.vy)
    path = path_from(begin, leg.radius)
    lead = math.hypot(begin.x - entry.x, begin.y - entry.y)
    length = leg.radius * length_of(path) + lead
    if begins_in_field(fresh, entry, length, distance_for_altitude - final_approach):
        return LegStart(in_phase(fresh, FIELD, leg.progress), final_approach + length)
    longest = (
        max(final_approach, HASTY_FINAL_APPROACH * leg.radius) if is_hasty(path) else final_approach
    )
    end = longest_end(begin, leg.radius, final_approach, longest)
    begin, fresh = moved(begin, end - final_approach), with_final_approach(fresh, end)
    path = path_from(begin, leg.radius)
    start = path_or_outbound(fresh, begin, path, distance_for_altitude - fresh.final_approach)
    return LegStart(start.leg, lead + start.length)


@compiled
def longest_end(begin: PlanarState, radius: float, final_approach: float, longest: float) -> float:
    """The longest final approach whose path is not a leap longer than that of a shorter one [m].

    The shortest path to a final approach that starts a little earlier may be longer by a circle,
    because another Dubins path is the shortest.

    Args:
        begin: the vehicle; the origin is the start of a final approach of length `final_approach`.
        radius: radius of the turns [m].
        final_approach: ordinary length of the final approach [m].
        longest: longest one that is tried [m].
    """
    chosen, shortest = longest, math.inf
    for k in range(APPROACH_STEPS + 1):
        end = (
            longest
            + (min(SHORTEST_FINAL_APPROACH * radius, final_approach) - longest) * k / APPROACH_STEPS
        )
        path = path_from(moved(begin, end - final_approach), radius)
        length = end + radius * length_of(path)
        if length < shortest - LEAP * radius:
            chosen, shortest = end, length
    return chosen


@compiled
def path_or_outbound(
    leg: Leg, begin: PlanarState, path: DubinsPath, distance_for_altitude: float
) -> LegStart:
    """The leg along a Dubins path that is long enough for the change of height.

    It gets full circles; what is missing and less than one becomes a longer final approach, or
    phase OUTBOUND. `begin` is relative to the start of the final approach.
    """
    missing = (distance_for_altitude / leg.radius - length_of(path)) / FULL_TURN  # in circles
    circles = float(math.floor(missing)) if missing > 0.0 else 0.0
    if leg.phase == OUTBOUND:
        circles = leg.circles
    if missing <= circles:
        return along_path(leg, begin, with_circles(path, circles))
    if leg.phase == OUTBOUND:
        return LegStart(leg, math.inf)
    round_once = FULL_TURN * circles * leg.radius
    distance_for_altitude -= round_once
    farther, with_end = best_end(begin, leg.radius, distance_for_altitude)
    course, with_outbound = best_outbound(begin, leg.radius, distance_for_altitude)
    if with_outbound < with_end:
        outbound = Leg(OUTBOUND, leg.radius, leg.final_approach, course, circles, leg.progress)
        return LegStart(outbound, with_outbound + round_once + leg.final_approach)
    begin = moved(begin, farther)
    path = with_circles(path_from(begin, leg.radius), circles)
    return along_path(with_final_approach(leg, leg.final_approach + farther), begin, path)


@compiled
def along_path(leg: Leg, begin: PlanarState, path: DubinsPath) -> LegStart:
    """The leg in phase ON_PATH along a Dubins path from `begin`."""
    progress = begin_path(begin, path, leg.radius)
    return LegStart(
        in_phase(leg, ON_PATH, progress), leg.final_approach + leg.radius * length_of(path)
    )


@compiled
def with_circles(path: DubinsPath, circles: float) -> DubinsPath:
    """The Dubins path with a number of full circles added to its first turn."""
    arc = path.arc + FULL_TURN * circles
    return DubinsPath(path.first, arc, path.middle, path.reach, path.last, path.end)


@compiled
def path_from(at: PlanarState, radius: float) -> DubinsPath:
    """The shortest Dubins path from here to the origin, course 0, with turns of `radius` [m]."""
    return shortest_path(at.x, at.y, course_of(at), radius)
