"""A way: three pieces, turns and straights, onto the straight end of the approach.

Everything is in the horizontal plane of the goal frame, moved so that the way ends at the origin
along x.
"""

import math
from typing import NamedTuple

from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import reader, writer
from vfguide.paths.course_laws import Course, Planar, line_course, loiter_course
from vfguide.paths.dubins import BRIEF, FULL, Word

TURN_IN = 0.37
"""The roll into a turn, or out of it, sets in this much earlier [s], from one turn into the other
twice as much: the lag of the bank."""
FIRST_TURN, MIDDLE, LAST_TURN = 0, 1, 2
"""Pieces of a way."""


class Way(NamedTuple):
    """Where the pieces lie, and how far along them the vehicle is."""

    x: float
    y: float
    """Where the way begins [m]."""
    course: float
    """There [rad]."""
    word: Word
    radius: float
    """Of both turns [m]."""
    piece: int
    left: float
    """Of the piece that is flown: of a turn [rad], of a straight [radii]."""


class Pose(NamedTuple):
    """A place [m] and a course [rad]."""

    x: float
    y: float
    course: float


read_pose, write_pose = reader(Pose), writer(Pose)


@compiled
def new_way(at: Planar, word: Word, radius: float) -> Way:
    """The way along `word` from here."""
    return Way(at.x, at.y, math.atan2(at.vy, at.vx), word, radius, FIRST_TURN, word.arc)


@compiled
def centre_beside(at: Pose, side: float, radius: float) -> tuple[float, float]:
    """Centre of a turn that begins here [m]."""
    turn = side * radius
    return at.x - turn * math.sin(at.course), at.y + turn * math.cos(at.course)


@compiled
def after_turn(at: Pose, side: float, arc: float, radius: float) -> Pose:
    """Where a turn by `arc` [rad] ends that begins here."""
    x, y = centre_beside(at, side, radius)
    course = at.course + side * arc
    turn = side * radius
    return Pose(x + turn * math.sin(course), y - turn * math.cos(course), course)


@compiled
def begin_of(way: Way) -> Pose:
    """Where the way begins."""
    return Pose(way.x, way.y, way.course)


@compiled
def middle_begin(way: Way) -> Pose:
    """Where the middle piece begins."""
    return after_turn(begin_of(way), way.word.first, way.word.arc, way.radius)


@compiled
def is_straight(way: Way) -> bool:
    """Whether the piece that is flown is straight."""
    return way.piece == MIDDLE and way.word.middle == 0.0


@compiled
def leads_straight_on(way: Way) -> bool:
    """Whether only the last turn is left to fly, or the straight before it."""
    return way.piece == LAST_TURN or is_straight(way)


class Turn(NamedTuple):
    """A turn that is flown."""

    x: float
    y: float
    """Its centre [m]."""
    side: float
    end: float
    """Course at its end [rad]."""


@compiled
def present_turn(way: Way) -> Turn:
    """The turn that is flown."""
    word, middle = way.word, middle_begin(way)
    if way.piece == FIRST_TURN:
        x, y = centre_beside(begin_of(way), word.first, way.radius)
        return Turn(x, y, word.first, middle.course)
    if way.piece == MIDDLE:
        x, y = centre_beside(middle, word.middle, way.radius)
        return Turn(x, y, word.middle, middle.course + word.middle * word.reach)
    return Turn(0.0, word.last * way.radius, word.last, 0.0)


@compiled
def about(turn: Turn, at: Planar) -> Planar:
    """The vehicle, seen from the centre of a turn."""
    return Planar(at.x - turn.x, at.y - turn.y, at.vx, at.vy)


@compiled
def piece_left(way: Way, at: Planar) -> float:
    """What the piece lacks to its end: of a turn [rad], of a straight [radii].

    Whole circles are those that there were at the step before.
    """
    if is_straight(way):
        begin = middle_begin(way)
        dx, dy = at.x - begin.x, at.y - begin.y
        gone = math.cos(begin.course) * dx + math.sin(begin.course) * dy
        return way.word.reach - gone / way.radius
    turn = present_turn(way)
    here = about(turn, at)
    course = math.atan2(here.y, here.x) + turn.side * 0.5 * math.pi
    left = turn.side * (turn.end - course)
    return left + FULL * round((way.left - left) / FULL)


@compiled
def in_piece(way: Way, piece: int, left: float) -> Way:
    """The way, so far along it."""
    return Way(way.x, way.y, way.course, way.word, way.radius, piece, left)


@compiled
def along(way: Way, at: Planar) -> Way:
    """The way, as far along it as the vehicle is."""
    word, lead = way.word, TURN_IN * math.hypot(at.vx, at.vy) / way.radius
    last = word.last * min(1.0, word.end / BRIEF)
    middle = last if word.middle == 0.0 and word.reach < lead else word.middle
    way = in_piece(way, way.piece, piece_left(way, at))
    if way.piece == FIRST_TURN and way.left < lead * abs(middle - word.first):
        way = in_piece(way, MIDDLE, way.word.reach)
        way = in_piece(way, MIDDLE, piece_left(way, at))
    if way.piece == MIDDLE and way.left < lead * abs(last - word.middle):
        way = in_piece(way, LAST_TURN, way.word.end)
        way = in_piece(way, LAST_TURN, piece_left(way, at))
    return way


@compiled
def way_left(way: Way) -> float:
    """Length of the rest of the way [m]."""
    rest = way.left
    if way.piece == FIRST_TURN:
        rest += way.word.reach
    if way.piece != LAST_TURN:
        rest += way.word.end
    return way.radius * rest


@compiled
def way_course(way: Way, at: Planar) -> Course:
    """Course along the piece that is flown, back onto it where the vehicle is beside it."""
    if is_straight(way):
        begin = middle_begin(way)
        onto = line_course(at, (begin.x, begin.y), begin.course, way.radius)
    else:
        turn = present_turn(way)
        onto = loiter_course(about(turn, at), turn.side, way.radius)
    return Course(onto.chi, onto.chi_rate, way_left(way))


@compiled
def beside(way: Way, at: Planar) -> float:
    """Distance from the piece that is flown [m]."""
    if is_straight(way):
        begin = middle_begin(way)
        dx, dy = at.x - begin.x, at.y - begin.y
        return abs(math.cos(begin.course) * dy - math.sin(begin.course) * dx)
    here = about(present_turn(way), at)
    return abs(math.hypot(here.x, here.y) - way.radius)
