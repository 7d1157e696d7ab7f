"""The paper's closed loop for a swarm: v_x = k_v |p - p_d|, and Lemma 4 on the composite field.

The paper's law is continuous. Here speed and body rates are held from one step to the next, and
the gains are those that have the same effect over a step: an error decays as exp(-k t) from step
to step, at any rate of the steps. Beside the goal's axis R_a may roll by any angle in one step: fed
forward, that would keep a robot whose nose is off the axis circling around it (`MAX_ROLL_STEP`).
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.field.composite_arrays import CompositeArrays
from vfguide.field.goal_frame import read_goal
from vfguide.field.obstacle import Rows
from vfguide.field.rate_law import rate_law
from vfguide.field.robots import Robot, Spacing, write_robot
from vfguide.field.swarm import fields_of_robots
from vfguide.geometry.vector import Matrices, Series, Vectors, mat3, norm, scale, sub, vec3
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import width

ROBOT_WIDTH = width(Robot)
"""Number of floats in the row of a `Robot`."""
MAX_ROLL_STEP = 0.3
"""Largest roll of the auxiliary attitude that is fed forward in one step [rad], chosen with
`tools/measure_kinematics.py`: without the bound, one start in a thousand kept circling the goal's
axis."""


class Swarm(NamedTuple):
    """N robots in the order of their priority."""

    p_n: Vectors
    """(N, 3) positions, NED [m]."""
    R_nb: Matrices
    """(N, 3, 3) attitudes, body to NED."""
    moving: NDArray[np.bool_]
    """(N,) whether the robot flies to its goal; else it stands still."""


class PaperGains(NamedTuple):
    """The law's gains, and the step over which its outputs are held."""

    k_v: float
    """Gain from the distance to the goal to the speed [1/s] (eq_vx_design)."""
    k_w: float
    """Decay rate of the attitude error [1/s] (Lemma 4)."""
    dt: float
    """Time for which speed and body rates are held [s]."""


@compiled
def held_gain(k: float, dt: float) -> float:
    """(1 - exp(-k dt)) / dt: held for `dt`, it reduces an error as the continuous gain `k` does."""
    return -math.expm1(-k * dt) / dt


def fly_paper_law(
    goals: Rows,
    swarm: Swarm,
    t: float,
    obstacles: Rows,
    spacing: Spacing | None,
    gains: PaperGains,
) -> tuple[Series, Vectors]:
    """Speeds (N,) [m/s] and body rates (N, 3) [rad/s] of all robots.

    Args:
        goals: of `goal_rows`, N rows.
        swarm: the robots.
        t: time [s], for the motion of the obstacles.
        obstacles: of `obstacle_rows`, M rows.
        spacing: r_c and r_d; None: robots take no notice of each other.
        gains: of the law.
    """
    robots, speed = velocities(goals, swarm, held_gain(gains.k_v, gains.dt))
    fields = fields_of_robots(goals, robots, t, obstacles, spacing)
    return speed, body_rates(
        swarm, fields, held_gain(gains.k_w, gains.dt), MAX_ROLL_STEP / gains.dt
    )


@compiled
def velocities(goals: Rows, swarm: Swarm, k_v: float) -> tuple[Rows, Series]:
    """The robots, moving with v_x R e_x, a `Robot` a row; and speeds v_x = k_v |p - p_d| (N,)."""
    count = len(goals)
    robots, speed = np.zeros((count, ROBOT_WIDTH)), np.zeros(count)
    for i in range(count):
        p_n, R_nb = vec3(swarm.p_n[i]), mat3(swarm.R_nb[i])
        if swarm.moving[i]:
            speed[i] = k_v * norm(sub(p_n, read_goal(goals[i]).p_n))
        v_n = scale(speed[i], (R_nb[0][0], R_nb[1][0], R_nb[2][0]))
        write_robot(Robot(p_n, v_n), robots[i])
    return robots, speed


@compiled
def body_rates(swarm: Swarm, fields: CompositeArrays, k_w: float, most: float) -> Vectors:
    """Lemma 4, eq_Omega_design, towards R_a of the fields, (N, 3) [rad/s].

    The roll of Omega_a is limited to `most` [rad/s].
    """
    omega_b: Vectors = np.zeros((len(swarm.p_n), 3))
    for i in range(len(swarm.p_n)):
        if swarm.moving[i]:
            R_nb, R_na, Omega_a = mat3(swarm.R_nb[i]), mat3(fields.R_na[i]), vec3(fields.Omega_a[i])
            roll = max(-most, min(most, Omega_a[0]))
            rates = rate_law(R_nb, R_na, (roll, Omega_a[1], Omega_a[2]), k_w)
            omega_b[i, 0], omega_b[i, 1], omega_b[i, 2] = rates
    return omega_b
