"""Graph search: the shortest route over tangent poses around the hazards that it meets.

It is an A* search whose edges are Dubins paths. It starts with the start and the goal alone; where
an edge is blocked, the tangent poses around its blocker become neighbours of the pose it started
at. Everything is computed as late as possible: an edge first has the length of the straight line,
then that of its Dubins path, and is checked only when it is the most promising of all.

P. E. Hart, N. J. Nilsson and B. Raphael, A Formal Basis for the Heuristic Determination of Minimum
Cost Paths, 1968 (A*); that edges are checked only when they are the most promising is the lazy
roadmap of R. Bohlin and L. E. Kavraki, Path Planning Using Lazy PRM, 2000.
"""

from heapq import heappop

import numpy as np

from vfguide.airspace.keep_out import KeepOutZones
from vfguide.airspace.planar_clearance import NO_HAZARD
from vfguide.geometry.se2 import write_pose
from vfguide.kernels.compiled import compiled
from vfguide.paths.edge import EDGE_WIDTH, RouteEdges, edge_row
from vfguide.planning.collision_check import Demand, Task, check_edge
from vfguide.planning.roadmap import (
    GOAL,
    MAX_ROUTE_EDGES,
    START,
    Edges,
    Queue,
    TangentPoses,
    add_edge,
    add_edges,
    edge_of,
    find_path,
    new_edges,
    new_tangent_poses,
    settle,
    try_longer,
)
from vfguide.planning.tangent_poses import add_fan, add_tangent_poses

CHECK_EFFORT = 6
"""Number of Dubins paths that the check of an edge counts as; chosen for its time."""


@compiled
def search(
    hazards: KeepOutZones, task: Task, demand: Demand, effort: int
) -> tuple[RouteEdges, int]:
    """Edges from the start to the goal, none where no route is found, and the effort that is left.

    Args:
        hazards: the keep-out zones.
        task: start, goal, turn radius and wind.
        demand: the wanted clearance.
        effort: number of Dubins paths that may be computed; a check counts as CHECK_EFFORT.
    """
    tangents, edges = new_tangent_poses(len(hazards.table)), new_edges()
    queue = begin(tangents, edges, task)
    while effort > 0:
        if len(queue) == 0 and not fan_out(task, tangents, edges, queue):
            break
        _, e = heappop(queue)
        end = edges.ends[e]
        if tangents.cost_to_come[end] < np.inf:
            continue
        if not edges.known[e]:
            find_path(tangents, edges, queue, e, task.radius)
            effort -= 1
            continue
        effort -= CHECK_EFFORT
        follow(hazards, task, demand, tangents, edges, queue, e)
        if end == GOAL and tangents.cost_to_come[GOAL] < np.inf:
            return route_found(tangents, edges), effort
    return np.empty((0, EDGE_WIDTH)), effort


@compiled
def begin(tangents: TangentPoses, edges: Edges, task: Task) -> Queue:
    """The queue with the edge from the start to the goal."""
    write_pose(task.start, tangents.poses[START])
    write_pose(task.goal, tangents.poses[GOAL])
    tangents.cost_to_come[START], tangents.times[START], tangents.cost_to_go[GOAL] = (
        0.0,
        task.t,
        0.0,
    )
    tangents.used[0] = 2
    queue = [(0.0, 0)]
    queue.clear()
    add_edge(tangents, edges, queue, START, GOAL)
    return queue


@compiled
def follow(
    hazards: KeepOutZones,
    task: Task,
    demand: Demand,
    tangents: TangentPoses,
    edges: Edges,
    queue: Queue,
    e: int,
) -> None:
    """Checks an edge, and queues those from its end, or those around what blocks it."""
    begin, end = edges.begins[e], edges.ends[e]
    found = check_edge(
        hazards, task, demand, edge_of(tangents, edges, e), float(tangents.times[begin])
    )
    if found.blocker == NO_HAZARD:
        settle(tangents, edges, e, task.radius, found.t)
        if end != GOAL and tangents.depth[end] < MAX_ROUTE_EDGES:
            add_edge(tangents, edges, queue, end, GOAL)
            add_edges(tangents, edges, queue, end, len(hazards.table))
        return
    go_round(hazards, demand, tangents, edges, queue, begin, found.blocker, found.t)
    if begin == START or end == GOAL:
        try_longer(tangents, edges, queue, e, task.radius)


@compiled
def go_round(
    hazards: KeepOutZones,
    demand: Demand,
    tangents: TangentPoses,
    edges: Edges,
    queue: Queue,
    begin: int,
    hazard: int,
    t: float,
) -> None:
    """Queues edges from a tangent pose to those around a hazard, met at time `t` [s]."""
    if tangents.avoids[begin, hazard] or tangents.depth[begin] + 1 >= MAX_ROUTE_EDGES:
        return
    tangents.avoids[begin, hazard] = True
    if tangents.after[hazard] == 0:
        first = tangents.used[0]
        after = add_tangent_poses(hazards, hazard, t, demand.wanted, tangents.poses, first)
        tangents.first[hazard], tangents.after[hazard], tangents.used[0] = first, after, after
    add_edges(tangents, edges, queue, begin, hazard)


@compiled
def fan_out(task: Task, tangents: TangentPoses, edges: Edges, queue: Queue) -> bool:
    """Queues edges from all reached poses to poses near the ends, once; whether there are any.

    Zones that no edge has met may still leave no room to turn into the edges that were tried.
    """
    fan = len(tangents.first) - 1
    if tangents.after[fan] > 0:
        return False
    reached = tangents.used[0]
    after = add_fan(task.start, 1.0, task.radius, tangents.poses, reached)
    after = add_fan(task.goal, -1.0, task.radius, tangents.poses, after)
    tangents.first[fan], tangents.after[fan], tangents.used[0] = reached, after, after
    for tangent in range(reached):
        if (
            tangents.cost_to_come[tangent] < np.inf
            and tangents.depth[tangent] + 1 < MAX_ROUTE_EDGES
        ):
            add_edges(tangents, edges, queue, tangent, fan)
    return len(queue) > 0


@compiled
def route_found(tangents: TangentPoses, edges: Edges) -> RouteEdges:
    """The edges by which the goal was reached, one `Edge` a row."""
    count = tangents.depth[GOAL]
    route_edges = np.empty((count, EDGE_WIDTH))
    tangent = GOAL
    for i in range(count - 1, -1, -1):
        e = tangents.edges[tangent]
        route_edges[i] = edge_row(edge_of(tangents, edges, e))
        tangent = edges.begins[e]
    return route_edges
