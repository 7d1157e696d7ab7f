"""Memory of a coarse search: tangent poses, the edges tried between them, and which are reached."""

import math
from heapq import heappush
from typing import NamedTuple

import numpy as np

from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import Table, width
from vfguide.geometry.vector import Indices, Mask, Series
from vfguide.paths.dubins import DubinsPath, length_of, read_dubins_path, write_dubins_path
from vfguide.paths.edge import Edge, next_path
from vfguide.paths.path_progress import Pose, read_pose

START, GOAL = 0, 1
"""Rows of the ends among the tangent poses."""
MAX_TANGENT_POSES = 1024
MOST_EDGES = 30_000
"""Of one search."""
MAX_ROUTE_EDGES = 8
"""Of a route."""
HEURISTIC_WEIGHT = 1.1
"""What is left counts so much more than what is gone: fewer edges are tried, and the route is
longer than the shortest over the same tangent poses by no more than that."""

Queue = list[tuple[float, int]]
"""Edges by the length of the route through them that can be hoped for [m]."""
Counter = Indices
"""One number that compiled code counts up, (1,)."""
POSE_WIDTH, DUBINS_PATH_WIDTH = width(Pose), width(DubinsPath)
"""How many numbers the row of a pose has, and that of a Dubins path."""


class TangentPoses(NamedTuple):
    """Poses a route may lead through, the first two its ends; arrays of one row each."""

    used: Counter
    """How many there are."""
    poses: Table
    """A `Pose` a row."""
    cost_to_go: Series
    """Least length to the goal [m], negative while unknown."""
    cost_to_come: Series
    """Length of the route by which it was reached [m], infinite before."""
    times: Series
    """When it is reached [s]."""
    depth: Indices
    """Edges of the route by which it was reached."""
    edges: Indices
    """The last of that route."""
    avoids: Mask
    """(tangent poses, hazards): whether edges from here to the tangent poses of a hazard are in
    the queue."""
    first: Indices
    after: Indices
    """(hazards + 1,): first tangent pose of each hazard, and the one after its last; both 0
    before. The last of the hazards stands for poses near the ends."""


class Edges(NamedTuple):
    """Edges tried or to be tried; arrays of one row each."""

    used: Counter
    """How many there are."""
    begins: Indices
    ends: Indices
    """The tangent poses at both ends."""
    above: Series
    """Only Dubins paths longer than this are left to be tried [radii]."""
    paths: Table
    """A `DubinsPath` a row."""
    known: Mask
    """Whether the Dubins path has been found."""


@compiled
def new_tangent_poses(hazards: int) -> TangentPoses:
    """No tangent poses yet, for so many hazards."""
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
    """No edges yet."""
    return Edges(
        np.zeros(1, np.int64),
        np.empty(MOST_EDGES, np.int64),
        np.empty(MOST_EDGES, np.int64),
        np.empty(MOST_EDGES),
        np.empty((MOST_EDGES, DUBINS_PATH_WIDTH)),
        np.zeros(MOST_EDGES, np.bool_),
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
    """Queues an edge whose Dubins path is not known yet, with the straight line as its length."""
    e = edges.used[0]
    if e == MOST_EDGES or tangents.cost_to_come[end] < math.inf:
        return
    edges.used[0] = e + 1
    edges.begins[e], edges.ends[e], edges.above[e] = begin, end, -1.0
    here, there, goal = pose_in(tangents, begin), pose_in(tangents, end), pose_in(tangents, GOAL)
    cost_to_go = tangents.cost_to_go[end]
    if cost_to_go < 0.0:
        cost_to_go = math.hypot(goal.x - there.x, goal.y - there.y)
    hoped = (
        tangents.cost_to_come[begin]
        + math.hypot(there.x - here.x, there.y - here.y)
        + HEURISTIC_WEIGHT * cost_to_go
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
    """The end of an edge is reached along it at time `t`."""
    begin, end = edges.begins[e], edges.ends[e]
    tangents.cost_to_come[end] = tangents.cost_to_come[begin] + radius * edges.above[e]
    tangents.depth[end] = tangents.depth[begin] + 1
    tangents.times[end], tangents.edges[end] = t, e
