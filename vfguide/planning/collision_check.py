"""Collision check: whether edges stay clear of hazards that may move during the flight."""

import math
from typing import NamedTuple

from vfguide.airspace.keep_out import KeepOutZones
from vfguide.airspace.planar_clearance import NO_HAZARD, clearance_at, free_path, near_hazards
from vfguide.geometry.se2 import Pose, unrotated
from vfguide.kernels.compiled import compiled
from vfguide.paths.edge import Edge, RouteEdges, Segment, edge_in, pose_along, segments_of

STEP_SHARE = 0.3
"""Least distance between two checked points, as a share of the wanted clearance; chosen."""
TURN_STEP = 0.6
"""Largest angle between two checked points of a turn [rad]; chosen, since the groundspeed changes
with the course."""
LEAST_GROUND_SPEED = 1.0
"""Least speed over ground with which times are computed [m/s]; chosen."""


class Air(NamedTuple):
    """Airspeed and wind, from which the groundspeed of a course follows."""

    airspeed: float
    """True airspeed [m/s]."""
    wind_x: float
    """Wind blowing to the north [m/s]."""
    wind_y: float
    """Wind blowing to the east [m/s]."""


class Task(NamedTuple):
    """A planning problem: from a pose to a pose."""

    start: Pose
    """Pose at the start, NED."""
    goal: Pose
    """Pose to reach, NED."""
    radius: float
    """Radius of the turns over ground [m]."""
    air: Air
    t: float
    """Time at the start, on the clock of the obstacles [s]."""


class Demand(NamedTuple):
    """Clearance that is wanted; around the ends less suffices, where there is no more."""

    wanted: float
    """Clearance along the route [m]."""
    at_start: float
    """Clearance that suffices around the start [m]."""
    at_goal: float
    """Clearance that suffices around the goal [m]."""
    step: float
    """Least distance between two checked points [m]; half of it is added to the clearance."""
    around: float
    """Distance from an end within which its clearance suffices [m]."""


class Check(NamedTuple):
    """Result of the check of an edge."""

    blocker: int
    """Row of the hazard that is too near, or `NO_HAZARD`."""
    t: float
    """Time at the end of the edge, or where it is blocked [s]."""


@compiled
def ground_speed(air: Air, course: float) -> float:
    """Speed over ground on a course over ground [m/s], at least LEAST_GROUND_SPEED."""
    c, s = math.cos(course), math.sin(course)
    along, across = unrotated(air.wind_x, air.wind_y, c, s)
    square = air.airspeed * air.airspeed - across * across
    return max(LEAST_GROUND_SPEED, along + math.sqrt(max(0.0, square)))


@compiled
def wanted_at(task: Task, demand: Demand, x: float, y: float) -> float:
    """Clearance that is wanted at (x, y) [m]."""
    wanted = demand.wanted
    if demand.at_start < wanted and math.hypot(x - task.start.x, y - task.start.y) < demand.around:
        wanted = demand.at_start
    if demand.at_goal < wanted and math.hypot(x - task.goal.x, y - task.goal.y) < demand.around:
        wanted = demand.at_goal
    return wanted


@compiled
def check_segment(
    hazards: KeepOutZones, task: Task, demand: Demand, segment: Segment, begin: float, t: float
) -> Check:
    """Whether a segment is clear from `begin` [m] after its start, reached at time `t` [s]."""
    travelled, radius = begin, task.radius
    near = hazards_beside(hazards, demand, segment, begin, radius)
    speed = ground_speed(task.air, segment.begin.course)
    while True:
        at = pose_along(segment, travelled, radius)
        if segment.side != 0.0:
            halfway = at.course + 0.5 * segment.side * TURN_STEP
            speed = ground_speed(task.air, halfway)
        wanted = wanted_at(task, demand, at.x, at.y)
        free, nearest = free_path(hazards, near, at.x, at.y, t, wanted, speed, demand.step)
        if free < 0.5 * demand.step:  # what may be lost between two points
            return Check(nearest, t)
        if travelled >= segment.length:
            return Check(NO_HAZARD, t)
        longest = TURN_STEP * radius if segment.side != 0.0 else math.inf
        step = min(max(free, demand.step), segment.length - travelled, longest)
        travelled += step
        t += step / speed


@compiled
def hazards_beside(
    hazards: KeepOutZones, demand: Demand, segment: Segment, begin: float, radius: float
) -> int:
    """Mask of the hazards that matter for the rest of a segment, see `near_hazards`."""
    half = 0.5 * (segment.length - begin)
    middle = pose_along(segment, begin + half, radius)
    return near_hazards(hazards, middle.x, middle.y, half + demand.wanted + demand.step)


@compiled
def check_edge(hazards: KeepOutZones, task: Task, demand: Demand, edge: Edge, t: float) -> Check:
    """Whether an edge that starts at time `t` [s] is clear."""
    one, two, three = segments_of(edge, task.radius)
    found = check_segment(hazards, task, demand, one, 0.0, t)
    if found.blocker == NO_HAZARD and two.length > 0.0:
        found = check_segment(hazards, task, demand, two, 0.0, found.t)
    if found.blocker == NO_HAZARD and three.length > 0.0:
        found = check_segment(hazards, task, demand, three, 0.0, found.t)
    return found


@compiled
def demand_of(hazards: KeepOutZones, task: Task, wanted: float) -> Demand:
    """The demand for a clearance [m], reduced at the ends to what there is."""
    slack = STEP_SHARE * wanted  # so that a start along a hazard is not blocked
    start, goal = task.start, task.goal
    at_start = clearance_at(hazards, start.x, start.y, task.t).distance - slack
    at_goal = clearance_at(hazards, goal.x, goal.y, task.t).distance - slack
    at_start, at_goal = min(wanted, at_start), min(wanted, at_goal)
    return Demand(wanted, at_start, at_goal, STEP_SHARE * wanted, task.radius)


@compiled
def route_is_clear(
    hazards: KeepOutZones,
    task: Task,
    wanted: float,
    route_edges: RouteEdges,
    first: int,
    segment: int,
    travelled: float,
) -> bool:
    """Whether the rest of a route is clear.

    Args:
        hazards: the known keep-out zones.
        task: `task.start` is the present pose, `task.t` the present time.
        wanted: clearance [m].
        route_edges: the route, one `Edge` a row.
        first: row of the present edge.
        segment: its present segment, 0 to 2.
        travelled: length of that segment that has been flown [m].
    """
    demand, t = demand_of(hazards, task, wanted), task.t
    for i in range(first, len(route_edges)):
        segments = segments_of(edge_in(route_edges, i), task.radius)
        for k in range(3):
            if i == first and k < segment:
                continue
            begin = travelled if i == first and k == segment else 0.0
            found = check_segment(hazards, task, demand, segments[k], begin, t)
            if found.blocker != NO_HAZARD:
                return False
            t = found.t
    return True
