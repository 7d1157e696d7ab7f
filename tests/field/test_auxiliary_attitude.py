import math

import numpy as np
import pytest
from body_rates import vee
from hypothesis import given
from hypothesis import strategies as st

from vfguide.field import arrays
from vfguide.field.attitude import AXIS, attitude, goal_attitude
from vfguide.field.goal_frame import GoalFrame, goal_frame
from vfguide.field.navigation import binormal_field, navigation_field, normal_field
from vfguide.geometry.so3 import IDENTITY, exp, rot_x
from vfguide.geometry.vector import add, matmul, matvec, norm, scale, unit

AT_REST = (0.0, 0.0, 0.0)
DISTANCES = [1e-9, 1e-3, 1.0, 1e3, 1e7]

angles = st.floats(-math.pi, math.pi)
coordinates = st.floats(-1e3, 1e3)
points = st.tuples(coordinates, coordinates, coordinates)
off_axis_points = points.filter(lambda p: math.hypot(p[1], p[2]) > 1.0)
goals = st.builds(goal_frame, points, angles, st.floats(-1.5, 1.5))


def random_points(count, seed=3):
    """Points 1e-9 m to 1e7 m from the goal, half of them within a degree of its axis."""
    rng = np.random.default_rng(seed)
    p = rng.normal(size=(count, 3))
    p[::2, 1:] *= 10.0 ** rng.uniform(-6.0, -2.0, (count // 2, 1))
    distance = 10.0 ** rng.uniform(-9.0, 7.0, (count, 1))
    return distance * p / np.linalg.norm(p, axis=1, keepdims=True)


def random_velocities(count, seed=4):
    rng = np.random.default_rng(seed)
    return rng.normal(size=(count, 3)) * 10.0 ** rng.uniform(-1.0, 2.0, (count, 1))


def assert_rotations(R, tolerance=1e-12):
    R = np.asarray(R)
    gram = np.swapaxes(R, -1, -2) @ R
    np.testing.assert_allclose(gram, np.broadcast_to(np.eye(3), R.shape), atol=tolerance)
    np.testing.assert_allclose(np.linalg.det(R), 1.0, atol=tolerance)


def test_attitudes_are_rotations_at_10000_points():
    assert_rotations(arrays.attitudes(random_points(10_000)))


@pytest.mark.parametrize(
    ("k", "fields"),
    [(0, arrays.navigation_fields), (1, arrays.binormal_fields), (2, arrays.normal_fields)],
)
def test_columns_are_the_normalised_fields(k, fields):
    p = random_points(2000)
    expected = fields(p)
    expected /= np.linalg.norm(expected, axis=1, keepdims=True)
    np.testing.assert_allclose(arrays.attitudes(p)[:, :, k], expected, atol=1e-14)


def test_angular_velocities_are_central_differences_at_10000_points():
    p, v = random_points(10_000), random_velocities(10_000)
    # The attitude varies over the distance r from the axis; Richardson's step removes h^2.
    r = np.hypot(p[:, 1], p[:, 2])
    h = 1e-3 * (r / np.linalg.norm(v, axis=1))[:, None]

    def difference(h):
        return (arrays.attitudes(p + h * v) - arrays.attitudes(p - h * v)) / (2.0 * h[..., None])

    R_rate = (4.0 * difference(0.5 * h) - difference(h)) / 3.0
    product = np.swapaxes(arrays.attitudes(p), 1, 2) @ R_rate
    expected = vee(product)
    size = 1.0 + np.linalg.norm(expected, axis=1)[:, None, None]
    np.testing.assert_allclose((product + np.swapaxes(product, 1, 2)) / size, 0.0, atol=1e-6)
    error = np.linalg.norm(arrays.attitude_rates(p, v) - expected, axis=1)
    assert np.max(error / (1.0 + np.linalg.norm(expected, axis=1))) <= 1e-6
    assert np.median(np.linalg.norm(expected, axis=1)) > 1e-3


@given(goals, off_axis_points, points, points)
def test_attitude_turns_with_the_world(goal, p_g, v_n, rotation):
    turn = exp(scale(1e-2, rotation))
    there = GoalFrame(matvec(turn, goal.p_n), matmul(turn, goal.R_ng))
    p_n = add(goal.p_n, matvec(goal.R_ng, p_g))
    here = attitude(goal, p_n, v_n)
    moved = attitude(there, matvec(turn, p_n), matvec(turn, v_n))
    np.testing.assert_allclose(moved.R_na, matmul(turn, here.R_na), atol=1e-11)
    np.testing.assert_allclose(moved.Omega_a, here.Omega_a, atol=1e-11 * (1.0 + norm(v_n)))


@given(angles, angles)
def test_attitude_turns_about_the_goal_axis_with_the_point(angle, phi):
    p = (10.0 * math.cos(phi), 10.0 * abs(math.sin(phi)) + 1e-3, 0.0)
    turned, _ = goal_attitude(matvec(rot_x(angle), p), AT_REST)
    np.testing.assert_allclose(
        turned, matmul(rot_x(angle), goal_attitude(p, AT_REST)[0]), atol=1e-12
    )


def test_angular_velocity_on_a_circle_of_the_field():
    """Along F at speed V the field turns by 2 r V / |p|^2 about -y_a and does not roll."""
    p = (-30.0, 40.0, 0.0)
    F = navigation_field(p)
    _, Omega_a = goal_attitude(p, scale(25.0 / norm(F), F))
    assert Omega_a == pytest.approx((0.0, 2.0 * 40.0 * 25.0 / 2500.0, 0.0), abs=1e-14)


@pytest.mark.parametrize("x", [s * d for d in DISTANCES for s in (1.0, -1.0)])
def test_on_the_axis_the_attitude_is_the_goals(x):
    R_ga, Omega_a = goal_attitude((x, 0.0, 0.0), (5.0, 2.0, -3.0))
    assert R_ga == IDENTITY
    # F's direction turns with 2 v / x there (finite, exact); roll is held.
    assert Omega_a == pytest.approx((0.0, 6.0 / x, 4.0 / x), rel=1e-14)


@pytest.mark.parametrize("v", [AT_REST, (25.0, 0.0, 0.0), (0.0, 1.0, -1.0)])
def test_at_the_goal_the_attitude_is_the_goals_and_stands_still(v):
    assert goal_attitude((0.0, 0.0, 0.0), v) == (IDENTITY, (0.0, 0.0, 0.0))
    goal = goal_frame((1.0, 2.0, 3.0), 0.4, 0.2)
    assert attitude(goal, goal.p_n, v).R_na == goal.R_ng


@pytest.mark.parametrize("distance", DISTANCES)
@pytest.mark.parametrize("ratio", [0.0, 1e-300, 1e-20, 0.9 * AXIS, 1.1 * AXIS, 1e-6, 1.0])
@pytest.mark.parametrize("theta", [-2.0, 0.0, math.pi / 2])
def test_around_the_axis_all_is_finite_and_x_is_along_the_field(distance, ratio, theta):
    for side in (1.0, -1.0):
        r = distance * ratio
        p = (side * distance, r * math.cos(theta), r * math.sin(theta))
        R_ga, Omega_a = goal_attitude(p, (20.0, 5.0, -5.0))
        assert_rotations(R_ga)
        assert np.isfinite(Omega_a).all()
        x = tuple(row[0] for row in R_ga)
        assert x == pytest.approx(unit(navigation_field(p)), abs=1e-15)


def test_approaching_the_axis_from_above_the_attitude_is_continuous():
    p = (-100.0, 0.0, -100.0 * 2.0 * AXIS)
    R_ga, _ = goal_attitude(p, AT_REST)
    np.testing.assert_allclose(R_ga, IDENTITY, atol=5.0 * AXIS)


def test_frame_of_a_point_worked_by_hand():
    """Abreast of the goal, r = 1 on +y: F = -e_x, H = e_z, G = e_y."""
    p = (0.0, 1.0, 0.0)
    assert (navigation_field(p), binormal_field(p), normal_field(p)) == (
        (-1.0, 0.0, 0.0),
        (0.0, 0.0, 1.0),
        (0.0, 1.0, 0.0),
    )
    R_ga, _ = goal_attitude(p, AT_REST)
    assert R_ga == ((-1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 1.0, 0.0))
