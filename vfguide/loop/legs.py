"""The mission that a companion is asked to fly: goals in their order, and the circle after them."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Table, reader, table_of
from vfguide.planning.objective import GuidanceTarget


class Goal(NamedTuple):
    """A pose to pass: a position and a direction of flight over ground."""

    p_n: Vec3
    """Position in the plan's frame, NED [m]."""
    course: float
    """Course over ground [rad]."""
    climb: float
    """Angle of climb over ground, positive up [rad]."""
    tolerance: float
    """Largest miss that counts as reached [m]."""
    tolerance_angle: float
    """Largest error of course and climb that counts as reached [rad]."""
    attempts: int = 0
    """Number of missed passes after which it is given up; 0 for never."""


class MissionLeg(NamedTuple):
    """One leg of the mission: to a goal, or along the circle after the last one."""

    goal: Goal
    """The goal; of the circle, the last goal."""
    slope: float
    """Slope dh/ds at the goal."""
    circle: float
    """Side of the circle, as in a `GuidanceTarget`; 0 for a goal."""
    radius: float
    """Radius of the circle [m]."""


Legs = Table
"""(N + 1, 11), one `MissionLeg` a row, the last one the circle."""
read_leg = reader(MissionLeg)


def leg_rows(goals: Sequence[Goal], loiter_side: float, loiter_radius: float) -> Legs:
    """The legs to all goals, and the level circle that leaves the last one.

    The circle turns to `loiter_side`, +1 right or -1 left, with `loiter_radius` [m].
    """
    to_goals = [MissionLeg(goal, math.tan(goal.climb), 0.0, 0.0) for goal in goals]
    circle = MissionLeg(goals[-1], 0.0, loiter_side, loiter_radius)
    return table_of(MissionLeg, [*to_goals, circle])


@compiled
def goal_of(legs: Legs, index: int) -> Goal:
    """The goal of a leg; of the circle, the last goal."""
    return read_leg(legs[index]).goal


@compiled
def target_of(legs: Legs, index: int) -> GuidanceTarget:
    """The target of a leg."""
    leg = read_leg(legs[index])
    return GuidanceTarget(leg.goal.p_n, leg.goal.course, leg.slope, leg.circle, leg.radius)
