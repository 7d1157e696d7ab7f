"""Over what blocks the route, instead of round it.

The route stays as it is. The vehicle climbs before what is passed, keeps that level, and flies to
the goal's height after it. What moves is not passed so.
"""

import math
from typing import NamedTuple

import numpy as np

from vfguide.aircraft.path_limits import descent_at_airspeed
from vfguide.aircraft.performance import Gains, Performance, turn_length
from vfguide.aircraft.state import FlightState
from vfguide.airspace.footprint import Band
from vfguide.airspace.keep_out import hazards_of
from vfguide.airspace.planar_clearance import clearance_at
from vfguide.field.obstacle import OUT_OF_SIGHT, PlacedObstacle, Rows, read_obstacle
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Series, Vec3
from vfguide.paths.distance_for_altitude import distance_for_altitude
from vfguide.planning.objective import GuidanceTarget

PLANNED_SLOPE_PART, ENOUGH_SLOPE_PART = 0.7, 0.9
"""Part of the steepest path that a change of height is planned with, and found to be enough on the
way: the wind that is believed changes."""
GOAL_HEIGHT_LEAD = 3.0
"""Before the goal its height is flown to for so long, in turn lengths, whatever the change."""
COST = 1.0
"""A metre of height more, up or down, counts as so many metres of way: what is climbed comes back
in the descent, but for the losses of the propeller."""
MOST_LEVELS = 12
"""No more heights are tried."""
NO_LEVEL = math.inf
"""Stands for a level where none is kept: as low as nothing is [m]."""
UNDER = 15.0
"""What is so far below the vehicle already is passed by a level that is no lower, however near it
is [m]."""


class AltitudePlan(NamedTuple):
    """Heights along a way: from here to a level, and from there to the goal."""

    here: Vec3
    goal: Vec3
    """NED [m]."""
    level: float
    """Down from the origin [m]; infinite: there is none."""
    rise: float
    fall: float
    """Path that the change to the level takes, and the one from there to the goal's height [m]."""


@compiled
def altitude_plan_by(
    level: float, state: FlightState, target: GuidanceTarget, aircraft: Performance, gains: Gains
) -> AltitudePlan:
    """The heights of a route by a level, as it is planned."""
    here, goal = state.p_n, target.p_n
    rise = change_length(here[2] - level, PLANNED_SLOPE_PART, state.wind_n, aircraft, gains)
    fall = change_length(level - goal[2], PLANNED_SLOPE_PART, state.wind_n, aircraft, gains)
    return AltitudePlan(
        here, goal, level, rise, fall + GOAL_HEIGHT_LEAD * turn_length(gains.airspeed)
    )


@compiled
def altitude_plan_left(
    level: float,
    fall: float,
    state: FlightState,
    target: GuidanceTarget,
    aircraft: Performance,
    gains: Gains,
) -> AltitudePlan:
    """The heights of the rest of a route by a level that was planned with a fall [m]."""
    rise = change_length(state.p_n[2] - level, ENOUGH_SLOPE_PART, state.wind_n, aircraft, gains)
    return AltitudePlan(state.p_n, target.p_n, level, rise, fall)


@compiled
def change_length(
    up: float, part: float, wind_n: Vec3, aircraft: Performance, gains: Gains
) -> float:
    """Path over ground that a climb by `up`, or a descent, takes with the wind behind [m].

    Flown with a part of the steepest path.
    """
    steepest = math.tan(aircraft.climb_max if up > 0.0 else descent_at_airspeed(aircraft, 0.0))
    faster = 1.0 + math.hypot(wind_n[0], wind_n[1]) / max(gains.airspeed, 1e-3)
    most, unit = max(part * steepest / faster, 1e-6), turn_length(gains.airspeed)
    return distance_for_altitude(-up, math.inf, 0.0, most, unit, 0.0)


@compiled
def band_of(altitudes: AltitudePlan) -> Band:
    """All heights of the route."""
    here, goal = altitudes.here[2], altitudes.goal[2]
    level = goal if math.isinf(altitudes.level) else altitudes.level
    return Band(min(here, goal, level), max(here, goal, level))


@compiled
def is_above(obstacle: PlacedObstacle, z: float, margin: float) -> bool:
    """Whether a height, down from the origin, is above an obstacle by the margin [m]."""
    return z <= level_over(obstacle, margin)


@compiled
def level_over(obstacle: PlacedObstacle, margin: float) -> float:
    """The lowest height above an obstacle by the margin, down from the origin [m]."""
    return obstacle.p_n[2] - obstacle.semi_axes[2] - margin


@compiled
def is_passed(obstacles: Rows, i: int, altitudes: AltitudePlan, margin: float) -> bool:
    """Whether row `i` is below the route wherever on it the vehicle may meet it."""
    obstacle = read_obstacle(obstacles[i])
    if not is_above(obstacle, altitudes.level, margin) or not stands_still(obstacle):
        return False
    here = min(margin, UNDER) if altitudes.level <= altitudes.here[2] else margin
    ends = ((altitudes.here, altitudes.rise, here), (altitudes.goal, altitudes.fall, margin))
    for end, length, over in ends:
        above = is_above(obstacle, end[2], over)
        if not above and distance_beside(obstacles, i, end) < length + margin:
            return False
    return True


@compiled
def stands_still(obstacle: PlacedObstacle) -> bool:
    """Whether an obstacle does not move."""
    north, east, down = obstacle.v_n
    return north == 0.0 and east == 0.0 and down == 0.0


@compiled
def distance_beside(obstacles: Rows, i: int, p_n: Vec3) -> float:
    """Horizontal distance of a place from the whole of row `i`, which stands still [m]."""
    band = Band(-math.inf, math.inf)
    return clearance_at(hazards_of(obstacles[i : i + 1], band, 0.0), p_n[0], p_n[1], 0.0).distance


@compiled
def left_in_path(obstacles: Rows, altitudes: AltitudePlan, margin: float) -> Rows:
    """The obstacles that are not passed over by the margin [m]."""
    if math.isinf(altitudes.level):
        return obstacles
    left = np.ones(len(obstacles), dtype=np.bool_)
    for i in range(len(obstacles)):
        left[i] = not is_passed(obstacles, i, altitudes, margin)
    return obstacles[left]


@compiled
def levels_for(obstacles: Rows, here: float, goal: float, highest: float, margin: float) -> Series:
    """Levels to try, the cheapest first, (N,) [m].

    The heights of both ends, and those over one of the obstacles by the margin: MOST_LEVELS that
    differ, the costliest among them. None is below both ends: nobody knows of the ground.

    Args:
        obstacles: rows of `obstacle_rows`.
        here: height, down from the origin [m].
        goal: its height [m].
        highest: no level is above this [m], but for the height that the vehicle has.
        margin: over what is passed [m].
    """
    levels: Series = np.full(len(obstacles) + 2, math.inf)
    levels[0], levels[1] = here, goal
    for i in range(len(obstacles)):
        obstacle = read_obstacle(obstacles[i])
        if stands_still(obstacle) and obstacle.p_n[0] < OUT_OF_SIGHT:
            levels[i + 2] = level_over(obstacle, margin)
    allowed = (levels >= min(highest, here)) & (levels <= max(here, goal))
    levels = distinct(levels[allowed])
    costs = np.empty(len(levels))
    for k in range(len(levels)):
        costs[k] = cost_of(levels[k], here, goal)
    levels = levels[np.argsort(costs, kind="mergesort")]
    if len(levels) > MOST_LEVELS:
        levels[MOST_LEVELS - 1] = levels[-1]
    return levels[:MOST_LEVELS]


@compiled
def distinct(values: Series) -> Series:
    """The values, each where it comes first, (N,)."""
    first = np.ones(len(values), dtype=np.bool_)
    for k in range(1, len(values)):
        first[k] = not np.any(values[:k] == values[k])
    return values[first]


@compiled
def cost_of(level: float, here: float, goal: float) -> float:
    """Of the height that a level costs more than the route without it, as a length [m]."""
    return COST * (abs(level - here) + abs(level - goal) - abs(here - goal))


@compiled
def aim_at(level: float, fall: float, target: GuidanceTarget, remaining: float) -> GuidanceTarget:
    """The target whose height is flown to: the level until `remaining` is the fall [m].

    A level is kept as on a circle.
    """
    if math.isinf(level) or target.circle != 0.0 or remaining <= fall:
        return target
    at = (target.p_n[0], target.p_n[1], level)
    return GuidanceTarget(at, target.course, 0.0, 1.0, target.radius)
