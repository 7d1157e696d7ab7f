"""Route following: edge after edge, until the last one becomes the path of the leg.

The edges lie in the horizontal plane, NED. Each is followed as a Dubins path, by `path_progress`.
"""

import math
from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.aircraft.state import FlightState
from vfguide.geometry.angles import wrap
from vfguide.geometry.se2 import ORIGIN, Pose, seen_from
from vfguide.geometry.velocity import horizontal_norm
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Shape, replacing
from vfguide.paths.course_laws import Course, planar_of
from vfguide.paths.dubins import length_of
from vfguide.paths.edge import EDGE_WIDTH, FIRST_TURN, LAST_TURN, Edge, RouteEdges, edge_in
from vfguide.paths.leg import ON_PATH, Leg, in_phase, with_radius
from vfguide.paths.path_progress import TURN_IN, PathProgress, along, beside, path_course, path_left
from vfguide.planning.overflight import NO_LEVEL
from vfguide.planning.roadmap import MAX_ROUTE_EDGES
from vfguide.planning.route_search import FoundRoute

OFF_EDGE = 0.7
"""Distance beside an edge above which the route is checked anew [turn radii]; chosen."""


class RouteFollowing(NamedTuple):
    """State of the route around hazards, and of the searches for one."""

    length: int
    """Number of edges of the route; 0 while none is flown."""
    present: int
    """Index of the present edge."""
    segment: int
    """Present segment of that edge, as in `PathProgress`."""
    left: float
    """Rest of that segment, as in `PathProgress`."""
    radius: float
    """Radius of the turns [m]."""
    end: Pose
    """Pose at the end of the last edge, NED."""
    clearance: float
    """Clearance with which the route was found [m]; negative if none was found."""
    looked: float
    """Time of the last check of the route, on the clock of the obstacles [s]."""
    sought: float
    """Time of the last search for a route, on the clock of the obstacles [s]."""
    shifted: bool
    """Whether the leg has changed since the last check."""
    level: float
    """Level of the overflight, z of NED [m]; infinite for none."""
    fall: float
    """Path length to the goal at which its height is flown to again [m]."""
    route_edges: Annotated[NDArray[np.float64], Shape(MAX_ROUTE_EDGES, EDGE_WIDTH)]
    """The edges of the route, one `Edge` a row; rows after them have no meaning."""


with_shift = replacing(RouteFollowing, "shifted")
with_level = replacing(RouteFollowing, "level")
with_look = replacing(RouteFollowing, "looked", "shifted")
with_search = replacing(RouteFollowing, "looked", "sought", "length", "clearance")
with_overflight = replacing(RouteFollowing, "level", "fall", "clearance")
_with_edges = replacing(RouteFollowing, "length", "radius", "end", "clearance", "route_edges")
_at_edge = replacing(RouteFollowing, "present", "segment", "left")
_without_edges = replacing(RouteFollowing, "length")
_in_frame = replacing(PathProgress, "edge", "end")


@compiled
def fresh_following() -> RouteFollowing:
    """The state without a route, before the first check."""
    never, route_edges = -math.inf, np.zeros((MAX_ROUTE_EDGES, EDGE_WIDTH))
    nowhere = Pose(0.0, 0.0, 0.0)
    return RouteFollowing(
        0, 0, 0, 0.0, 0.0, nowhere, 0.0, never, never, True, NO_LEVEL, 0.0, route_edges
    )


@compiled
def is_on_route(route: RouteFollowing) -> bool:
    """Whether a route is flown."""
    return route.length > 0


@compiled
def begin_route(
    route: RouteFollowing, found: FoundRoute, end: Pose, radius: float
) -> RouteFollowing:
    """The state at the start of a route that was found, which ends at `end`."""
    count, route_edges = len(found.route_edges), route.route_edges.copy()
    for i in range(count):
        route_edges[i] = found.route_edges[i]
    return begin_edge(_with_edges(route, count, radius, end, found.clearance, route_edges), 0)


@compiled
def begin_edge(route: RouteFollowing, i: int) -> RouteFollowing:
    """The state at the start of edge `i`."""
    return _at_edge(route, i, FIRST_TURN, edge_at(route, i).path.arc)


@compiled
def edge_at(route: RouteFollowing, i: int) -> Edge:
    """Edge `i` of the route."""
    return edge_in(route.route_edges, i)


@compiled
def end_at(route: RouteFollowing, i: int) -> Pose:
    """Pose at the end of edge `i`, NED."""
    return edge_at(route, i + 1).begin if i + 1 < route.length else route.end


@compiled
def progress_of(route: RouteFollowing) -> PathProgress:
    """The present edge as a path with its progress, NED."""
    i = route.present
    return PathProgress(
        edge_at(route, i), end_at(route, i), route.radius, route.segment, route.left
    )


@compiled
def follow_route(route: RouteFollowing, state: FlightState, leg: Leg) -> tuple[RouteFollowing, Leg]:
    """The state after the edges that have been flown; the last edge becomes the leg's path."""
    last, at = route.length - 1, planar_of(state)
    while route.present < last:
        i = route.present
        progress = along(progress_of(route), at)
        route = _at_edge(route, i, progress.segment, progress.left)
        if beside(progress, at) > OFF_EDGE * route.radius:
            route = with_shift(route, True)
        if path_left(progress) > lead_into(route, i, state):
            return route, leg
        route = begin_edge(route, i + 1)
    begin = seen_from(route.end, edge_at(route, last).begin)
    progress = _in_frame(progress_of(route), Edge(begin, edge_at(route, last).path), ORIGIN)
    leg = in_phase(with_radius(leg, route.radius), ON_PATH, progress)
    return _without_edges(route, 0), leg


@compiled
def lead_into(route: RouteFollowing, i: int, state: FlightState) -> float:
    """Length before its end at which edge `i` is left for the next, for the lag of the bank [m]."""
    path, next_path = edge_at(route, i).path, edge_at(route, i + 1).path
    now = path.last if route.segment == LAST_TURN and path.end > 0.0 else 0.0
    then = next_path.first if next_path.arc > 0.0 else 0.0
    return TURN_IN * horizontal_norm(state.v_n) * abs(then - now)


@compiled
def route_course(route: RouteFollowing, state: FlightState, leg: Leg, course: float) -> Course:
    """Course along the present edge, relative to `course`, and the path length to the goal."""
    onto = path_course(progress_of(route), planar_of(state))
    remaining = onto.remaining + leg.final_approach
    for k in range(route.present + 1, route.length):
        remaining += route.radius * length_of(edge_at(route, k).path)
    return Course(wrap(onto.chi - course), onto.chi_rate, remaining)


@compiled
def edges_of(route: RouteFollowing) -> RouteEdges:
    """All edges of the route, one `Edge` a row."""
    return route.route_edges[: route.length]
