"""When to look for a route round hazards, or over them, and what becomes of the leg then.

The route that is flown is looked along several times a second; where something that is known comes
too near to it, or where the flight law has changed it by itself, the coarse search finds another.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.performance import Gains, Performance
from vfguide.aircraft.state import FlightState
from vfguide.airspace.keep_out import KeepOutZones, hazards_of, joined
from vfguide.airspace.planar_clearance import NO_HAZARD, clearance_at
from vfguide.field.obstacle import Rows
from vfguide.geometry.compiled import compiled
from vfguide.paths.course_laws import arc_to_goal
from vfguide.paths.dubins import DubinsPath, length_of
from vfguide.paths.edge import EDGE_WIDTH, Edge, Segment, edge_row, next_path
from vfguide.paths.leg import FIELD, NEW, ON_PATH, OUTBOUND, Leg, with_final_approach
from vfguide.paths.path_progress import TURN_IN, Pose
from vfguide.planning.collision_check import Air, Task, check_segment, demand_of, route_is_clear
from vfguide.planning.objective import GuidanceTarget
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
    vehicle_from,
    with_level,
    with_look,
    with_overflight,
    with_search,
)
from vfguide.planning.route_search import CLEARANCES, find_route

LOOK = 0.2
"""Between two looks along the route [s]."""
SEEK = 1.0
"""Between two searches that found nothing [s]."""
TOLERATED = 0.6
"""Part of the clearance that was found of which so much is left when a route is given up."""


class PlanningContext(NamedTuple):
    """Who flies where."""

    state: FlightState
    target: GuidanceTarget
    aircraft: Performance
    gains: Gains


class Scene(NamedTuple):
    """What may block the route."""

    obstacles: Rows
    """That are known."""
    fence: KeepOutZones
    """To stay in or out of."""
    highest: float
    """Nothing is passed over above this, down from the origin [m]."""
    t: float
    """Now, on the clock of the obstacles [s]."""


@compiled
def seek_route(
    context: PlanningContext, leg: Leg, scene: Scene, route: RouteFollowing
) -> tuple[Leg, RouteFollowing]:
    """The leg with a route that keeps clear of the hazards, if it needs another."""
    t = scene.t
    if is_on_route(route):
        route, leg = follow_route(route, context.state, leg)
    is_unplanned = leg.phase == NEW and not is_on_route(route)
    if is_unplanned or (not route.shifted and t - route.looked < LOOK):
        return leg, route
    route = drop_level(context, leg, scene, with_look(route, t, False))
    altitudes = altitude_plan_of(context, route)
    if is_clear(context, leg, scene, route, altitudes, tolerated(route)):
        return leg, route
    if route.clearance < 0.0 and t - route.sought < SEEK:
        return leg, route
    return with_new_route(context, leg, scene, route)


@compiled
def altitude_plan_of(context: PlanningContext, route: RouteFollowing) -> AltitudePlan:
    """Heights from here to the goal."""
    j = context
    return altitude_plan_left(route.level, route.fall, j.state, j.target, j.aircraft, j.gains)


@compiled
def tolerated(route: RouteFollowing) -> float:
    """Clearance with which a route is not given up yet [m]."""
    return TOLERATED * (route.clearance if route.clearance > 0.0 else CLEARANCES[0])


@compiled
def task_from(context: PlanningContext, start: Pose, goal: Pose, radius: float, t: float) -> Task:
    """What is to be flown from a pose in this wind."""
    wind_n = context.state.wind_n
    return Task(start, goal, radius, Air(context.gains.airspeed, wind_n[0], wind_n[1]), t)


@compiled
def entry_of(target: GuidanceTarget, final_approach: float) -> Pose:
    """Where the straight end of the approach begins."""
    c, s = math.cos(target.course), math.sin(target.course)
    return Pose(
        target.p_n[0] - final_approach * c, target.p_n[1] - final_approach * s, target.course
    )


@compiled
def pose_of(state: FlightState, ahead: float) -> Pose:
    """Where the vehicle will be `ahead` [s] from now, straight on."""
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
    """Whether the rest of the route is clear by what is wanted [m]."""
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
        edge = Edge(placed(entry, Pose(progress.x, progress.y, progress.course)), progress.path)
        rows = edge_row(edge).reshape(1, EDGE_WIDTH)
        travelled = travelled_in(progress.path, progress.segment, progress.left, progress.radius)
        return route_is_clear(hazards, task, wanted, rows, 0, progress.segment, travelled)
    if leg.phase == FIELD:
        return field_is_clear(state, leg, hazards, task, entry, wanted)
    return True


@compiled
def field_is_clear(
    state: FlightState, leg: Leg, hazards: KeepOutZones, task: Task, entry: Pose, wanted: float
) -> bool:
    """Whether the arc of the paper's field from here to the straight end is clear."""
    at = vehicle_from(entry, state)
    radius = max((at.x * at.x + at.y * at.y) / max(2.0 * abs(at.y), 1e-3), leg.radius)
    begin = placed(entry, Pose(at.x, at.y, 2.0 * math.atan2(at.y, at.x)))
    arc = Segment(begin, 1.0 if at.y > 0.0 else -1.0, arc_to_goal(at.x, at.y))
    if at.x >= 0.0:
        arc = Segment(entry, 0.0, leg.final_approach)
    demand = demand_of(hazards, task, wanted)
    task = Task(task.start, task.goal, radius, task.air, task.t)
    return check_segment(hazards, task, demand, arc, 0.0, task.t).blocker == NO_HAZARD


@compiled
def travelled_in(path: DubinsPath, segment: int, left: float, radius: float) -> float:
    """Length of a segment of a Dubins path that lies behind where so much is `left` of it [m]."""
    lengths = (path.arc, path.reach, path.end)
    return radius * max(0.0, lengths[segment] - left)


@compiled
def placed(frame: Pose, pose: Pose) -> Pose:
    """A pose that is given in the axes of another, NED."""
    c, s = math.cos(frame.course), math.sin(frame.course)
    x = frame.x + c * pose.x - s * pose.y
    return Pose(x, frame.y + s * pose.x + c * pose.y, frame.course + pose.course)


@compiled
def with_new_route(
    context: PlanningContext, leg: Leg, scene: Scene, route: RouteFollowing
) -> tuple[Leg, RouteFollowing]:
    """The leg along what is found, or as it was: over what blocks it, or with nothing found.

    A level that is kept is kept on a new route too. Where there is no route to the beginning of the
    straight end, one to the goal itself is taken.
    """
    state, target, radius = context.state, context.target, leg.radius
    altitudes, may_climb = altitude_plan_of(context, route), not is_on_route(route)
    may_climb = may_climb and math.isinf(altitudes.level)
    obstacles = left_in_path(scene.obstacles, altitudes, TOLERATED * CLEARANCES[0])
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

    That has to cost less than `most` [m]; where nothing is found the route is as it was.
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
    """The route without a level once the route is clear without it."""
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
    """Whether the rest of the route has all the clearance, and so has the place where it begins.

    Near a hazard less is asked for round the beginning, and none of it above one.
    """
    wanted, p_n = CLEARANCES[0], context.state.p_n
    obstacles = left_in_path(scene.obstacles, altitudes, wanted)
    near = hazards_of(obstacles, band_of(altitudes), wanted)
    if clearance_at(near, p_n[0], p_n[1], scene.t).distance < wanted:
        return False
    return is_clear(context, leg, scene, route, altitudes, wanted)
