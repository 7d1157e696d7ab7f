"""Overflight: over the obstacles that block the route, instead of around them.

The route stays as it is. The vehicle climbs before the obstacles, keeps that level, and flies to
the goal's height after them. It does not fly over moving obstacles.
"""

import math
from typing import NamedTuple

import numpy as np

from vfguide.aircraft.path_limits import descent_at_airspeed
from vfguide.aircraft.performance import Gains, Performance, turn_length
from vfguide.aircraft.state import FlightState
from vfguide.airspace.footprint import Band
from vfguide.airspace.keep_out import obstacle_zones
from vfguide.airspace.planar_clearance import clearance_at
from vfguide.field.obstacle import OUT_OF_SIGHT, PlacedObstacle, Rows, read_obstacle
from vfguide.geometry.vector import Series, Vec3
from vfguide.geometry.velocity import horizontal_norm
from vfguide.kernels.compiled import compiled
from vfguide.paths.distance_for_altitude import distance_for_altitude
from vfguide.planning.objective import GuidanceTarget

PLANNED_SLOPE_SHARE = 0.7
"""Share of the steepest path with which a change of height is planned; tuned with flights over
ridges: with 0.85 a goal was missed by its height, and a climb given up half way."""
ENOUGH_SLOPE_SHARE = 0.9
"""Share of the steepest path with which a change of height must still be possible during the
flight; chosen larger, since the estimated wind changes."""
GOAL_HEIGHT_LEAD = 3.0
"""Length of path by which the change to the goal's height starts earlier than it has to [turn
lengths]; chosen."""
HEIGHT_COST = 1.0
"""Ratio of the cost of a metre of height, up or down, to that of a metre of path; chosen: a climb
costs airspeed and thrust, most of which a descent returns."""
MAX_LEVELS = 12
"""Largest number of levels that are tried; chosen for the time it takes."""
NO_LEVEL = math.inf
"""Level that stands for none, z of NED: infinitely low [m]."""
PASSED_MARGIN = 15.0
"""Height above an obstacle that suffices where the vehicle is above it already and keeps its level
[m]; chosen smaller than the ordinary clearance."""


class AltitudePlan(NamedTuple):
    """Heights along a route: from here to a level, and from there to the goal."""

    here: Vec3
    """Position of the vehicle, NED [m]."""
    goal: Vec3
    """Position of the goal, NED [m]."""
    level: float
    """Level, z of NED [m]; infinite for none."""
    rise: float
    """Length of path that the change to the level takes [m]."""
    fall: float
    """Length of path that the change from the level to the goal's height takes [m]."""


@compiled
def altitude_plan_by(
    level: float, state: FlightState, target: GuidanceTarget, aircraft: Performance, gains: Gains
) -> AltitudePlan:
    """The altitude plan of a route that is planned now, by a level (z of NED [m])."""
    here, goal = state.p_n, target.p_n
    rise = change_length(here[2] - level, PLANNED_SLOPE_SHARE, state.wind_n, aircraft, gains)
    fall = change_length(level - goal[2], PLANNED_SLOPE_SHARE, state.wind_n, aircraft, gains)
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
    """The altitude plan of the rest of a route that was planned with a level and a `fall` [m]."""
    rise = change_length(state.p_n[2] - level, ENOUGH_SLOPE_SHARE, state.wind_n, aircraft, gains)
    return AltitudePlan(state.p_n, target.p_n, level, rise, fall)


@compiled
def change_length(
    up: float, part: float, wind_n: Vec3, aircraft: Performance, gains: Gains
) -> float:
    """Length of path over ground that a change of height takes with a tail wind [m].

    Args:
        up: height to climb, negative to descend [m].
        part: share of the steepest path that is flown.
        wind_n: wind, NED, blowing toward [m/s].
        aircraft: its path angles.
        gains: gains of the guidance.
    """
    steepest = math.tan(aircraft.climb_max if up > 0.0 else descent_at_airspeed(aircraft, 0.0))
    faster = 1.0 + horizontal_norm(wind_n) / max(gains.airspeed, 1e-3)
    most, unit = max(part * steepest / faster, 1e-6), turn_length(gains.airspeed)
    return distance_for_altitude(-up, math.inf, 0.0, most, unit, 0.0)


@compiled
def band_of(altitudes: AltitudePlan) -> Band:
    """The band that contains all heights of an altitude plan."""
    here, goal = altitudes.here[2], altitudes.goal[2]
    level = goal if math.isinf(altitudes.level) else altitudes.level
    return Band(min(here, goal, level), max(here, goal, level))


@compiled
def is_above(obstacle: PlacedObstacle, z: float, margin: float) -> bool:
    """Whether the height `z` (down) [m] is above an obstacle by the margin [m]."""
    return z <= level_over(obstacle, margin)


@compiled
def level_over(obstacle: PlacedObstacle, margin: float) -> float:
    """The lowest level above an obstacle by the margin [m], z of NED [m]."""
    return obstacle.p_n[2] - obstacle.semi_axes[2] - margin


@compiled
def is_passed(obstacles: Rows, i: int, altitudes: AltitudePlan, margin: float) -> bool:
    """Whether the obstacle of row `i` is below the vehicle wherever the vehicle may meet it."""
    obstacle = read_obstacle(obstacles[i])
    if not is_above(obstacle, altitudes.level, margin) or not stands_still(obstacle):
        return False
    here = min(margin, PASSED_MARGIN) if altitudes.level <= altitudes.here[2] else margin
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
    """Horizontal distance of `p_n` from the obstacle of row `i`, which does not move [m]."""
    band = Band(-math.inf, math.inf)
    return clearance_at(
        obstacle_zones(obstacles[i : i + 1], band, 0.0), p_n[0], p_n[1], 0.0
    ).distance


@compiled
def left_in_path(obstacles: Rows, altitudes: AltitudePlan, margin: float) -> Rows:
    """The obstacles that an altitude plan does not pass over by the margin [m]."""
    if math.isinf(altitudes.level):
        return obstacles
    left = np.ones(len(obstacles), dtype=np.bool_)
    for i in range(len(obstacles)):
        left[i] = not is_passed(obstacles, i, altitudes, margin)
    return obstacles[left]


@compiled
def levels_for(obstacles: Rows, here: float, goal: float, highest: float, margin: float) -> Series:
    """Levels to try, the cheapest first, (N,), z of NED [m].

    They are the heights of both ends and those above an obstacle by the margin: up to MAX_LEVELS
    different ones, among them the costliest. None is below both ends, since the ground is unknown.

    Args:
        obstacles: rows of `obstacle_rows`.
        here: height of the vehicle, down [m].
        goal: height of the goal, down [m].
        highest: highest level, down [m]; the present height of the vehicle is always allowed.
        margin: height above the obstacles that are passed [m].
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
    if len(levels) > MAX_LEVELS:
        levels[MAX_LEVELS - 1] = levels[-1]
    return levels[:MAX_LEVELS]


@compiled
def distinct(values: Series) -> Series:
    """The values without repetitions, in their order, (N,)."""
    first = np.ones(len(values), dtype=np.bool_)
    for k in range(1, len(values)):
        first[k] = not np.any(values[:k] == values[k])
    return values[first]


@compiled
def cost_of(level: float, here: float, goal: float) -> float:
    """Cost of the additional change of height by a level, as a length of path [m]."""
    return HEIGHT_COST * (abs(level - here) + abs(level - goal) - abs(here - goal))


@compiled
def aim_at(level: float, fall: float, target: GuidanceTarget, remaining: float) -> GuidanceTarget:
    """The target whose height is flown to: the level until `remaining` is less than the fall [m].

    A level is held like that of a circle.
    """
    if math.isinf(level) or target.circle != 0.0 or remaining <= fall:
        return target
    at = (target.p_n[0], target.p_n[1], level)
    return GuidanceTarget(at, target.course, 0.0, 1.0, target.radius)
