"""Hops: words that join poses of the horizontal plane, and places along them."""

import math
from typing import NamedTuple

import numpy as np

from vfguide.geometry.angles import wrap
from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import Row, Table, reader, width, writer
from vfguide.paths.dubins import Word, length_of, opposite_turns, same_turns, three_turns
from vfguide.paths.path_progress import Pose, after_turn

KINDS = 6
"""Of words: three, each with its first turn to either side."""
FARTHEST_THREE = 4.0
"""Apart at most for three turns [radii]."""
JOINS = 1e-10
"""A word ends where it should when it is off by no more than this [radii, or rad]."""

Hops = Table
"""A `Hop` a row."""


class Hop(NamedTuple):
    """A word from a pose."""

    begin: Pose
    word: Word


HOP_COLUMNS = width(Hop)
"""How many numbers the row of a hop has."""
read_hop, write_hop = reader(Hop), writer(Hop)


class Piece(NamedTuple):
    """A turn, or a straight."""

    begin: Pose
    side: float
    """Of a turn, 0 for a straight."""
    length: float
    """[m]."""


@compiled
def pieces_of(hop: Hop, radius: float) -> tuple[Piece, Piece, Piece]:
    """The three pieces of a hop."""
    word, begin = hop.word, hop.begin
    first = Piece(begin, word.first, radius * word.arc)
    second = Piece(piece_end(first, radius), word.middle, radius * word.reach)
    return first, second, Piece(piece_end(second, radius), word.last, radius * word.end)


@compiled
def pose_along(piece: Piece, gone: float, radius: float) -> Pose:
    """Where one is `gone` [m] after the beginning of a piece."""
    begin = piece.begin
    if piece.side != 0.0:
        return after_turn(begin, piece.side, gone / radius, radius)
    dx, dy = math.cos(begin.course), math.sin(begin.course)
    return Pose(begin.x + gone * dx, begin.y + gone * dy, begin.course)


@compiled
def piece_end(piece: Piece, radius: float) -> Pose:
    """Where a piece ends."""
    return pose_along(piece, piece.length, radius)


@compiled
def hop_end(hop: Hop, radius: float) -> Pose:
    """Where a hop ends."""
    return piece_end(pieces_of(hop, radius)[2], radius)


@compiled
def word_of(kind: int, d: float, alpha: float, beta: float) -> Word:
    """One of the KINDS of words; arguments of `same_turns`."""
    side = 1.0 if kind % 2 == 0 else -1.0
    if kind < 2:
        return same_turns(d, alpha, beta, side)
    if kind < 4:
        return opposite_turns(d, alpha, beta, side)
    return three_turns(d, alpha, beta, side)


@compiled
def is_joined(hop: Hop, end: Pose, radius: float) -> bool:
    """Whether the hop ends at `end`.

    It does not where a turn was taken as none because it nearly was a full circle.
    """
    there = hop_end(hop, radius)
    off = math.hypot(there.x - end.x, there.y - end.y) / radius
    return off <= JOINS and abs(wrap(there.course - end.course)) <= JOINS


@compiled
def next_word(begin: Pose, end: Pose, radius: float, above: float) -> Word:
    """The shortest word from one pose to the other that is longer than `above` [radii].

    Infinitely long where there is none.
    """
    x, y = end.x - begin.x, end.y - begin.y
    d, bearing = math.hypot(x, y) / radius, math.atan2(y, x)
    alpha, beta = begin.course - bearing, end.course - bearing
    while True:
        word = least_word(d, alpha, beta, above)
        above = length_of(word)
        if above == math.inf or is_joined(Hop(begin, word), end, radius):
            return word


@compiled
def least_word(d: float, alpha: float, beta: float, above: float) -> Word:
    """The shortest word longer than `above` [radii]; other arguments of `same_turns`."""
    least, best = math.inf, Word(1.0, 0.0, 0.0, math.inf, 1.0, 0.0)
    for kind in range(KINDS if d <= FARTHEST_THREE else KINDS - 2):
        word = word_of(kind, d, alpha, beta)
        length = length_of(word)
        if above < length < least:
            least, best = length, word
    return best


@compiled
def hop_row(hop: Hop) -> Row:
    """The row of a hop."""
    row = np.empty(HOP_COLUMNS)
    write_hop(hop, row)
    return row


@compiled
def hop_in(rows: Hops, i: int) -> Hop:
    """The hop in row `i`."""
    return read_hop(rows[i])


@compiled
def way_length(hops: Hops, radius: float) -> float:
    """Length of all hops [m]."""
    length = 0.0
    for i in range(len(hops)):
        length += radius * length_of(hop_in(hops, i).word)
    return length
