"""The way that a companion is asked to fly: goals in their order, and the circle after them.

Compiled code takes it as an array, a row a leg: the last row is the circle.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.flight.memory import Target
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3

Legs = NDArray[np.float64]
"""(N + 1, 11): the six values of a `Goal`, its position taking three columns, then slope, circle
and radius of a `Target`."""


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
    """It is given up after so many missed passes; 0: never."""


def leg_rows(goals: Sequence[Goal], loiter_side: float, loiter_radius: float) -> Legs:
    """The legs to all goals, and the level circle that leaves the last one."""
    to_goals = [(*goal.p_n, *goal[1:], math.tan(goal.climb), 0.0, 0.0) for goal in goals]
    last = goals[-1]
    return np.array([*to_goals, (*last.p_n, *last[1:], 0.0, loiter_side, loiter_radius)])


@compiled
def goal_of(legs: Legs, index: int) -> Goal:
    """The goal of a leg; of the circle, the last goal."""
    a = legs[index]
    return Goal((a[0], a[1], a[2]), a[3], a[4], a[5], a[6], int(a[7]))


@compiled
def target_of(legs: Legs, index: int) -> Target:
    """What to fly to on a leg."""
    a = legs[index]
    return Target((a[0], a[1], a[2]), a[3], a[8], a[9], a[10])
