"""Field capture: where the paper's field leads to the goal without a turn that is too tight.

The origin is the start of the final approach, x along the goal's course.
"""

import math

from vfguide.geometry.angles import wrap
from vfguide.kernels.compiled import compiled
from vfguide.paths.course_laws import PlanarState, arc_to_goal, course_of, speed_of
from vfguide.paths.leg import Leg
from vfguide.paths.path_progress import TURN_IN

START_DEPTH = 0.045
"""Largest depth, inside the circles where the field turns too tightly, at which a leg starts in the
field [turn radii]; chosen."""
CAPTURE_DEPTH = 0.1
"""Largest depth, inside the circles where the field turns too tightly, at which the field is
captured from a path, and kept [turn radii]; chosen larger than `START_DEPTH`, as hysteresis."""
CAPTURE_ANGLE = 0.14
"""Largest angle between the course and the field at which the field is captured from a path [rad];
tuned with `tools/measure_poses.py`, so that turns onto the final approach begin in time."""
STRAY_ANGLE = 2.0
"""Angle between the course and the field above which the field is left, except near the goal [rad];
chosen."""
GOAL_COURSE_ANGLE = 1.2
"""Angle between the course and the goal's below which the field is kept near the goal, whatever its
direction [rad]; chosen."""
START_ANGLE = 0.5
"""Largest angle between the course and the field at which a leg starts in the field [rad];
chosen."""
FIELD_LENGTH_RATIO = 1.03
"""Largest ratio of the length along the field to that of the shortest path at which a leg starts in
the field; chosen."""
LINE_DISTANCE = 0.01
"""Largest distance beside the final approach at which a leg starts on it [turn radii]; chosen."""
LINE_ANGLE = 0.05
"""Largest angle between the course and the final approach at which a leg starts on it [rad];
chosen."""
ROLL_OUT_FACTOR = 5.0
"""Factor by which line distance and line angle may be larger at the end of a path, where the
vehicle rolls out onto the final approach; chosen: a path that ends up to 5 % of the radius beside
the final approach goes on along it."""


@compiled
def is_lined_up(leg: Leg, at: PlanarState) -> bool:
    """Whether the vehicle is on the final approach, as between goals in line."""
    is_on_line = 0.0 < at.x < leg.final_approach and abs(at.y) < LINE_DISTANCE * leg.radius
    return is_on_line and abs(course_of(at)) < LINE_ANGLE


@compiled
def rolls_out(leg: Leg, at: PlanarState, left: float) -> bool:
    """Whether to roll out onto the final approach now, `left` [m] before the end of a path."""
    lead = TURN_IN * speed_of(at)
    off = ROLL_OUT_FACTOR * LINE_ANGLE + lead / leg.radius
    is_beside = abs(at.y) < ROLL_OUT_FACTOR * LINE_DISTANCE * leg.radius
    return left < lead and is_beside and abs(course_of(at)) < off


@compiled
def depth(leg: Leg, at: PlanarState) -> float:
    """Depth inside the nearer circle of the leg's radius that touches the goal's line [m]."""
    return leg.radius - math.hypot(at.x, abs(at.y) - leg.radius)


@compiled
def off_field(at: PlanarState) -> float:
    """Angle between the course and the field [rad], not negative."""
    return abs(wrap(course_of(at) - 2.0 * math.atan2(at.y, at.x)))


@compiled
def takes_up_field(leg: Leg, at: PlanarState) -> bool:
    """Whether the field is captured from the end of a path."""
    is_wide = at.x < -abs(at.y) and depth(leg, at) <= CAPTURE_DEPTH * leg.radius
    return is_wide and off_field(at) < CAPTURE_ANGLE


@compiled
def stays_in_field(leg: Leg, at: PlanarState) -> bool:
    """Whether the field still leads to the goal without a turn that is too tight."""
    near = at.x > 0.0 or math.hypot(at.x, at.y) < leg.radius
    inside = depth(leg, at) / leg.radius
    if near and abs(course_of(at)) < GOAL_COURSE_ANGLE:
        return inside <= CAPTURE_DEPTH or at.x > 0.0
    return inside <= CAPTURE_DEPTH and at.x < -abs(at.y) and off_field(at) < STRAY_ANGLE


@compiled
def begins_in_field(leg: Leg, at: PlanarState, length: float, distance_for_altitude: float) -> bool:
    """Whether a leg starts in the field: flyable, hardly longer than the path of `length` [m]."""
    is_wide = at.x < -abs(at.y) and depth(leg, at) <= START_DEPTH * leg.radius
    if not is_wide or off_field(at) > START_ANGLE:
        return False
    field = arc_to_goal(at.x, at.y) + leg.radius * off_field(at)
    return distance_for_altitude <= field <= FIELD_LENGTH_RATIO * length
