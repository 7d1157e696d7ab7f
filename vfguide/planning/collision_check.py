"""Whether edges stay clear of the hazards, which may move while one flies."""

import math
from typing import NamedTuple

from vfguide.airspace.keep_out import KeepOutZones
from vfguide.airspace.planar_clearance import NO_HAZARD, clearance_at, free_path, near_hazards
from vfguide.geometry.compiled import compiled
from vfguide.paths.edge import Edge, RouteEdges, Segment, edge_in, pose_along, segments_of
from vfguide.paths.path_progress import Pose

SHORTEST_STEP = 0.3
"""Between two looks at the hazards, of the wanted clearance."""
LONGEST_TURN = 0.6
"""Between two looks in a turn [rad], for the speed over ground."""
SLOWEST = 1.0
"""Speed over ground for which times are right, at least [m/s]."""


class Air(NamedTuple):
    """What makes courses fast and slow."""

    airspeed: float
    wind_x: float
    wind_y: float
    """Towards, NED [m/s]."""


class Task(NamedTuple):
    """What is to be flown."""

    start: Pose
    goal: Pose
    radius: float
    """Of the turns over ground [m]."""
    air: Air
    t: float
    """When it begins [s]."""


class Demand(NamedTuple):
    """How clear one wants to be: less around the ends, where one has to be."""

    wanted: float
    at_start: float
    at_goal: float
    """Clearance that there is [m]."""
    step: float
    """Between two looks at the hazards [m]; half of it comes on top of the clearance."""
    around: float
    """As near as this to an end its clearance is enough [m]."""


class Check(NamedTuple):
    """What is found along an edge."""

    blocker: int
    """Row of the hazard that is too near, else `NO_HAZARD`."""
    t: float
    """At its end, or where it is blocked [s]."""


@compiled
def ground_speed(air: Air, course: float) -> float:
    """Speed over ground on a course over ground [m/s], at least SLOWEST."""
    c, s = math.cos(course), math.sin(course)
    along, across = air.wind_x * c + air.wind_y * s, air.wind_y * c - air.wind_x * s
    square = air.airspeed * air.airspeed - across * across
    return max(SLOWEST, along + math.sqrt(max(0.0, square)))


@compiled
def wanted_at(task: Task, demand: Demand, x: float, y: float) -> float:
    """Clearance that is wanted at a place [m]."""
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
    """Whether a segment is clear from `begin` [m] after its beginning, where one is at `t`."""
    travelled, radius = begin, task.radius
    near = hazards_beside(hazards, demand, segment, begin, radius)
    speed = ground_speed(task.air, segment.begin.course)
    while True:
        at = pose_along(segment, travelled, radius)
        if segment.side != 0.0:
            halfway = at.course + 0.5 * segment.side * LONGEST_TURN
            speed = ground_speed(task.air, halfway)
        wanted = wanted_at(task, demand, at.x, at.y)
        free, nearest = free_path(hazards, near, at.x, at.y, t, wanted, speed, demand.step)
        if free < 0.5 * demand.step:  # what is lost until the next look, or since the last one
            return Check(nearest, t)
        if travelled >= segment.length:
            return Check(NO_HAZARD, t)
        longest = LONGEST_TURN * radius if segment.side != 0.0 else math.inf
        step = min(max(free, demand.step), segment.length - travelled, longest)
        travelled += step
        t += step / speed


@compiled
def hazards_beside(
    hazards: KeepOutZones, demand: Demand, segment: Segment, begin: float, radius: float
) -> int:
    """The hazards that matter for the rest of a segment, see `near_hazards`."""
    half = 0.5 * (segment.length - begin)
    middle = pose_along(segment, begin + half, radius)
    return near_hazards(hazards, middle.x, middle.y, half + demand.wanted + demand.step)


@compiled
def check_edge(hazards: KeepOutZones, task: Task, demand: Demand, edge: Edge, t: float) -> Check:
    """Whether an edge that begins at `t` is clear."""
    one, two, three = segments_of(edge, task.radius)
    found = check_segment(hazards, task, demand, one, 0.0, t)
    if found.blocker == NO_HAZARD and two.length > 0.0:
        found = check_segment(hazards, task, demand, two, 0.0, found.t)
    if found.blocker == NO_HAZARD and three.length > 0.0:
        found = check_segment(hazards, task, demand, three, 0.0, found.t)
    return found


@compiled
def demand_of(hazards: KeepOutZones, task: Task, wanted: float) -> Demand:
    """The clearance that is wanted, and what there is at the ends."""
    slack = SHORTEST_STEP * wanted  # what begins along a hazard is not blocked
    start, goal = task.start, task.goal
    at_start = clearance_at(hazards, start.x, start.y, task.t).distance - slack
    at_goal = clearance_at(hazards, goal.x, goal.y, task.t).distance - slack
    at_start, at_goal = min(wanted, at_start), min(wanted, at_goal)
    return Demand(wanted, at_start, at_goal, SHORTEST_STEP * wanted, task.radius)


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
    """Whether the rest of a chain of edges is clear.

    Args:
        hazards: as they are believed to be now.
        task: `task.start` is the present place, `task.t` the present time.
        wanted: clearance [m].
        route_edges: a `Edge` a row.
        first: row of the edge that is flown.
        segment: its segment that is flown, 0 to 2.
        travelled: length of it that lies behind [m].
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
