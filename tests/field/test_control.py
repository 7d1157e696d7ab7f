"""Theorem 2: the kinematics (2) of a rigid body under the rate law and v_x = k_v |p|."""

import math

import numpy as np
import pytest
from obstacle_samples import NOTHING
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from vfguide.field.attitude import attitude
from vfguide.field.goal_frame import GoalFrame, goal_frame, position_in_goal
from vfguide.field.rate_law import rate_law
from vfguide.field.swarm import goal_rows
from vfguide.field.swarm_control import PaperGains, Swarm, fly_paper_law
from vfguide.geometry.so3 import exp
from vfguide.geometry.vector import Mat3, Vec3, add, matmul, matvec, norm, scale, sub
from vfguide.sim import kinematic

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


@pytest.mark.parametrize("seed", range(12))
def test_the_robot_comes_to_the_goal_with_its_heading(seed):
    """Theorem 2, from any position and any attitude."""
    rng = np.random.default_rng([41, seed])
    p_n = tuple(map(float, rng.uniform(-100.0, 100.0, 3)))
    R_nb = rows(Rotation.random(rng=rng).as_matrix())
    R_nb, p_n = move(GOAL, R_nb, p_n)
    assert norm(sub(p_n, GOAL.p_n)) <= 0.05
    ahead, e_d = matvec(R_nb, E_X), matvec(GOAL.R_ng, E_X)
    assert np.dot(ahead, e_d) >= math.cos(1e-3)


@pytest.mark.parametrize("start", [(-60.0, 10.0, 5.0), (30.0, 40.0, -10.0), (0.0, 0.0, 50.0)])
def test_with_its_heading_on_the_field_the_robot_flies_the_circle_at_the_rate_of_the_law(start):
    """rho' = k_v rho cos phi and phi' = k_v sin phi: tan(phi / 2) grows as exp(k_v t)."""
    p_n = add(GOAL.p_n, matvec(GOAL.R_ng, start))
    R_na, _ = attitude(GOAL, p_n, E_X)
    duration = 5.0
    _, p_n = move(GOAL, R_na, p_n, duration)
    x, y, z = position_in_goal(GOAL, p_n)
    r0 = math.hypot(start[1], start[2])
    half = math.tan(0.5 * math.atan2(r0, start[0])) * math.exp(K_V * duration)
    phi = 2.0 * math.atan(half)
    rho = norm(start) ** 2 / r0 * math.sin(phi)
    expected = (rho * math.cos(phi), *(rho * math.sin(phi) / r0 * a for a in start[1:]))
    assert (x, y, z) == pytest.approx(expected, abs=1e-3 * rho)


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_on_the_axis_before_the_goal_it_arrives_and_beyond_it_leaves(side):
    """X_0+ is what the theorem leaves out: k_v |p| grows for ever."""
    p_n = add(GOAL.p_n, matvec(GOAL.R_ng, (side * 10.0, 0.0, 0.0)))
    _, p_n = move(GOAL, GOAL.R_ng, p_n, 5.0)
    expected = side * 10.0 * math.exp(side * K_V * 5.0)
    assert position_in_goal(GOAL, p_n) == pytest.approx((expected, 0.0, 0.0), rel=1e-4, abs=1e-6)


@pytest.mark.parametrize("seed", range(5))
def test_a_step_of_the_body_solves_its_kinematics(seed):
    """eq_kine_UVA with constant inputs, integrated by SciPy."""
    rng = np.random.default_rng([43, seed])
    R_nb, w = rows(Rotation.random(rng=rng).as_matrix()), rng.uniform(-2.0, 2.0, 3)
    hat = np.array([[0.0, -w[2], w[1]], [w[2], 0.0, -w[0]], [-w[1], w[0], 0.0]])

    def rate(_, state):
        R = state[3:].reshape(3, 3)
        return np.concatenate((25.0 * R[:, 0], (R @ hat).ravel()))

    start = np.concatenate((GOAL.p_n, np.ravel(R_nb)))
    end = solve_ivp(rate, (0.0, 1.5), start, rtol=1e-11, atol=1e-11).y[:, -1]
    R_after, p_after = kinematic.move(R_nb, GOAL.p_n, 25.0, tuple(map(float, w)), 1.5)
    np.testing.assert_allclose(p_after, end[:3], atol=1e-8)
    np.testing.assert_allclose(R_after, end[3:].reshape(3, 3), atol=1e-9)


@pytest.mark.parametrize("seed", range(5))
def test_the_law_in_steps_flies_the_path_of_the_continuous_law(seed):
    rng = np.random.default_rng([44, seed])
    p_n = tuple(map(float, rng.uniform(-100.0, 100.0, 3)))
    R_nb = rows(Rotation.random(rng=rng).as_matrix())
    gains = PaperGains(K_V, K_W, 0.002)
    bodies = kinematic.Bodies(np.array([p_n]), np.array([R_nb]))
    for _ in range(2000):
        swarm = Swarm(bodies.p_n, bodies.R_nb, np.array([True]))
        speed, omega_b = fly_paper_law(goal_rows([GOAL]), swarm, 0.0, NOTHING, None, gains)
        bodies = kinematic.advance(bodies, kinematic.Commands(speed, omega_b), gains.dt)
    R_nb, p_n = move(GOAL, R_nb, p_n, 4.0)
    np.testing.assert_allclose(bodies.p_n[0], p_n, atol=0.05)
    np.testing.assert_allclose(bodies.R_nb[0], R_nb, atol=1e-3)
