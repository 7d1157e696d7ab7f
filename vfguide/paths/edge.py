"""Edges: Dubins paths that start at a pose of the horizontal plane, those of a route in NED."""

import math
from typing import NamedTuple

import numpy as np

from vfguide.geometry.angles import wrap
from vfguide.geometry.se2 import Pose, after_turn, distance_between, straight_on
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Row, Table, reader, width, writer
from vfguide.paths.dubins import DubinsPath, length_of, opposite_turns, same_turns, three_turns

PATH_KINDS = 6
"""Number of Dubins paths: three kinds, each with its first turn to either side."""
FARTHEST_THREE_TURNS = 4.0
"""Largest distance of two poses that three turns can join [turn radii] (Shkel and Lumelsky,
2001)."""
JOIN_TOLERANCE = 1e-10
"""Largest distance from its end pose at which a Dubins path counts as joined [turn radii, or rad];
chosen above rounding."""

FIRST_TURN = 0
"""Number of the first segment of a Dubins path."""
MIDDLE = 1
"""Number of the second segment of a Dubins path, a straight or a turn."""
LAST_TURN = 2
"""Number of the last segment of a Dubins path."""

RouteEdges = Table
"""A table with one `Edge` a row."""


class Edge(NamedTuple):
    """A Dubins path from a pose."""

    begin: Pose
    """Pose at its start."""
    path: DubinsPath


EDGE_WIDTH = width(Edge)
"""Number of floats in the row of an `Edge`."""
read_edge, write_edge = reader(Edge), writer(Edge)


class Segment(NamedTuple):
    """A turn or a straight."""

    begin: Pose
    """Pose at its start."""
    side: float
    """Side of a turn, +1 right, -1 left; 0 for a straight."""
    length: float
    """Length along the path [m]."""


@compiled
def first_segment(edge: Edge, radius: float) -> Segment:
    """The first segment of an edge with turns of `radius` [m]."""
    return Segment(edge.begin, edge.path.first, radius * edge.path.arc)


@compiled
def segment_after(segment: Segment, side: float, length: float, radius: float) -> Segment:
    """A segment to a `side`, of a `length` [m], from the end of another."""
    return Segment(segment_end(segment, radius), side, length)


@compiled
def segments_of(edge: Edge, radius: float) -> tuple[Segment, Segment, Segment]:
    """The three segments of an edge with turns of `radius` [m]."""
    path, first = edge.path, first_segment(edge, radius)
    middle = segment_after(first, path.middle, radius * path.reach, radius)
    return first, middle, segment_after(middle, path.last, radius * path.end, radius)


@compiled
def segment_at(edge: Edge, k: int, radius: float) -> Segment:
    """Segment `k` of an edge with turns of `radius` [m]: FIRST_TURN, MIDDLE or LAST_TURN.

    Only the segments before it are worked out.
    """
    path, segment = edge.path, first_segment(edge, radius)
    if k >= MIDDLE:
        segment = segment_after(segment, path.middle, radius * path.reach, radius)
    if k == LAST_TURN:
        segment = segment_after(segment, path.last, radius * path.end, radius)
    return segment


@compiled
def pose_along(segment: Segment, travelled: float, radius: float) -> Pose:
    """Pose after `travelled` [m] of a segment."""
    begin = segment.begin
    if segment.side != 0.0:
        return after_turn(begin, segment.side, travelled / radius, radius)
    return straight_on(begin, travelled)


@compiled
def segment_end(segment: Segment, radius: float) -> Pose:
    """Pose at the end of a segment."""
    return pose_along(segment, segment.length, radius)


@compiled
def edge_end(edge: Edge, radius: float) -> Pose:
    """Pose at the end of an edge."""
    return segment_end(segments_of(edge, radius)[2], radius)


@compiled
def dubins_path_of(kind: int, d: float, alpha: float, beta: float) -> DubinsPath:
    """Dubins path number `kind` of PATH_KINDS; the other arguments are those of `same_turns`."""
    side = 1.0 if kind % 2 == 0 else -1.0
    if kind < 2:
        return same_turns(d, alpha, beta, side)
    if kind < 4:
        return opposite_turns(d, alpha, beta, side)
    return three_turns(d, alpha, beta, side)


@compiled
def is_joined(edge: Edge, end: Pose, radius: float) -> bool:
    """Whether the edge ends at `end`.

    It does not where a turn of nearly a full circle was taken as none.
    """
    there = edge_end(edge, radius)
    off = distance_between(there, end) / radius
    return off <= JOIN_TOLERANCE and abs(wrap(there.course - end.course)) <= JOIN_TOLERANCE


@compiled
def next_path(begin: Pose, end: Pose, radius: float, above: float) -> DubinsPath:
    """The shortest Dubins path from one pose to the other that is longer than `above` [radii].

    It is infinitely long where there is none. `radius` is that of the turns [m].
    """
    x, y = end.x - begin.x, end.y - begin.y
    d, bearing = math.hypot(x, y) / radius, math.atan2(y, x)
    alpha, beta = begin.course - bearing, end.course - bearing
    while True:
        path = least_path(d, alpha, beta, above)
        above = length_of(path)
        if above == math.inf or is_joined(Edge(begin, path), end, radius):
            return path


@compiled
def least_path(d: float, alpha: float, beta: float, above: float) -> DubinsPath:
    """The shortest Dubins path longer than `above` [radii]; other arguments of `same_turns`."""
    least, best = math.inf, DubinsPath(1.0, 0.0, 0.0, math.inf, 1.0, 0.0)
    for kind in range(PATH_KINDS if d <= FARTHEST_THREE_TURNS else PATH_KINDS - 2):
        path = dubins_path_of(kind, d, alpha, beta)
        length = length_of(path)
        if above < length < least:
            least, best = length, path
    return best


@compiled
def edge_row(edge: Edge) -> Row:
    """The row of an edge."""
    row = np.empty(EDGE_WIDTH)
    write_edge(edge, row)
    return row


@compiled
def edge_in(rows: RouteEdges, i: int) -> Edge:
    """The edge in row `i`."""
    return read_edge(rows[i])


@compiled
def route_length(route_edges: RouteEdges, radius: float) -> float:
    """Length of all edges with turns of `radius` [m]."""
    length = 0.0
    for i in range(len(route_edges)):
        length += radius * length_of(edge_in(route_edges, i).path)
    return length
