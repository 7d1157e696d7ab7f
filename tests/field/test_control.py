"""Theorem 2: the kinematics (2) of a rigid body under the rate law and v_x = k_v |p|."""

import math

import numpy as np
import pytest
from continuous_law import E_X, GOAL, K_V, move, rows
from scipy.spatial.transform import Rotation

from vfguide.field.attitude import attitude
from vfguide.field.goal_frame import position_in_goal
from vfguide.geometry.vector import add, matvec, norm, sub


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
