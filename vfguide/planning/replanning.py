"""When to look for a way round hazards, or over them, and what becomes of the leg then.

The way that is flown is looked along several times a second; where something that is known comes
too near to it, or where the flight law has changed it by itself, the coarse search finds another.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.performance import Gains, Performance
from vfguide.aircraft.state import FlightState
from vfguide.airspace.keep_out import Outlines, hazards_of, joined
from vfguide.airspace.planar_clearance import NOTHING, clearance_at
from vfguide.field.obstacle import Rows
from vfguide.geometry.compiled import compiled
from vfguide.paths.course_laws import arc_to_goal
from vfguide.paths.dubins import Word, length_of
from vfguide.paths.edge import HOP_COLUMNS, Hop, Piece, hop_row, next_word
from vfguide.paths.leg import AWAY, FIELD, NEW, WAY, Leg, with_final
from vfguide.paths.path_progress import TURN_IN, Pose
from vfguide.planning.collision_check import Air, Task, check_piece, demand_of, way_is_clear
from vfguide.planning.objective import Target
from vfguide.planning.overflight import (
    NO_LEVEL,
    Heights,
    band_of,
    cost_of,
    heights_by,
    heights_left,
    left_in_way,
    levels_for,
)
from vfguide.planning.route_following import (
    RouteState,
    begin_route,
    follow_route,
    hop_at,
    hops_of,
    is_on_route,
    vehicle_from,
    with_level,
    with_look,
    with_overflight,
    with_search,
)
from vfguide.planning.route_search import CLEARANCES, find_detour

LOOK = 0.2
"""Between two looks along the way [s]."""
SEEK = 1.0
"""Between two searches that found nothing [s]."""
TOLERATED = 0.6
"""Part of the clearance that was found of which so much is left when a way is given up."""


class Journey(NamedTuple):
    """Who flies where."""

    state: FlightState
    target: Target
    aircraft: Performance
    gains: Gains


class Scene(NamedTuple):
    """What may be in the way."""

    obstacles: Rows
    """That are known."""
    fence: Outlines
    """To stay in or out of."""
    highest: float
    """Nothing is passed over above this, down from the origin [m]."""
    t: float
    """Now, on the clock of the obstacles [s]."""


@compiled
def seek_way(journey: Journey, leg: Leg, scene: Scene, route: RouteState) -> tuple[Leg, RouteState]:
    """The leg with a way that keeps clear of the hazards, if it needs another."""
    t = scene.t
    if is_on_route(route):
        route, leg = follow_route(route, journey.state, leg)
    is_unplanned = leg.phase == NEW and not is_on_route(route)
    if is_unplanned or (not route.shifted and t - route.looked < LOOK):
        return leg, route
    route = drop_level(journey, leg, scene, with_look(route, t, False))
    heights = heights_of(journey, route)
    if is_clear(journey, leg, scene, route, heights, tolerated(route)):
        return leg, route
    if route.clearance < 0.0 and t - route.sought < SEEK:
        return leg, route
    return with_new_way(journey, leg, scene, route)


@compiled
def heights_of(journey: Journey, route: RouteState) -> Heights:
    """Heights from here to the goal."""
    j = journey
    return heights_left(route.level, route.fall, j.state, j.target, j.aircraft, j.gains)


@compiled
def tolerated(route: RouteState) -> float:
    """Clearance with which a way is not given up yet [m]."""
    return TOLERATED * (route.clearance if route.clearance > 0.0 else CLEARANCES[0])


@compiled
def task_from(journey: Journey, start: Pose, goal: Pose, radius: float, t: float) -> Task:
    """What is to be flown from a pose in this wind."""
    wind_n = journey.state.wind_n
    return Task(start, goal, radius, Air(journey.gains.airspeed, wind_n[0], wind_n[1]), t)


@compiled
def entry_of(target: Target, final: float) -> Pose:
    """Where the straight end of the approach begins."""
    c, s = math.cos(target.course), math.sin(target.course)
    return Pose(target.p_n[0] - final * c, target.p_n[1] - final * s, target.course)


@compiled
def pose_of(state: FlightState, ahead: float) -> Pose:
    """Where the vehicle will be `ahead` [s] from now, straight on."""
    x = state.p_n[0] + ahead * state.v_n[0]
    y = state.p_n[1] + ahead * state.v_n[1]
    return Pose(x, y, math.atan2(state.v_n[1], state.v_n[0]))


@compiled
def is_clear(
    journey: Journey,
    leg: Leg,
    scene: Scene,
    route: RouteState,
    heights: Heights,
    wanted: float,
) -> bool:
    """Whether the rest of the way is clear by what is wanted [m]."""
    state, target = journey.state, journey.target
    obstacles = left_in_way(scene.obstacles, heights, wanted)
    hazards = joined(hazards_of(obstacles, band_of(heights), wanted), scene.fence)
    here, entry = pose_of(state, 0.0), entry_of(target, leg.final)
    task = task_from(journey, here, entry_of(target, 0.0), leg.radius, scene.t)
    if is_on_route(route):
        gone = gone_in(hop_at(route, route.present).word, route.piece, route.left, leg.radius)
        return way_is_clear(hazards, task, wanted, hops_of(route), route.present, route.piece, gone)
    if leg.phase == WAY:
        way = leg.way
        hop = Hop(placed(entry, Pose(way.x, way.y, way.course)), way.word)
        rows = hop_row(hop).reshape(1, HOP_COLUMNS)
        gone = gone_in(way.word, way.piece, way.left, way.radius)
        return way_is_clear(hazards, task, wanted, rows, 0, way.piece, gone)
    if leg.phase == FIELD:
        return field_is_clear(state, leg, hazards, task, entry, wanted)
    return True


@compiled
def field_is_clear(
    state: FlightState, leg: Leg, hazards: Outlines, task: Task, entry: Pose, wanted: float
) -> bool:
    """Whether the arc of the paper's field from here to the straight end is clear."""
    at = vehicle_from(entry, state)
    radius = max((at.x * at.x + at.y * at.y) / max(2.0 * abs(at.y), 1e-3), leg.radius)
    begin = placed(entry, Pose(at.x, at.y, 2.0 * math.atan2(at.y, at.x)))
    arc = Piece(begin, 1.0 if at.y > 0.0 else -1.0, arc_to_goal(at.x, at.y))
    if at.x >= 0.0:
        arc = Piece(entry, 0.0, leg.final)
    demand = demand_of(hazards, task, wanted)
    task = Task(task.start, task.goal, radius, task.air, task.t)
    return check_piece(hazards, task, demand, arc, 0.0, task.t).blocker == NOTHING


@compiled
def gone_in(word: Word, piece: int, left: float, radius: float) -> float:
    """Length of a piece of a word that lies behind where so much is `left` of it [m]."""
    lengths = (word.arc, word.reach, word.end)
    return radius * max(0.0, lengths[piece] - left)


@compiled
def placed(frame: Pose, pose: Pose) -> Pose:
    """A pose that is given in the axes of another, NED."""
    c, s = math.cos(frame.course), math.sin(frame.course)
    x = frame.x + c * pose.x - s * pose.y
    return Pose(x, frame.y + s * pose.x + c * pose.y, frame.course + pose.course)


@compiled
def with_new_way(
    journey: Journey, leg: Leg, scene: Scene, route: RouteState
) -> tuple[Leg, RouteState]:
    """The leg along what is found, or as it was: over what is in its way, or with nothing found.

    A level that is kept is kept on a new way too. Where there is no way to the beginning of the
    straight end, one to the goal itself is taken.
    """
    state, target, radius = journey.state, journey.target, leg.radius
    heights, may_climb = heights_of(journey, route), not is_on_route(route)
    may_climb = may_climb and math.isinf(heights.level)
    obstacles = left_in_way(scene.obstacles, heights, TOLERATED * CLEARANCES[0])
    route = with_search(route, scene.t, scene.t, 0, -1.0)
    begin = pose_of(state, TURN_IN)
    for end in (journey.gains.final * radius, 0.0):
        entry = entry_of(target, end)
        task = task_from(journey, begin, entry, radius, scene.t + TURN_IN)
        found = find_detour(obstacles, scene.fence, band_of(heights), task)
        if len(found.hops) > 0:
            longer = found.length - radius * length_of(next_word(begin, entry, radius, -1.0))
            if may_climb:
                over = seek_level(journey, leg, scene, route, longer)
                if over.clearance > 0.0:
                    return leg, over
            route = begin_route(route, found, entry, radius)
            route, leg = follow_route(route, state, with_final(leg, end))
            return leg, route
    if may_climb:
        route = seek_level(journey, leg, scene, route, math.inf)
    return leg, route


@compiled
def seek_level(
    journey: Journey, leg: Leg, scene: Scene, route: RouteState, most: float
) -> RouteState:
    """The route over what is in the way, where the leg is clear at another height.

    That has to cost less than `most` [m]; where nothing is found the route is as it was.
    """
    its, wanted = journey, CLEARANCES[0]
    here, goal = its.state.p_n[2], its.target.p_n[2]
    for level in levels_for(scene.obstacles, here, goal, scene.highest, wanted):
        if cost_of(level, here, goal) >= most:
            break
        heights = heights_by(level, its.state, its.target, its.aircraft, its.gains)
        if is_free(journey, leg, scene, route, heights):
            return with_overflight(route, level, heights.fall, wanted)
    return route


@compiled
def drop_level(journey: Journey, leg: Leg, scene: Scene, route: RouteState) -> RouteState:
    """The route without a level once the way is clear without it."""
    if not math.isinf(route.level):
        state, target = journey.state, journey.target
        heights = Heights(state.p_n, target.p_n, NO_LEVEL, 0.0, 0.0)
        if leg.phase != AWAY and is_free(journey, leg, scene, route, heights):
            return with_level(route, NO_LEVEL)
    return route


@compiled
def is_free(journey: Journey, leg: Leg, scene: Scene, route: RouteState, heights: Heights) -> bool:
    """Whether the rest of the way has all the clearance, and so has the place where it begins.

    Near a hazard less is asked for round the beginning, and none of it above one.
    """
    wanted, p_n = CLEARANCES[0], journey.state.p_n
    obstacles = left_in_way(scene.obstacles, heights, wanted)
    near = hazards_of(obstacles, band_of(heights), wanted)
    if clearance_at(near, p_n[0], p_n[1], scene.t).distance < wanted:
        return False
    return is_clear(journey, leg, scene, route, heights, wanted)
