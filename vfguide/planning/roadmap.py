"""Roadmap of one graph search: tangent poses, edges between them, and the costs to reach them.

S. M. LaValle, Planning Algorithms, 2006, chapters 5 and 15 (roadmaps and Dubins paths).
"""

import math
from heapq import heappush
from typing import NamedTuple

import numpy as np

from vfguide.geometry.se2 import Pose, distance_between, read_pose
from vfguide.geometry.vector import Indices, Mask, Series
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Table, width
from vfguide.paths.dubins import DubinsPath, length_of, read_dubins_path, write_dubins_path
from vfguide.paths.edge import Edge, next_path

START = 0
"""Index of the start among the tangent poses."""
GOAL = 1
"""Index of the goal among the tangent poses."""
MAX_TANGENT_POSES = 1024
"""Largest number of tangent poses of one search; chosen for its memory."""
MAX_EDGES = 30_000
"""Largest number of edges of one search; chosen for its memory."""
MAX_ROUTE_EDGES = 8
"""Largest number of edges of a route; chosen for the size of the state."""
HEURISTIC_WEIGHT = 1.1
"""Weight of the cost to go, a factor: fewer edges are tried, and the route is longer than the
shortest one over the same tangent poses by at most this factor (weighted A*: I. Pohl, Heuristic
Search Viewed as Path Finding in a Graph, 1970); chosen."""

Queue = list[tuple[float, int]]
"""A heap of the least length of a route through an edge [m], and the number of the edge."""
Counter = Indices
"""One number that compiled code counts up, (1,)."""
POSE_WIDTH = width(Pose)
"""Number of floats in the row of a `Pose`."""
DUBINS_PATH_WIDTH = width(DubinsPath)
"""Number of floats in the row of a `DubinsPath`."""


class TangentPoses(NamedTuple):
    """Poses that a route may pass, the first two its ends; arrays with one row for each."""

    used: Counter
    """Number of rows in use, (1,)."""
    poses: Table
    """One `Pose` a row, NED."""
    cost_to_go: Series
    """Least length to the goal [m], negative while unknown."""
    cost_to_come: Series
    """Length of the route by which it was reached [m], infinite while it is not."""
    times: Series
    """Time at which it is reached [s]."""
    depth: Indices
    """Number of edges of the route by which it was reached."""
    edges: Indices
    """Number of the last edge of that route, -1 for none."""
    avoids: Mask
    """(tangent poses, hazards): whether edges from here to the tangent poses of a hazard are in
    the queue."""
    first: Indices
    """(hazards + 1,): first tangent pose of each hazard, 0 while it has none. The last entry stands
    for the poses near the ends."""
    after: Indices
    """(hazards + 1,): the tangent pose after the last one of each hazard, 0 while it has none."""


class Edges(NamedTuple):
    """Edges that were tried or are to be tried; arrays with one row for each."""

    used: Counter
    """Number of rows in use, (1,)."""
    begins: Indices
    """Tangent pose at the start of each."""
    ends: Indices
    """Tangent pose at the end of each."""
    above: Series
    """Length above which Dubins paths are still to be tried [turn radii]."""
    paths: Table
    """One `DubinsPath` a row."""
    known: Mask
    """Whether the Dubins path has been found."""


@compiled
def new_tangent_poses(hazards: int) -> TangentPoses:
    """Arrays without tangent poses, for a number of hazards."""
    return TangentPoses(
        np.zeros(1, np.int64),
        np.empty((MAX_TANGENT_POSES, POSE_WIDTH)),
        np.full(MAX_TANGENT_POSES, -1.0),
        np.full(MAX_TANGENT_POSES, math.inf),
        np.zeros(MAX_TANGENT_POSES),
        np.zeros(MAX_TANGENT_POSES, np.int64),
        np.full(MAX_TANGENT_POSES, -1),
        np.zeros((MAX_TANGENT_POSES, hazards), np.bool_),
        np.zeros(hazards + 1, np.int64),
        np.zeros(hazards + 1, np.int64),
    )


@compiled
def new_edges() -> Edges:
    """Arrays without edges."""
    return Edges(
        np.zeros(1, np.int64),
        np.empty(MAX_EDGES, np.int64),
        np.empty(MAX_EDGES, np.int64),
        np.empty(MAX_EDGES),
        np.empty((MAX_EDGES, DUBINS_PATH_WIDTH)),
        np.zeros(MAX_EDGES, np.bool_),
    )


@compiled
def pose_in(tangents: TangentPoses, i: int) -> Pose:
    """The pose in row `i`."""
    return read_pose(tangents.poses[i])


@compiled
def path_in(edges: Edges, e: int) -> DubinsPath:
    """The Dubins path of edge `e`."""
    return read_dubins_path(edges.paths[e])


@compiled
def edge_of(tangents: TangentPoses, edges: Edges, e: int) -> Edge:
    """Edge `e` as a record."""
    return Edge(pose_in(tangents, edges.begins[e]), path_in(edges, e))


@compiled
def add_edge(tangents: TangentPoses, edges: Edges, queue: Queue, begin: int, end: int) -> None:
    """Queues an edge without a Dubins path yet, with the straight line as its length."""
    e = edges.used[0]
    if e == MAX_EDGES or tangents.cost_to_come[end] < math.inf:
        return
    edges.used[0] = e + 1
    edges.begins[e], edges.ends[e], edges.above[e] = begin, end, -1.0
    here, there, goal = pose_in(tangents, begin), pose_in(tangents, end), pose_in(tangents, GOAL)
    cost_to_go = tangents.cost_to_go[end]
    if cost_to_go < 0.0:
        cost_to_go = distance_between(goal, there)
    hoped = (
        tangents.cost_to_come[begin] + distance_between(there, here) + HEURISTIC_WEIGHT * cost_to_go
    )
    heappush(queue, (float(hoped), e))


@compiled
def add_edges(tangents: TangentPoses, edges: Edges, queue: Queue, begin: int, hazard: int) -> None:
    """Queues edges to all tangent poses of a hazard."""
    for tangent in range(tangents.first[hazard], tangents.after[hazard]):
        if tangent != begin:
            add_edge(tangents, edges, queue, begin, tangent)


@compiled
def find_path(tangents: TangentPoses, edges: Edges, queue: Queue, e: int, radius: float) -> None:
    """Finds the Dubins path of an edge, and queues it again with its length."""
    begin, end = edges.begins[e], edges.ends[e]
    if tangents.cost_to_go[end] < 0.0:
        path = next_path(pose_in(tangents, end), pose_in(tangents, GOAL), radius, -1.0)
        tangents.cost_to_go[end] = radius * length_of(path)
    path = next_path(pose_in(tangents, begin), pose_in(tangents, end), radius, edges.above[e])
    length = length_of(path)
    if length < math.inf:
        write_dubins_path(path, edges.paths[e])
        edges.known[e], edges.above[e] = True, length
        hoped = (
            tangents.cost_to_come[begin]
            + radius * length
            + HEURISTIC_WEIGHT * tangents.cost_to_go[end]
        )
        heappush(queue, (float(hoped), e))


@compiled
def try_longer(tangents: TangentPoses, edges: Edges, queue: Queue, e: int, radius: float) -> None:
    """Queues an edge again whose Dubins path was blocked, for a longer one."""
    edges.known[e] = False
    begin, end = edges.begins[e], edges.ends[e]
    hoped = (
        tangents.cost_to_come[begin]
        + radius * edges.above[e]
        + HEURISTIC_WEIGHT * tangents.cost_to_go[end]
    )
    heappush(queue, (float(hoped), e))


@compiled
def settle(tangents: TangentPoses, edges: Edges, e: int, radius: float, t: float) -> None:
    """Records that the end of an edge is reached along it at time `t` [s]."""
    begin, end = edges.begins[e], edges.ends[e]
    tangents.cost_to_come[end] = tangents.cost_to_come[begin] + radius * edges.above[e]
    tangents.depth[end] = tangents.depth[begin] + 1
    tangents.times[end], tangents.edges[end] = t, e
