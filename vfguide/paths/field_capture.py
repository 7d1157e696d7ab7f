"""Where the paper's field leads to the goal without a turn that is too tight.

The origin is the beginning of the straight end of the approach, x along the goal's course.
"""

import math

from vfguide.geometry.angles import wrap
from vfguide.geometry.compiled import compiled
from vfguide.paths.course_laws import Planar, arc_to_goal
from vfguide.paths.leg import Leg
from vfguide.paths.path_progress import TURN_IN

INSIDE = 0.045
"""The field is begun no farther inside the circles where it is too tight than so many radii, ..."""
COMMITTED = 0.1
"""... and taken up from a path, and kept, no farther inside than this."""
AGREEMENT = 0.14
"""From a path the field is taken up where the course is within this of it [rad]."""
STRAYED = 2.0
"""Away from the goal the field is given up where the course is off by this [rad]."""
TOWARD = 0.5
"""A leg is begun in the field only where the course is within this of it [rad]."""
FIELD_LENGTH_RATIO = 1.03
"""At the beginning of a leg the field may be longer than the shortest path by this factor."""
ASIDE = 0.01
"""The straight end is begun between its ends no farther aside than this, in radii, ..."""
OFF_COURSE = 0.05
"""... and within this of its course [rad]; at the end of a path ..."""
ROLL_OUT_FACTOR = 5.0
"""... so many times as far."""


@compiled
def is_lined_up(leg: Leg, at: Planar) -> bool:
    """Whether the vehicle is on the straight end of the approach, as between goals in line."""
    is_on_line = 0.0 < at.x < leg.final_approach and abs(at.y) < ASIDE * leg.radius
    return is_on_line and abs(math.atan2(at.vy, at.vx)) < OFF_COURSE


@compiled
def rolls_out(leg: Leg, at: Planar, left: float) -> bool:
    """Whether to roll out onto the straight end now, `left` [m] before the end of a path."""
    lead = TURN_IN * math.hypot(at.vx, at.vy)
    off = ROLL_OUT_FACTOR * OFF_COURSE + lead / leg.radius
    is_beside = abs(at.y) < ROLL_OUT_FACTOR * ASIDE * leg.radius
    return left < lead and is_beside and abs(math.atan2(at.vy, at.vx)) < off


@compiled
def depth(leg: Leg, at: Planar) -> float:
    """How far inside the nearer circle of the leg's radius that touches the goal's line [m]."""
    return leg.radius - math.hypot(at.x, abs(at.y) - leg.radius)


@compiled
def off_field(at: Planar) -> float:
    """Angle between the course and the field's [rad]."""
    return abs(wrap(math.atan2(at.vy, at.vx) - 2.0 * math.atan2(at.y, at.x)))


@compiled
def takes_up_field(leg: Leg, at: Planar) -> bool:
    """Whether the field leads on from the end of a path."""
    is_wide = at.x < -abs(at.y) and depth(leg, at) <= COMMITTED * leg.radius
    return is_wide and off_field(at) < AGREEMENT


@compiled
def stays_in_field(leg: Leg, at: Planar) -> bool:
    """Whether the field still leads to the goal without a turn that is too tight."""
    near = at.x > 0.0 or math.hypot(at.x, at.y) < leg.radius
    inside = depth(leg, at) / leg.radius
    if near and abs(math.atan2(at.vy, at.vx)) < 1.2:
        return inside <= COMMITTED or at.x > 0.0
    return inside <= COMMITTED and at.x < -abs(at.y) and off_field(at) < STRAYED


@compiled
def begins_in_field(leg: Leg, at: Planar, length: float, distance_for_altitude: float) -> bool:
    """Whether the field is flyable from here, hardly longer than the path of `length` [m]."""
    is_wide = at.x < -abs(at.y) and depth(leg, at) <= INSIDE * leg.radius
    if not is_wide or off_field(at) > TOWARD:
        return False
    field = arc_to_goal(at.x, at.y) + leg.radius * off_field(at)
    return distance_for_altitude <= field <= FIELD_LENGTH_RATIO * length
