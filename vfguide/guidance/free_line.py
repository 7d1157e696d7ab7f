"""The free field of law `field`: the paper's in the horizontal plane of the goal, and its lines."""

import math

from vfguide.field.goal_frame import goal_frame, position_in_goal
from vfguide.field.navigation import navigation_field
from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled
from vfguide.planning.objective import GuidanceTarget

BOUND_BEHIND = 4.0
"""How far before the goal the bounded circles lead to [turn radii]; chosen."""
BOUND_ASIDE = 3.0
"""How far beside the goal's axis they lead to [turn radii]; chosen."""


@compiled
def free_course(p_n: Vec3, target: GuidanceTarget, radius: float, bounded: bool) -> float:
    """Course of the free field [rad]: the paper's, where its circles lead to the goal soon.

    Ahead of the goal they grow without bound, and on its axis there is none. There a point before
    the goal and beside its axis is led to, from which the circles are short.
    """
    x, y, _ = position_in_goal(goal_frame(target.p_n, target.course, 0.0), p_n)
    if bounded and x > -radius:
        side = math.copysign(BOUND_ASIDE * radius, y)
        return target.course + math.atan2(side - y, -BOUND_BEHIND * radius - x)
    north, east, _ = navigation_field((x, y, 0.0))
    return target.course + math.atan2(east, north)


@compiled
def line_length(p_n: Vec3, target: GuidanceTarget, radius: float, bounded: bool) -> float:
    """Length of the line of the free field from a position, NED [m], to the goal [m]."""
    x, y, _ = position_in_goal(goal_frame(target.p_n, target.course, 0.0), p_n)
    first = 0.0
    if bounded and x > -radius:
        aside = BOUND_ASIDE * radius
        first = math.hypot(x + BOUND_BEHIND * radius, abs(y) - aside)
        x, y = -BOUND_BEHIND * radius, aside
    half, chord = math.atan2(abs(y), -x), math.hypot(x, y)
    return first + (chord if half < 1e-6 else chord * half / math.sin(half))
