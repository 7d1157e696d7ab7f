"""Replanning: when to search for a route around hazards, or over them.

The route is checked several times a second. Where a known hazard is too near to it, or where the
leg has changed, the graph search finds another.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.performance import Gains, Performance
from vfguide.aircraft.state import FlightState
from vfguide.airspace.keep_out import KeepOutZones, hazards_of, joined
from vfguide.airspace.planar_clearance import NO_HAZARD, clearance_at
from vfguide.field.obstacle import Rows
from vfguide.geometry.se2 import Pose, composed, straight_on
from vfguide.kernels.compiled import compiled
from vfguide.paths.course_laws import arc_to_goal, planar_from, planar_of
from vfguide.paths.dubins import DubinsPath, length_of
from vfguide.paths.edge import EDGE_WIDTH, Edge, Segment, edge_row, next_path
from vfguide.paths.leg import FIELD, NEW, ON_PATH, OUTBOUND, Leg, with_final_approach
from vfguide.paths.path_progress import TURN_IN
from vfguide.planning.collision_check import Air, Task, check_segment, demand_of, route_is_clear
from vfguide.planning.objective import GuidanceTarget, pose_of_target
from vfguide.planning.overflight import (
    NO_LEVEL,
    AltitudePlan,
    altitude_plan_by,
    altitude_plan_left,
    band_of,
    cost_of,
    left_in_path,
    levels_for,
)
from vfguide.planning.route_following import (
    RouteFollowing,
    begin_route,
    edge_at,
    edges_of,
    follow_route,
    is_on_route,
    with_level,
    with_look,
    with_overflight,
    with_search,
)
from vfguide.planning.route_search import CLEARANCES, find_route

CHECK_INTERVAL = 0.2
"""Time between two checks of the route [s]; chosen."""
SEARCH_INTERVAL = 1.0
"""Time between two searches that found no route [s]; chosen for the time they take."""
KEPT_CLEARANCE = 0.6
"""Share of the clearance with which a route was found that must remain; chosen as hysteresis."""


class PlanningContext(NamedTuple):
    """The vehicle and its target."""

    state: FlightState
    target: GuidanceTarget
    aircraft: Performance
    gains: Gains


class Scene(NamedTuple):
    """What may block the route."""

    obstacles: Rows
    """The known obstacles, rows of `obstacle_rows`."""
    fence: KeepOutZones
    """Zones of the fence, and of traffic."""
    highest: float
    """Highest level of an overflight, z of NED [m]."""
    t: float
    """Present time on the clock of the obstacles [s]."""


@compiled
def seek_route(
    context: PlanningContext, leg: Leg, scene: Scene, route: RouteFollowing
) -> tuple[Leg, RouteFollowing]:
    """The leg and the route after a check, with a new route if the present one is blocked."""
    t = scene.t
    if is_on_route(route):
        route, leg = follow_route(route, context.state, leg)
    is_unplanned = leg.phase == NEW and not is_on_route(route)
    if is_unplanned or (not route.shifted and t - route.looked < CHECK_INTERVAL):
        return leg, route
    route = drop_level(context, leg, scene, with_look(route, t, False))
    altitudes = altitude_plan_of(context, route)
    if is_clear(context, leg, scene, route, altitudes, tolerated(route)):
        return leg, route
    if route.clearance < 0.0 and t - route.sought < SEARCH_INTERVAL:
        return leg, route
    return with_new_route(context, leg, scene, route)


@compiled
def altitude_plan_of(context: PlanningContext, route: RouteFollowing) -> AltitudePlan:
    """The altitude plan from here to the goal."""
    j = context
    return altitude_plan_left(route.level, route.fall, j.state, j.target, j.aircraft, j.gains)


@compiled
def tolerated(route: RouteFollowing) -> float:
    """Clearance with which the present route is kept [m]."""
    return KEPT_CLEARANCE * (route.clearance if route.clearance > 0.0 else CLEARANCES[0])


@compiled
def task_from(context: PlanningContext, start: Pose, goal: Pose, radius: float, t: float) -> Task:
    """The planning problem between two poses in the present wind."""
    wind_n = context.state.wind_n
    return Task(start, goal, radius, Air(context.gains.airspeed, wind_n[0], wind_n[1]), t)


@compiled
def entry_of(target: GuidanceTarget, final_approach: float) -> Pose:
    """Pose at the start of a final approach of the length given [m], NED."""
    return straight_on(pose_of_target(target), -final_approach)


@compiled
def pose_of(state: FlightState, ahead: float) -> Pose:
    """Pose of the vehicle `ahead` [s] from now, straight on, NED."""
    x = state.p_n[0] + ahead * state.v_n[0]
    y = state.p_n[1] + ahead * state.v_n[1]
    return Pose(x, y, math.atan2(state.v_n[1], state.v_n[0]))


@compiled
def is_clear(
    context: PlanningContext,
    leg: Leg,
    scene: Scene,
    route: RouteFollowing,
    altitudes: AltitudePlan,
    wanted: float,
) -> bool:
    """Whether the rest of the route has the clearance `wanted` [m]."""
    state, target = context.state, context.target
    obstacles = left_in_path(scene.obstacles, altitudes, wanted)
    hazards = joined(hazards_of(obstacles, band_of(altitudes), wanted), scene.fence)
    here, entry = pose_of(state, 0.0), entry_of(target, leg.final_approach)
    task = task_from(context, here, entry_of(target, 0.0), leg.radius, scene.t)
    if is_on_route(route):
        travelled = travelled_in(
            edge_at(route, route.present).path, route.segment, route.left, leg.radius
        )
        return route_is_clear(
            hazards, task, wanted, edges_of(route), route.present, route.segment, travelled
        )
    if leg.phase == ON_PATH:
        progress = leg.progress
        edge = Edge(composed(entry, progress.edge.begin), progress.edge.path)
        rows = edge_row(edge).reshape(1, EDGE_WIDTH)
        travelled = travelled_in(edge.path, progress.segment, progress.left, progress.radius)
        return route_is_clear(hazards, task, wanted, rows, 0, progress.segment, travelled)
    if leg.phase == FIELD:
        return field_is_clear(state, leg, hazards, task, entry, wanted)
    return True


@compiled
def field_is_clear(
    state: FlightState, leg: Leg, hazards: KeepOutZones, task: Task, entry: Pose, wanted: float
) -> bool:
    """Whether the arc of the paper's field from here to the final approach is clear."""
    at = planar_from(entry, planar_of(state))
    radius = max((at.x * at.x + at.y * at.y) / max(2.0 * abs(at.y), 1e-3), leg.radius)
    begin = composed(entry, Pose(at.x, at.y, 2.0 * math.atan2(at.y, at.x)))
    arc = Segment(begin, 1.0 if at.y > 0.0 else -1.0, arc_to_goal(at.x, at.y))
    if at.x >= 0.0:
        arc = Segment(entry, 0.0, leg.final_approach)
    demand = demand_of(hazards, task, wanted)
    task = Task(task.start, task.goal, radius, task.air, task.t)
    return check_segment(hazards, task, demand, arc, 0.0, task.t).blocker == NO_HAZARD


@compiled
def travelled_in(path: DubinsPath, segment: int, left: float, radius: float) -> float:
    """Length of a segment that has been flown [m]; `left` is its rest [turn radii]."""
    lengths = (path.arc, path.reach, path.end)
    return radius * max(0.0, lengths[segment] - left)


@compiled
def with_new_route(
    context: PlanningContext, leg: Leg, scene: Scene, route: RouteFollowing
) -> tuple[Leg, RouteFollowing]:
    """The leg along a new route, or over what blocks it, or as it was if neither is found.

    A level is kept on a new route too. Where no route leads to the start of the final approach,
    one to the goal itself is taken.
    """
    state, target, radius = context.state, context.target, leg.radius
    altitudes, may_climb = altitude_plan_of(context, route), not is_on_route(route)
    may_climb = may_climb and math.isinf(altitudes.level)
    obstacles = left_in_path(scene.obstacles, altitudes, KEPT_CLEARANCE * CLEARANCES[0])
    route = with_search(route, scene.t, scene.t, 0, -1.0)
    begin = pose_of(state, TURN_IN)
    for end in (context.gains.final_approach * radius, 0.0):
        entry = entry_of(target, end)
        task = task_from(context, begin, entry, radius, scene.t + TURN_IN)
        found = find_route(obstacles, scene.fence, band_of(altitudes), task)
        if len(found.route_edges) > 0:
            longer = found.length - radius * length_of(next_path(begin, entry, radius, -1.0))
            if may_climb:
                over = seek_level(context, leg, scene, route, longer)
                if over.clearance > 0.0:
                    return leg, over
            route = begin_route(route, found, entry, radius)
            route, leg = follow_route(route, state, with_final_approach(leg, end))
            return leg, route
    if may_climb:
        route = seek_level(context, leg, scene, route, math.inf)
    return leg, route


@compiled
def seek_level(
    context: PlanningContext, leg: Leg, scene: Scene, route: RouteFollowing, most: float
) -> RouteFollowing:
    """The route over what blocks it, where the leg is clear at another height.

    The level must cost less than `most` [m]; where none is found the route is unchanged.
    """
    each, wanted = context, CLEARANCES[0]
    here, goal = each.state.p_n[2], each.target.p_n[2]
    for level in levels_for(scene.obstacles, here, goal, scene.highest, wanted):
        if cost_of(level, here, goal) >= most:
            break
        altitudes = altitude_plan_by(level, each.state, each.target, each.aircraft, each.gains)
        if is_free(context, leg, scene, route, altitudes):
            return with_overflight(route, level, altitudes.fall, wanted)
    return route


@compiled
def drop_level(
    context: PlanningContext, leg: Leg, scene: Scene, route: RouteFollowing
) -> RouteFollowing:
    """The route without its level, once it is clear without it."""
    if not math.isinf(route.level):
        state, target = context.state, context.target
        altitudes = AltitudePlan(state.p_n, target.p_n, NO_LEVEL, 0.0, 0.0)
        if leg.phase != OUTBOUND and is_free(context, leg, scene, route, altitudes):
            return with_level(route, NO_LEVEL)
    return route


@compiled
def is_free(
    context: PlanningContext, leg: Leg, scene: Scene, route: RouteFollowing, altitudes: AltitudePlan
) -> bool:
    """Whether the rest of the route has the full clearance, the present position included.

    `is_clear` alone asks for less around the start where a hazard is near it.
    """
    wanted, p_n = CLEARANCES[0], context.state.p_n
    obstacles = left_in_path(scene.obstacles, altitudes, wanted)
    near = hazards_of(obstacles, band_of(altitudes), wanted)
    if clearance_at(near, p_n[0], p_n[1], scene.t).distance < wanted:
        return False
    return is_clear(context, leg, scene, route, altitudes, wanted)
