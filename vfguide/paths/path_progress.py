"""A path: three segments, turns and straights, onto the straight end of the approach.

Everything is in the horizontal plane of the goal frame, moved so that the path ends at the origin
along x.
"""

import math
from typing import NamedTuple

from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import reader, writer
from vfguide.paths.course_laws import Course, Planar, line_course, loiter_course
from vfguide.paths.dubins import FULL, SHORT_LAST_TURN, DubinsPath

TURN_IN = 0.37
"""The roll into a turn, or out of it, sets in this much earlier [s], from one turn into the other
twice as much: the lag of the bank."""
FIRST_TURN, MIDDLE, LAST_TURN = 0, 1, 2
"""Segments of a path."""


class PathProgress(NamedTuple):
    """Where the segments lie, and how far along them the vehicle is."""

    x: float
    y: float
    """Where the path begins [m]."""
    course: float
    """There [rad]."""
    path: DubinsPath
    radius: float
    """Of both turns [m]."""
    segment: int
    left: float
    """Of the segment that is flown: of a turn [rad], of a straight [radii]."""


class Pose(NamedTuple):
    """A place [m] and a course [rad]."""

    x: float
    y: float
    course: float


read_pose, write_pose = reader(Pose), writer(Pose)


@compiled
def begin_path(at: Planar, path: DubinsPath, radius: float) -> PathProgress:
    """The path along `path` from here."""
    return PathProgress(at.x, at.y, math.atan2(at.vy, at.vx), path, radius, FIRST_TURN, path.arc)


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
def begin_of(progress: PathProgress) -> Pose:
    """Where the path begins."""
    return Pose(progress.x, progress.y, progress.course)


@compiled
def middle_begin(progress: PathProgress) -> Pose:
    """Where the middle segment begins."""
    return after_turn(begin_of(progress), progress.path.first, progress.path.arc, progress.radius)


@compiled
def is_straight(progress: PathProgress) -> bool:
    """Whether the segment that is flown is straight."""
    return progress.segment == MIDDLE and progress.path.middle == 0.0


@compiled
def leads_straight_on(progress: PathProgress) -> bool:
    """Whether only the last turn is left to fly, or the straight before it."""
    return progress.segment == LAST_TURN or is_straight(progress)


class Turn(NamedTuple):
    """A turn that is flown."""

    x: float
    y: float
    """Its centre [m]."""
    side: float
    end: float
    """Course at its end [rad]."""


@compiled
def present_turn(progress: PathProgress) -> Turn:
    """The turn that is flown."""
    path, middle = progress.path, middle_begin(progress)
    if progress.segment == FIRST_TURN:
        x, y = centre_beside(begin_of(progress), path.first, progress.radius)
        return Turn(x, y, path.first, middle.course)
    if progress.segment == MIDDLE:
        x, y = centre_beside(middle, path.middle, progress.radius)
        return Turn(x, y, path.middle, middle.course + path.middle * path.reach)
    return Turn(0.0, path.last * progress.radius, path.last, 0.0)


@compiled
def about(turn: Turn, at: Planar) -> Planar:
    """The vehicle, seen from the centre of a turn."""
    return Planar(at.x - turn.x, at.y - turn.y, at.vx, at.vy)


@compiled
def segment_left(progress: PathProgress, at: Planar) -> float:
    """What the segment lacks to its end: of a turn [rad], of a straight [radii].

    Whole circles are those that there were at the step before.
    """
    if is_straight(progress):
        begin = middle_begin(progress)
        dx, dy = at.x - begin.x, at.y - begin.y
        travelled = math.cos(begin.course) * dx + math.sin(begin.course) * dy
        return progress.path.reach - travelled / progress.radius
    turn = present_turn(progress)
    here = about(turn, at)
    course = math.atan2(here.y, here.x) + turn.side * 0.5 * math.pi
    left = turn.side * (turn.end - course)
    return left + FULL * round((progress.left - left) / FULL)


@compiled
def at_segment(progress: PathProgress, segment: int, left: float) -> PathProgress:
    """The path, so far along it."""
    return PathProgress(
        progress.x, progress.y, progress.course, progress.path, progress.radius, segment, left
    )


@compiled
def along(progress: PathProgress, at: Planar) -> PathProgress:
    """The path, as far along it as the vehicle is."""
    path, lead = progress.path, TURN_IN * math.hypot(at.vx, at.vy) / progress.radius
    last = path.last * min(1.0, path.end / SHORT_LAST_TURN)
    middle = last if path.middle == 0.0 and path.reach < lead else path.middle
    progress = at_segment(progress, progress.segment, segment_left(progress, at))
    if progress.segment == FIRST_TURN and progress.left < lead * abs(middle - path.first):
        progress = at_segment(progress, MIDDLE, progress.path.reach)
        progress = at_segment(progress, MIDDLE, segment_left(progress, at))
    if progress.segment == MIDDLE and progress.left < lead * abs(last - path.middle):
        progress = at_segment(progress, LAST_TURN, progress.path.end)
        progress = at_segment(progress, LAST_TURN, segment_left(progress, at))
    return progress


@compiled
def path_left(progress: PathProgress) -> float:
    """Length of the rest of the path [m]."""
    rest = progress.left
    if progress.segment == FIRST_TURN:
        rest += progress.path.reach
    if progress.segment != LAST_TURN:
        rest += progress.path.end
    return progress.radius * rest


@compiled
def path_course(progress: PathProgress, at: Planar) -> Course:
    """Course along the segment that is flown, back onto it where the vehicle is beside it."""
    if is_straight(progress):
        begin = middle_begin(progress)
        onto = line_course(at, (begin.x, begin.y), begin.course, progress.radius)
    else:
        turn = present_turn(progress)
        onto = loiter_course(about(turn, at), turn.side, progress.radius)
    return Course(onto.chi, onto.chi_rate, path_left(progress))


@compiled
def beside(progress: PathProgress, at: Planar) -> float:
    """Distance from the segment that is flown [m]."""
    if is_straight(progress):
        begin = middle_begin(progress)
        dx, dy = at.x - begin.x, at.y - begin.y
        return abs(math.cos(begin.course) * dy - math.sin(begin.course) * dx)
    here = about(present_turn(progress), at)
    return abs(math.hypot(here.x, here.y) - progress.radius)
