"""Replanning: when to search for a route around hazards, or over them.

The route is checked several times a second. Where a known hazard is too near to it, or where the
leg has changed, the graph search finds another.
"""

import math

from vfguide.kernels.compiled import compiled
from vfguide.paths.dubins import length_of
from vfguide.paths.edge import next_path
from vfguide.paths.leg import NEW, OUTBOUND, Leg, with_final_approach
from vfguide.paths.path_progress import TURN_IN
from vfguide.planning.overflight import (
    NO_LEVEL,
    AltitudePlan,
    altitude_plan_by,
    band_of,
    cost_of,
    left_in_path,
    levels_for,
)
from vfguide.planning.route_ahead import (
    PlanningContext,
    Scene,
    altitude_plan_of,
    entry_of,
    is_clear,
    is_free,
    pose_of,
    task_from,
)
from vfguide.planning.route_following import (
    RouteFollowing,
    begin_route,
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
def tolerated(route: RouteFollowing) -> float:
    """Clearance with which the present route is kept [m]."""
    return KEPT_CLEARANCE * (route.clearance if route.clearance > 0.0 else CLEARANCES[0])


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
