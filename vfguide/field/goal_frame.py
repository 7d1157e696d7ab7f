"""Any goal: the frame at the goal pose and the paper's fields turned into it (Corollary 1).

The print writes the components with earth-frame differences x - x_d, ...; they belong into the
goal frame: F~(p) = R_d F(R_d^T (p - p_d)), and likewise for G and H.
"""

from typing import NamedTuple

from vfguide.field.navigation import navigation_field, normal_field
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.vector import Mat3, Vec3, matvec, sub, transpose
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import reader


class GoalFrame(NamedTuple):
    """A goal pose: p_d and R_d of the paper."""

    p_n: Vec3
    """The goal, NED [m]."""
    R_ng: Mat3
    """From the goal frame to NED; its first column is the direction e_d to arrive in."""


read_goal = reader(GoalFrame)


@compiled
def goal_frame(p_n: Vec3, heading: float, climb: float) -> GoalFrame:
    """The goal at `p_n` with course `heading` and angle of climb `climb`, up positive [rad].

    R_d = Rz(heading) Ry(climb), hence e_d = (cos c cos h, cos c sin h, -sin c).
    """
    return GoalFrame(p_n, from_euler(0.0, climb, heading))


@compiled
def position_in_goal(goal: GoalFrame, p_n: Vec3) -> Vec3:
    """p_g = R_d^T (p - p_d), the position in the goal frame [m]."""
    return velocity_in_goal(goal, sub(p_n, goal.p_n))


@compiled
def velocity_in_goal(goal: GoalFrame, v_n: Vec3) -> Vec3:
    """v_g = R_d^T v, a velocity or any free vector in the goal frame."""
    return matvec(transpose(goal.R_ng), v_n)


@compiled
def navigation_field_n(goal: GoalFrame, p_n: Vec3) -> Vec3:
    """F~ in NED: Corollary 1 (cor_VF_arbitra), corrected."""
    return matvec(goal.R_ng, navigation_field(position_in_goal(goal, p_n)))


@compiled
def normal_field_n(goal: GoalFrame, p_n: Vec3) -> Vec3:
    """G~ in NED: Lemma 1 under Corollary 1."""
    return matvec(goal.R_ng, normal_field(position_in_goal(goal, p_n)))
