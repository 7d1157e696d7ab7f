"""Memory of a coarse search: via poses, the hops tried between them, and which are reached."""

import math
from heapq import heappush
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import Table, width
from vfguide.paths.dubins import Word, length_of, read_word, write_word
from vfguide.paths.edge import Hop, next_word
from vfguide.paths.path_progress import Pose, read_pose

START, GOAL = 0, 1
"""Rows of the ends among the vias."""
MOST_VIAS = 1024
MOST_EDGES = 30_000
"""Of one search."""
MOST_HOPS = 8
"""Of a way."""
EAGER = 1.1
"""What is left counts so much more than what is gone: fewer hops are tried, and the way is longer
than the shortest over the same vias by no more than that."""

Queue = list[tuple[float, int]]
"""Edges by the length of the way through them that can be hoped for [m]."""
Counter = NDArray[np.int64]
"""One number that compiled code counts up, (1,)."""
POSE_WIDTH, WORD_WIDTH = width(Pose), width(Word)
"""How many numbers the row of a pose has, and that of a word."""


class Vias(NamedTuple):
    """Poses a way may lead through, the first two its ends; arrays of one row each."""

    used: Counter
    """How many there are."""
    poses: Table
    """A `Pose` a row."""
    to_go: NDArray[np.float64]
    """Least length to the goal [m], negative while unknown."""
    gone: NDArray[np.float64]
    """Length of the way by which it was reached [m], infinite before."""
    times: NDArray[np.float64]
    """When it is reached [s]."""
    hops: NDArray[np.int64]
    """Of the way by which it was reached."""
    edges: NDArray[np.int64]
    """The last of that way."""
    avoids: NDArray[np.bool_]
    """(vias, hazards): whether hops from here to the vias of a hazard are in the queue."""
    first: NDArray[np.int64]
    after: NDArray[np.int64]
    """(hazards + 1,): first via of each hazard, and the one after its last; both 0 before. The last
    of the hazards stands for poses near the ends."""


class Edges(NamedTuple):
    """Hops tried or to be tried; arrays of one row each."""

    used: Counter
    """How many there are."""
    begins: NDArray[np.int64]
    ends: NDArray[np.int64]
    """The vias at both ends."""
    above: NDArray[np.float64]
    """Only words longer than this are left to be tried [radii]."""
    words: Table
    """A `Word` a row."""
    known: NDArray[np.bool_]
    """Whether the word has been found."""


@compiled
def new_vias(hazards: int) -> Vias:
    """No vias yet, for so many hazards."""
    return Vias(
        np.zeros(1, np.int64),
        np.empty((MOST_VIAS, POSE_WIDTH)),
        np.full(MOST_VIAS, -1.0),
        np.full(MOST_VIAS, math.inf),
        np.zeros(MOST_VIAS),
        np.zeros(MOST_VIAS, np.int64),
        np.full(MOST_VIAS, -1),
        np.zeros((MOST_VIAS, hazards), np.bool_),
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
        np.empty((MOST_EDGES, WORD_WIDTH)),
        np.zeros(MOST_EDGES, np.bool_),
    )


@compiled
def pose_in(vias: Vias, i: int) -> Pose:
    """The pose in row `i`."""
    return read_pose(vias.poses[i])


@compiled
def word_in(edges: Edges, e: int) -> Word:
    """The word of edge `e`."""
    return read_word(edges.words[e])


@compiled
def hop_of(vias: Vias, edges: Edges, e: int) -> Hop:
    """The hop of edge `e`."""
    return Hop(pose_in(vias, edges.begins[e]), word_in(edges, e))


@compiled
def add_edge(vias: Vias, edges: Edges, queue: Queue, begin: int, end: int) -> None:
    """Queues a hop whose word is not known yet, with the straight line as its length."""
    e = edges.used[0]
    if e == MOST_EDGES or vias.gone[end] < math.inf:
        return
    edges.used[0] = e + 1
    edges.begins[e], edges.ends[e], edges.above[e] = begin, end, -1.0
    here, there, goal = pose_in(vias, begin), pose_in(vias, end), pose_in(vias, GOAL)
    to_go = vias.to_go[end]
    if to_go < 0.0:
        to_go = math.hypot(goal.x - there.x, goal.y - there.y)
    hoped = vias.gone[begin] + math.hypot(there.x - here.x, there.y - here.y) + EAGER * to_go
    heappush(queue, (float(hoped), e))


@compiled
def add_edges(vias: Vias, edges: Edges, queue: Queue, begin: int, hazard: int) -> None:
    """Queues hops to all vias of a hazard."""
    for via in range(vias.first[hazard], vias.after[hazard]):
        if via != begin:
            add_edge(vias, edges, queue, begin, via)


@compiled
def find_word(vias: Vias, edges: Edges, queue: Queue, e: int, radius: float) -> None:
    """Finds the word of an edge, and queues it again with its length."""
    begin, end = edges.begins[e], edges.ends[e]
    if vias.to_go[end] < 0.0:
        word = next_word(pose_in(vias, end), pose_in(vias, GOAL), radius, -1.0)
        vias.to_go[end] = radius * length_of(word)
    word = next_word(pose_in(vias, begin), pose_in(vias, end), radius, edges.above[e])
    length = length_of(word)
    if length < math.inf:
        write_word(word, edges.words[e])
        edges.known[e], edges.above[e] = True, length
        hoped = vias.gone[begin] + radius * length + EAGER * vias.to_go[end]
        heappush(queue, (float(hoped), e))


@compiled
def try_longer(vias: Vias, edges: Edges, queue: Queue, e: int, radius: float) -> None:
    """Queues an edge again whose word was blocked, for a longer one."""
    edges.known[e] = False
    begin, end = edges.begins[e], edges.ends[e]
    hoped = vias.gone[begin] + radius * edges.above[e] + EAGER * vias.to_go[end]
    heappush(queue, (float(hoped), e))


@compiled
def settle(vias: Vias, edges: Edges, e: int, radius: float, t: float) -> None:
    """The end of an edge is reached along it at time `t`."""
    begin, end = edges.begins[e], edges.ends[e]
    vias.gone[end] = vias.gone[begin] + radius * edges.above[e]
    vias.hops[end] = vias.hops[begin] + 1
    vias.times[end], vias.edges[end] = t, e
