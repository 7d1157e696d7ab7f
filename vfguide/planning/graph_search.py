"""The coarse search: the shortest way over via poses round the hazards that are met.

A* whose edges are words. It begins with the start and the goal alone; where a hop is blocked, the
via poses round what blocks it become neighbours of the pose it began at. Nothing is computed
before its turn: first a hop counts as the straight line, then as its word, and whether it is clear
is only looked up when it is the most promising of all.
"""

from heapq import heappop

import numpy as np

from vfguide.airspace.keep_out import Outlines
from vfguide.airspace.planar_clearance import NOTHING
from vfguide.geometry.compiled import compiled
from vfguide.paths.edge import HOP_COLUMNS, Hops, hop_row
from vfguide.paths.path_progress import write_pose
from vfguide.planning.collision_check import Demand, Task, check_hop
from vfguide.planning.roadmap import (
    GOAL,
    MOST_HOPS,
    START,
    Edges,
    Queue,
    Vias,
    add_edge,
    add_edges,
    find_word,
    hop_of,
    new_edges,
    new_vias,
    settle,
    try_longer,
)
from vfguide.planning.tangent_poses import add_fan, add_vias

CHECK_EFFORT = 6
"""A check of a hop takes as long as so many words."""


@compiled
def search(hazards: Outlines, task: Task, demand: Demand, effort: int) -> tuple[Hops, int]:
    """Hops from the start to the goal, none where nothing is found, and the effort that is left.

    Args:
        hazards: to keep clear of.
        task: what is to be flown.
        demand: clearance.
        effort: words that may be computed, a check counts as CHECK_EFFORT of them.
    """
    vias, edges = new_vias(len(hazards.table)), new_edges()
    queue = begin(vias, edges, task)
    while effort > 0:
        if len(queue) == 0 and not fan_out(task, vias, edges, queue):
            break
        _, e = heappop(queue)
        end = edges.ends[e]
        if vias.gone[end] < np.inf:
            continue
        if not edges.known[e]:
            find_word(vias, edges, queue, e, task.radius)
            effort -= 1
            continue
        effort -= CHECK_EFFORT
        follow(hazards, task, demand, vias, edges, queue, e)
        if end == GOAL and vias.gone[GOAL] < np.inf:
            return way_found(vias, edges), effort
    return np.empty((0, HOP_COLUMNS)), effort


@compiled
def begin(vias: Vias, edges: Edges, task: Task) -> Queue:
    """The queue with the hop from the start to the goal."""
    write_pose(task.start, vias.poses[START])
    write_pose(task.goal, vias.poses[GOAL])
    vias.gone[START], vias.times[START], vias.to_go[GOAL] = 0.0, task.t, 0.0
    vias.used[0] = 2
    queue = [(0.0, 0)]
    queue.clear()
    add_edge(vias, edges, queue, START, GOAL)
    return queue


@compiled
def follow(
    hazards: Outlines,
    task: Task,
    demand: Demand,
    vias: Vias,
    edges: Edges,
    queue: Queue,
    e: int,
) -> None:
    """Checks a hop: from its end on to the goal, or else round what blocks it."""
    begin, end = edges.begins[e], edges.ends[e]
    found = check_hop(hazards, task, demand, hop_of(vias, edges, e), float(vias.times[begin]))
    if found.blocker == NOTHING:
        settle(vias, edges, e, task.radius, found.t)
        if end != GOAL and vias.hops[end] < MOST_HOPS:
            add_edge(vias, edges, queue, end, GOAL)
            add_edges(vias, edges, queue, end, len(hazards.table))
        return
    go_round(hazards, demand, vias, edges, queue, begin, found.blocker, found.t)
    if begin == START or end == GOAL:
        try_longer(vias, edges, queue, e, task.radius)


@compiled
def go_round(
    hazards: Outlines,
    demand: Demand,
    vias: Vias,
    edges: Edges,
    queue: Queue,
    begin: int,
    hazard: int,
    t: float,
) -> None:
    """Queues hops from a via to those round a hazard, which was met at time `t`."""
    if vias.avoids[begin, hazard] or vias.hops[begin] + 1 >= MOST_HOPS:
        return
    vias.avoids[begin, hazard] = True
    if vias.after[hazard] == 0:
        first = vias.used[0]
        after = add_vias(hazards, hazard, t, demand.wanted, vias.poses, first)
        vias.first[hazard], vias.after[hazard], vias.used[0] = first, after, after
    add_edges(vias, edges, queue, begin, hazard)


@compiled
def fan_out(task: Task, vias: Vias, edges: Edges, queue: Queue) -> bool:
    """Queues hops from all that is reached to poses near the ends, once; whether there are any.

    Outlines that no hop has met may still leave no room to turn into the hops that were tried.
    """
    fan = len(vias.first) - 1
    if vias.after[fan] > 0:
        return False
    reached = vias.used[0]
    after = add_fan(task.start, 1.0, task.radius, vias.poses, reached)
    after = add_fan(task.goal, -1.0, task.radius, vias.poses, after)
    vias.first[fan], vias.after[fan], vias.used[0] = reached, after, after
    for via in range(reached):
        if vias.gone[via] < np.inf and vias.hops[via] + 1 < MOST_HOPS:
            add_edges(vias, edges, queue, via, fan)
    return len(queue) > 0


@compiled
def way_found(vias: Vias, edges: Edges) -> Hops:
    """The hops by which the goal was reached."""
    count = vias.hops[GOAL]
    hops = np.empty((count, HOP_COLUMNS))
    via = GOAL
    for i in range(count - 1, -1, -1):
        e = vias.edges[via]
        hops[i] = hop_row(hop_of(vias, edges, e))
        via = edges.begins[e]
    return hops
