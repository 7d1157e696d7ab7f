"""Progress along a Dubins path onto the final approach.

Everything is in the horizontal plane of the goal frame, moved so that the path ends at the origin
with course 0. The path is followed segment by segment, by the course laws of lines and circles.
"""

import math
from typing import NamedTuple

from vfguide.geometry.angles import FULL_TURN
from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import reader, writer
from vfguide.paths.course_laws import Course, Planar, line_course, loiter_course
from vfguide.paths.dubins import SHORT_LAST_TURN, DubinsPath

TURN_IN = 0.37
"""Time before the end of a segment at which the roll into the next one starts [s], twice that from
one turn into the opposite one: the lag of the bank under the default gains, 1 / k_w + RATE_LAG of
the point mass."""
FIRST_TURN = 0
"""Number of the first segment of a Dubins path."""
MIDDLE = 1
"""Number of the second segment of a Dubins path, a straight or a turn."""
LAST_TURN = 2
"""Number of the last segment of a Dubins path."""


class PathProgress(NamedTuple):
    """A Dubins path in the plane, and how far along it the vehicle is."""

    x: float
    """Start of the path, along x [m]."""
    y: float
    """Start of the path, along y [m]."""
    course: float
    """Course at the start [rad]."""
    path: DubinsPath
    radius: float
    """Radius of the turns [m]."""
    segment: int
    """Present segment: FIRST_TURN, MIDDLE or LAST_TURN."""
    left: float
    """Rest of the present segment: angle of a turn [rad], length of a straight [turn radii]."""


class Pose(NamedTuple):
    """A position and a course in the horizontal plane."""

    x: float
    """Position along the first axis [m]."""
    y: float
    """Position along the second axis, to the right of the first [m]."""
    course: float
    """Course, clockwise from the first axis [rad]."""


read_pose, write_pose = reader(Pose), writer(Pose)


@compiled
def begin_path(at: Planar, path: DubinsPath, radius: float) -> PathProgress:
    """The progress at the start of a Dubins path from here, with turns of `radius` [m]."""
    return PathProgress(at.x, at.y, math.atan2(at.vy, at.vx), path, radius, FIRST_TURN, path.arc)


@compiled
def centre_beside(at: Pose, side: float, radius: float) -> tuple[float, float]:
    """Centre of a turn to a side (+1 right, -1 left) that starts here [m]."""
    turn = side * radius
    return at.x - turn * math.sin(at.course), at.y + turn * math.cos(at.course)


@compiled
def after_turn(at: Pose, side: float, arc: float, radius: float) -> Pose:
    """Pose at the end of a turn by `arc` [rad] that starts here."""
    x, y = centre_beside(at, side, radius)
    course = at.course + side * arc
    turn = side * radius
    return Pose(x + turn * math.sin(course), y - turn * math.cos(course), course)


@compiled
def begin_of(progress: PathProgress) -> Pose:
    """Pose at the start of the path."""
    return Pose(progress.x, progress.y, progress.course)


@compiled
def middle_begin(progress: PathProgress) -> Pose:
    """Pose at the start of the middle segment."""
    return after_turn(begin_of(progress), progress.path.first, progress.path.arc, progress.radius)


@compiled
def is_straight(progress: PathProgress) -> bool:
    """Whether the present segment is a straight."""
    return progress.segment == MIDDLE and progress.path.middle == 0.0


@compiled
def leads_straight_on(progress: PathProgress) -> bool:
    """Whether only the last turn is left to fly, or the straight before it."""
    return progress.segment == LAST_TURN or is_straight(progress)


class Turn(NamedTuple):
    """A turn of a path."""

    x: float
    """Centre along x [m]."""
    y: float
    """Centre along y [m]."""
    side: float
    """Side, +1 right, -1 left."""
    end: float
    """Course at its end [rad]."""


@compiled
def present_turn(progress: PathProgress) -> Turn:
    """The turn of the present segment."""
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
    """The vehicle relative to the centre of a turn."""
    return Planar(at.x - turn.x, at.y - turn.y, at.vx, at.vy)


@compiled
def segment_left(progress: PathProgress, at: Planar) -> float:
    """Rest of the present segment: angle of a turn [rad], length of a straight [turn radii].

    The number of full circles is that of the step before.
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
    return left + FULL_TURN * round((progress.left - left) / FULL_TURN)


@compiled
def at_segment(progress: PathProgress, segment: int, left: float) -> PathProgress:
    """The path with the progress that is given."""
    return PathProgress(
        progress.x, progress.y, progress.course, progress.path, progress.radius, segment, left
    )


@compiled
def along(progress: PathProgress, at: Planar) -> PathProgress:
    """The path with the progress of the vehicle, into the next segment in time for the roll."""
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
    """Length of the rest of the path along its segments [m]."""
    rest = progress.left
    if progress.segment == FIRST_TURN:
        rest += progress.path.reach
    if progress.segment != LAST_TURN:
        rest += progress.path.end
    return progress.radius * rest


@compiled
def path_course(progress: PathProgress, at: Planar) -> Course:
    """Course onto and along the present segment, and the length of the rest of the path."""
    if is_straight(progress):
        begin = middle_begin(progress)
        onto = line_course(at, (begin.x, begin.y), begin.course, progress.radius)
    else:
        turn = present_turn(progress)
        onto = loiter_course(about(turn, at), turn.side, progress.radius)
    return Course(onto.chi, onto.chi_rate, path_left(progress))


@compiled
def beside(progress: PathProgress, at: Planar) -> float:
    """Distance beside the present segment [m], not negative."""
    if is_straight(progress):
        begin = middle_begin(progress)
        dx, dy = at.x - begin.x, at.y - begin.y
        return abs(math.cos(begin.course) * dy - math.sin(begin.course) * dx)
    here = about(present_turn(progress), at)
    return abs(math.hypot(here.x, here.y) - progress.radius)
