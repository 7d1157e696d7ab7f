"""Memory of a coarse search: via poses, the hops tried between them, and which are reached."""

import math
from heapq import heappush
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.flight.hop import Hop, next_word
from vfguide.flight.shortest import Word, length_of
from vfguide.flight.way import Pose
from vfguide.geometry.compiled import compiled

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


class Vias(NamedTuple):
    """Poses a way may lead through, the first two its ends; arrays of one row each."""

    poses: NDArray[np.float64]
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
    blocks: NDArray[np.int64]
    """(hazards + 1, 2): first via of each hazard, and the one after the last; both 0 before. The
    last row is for poses near the ends."""
    used: NDArray[np.int64]
    """(2,): how many vias and edges there are."""


class Edges(NamedTuple):
    """Hops tried or to be tried; arrays of one row each."""

    ends: NDArray[np.int64]
    """(N, 2): the vias at both ends."""
    above: NDArray[np.float64]
    """Only words longer than this are left to be tried [radii]."""
    words: NDArray[np.float64]
    """(N, 6)."""
    known: NDArray[np.bool_]
    """Whether the word has been found."""


@compiled
def new_vias(hazards: int) -> Vias:
    """No vias yet, for so many hazards."""
    return Vias(
        np.empty((MOST_VIAS, 3)),
        np.full(MOST_VIAS, -1.0),
        np.full(MOST_VIAS, math.inf),
        np.zeros(MOST_VIAS),
        np.zeros(MOST_VIAS, np.int64),
        np.full(MOST_VIAS, -1),
        np.zeros((MOST_VIAS, hazards), np.bool_),
        np.zeros((hazards + 1, 2), np.int64),
        np.zeros(2, np.int64),
    )


@compiled
def new_edges() -> Edges:
    """No edges yet."""
    return Edges(
        np.empty((MOST_EDGES, 2), np.int64),
        np.empty(MOST_EDGES),
        np.empty((MOST_EDGES, 6)),
        np.zeros(MOST_EDGES, np.bool_),
    )


@compiled
def pose_in(vias: Vias, i: int) -> Pose:
    """The pose in row `i`."""
    x, y, course = vias.poses[i]
    return Pose(x, y, course)


@compiled
def word_in(edges: Edges, e: int) -> Word:
    """The word of edge `e`."""
    w = edges.words[e]
    return Word(w[0], w[1], w[2], w[3], w[4], w[5])


@compiled
def hop_of(vias: Vias, edges: Edges, e: int) -> Hop:
    """The hop of edge `e`."""
    return Hop(pose_in(vias, edges.ends[e, 0]), word_in(edges, e))


@compiled
def add_edge(vias: Vias, edges: Edges, queue: Queue, begin: int, end: int) -> None:
    """Queues a hop whose word is not known yet, with the straight line as its length."""
    e = vias.used[1]
    if e == MOST_EDGES or vias.gone[end] < math.inf:
        return
    vias.used[1] = e + 1
    edges.ends[e] = (begin, end)
    edges.above[e] = -1.0
    here, there, goal = vias.poses[begin], vias.poses[end], vias.poses[GOAL]
    to_go = vias.to_go[end]
    if to_go < 0.0:
        to_go = math.hypot(goal[0] - there[0], goal[1] - there[1])
    hoped = vias.gone[begin] + math.hypot(there[0] - here[0], there[1] - here[1]) + EAGER * to_go
    heappush(queue, (float(hoped), e))


@compiled
def add_edges(vias: Vias, edges: Edges, queue: Queue, begin: int, hazard: int) -> None:
    """Queues hops to all vias of a hazard."""
    for via in range(vias.blocks[hazard, 0], vias.blocks[hazard, 1]):
        if via != begin:
            add_edge(vias, edges, queue, begin, via)


@compiled
def find_word(vias: Vias, edges: Edges, queue: Queue, e: int, radius: float) -> None:
    """Finds the word of an edge, and queues it again with its length."""
    begin, end = edges.ends[e]
    if vias.to_go[end] < 0.0:
        word = next_word(pose_in(vias, end), pose_in(vias, GOAL), radius, -1.0)
        vias.to_go[end] = radius * length_of(word)
    word = next_word(pose_in(vias, begin), pose_in(vias, end), radius, edges.above[e])
    length = length_of(word)
    if length < math.inf:
        edges.words[e] = (word.first, word.arc, word.middle, word.reach, word.last, word.end)
        edges.known[e], edges.above[e] = True, length
        hoped = vias.gone[begin] + radius * length + EAGER * vias.to_go[end]
        heappush(queue, (float(hoped), e))


@compiled
def try_longer(vias: Vias, edges: Edges, queue: Queue, e: int, radius: float) -> None:
    """Queues an edge again whose word was blocked, for a longer one."""
    edges.known[e] = False
    begin, end = edges.ends[e]
    hoped = vias.gone[begin] + radius * edges.above[e] + EAGER * vias.to_go[end]
    heappush(queue, (float(hoped), e))


@compiled
def settle(vias: Vias, edges: Edges, e: int, radius: float, t: float) -> None:
    """The end of an edge is reached along it at time `t`."""
    begin, end = edges.ends[e]
    vias.gone[end] = vias.gone[begin] + radius * edges.above[e]
    vias.hops[end] = vias.hops[begin] + 1
    vias.times[end], vias.edges[end] = t, e
