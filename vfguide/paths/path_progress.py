"""Progress along a Dubins path, that of a leg or an edge of a route.

The path is followed segment by segment, by the course laws of lines and circles. The last turn is
the one that ends at the end pose: a path from which a turn of nearly a full circle was left out
still leads there.
"""

import math
from typing import NamedTuple

from vfguide.geometry.angles import FULL_TURN
from vfguide.geometry.se2 import ORIGIN, Pose, centre_beside, point_from
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import replacing
from vfguide.paths.course_laws import (
    Course,
    PlanarState,
    line_course,
    loiter_course,
    pose_at,
    speed_of,
)
from vfguide.paths.dubins import SHORT_LAST_TURN, DubinsPath
from vfguide.paths.edge import FIRST_TURN, LAST_TURN, MIDDLE, Edge, segment_at

TURN_IN = 0.37
"""Time before the end of a segment at which the roll into the next one starts [s], twice that from
one turn into the opposite one: the lag of the bank under the default gains, 1 / k_w + RATE_LAG of
the point mass."""


class PathProgress(NamedTuple):
    """A Dubins path in the horizontal plane, and the progress of the vehicle along it."""

    edge: Edge
    """The path, and the pose at its start."""
    end: Pose
    """Pose at its end."""
    radius: float
    """Radius of the turns [m]."""
    segment: int
    """Present segment: FIRST_TURN, MIDDLE or LAST_TURN."""
    left: float
    """Rest of the present segment: angle of a turn [rad], length of a straight [turn radii]."""


at_segment = replacing(PathProgress, "segment", "left")


@compiled
def begin_path(at: PlanarState, path: DubinsPath, radius: float) -> PathProgress:
    """The progress at the start of a Dubins path from here to the origin, course 0.

    `radius` is that of the turns [m].
    """
    edge = Edge(pose_at(at), path)
    return PathProgress(edge, ORIGIN, radius, FIRST_TURN, path.arc)


@compiled
def is_straight(progress: PathProgress) -> bool:
    """Whether the present segment is a straight."""
    return progress.segment == MIDDLE and progress.edge.path.middle == 0.0


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
    path, radius, end = progress.edge.path, progress.radius, progress.end
    if progress.segment == LAST_TURN:
        x, y = centre_beside(end, path.last, radius)
        return Turn(x, y, path.last, end.course)
    turn = segment_at(progress.edge, progress.segment, radius)
    x, y = centre_beside(turn.begin, turn.side, radius)
    return Turn(x, y, turn.side, turn.begin.course + turn.side * turn.length / radius)


@compiled
def on_straight(progress: PathProgress, at: PlanarState) -> tuple[float, float]:
    """Position of the vehicle along the present straight, and to the right of it [m]."""
    return point_from(
        segment_at(progress.edge, progress.segment, progress.radius).begin, at.x, at.y
    )


@compiled
def about(turn: Turn, at: PlanarState) -> PlanarState:
    """Position and velocity of the vehicle relative to the centre of a turn."""
    return PlanarState(at.x - turn.x, at.y - turn.y, at.vx, at.vy)


@compiled
def segment_left(progress: PathProgress, at: PlanarState) -> float:
    """Rest of the present segment: angle of a turn [rad], length of a straight [turn radii].

    The number of full circles still to be flown is that of the step before.
    """
    if is_straight(progress):
        travelled, _ = on_straight(progress, at)
        return progress.edge.path.reach - travelled / progress.radius
    turn = present_turn(progress)
    here = about(turn, at)
    course = math.atan2(here.y, here.x) + turn.side * 0.5 * math.pi
    left = turn.side * (turn.end - course)
    return left + FULL_TURN * round((progress.left - left) / FULL_TURN)


@compiled
def along(progress: PathProgress, at: PlanarState) -> PathProgress:
    """The path with the progress of the vehicle, into the next segment in time for the roll."""
    path, lead = progress.edge.path, TURN_IN * speed_of(at) / progress.radius
    last = path.last * min(1.0, path.end / SHORT_LAST_TURN)
    middle = last if path.middle == 0.0 and path.reach < lead else path.middle
    progress = at_segment(progress, progress.segment, segment_left(progress, at))
    if progress.segment == FIRST_TURN and progress.left < lead * abs(middle - path.first):
        progress = into_next(progress, path.reach, at)
    if progress.segment == MIDDLE and progress.left < lead * abs(last - path.middle):
        progress = into_next(progress, path.end, at)
    return progress


@compiled
def into_next(progress: PathProgress, whole: float, at: PlanarState) -> PathProgress:
    """The progress in the next segment, the `whole` of which [rad, or turn radii] lies ahead."""
    following = at_segment(progress, progress.segment + 1, whole)
    return at_segment(following, following.segment, segment_left(following, at))


@compiled
def path_left(progress: PathProgress) -> float:
    """Length of the rest of the path along its segments [m]."""
    rest, path = progress.left, progress.edge.path
    if progress.segment == FIRST_TURN:
        rest += path.reach
    if progress.segment != LAST_TURN:
        rest += path.end
    return progress.radius * rest


@compiled
def path_course(progress: PathProgress, at: PlanarState) -> Course:
    """Course onto and along the present segment, and the length of the rest of the path."""
    if is_straight(progress):
        begin = segment_at(progress.edge, progress.segment, progress.radius).begin
        onto = line_course(at, begin, progress.radius)
    else:
        turn = present_turn(progress)
        onto = loiter_course(about(turn, at), turn.side, progress.radius)
    return Course(onto.chi, onto.chi_rate, path_left(progress))


@compiled
def beside(progress: PathProgress, at: PlanarState) -> float:
    """Distance beside the present segment [m], not negative."""
    if is_straight(progress):
        _, off = on_straight(progress, at)
        return abs(off)
    here = about(present_turn(progress), at)
    return abs(math.hypot(here.x, here.y) - progress.radius)
