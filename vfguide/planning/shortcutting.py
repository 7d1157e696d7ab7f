"""Shortcutting: leaves tangent poses of a route out, and slides those that are left.

R. Geraerts and M. H. Overmars, Creating High-quality Paths for Motion Planning, 2007.
"""

import math

import numpy as np

from vfguide.airspace.keep_out import KeepOutZones, read_zone_row
from vfguide.airspace.planar_clearance import NO_HAZARD
from vfguide.geometry.se2 import Pose, composed
from vfguide.kernels.compiled import compiled
from vfguide.paths.edge import (
    EDGE_WIDTH,
    Edge,
    RouteEdges,
    edge_in,
    edge_row,
    next_path,
    route_length,
)
from vfguide.planning.collision_check import Demand, Task, check_edge

SLIDES = 0.3, 0.1
"""Distances by which tangent poses are slid and turned [turn radii, and rad]; chosen."""
LEAST_SAVING = 0.5
"""Least length that a change of the route must save [m]; chosen."""


@compiled
def shortened(
    hazards: KeepOutZones, task: Task, demand: Demand, route_edges: RouteEdges
) -> RouteEdges:
    """The route without needless tangent poses, the others slid where that shortens it."""
    i = 1
    while i < len(route_edges):
        candidate = without(task, route_edges, i)
        better = is_better(hazards, task, demand, candidate, route_edges, i - 1, i)
        route_edges = candidate if better else route_edges
        i += 0 if better else 1
    for size in SLIDES:
        for i in range(1, len(route_edges)):
            route_edges = slid(hazards, task, demand, route_edges, i, size)
    return route_edges


@compiled
def slid(
    hazards: KeepOutZones, task: Task, demand: Demand, route_edges: RouteEdges, i: int, size: float
) -> RouteEdges:
    """The route with the start of edge `i` slid across and along its course, and turned."""
    for side in (1.0, -1.0):
        for k in range(3):
            across = side * size * task.radius if k == 0 else 0.0
            along = side * size * task.radius if k == 1 else 0.0
            change = Pose(along, across, side * size if k == 2 else 0.0)
            there = composed(edge_in(route_edges, i).begin, change)
            candidate = through(task, route_edges, i, there)
            if is_better(hazards, task, demand, candidate, route_edges, i - 1, i + 1):
                route_edges = candidate
    return route_edges


@compiled
def is_better(
    hazards: KeepOutZones,
    task: Task,
    demand: Demand,
    candidate: RouteEdges,
    route_edges: RouteEdges,
    first: int,
    last: int,
) -> bool:
    """Whether a route is shorter than another and clear; only edges `first` to `last` are new."""
    saved = route_length(route_edges, task.radius) - route_length(candidate, task.radius)
    if not saved > LEAST_SAVING:
        return False
    if moves(hazards):
        first, last = 0, len(candidate)
    t = task.t
    for i in range(first, last):
        found = check_edge(hazards, task, demand, edge_in(candidate, i), t)
        if found.blocker != NO_HAZARD:
            return False
        t = found.t
    return True


@compiled
def moves(hazards: KeepOutZones) -> bool:
    """Whether any hazard moves or exists for a limited time, so that times matter."""
    for i in range(len(hazards.table)):
        zone = read_zone_row(hazards.table[i])
        if zone.speed > 0.0 or zone.since > -math.inf:
            return True
    return False


@compiled
def end_of(task: Task, route_edges: RouteEdges, i: int) -> Pose:
    """Pose at the end of edge `i`, NED."""
    return edge_in(route_edges, i + 1).begin if i + 1 < len(route_edges) else task.goal


@compiled
def edge_between(begin: Pose, end: Pose, radius: float) -> Edge:
    """The shortest edge between two poses with turns of `radius` [m]."""
    return Edge(begin, next_path(begin, end, radius, -1.0))


@compiled
def without(task: Task, route_edges: RouteEdges, i: int) -> RouteEdges:
    """The route with one edge in place of edges `i` - 1 and `i`."""
    candidate: RouteEdges = np.empty((len(route_edges) - 1, EDGE_WIDTH))
    candidate[: i - 1], candidate[i:] = route_edges[: i - 1], route_edges[i + 1 :]
    begin = edge_in(route_edges, i - 1).begin
    candidate[i - 1] = edge_row(edge_between(begin, end_of(task, route_edges, i), task.radius))
    return candidate


@compiled
def through(task: Task, route_edges: RouteEdges, i: int, tangent: Pose) -> RouteEdges:
    """The route with the start of edge `i` at another tangent pose."""
    candidate = route_edges.copy()
    begin, end = edge_in(route_edges, i - 1).begin, end_of(task, route_edges, i)
    candidate[i - 1] = edge_row(edge_between(begin, tangent, task.radius))
    candidate[i] = edge_row(edge_between(tangent, end, task.radius))
    return candidate
