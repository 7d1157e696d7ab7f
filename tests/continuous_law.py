"""The paper's rigid body under its law in continuous time."""

from vfguide.field.attitude import attitude
from vfguide.field.goal_frame import GoalFrame, goal_frame
from vfguide.field.rate_law import rate_law
from vfguide.geometry.so3 import exp
from vfguide.geometry.vector import Mat3, Vec3, add, matmul, matvec, norm, scale, sub

K_V, K_W = 0.4, 2.0
STEP = 0.01
DURATION = 40.0
GOAL = goal_frame((40.0, -20.0, 10.0), 0.8, -0.3)
E_X = (1.0, 0.0, 0.0)


def velocity(goal: GoalFrame, R_nb: Mat3, p_n: Vec3) -> Vec3:
    """eq_kine_trans with v = (k_v |p - p_d|, 0, 0): eq_vx_design."""
    return matvec(R_nb, scale(K_V * norm(sub(p_n, goal.p_n)), E_X))


def rates(goal: GoalFrame, R_nb: Mat3, p_n: Vec3) -> Vec3:
    """eq_Omega_design."""
    R_na, Omega_a = attitude(goal, p_n, velocity(goal, R_nb, p_n))
    return rate_law(R_nb, R_na, Omega_a, K_W)


def move(goal: GoalFrame, R_nb: Mat3, p_n: Vec3, duration: float = DURATION):
    """Attitude and position after a time: eq_kine_UVA by the midpoint rule on SO(3)."""
    for _ in range(round(duration / STEP)):
        R = matmul(R_nb, exp(scale(0.5 * STEP, rates(goal, R_nb, p_n))))
        p = add(p_n, scale(0.5 * STEP, velocity(goal, R_nb, p_n)))
        R_nb = matmul(R_nb, exp(scale(STEP, rates(goal, R, p))))
        p_n = add(p_n, scale(STEP, velocity(goal, R, p)))
    return R_nb, p_n


def rows(R) -> Mat3:
    return tuple(tuple(map(float, row)) for row in R)
