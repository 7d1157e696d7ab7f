"""The route ahead: what is left of a route, a path or the field, and whether it is clear.

Positions are NED; the route is flown in the present wind.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.performance import Gains, Performance
from vfguide.aircraft.state import FlightState
from vfguide.airspace.keep_out import KeepOutZones, joined, obstacle_zones
from vfguide.airspace.planar_clearance import NO_HAZARD, clearance_at
from vfguide.field.obstacle import Rows
from vfguide.geometry.se2 import Pose, composed, straight_on
from vfguide.geometry.velocity import azimuth_of
from vfguide.kernels.compiled import compiled
from vfguide.paths.course_laws import arc_to_goal, planar_from, planar_of
from vfguide.paths.dubins import DubinsPath
from vfguide.paths.edge import EDGE_WIDTH, Edge, Segment, edge_row
from vfguide.paths.leg import FIELD, ON_PATH, Leg
from vfguide.planning.collision_check import Air, Task, check_segment, demand_of, route_is_clear
from vfguide.planning.objective import GuidanceTarget, pose_of_target
from vfguide.planning.overflight import AltitudePlan, altitude_plan_left, band_of, left_in_path
from vfguide.planning.route_following import RouteFollowing, edge_at, edges_of, is_on_route
from vfguide.planning.route_search import CLEARANCES


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
def altitude_plan_of(context: PlanningContext, route: RouteFollowing) -> AltitudePlan:
    """The altitude plan from here to the goal."""
    j = context
    return altitude_plan_left(route.level, route.fall, j.state, j.target, j.aircraft, j.gains)


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
    return Pose(x, y, azimuth_of(state.v_n))


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
    hazards = joined(obstacle_zones(obstacles, band_of(altitudes), wanted), scene.fence)
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
def is_free(
    context: PlanningContext, leg: Leg, scene: Scene, route: RouteFollowing, altitudes: AltitudePlan
) -> bool:
    """Whether the rest of the route has the full clearance, the present position included.

    `is_clear` alone asks for less around the start where a hazard is near it.
    """
    wanted, p_n = CLEARANCES[0], context.state.p_n
    obstacles = left_in_path(scene.obstacles, altitudes, wanted)
    near = obstacle_zones(obstacles, band_of(altitudes), wanted)
    if clearance_at(near, p_n[0], p_n[1], scene.t).distance < wanted:
        return False
    return is_clear(context, leg, scene, route, altitudes, wanted)
