"""F_OA and its frame where a formula of the paper is singular.

On the surface, on the goal's axis, at the goal, at the centre of an obstacle, and where n x F,
n . F or n . G is zero. A point with a given normal n is put there by the choice of the goal: the
frame [F, H, G] of one point Q of the goal frame is turned into the wanted one.
"""

import math

import numpy as np
import pytest
from obstacle_samples import NOBODY, SPACING, STILL, at_level, one_obstacle
from shape_samples import SHAPES, every_shape, floats, random_directions

from vfguide.field import arrays
from vfguide.field.composite import composite_field
from vfguide.field.goal_frame import GoalFrame, goal_frame, navigation_field_n, normal_field_n
from vfguide.field.obstacle import PlacedObstacle, obstacle_surface
from vfguide.geometry.dual import Dual3
from vfguide.kernels.rows import place

pytestmark = pytest.mark.slow

Q = (-60.0, 80.0, 0.0)
VELOCITY = (12.0, -5.0, 3.0)
LEVELS = [1.0, 1.5, 3.0]
every_level = pytest.mark.parametrize("level", LEVELS)
every_direction = pytest.mark.parametrize("seed", range(2))


def point_and_normal(body, level, seed):
    """A point where U has the value, the unit normal there and two unit tangents."""
    obstacles = one_obstacle(body, heading=0.6)
    p = at_level(obstacles, random_directions(np.random.default_rng([42, seed]), 1), level)[0]
    n = np.array(obstacle_surface(obstacles, 0, Dual3(floats(p), STILL), 0.0).n.value)
    size = np.linalg.norm(n)
    n /= size
    t1 = np.cross(n, np.eye(3)[np.argmin(np.abs(n))])
    t1 /= np.linalg.norm(t1)
    return obstacles, p, n, t1, np.cross(n, t1), size


def goal_that_gives(p, F, G):
    """The goal of which F~ and G~ at `p` have the unit directions F and G."""
    wanted = np.column_stack((F, np.cross(G, F), G))
    R_ng = wanted @ arrays.attitudes(Q).T
    return GoalFrame(floats(p - R_ng @ Q), tuple(floats(row) for row in R_ng))


def at(goal, p, obstacles):
    """The field at `p`, after all that holds everywhere was found to hold."""
    here = composite_field(goal, floats(p), VELOCITY, 0.0, obstacles, NOBODY, SPACING)
    R_a, F, G = np.array(here.R_na), np.array(here.F), np.array(here.G)
    np.testing.assert_allclose(R_a.T @ R_a, np.eye(3), atol=1e-12)
    assert np.linalg.det(R_a) == pytest.approx(1.0, abs=1e-12)
    assert np.isfinite(here.Omega_a).all()
    assert np.linalg.norm(F) > 0.0
    assert abs(F @ G) <= 1e-12 * np.linalg.norm(F) * np.linalg.norm(G)
    np.testing.assert_allclose(R_a[:, 0], F / np.linalg.norm(F), atol=1e-12)
    np.testing.assert_allclose(R_a[:, 2], G / np.linalg.norm(G), atol=1e-12)
    return here


def assert_tangential(here, n):
    """Theorem 3 (1)."""
    assert abs(np.dot(here.F, n)) <= 1e-12 * np.linalg.norm(here.F)


@every_shape
@every_level
@every_direction
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_f_along_the_normal(body, level, seed, side):
    """F_OA = chi F + (1 - chi) G (eq_F_ob_de), and tau_b = G is square to F: the remark's 90."""
    obstacles, p, n, t1, _, _ = point_and_normal(body, level, seed)
    goal = goal_that_gives(p, side * n, t1)
    here = at(goal, p, obstacles)
    F, G = np.array(navigation_field_n(goal, floats(p))), np.array(normal_field_n(goal, floats(p)))
    assert abs(F @ G) <= 1e-12 * np.linalg.norm(F) * np.linalg.norm(G)
    chi = here.chi[0]
    expected = chi * F + (1.0 - chi) * G
    assert np.linalg.norm(here.F - expected) <= 1e-9 * np.linalg.norm(expected)
    if level == 1.0:
        assert_tangential(here, n)


@every_shape
@every_level
@every_direction
def test_f_tangential_to_the_level(body, level, seed):
    """n . F = 0, where the printed mu is 0 / 0: F_OA = (chi + (1 - chi) |n|^2) F."""
    obstacles, p, n, t1, t2, size = point_and_normal(body, level, seed)
    z = (n + t2) / math.sqrt(2.0)
    goal = goal_that_gives(p, t1, z)
    here = at(goal, p, obstacles)
    chi, F = here.chi[0], np.array(navigation_field_n(goal, floats(p)))
    expected = (chi + (1.0 - chi) * size**2) * F
    assert np.linalg.norm(here.F - expected) <= 1e-12 * np.linalg.norm(expected)
    if level == 1.0:
        assert_tangential(here, n)


@every_shape
@every_level
@every_direction
def test_g_tangential_to_the_level(body, level, seed):
    """n . G = 0, where on the surface G' vanishes: z of R_a stays along G, square to F_OA."""
    obstacles, p, n, t1, t2, _ = point_and_normal(body, level, seed)
    goal = goal_that_gives(p, (t2 - n) / math.sqrt(2.0), t1)
    here = at(goal, p, obstacles)
    np.testing.assert_allclose(np.array(here.R_na)[:, 2], t1, atol=1e-9)
    if level == 1.0:
        assert_tangential(here, n)
        np.testing.assert_allclose(np.array(here.R_na)[:, 0], t2, atol=1e-9)


@every_shape
@pytest.mark.parametrize("part", [0.0, 0.3, 1.0, 1.01, 1.1, 1.19, 1.5])
@pytest.mark.parametrize("ahead", [-1.0, 1.0])
@pytest.mark.parametrize("upright", [0.0, math.pi / 2])
def test_on_the_goals_axis(body, part, ahead, upright):
    """Inside the obstacle, on its surface, in its reactive area and beyond; level or upright."""
    goal = goal_frame((0.0, 0.0, 0.0), 0.0, upright)
    e_d = np.array(goal.R_ng)[:, 0]
    centre = floats(500.0 * e_d)
    obstacles = one_obstacle(body)
    obstacles[:, place(PlacedObstacle, "p_n")] = centre
    surface = at_level(obstacles, np.array([ahead * e_d]), 1.0)[0]
    p = np.array(centre) + part * (surface - centre)
    here = at(goal, p, obstacles)
    if part == 1.0:
        n = obstacle_surface(obstacles, 0, Dual3(floats(surface), STILL), 0.0).n.value
        assert_tangential(here, np.array(n) / np.linalg.norm(n))


@every_shape
@every_direction
def test_at_the_goal(body, seed):
    """F is zero there, and nowhere else; R_a is the goal's attitude and stands still."""
    obstacles, p, n, t1, _, _ = point_and_normal(body, 5.0, seed)
    goal = GoalFrame(floats(p), goal_that_gives(p, n, t1).R_ng)
    here = composite_field(goal, floats(p), VELOCITY, 0.0, obstacles, NOBODY, SPACING)
    assert (here.F, here.R_na, here.Omega_a) == (STILL, goal.R_ng, STILL)


@every_shape
@every_direction
def test_at_the_centre_of_an_obstacle(body, seed):
    """The gradient of the level may vanish there: n counts as collinear with F, tau_b is G."""
    obstacles, p, n, t1, _, _ = point_and_normal(body, 1.0, seed)
    goal = goal_that_gives(p, n, t1)
    here = at(goal, STILL, obstacles)
    normal = np.array(obstacle_surface(obstacles, 0, Dual3(STILL, STILL), 0.0).n.value)
    assert here.chi[0] == 0.0
    expected = np.array(normal_field_n(goal, STILL))
    if np.linalg.norm(normal) > 0.0:
        expected = np.cross(np.cross(normal, navigation_field_n(goal, STILL)), normal)
    np.testing.assert_allclose(here.F, expected, rtol=1e-9)


def test_near_the_surface_the_roll_rate_has_no_bound():
    """Where n . G changes sign G' turns over within a width that shrinks with chi."""
    rolls = []
    for level in (2.0, 1.4, 1.3, 1.2):
        obstacles, p, n, t1, t2, _ = point_and_normal(SHAPES["sphere"], level, 0)
        goal = goal_that_gives(p, (t2 - n) / math.sqrt(2.0), t1)
        F = np.array(at(goal, p, obstacles).F)
        v = floats(25.0 * F / np.linalg.norm(F))
        here = composite_field(goal, floats(p), v, 0.0, obstacles, NOBODY, SPACING)
        rolls.append(abs(math.degrees(here.Omega_a[0])))
    assert rolls == pytest.approx([0.457, 31.6, 233.0, 30095.0], rel=1e-2)


@every_shape
@every_direction
def test_an_obstacle_that_moves_runs_over_who_follows_the_field(body, seed):
    """Theorem 3 (1) is for one that stands: on the surface dU/dt = -n . v_o along F_OA."""
    obstacles, p, n, t1, t2, size = point_and_normal(body, 1.0, seed)
    goal = goal_that_gives(p, (t2 - n) / math.sqrt(2.0), t1)
    F = np.array(at(goal, p, obstacles).F)
    obstacles[:, place(PlacedObstacle, "v_n")] = 15.0 * n
    moving = composite_field(goal, floats(p), VELOCITY, 0.0, obstacles, NOBODY, SPACING)
    np.testing.assert_array_equal(moving.F, F)
    along = Dual3(floats(p), floats(25.0 * F / np.linalg.norm(F)))
    rate = obstacle_surface(obstacles, 0, along, 0.0).U.rate
    assert rate == pytest.approx(-15.0 * size, rel=1e-9)
