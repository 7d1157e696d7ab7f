"""Field, frame and angular velocity among moving obstacles and robots."""

import math

import numpy as np
import pytest
from body_rates import vee
from hypothesis import given
from hypothesis import strategies as st
from obstacle_samples import NOBODY, NOTHING, SPACING, STILL, at_level, one_obstacle, random_goal
from shape_samples import SHAPES, every_shape, floats, random_directions, random_shape

from vfguide.field import arrays
from vfguide.field.attitude import AXIS, attitude
from vfguide.field.avoidance import COLLINEAR
from vfguide.field.composite import composite_field
from vfguide.field.composite_arrays import CompositeArrays, composite_fields
from vfguide.field.composite_frame import orthogonal_part
from vfguide.field.goal_frame import (
    GoalFrame,
    goal_frame,
    navigation_field_n,
    normal_field_n,
    position_in_goal,
)
from vfguide.field.obstacle import Obstacle, obstacle_rows
from vfguide.geometry.dual import Dual3
from vfguide.geometry.shapes import shape
from vfguide.geometry.so3 import rot_z
from vfguide.geometry.vector import add, dot, matmul, matvec, norm

SCENES, POINTS = 200, 50
STEPS = (1e-3, 1e-4, 1e-5, 1e-7)
"""Of the differences [s]. The best of them counts: a long one may cross a flip of G', and in a
short one rounding is large.
"""
AT_ORIGIN = goal_frame(STILL, 0.0, 0.0)
coordinates = st.floats(-300.0, 300.0)
points = st.tuples(coordinates, coordinates, coordinates)
angles = st.floats(-math.pi, math.pi)


def random_scene(rng):
    """One to three moving obstacles, up to two robots, and points in and around their areas."""
    obstacles = [
        Obstacle(
            random_shape(rng),
            floats(rng.uniform(-40.0, 40.0, 3)),
            rng.uniform(-math.pi, math.pi),
            floats(8.0 * rng.normal(size=3)),
            10.0 ** rng.uniform(0.3, 2.0),
        )
        for _ in range(rng.integers(1, 4))
    ]
    others = np.hstack([rng.uniform(-60.0, 60.0, (2, 3)), 20.0 * rng.normal(size=(2, 3))])
    p, v = rng.uniform(-60.0, 60.0, (POINTS, 3)), 20.0 * rng.normal(size=(POINTS, 3))
    for i, direction in enumerate(random_directions(rng, 4 * POINTS // 5)):
        obstacle = obstacles[i % len(obstacles)]
        p[i] = obstacle.p_n + rng.uniform(0.8, 1.3) * direction * obstacle.shape.semi_axes
    return random_goal(rng), p, v, obstacle_rows(obstacles), others[: rng.integers(0, 3)]


def after(others, h):
    return np.hstack([others[:, :3] + h * others[:, 3:], others[:, 3:]])


def turn_rates(goal, p, v, obstacles, others, h):
    """Body rates of R_a from differences over `h`, obstacles and robots moving on, (..., 3)."""

    def there(s):
        moved = after(others, s)
        return composite_fields(goal, p + s * v, v, 1.0 + s, obstacles, moved, SPACING).R_na

    wide, narrow = there(h) - there(-h), there(0.5 * h) - there(-0.5 * h)
    rate = (8.0 * narrow - wide) / (6.0 * h)
    return vee(np.swapaxes(there(0.0), -1, -2) @ rate)


def singular(goal, p, here):
    """Points of the sets that the notes on the law name: G' vanishes, or n and F are collinear.

    G' vanishes on the goal's axis, and on surfaces where chi = 0 and n.G = 0, where `composite`
    puts a unit vector in its place.
    """
    at = np.array([position_in_goal(goal, floats(q)) for q in p])
    axis = np.hypot(at[:, 1], at[:, 2]) <= AXIS * np.linalg.norm(at, axis=1)
    replaced = np.abs(np.linalg.norm(here.G, axis=1) - 1.0) <= 1e-12
    return axis | replaced


def test_angular_velocity_is_the_central_difference_at_10000_points():
    rng = np.random.default_rng(10)
    errors, sizes, skipped, deflected, touching = [], [], 0, 0, 0
    for _ in range(SCENES):
        goal, p, v, obstacles, others = random_scene(rng)
        here = composite_fields(goal, p, v, 1.0, obstacles, others, SPACING)
        skipped += np.count_nonzero(singular(goal, p, here))
        deflected += np.count_nonzero((here.chi < 1.0).any(axis=1))
        touching += np.count_nonzero((here.chi == 0.0).any(axis=1))
        size = 1.0 + np.linalg.norm(here.Omega_a, axis=1)
        differences = [turn_rates(goal, p, v, obstacles, others, h) for h in STEPS]
        error = [np.linalg.norm(rate - here.Omega_a, axis=1) / size for rate in differences]
        errors.append(np.min(error, axis=0))
        sizes.append(size - 1.0)
    assert skipped == 0
    assert (deflected, touching) >= (5000, 1500)
    assert np.median(sizes) > 0.1
    assert np.max(errors) <= 1e-5


def test_frames_are_rotations_and_their_columns_the_fields():
    rng = np.random.default_rng(11)
    for _ in range(SCENES):
        goal, p, v, obstacles, others = random_scene(rng)
        here = composite_fields(goal, p, v, 1.0, obstacles, others, SPACING)
        gram = np.swapaxes(here.R_na, 1, 2) @ here.R_na
        np.testing.assert_allclose(gram, np.broadcast_to(np.eye(3), gram.shape), atol=1e-12)
        np.testing.assert_allclose(np.linalg.det(here.R_na), 1.0, atol=1e-12)
        np.testing.assert_array_equal(here.H, np.cross(here.G, here.F))
        for k, field in enumerate((here.F, here.H, here.G)):
            column = field / np.linalg.norm(field, axis=1, keepdims=True)
            np.testing.assert_allclose(here.R_na[:, :, k], column, atol=1e-12)


@pytest.mark.parametrize("part", [1.0, 1e-6, 1e-11])
def test_the_orthogonal_part_is_orthogonal_however_small_it_is(part):
    rng = np.random.default_rng(16)
    for b, across in zip(random_directions(rng, 100), random_directions(rng, 100), strict=True):
        a = Dual3(floats(1e3 * b + part * across), floats(across))
        found = orthogonal_part(a, Dual3(floats(b), floats(across)))
        assert abs(dot(found.value, floats(b))) <= 1e-15 * norm(found.value)
        rate = dot(found.rate, floats(b)) + dot(found.value, floats(across))
        assert abs(rate) <= 1e-12 * (norm(found.rate) + norm(found.value))


@given(points, points, st.builds(goal_frame, points, angles, st.floats(-1.5, 1.5)))
def test_in_free_space_it_is_the_navigation_field(p, v, goal):
    far_off = obstacle_rows([Obstacle(SHAPES["box"], (0.0, 0.0, 5e3))])
    ghosts = np.array([[0.0, 5e3, 0.0, 1.0, 2.0, 3.0]])
    for obstacles, others in ((NOTHING, NOBODY), (far_off, ghosts)):
        here = composite_field(goal, p, v, 0.0, obstacles, others, SPACING)
        np.testing.assert_allclose(here.F, navigation_field_n(goal, p), rtol=1e-14)
        assert (here.R_na, here.Omega_a) == attitude(goal, p, v)
        if abs(np.linalg.norm(here.G) - 1.0) > 1e-12:
            size = np.linalg.norm(here.G)
            np.testing.assert_allclose(here.G, normal_field_n(goal, p), atol=1e-13 * size)


@given(points, points, angles, st.tuples(coordinates, coordinates, coordinates))
def test_everything_turns_with_the_world_about_the_vertical(p, v, angle, shift):
    turn = rot_z(angle)
    obstacle = Obstacle(SHAPES["ellipsoid"], (30.0, -20.0, 10.0), 0.4, (3.0, 2.0, 1.0), 1e3)
    goal, robot = goal_frame((200.0, 50.0, -30.0), 0.7, 0.2), (20.0, 80.0, 30.0, -5.0, 6.0, 7.0)
    there = GoalFrame(add(shift, matvec(turn, goal.p_n)), matmul(turn, goal.R_ng))
    moved = obstacle._replace(
        p_n=add(shift, matvec(turn, obstacle.p_n)),
        v_n=matvec(turn, obstacle.v_n),
        heading=obstacle.heading + angle,
    )
    other = (*add(shift, matvec(turn, robot[:3])), *matvec(turn, robot[3:]))
    here = composite_field(goal, p, v, 2.0, obstacle_rows([obstacle]), np.array([robot]), SPACING)
    turned = composite_field(
        there,
        add(shift, matvec(turn, p)),
        matvec(turn, v),
        2.0,
        obstacle_rows([moved]),
        np.array([other]),
        SPACING,
    )
    size = np.linalg.norm(here.F)
    np.testing.assert_allclose(turned.F, matvec(turn, here.F), atol=1e-9 * size)
    np.testing.assert_allclose(turned.R_na, matmul(turn, here.R_na), atol=1e-6)
    rate = np.linalg.norm(here.Omega_a)
    np.testing.assert_allclose(turned.Omega_a, here.Omega_a, atol=1e-6 * (1.0 + rate))
    assert turned.chi == pytest.approx(here.chi, abs=1e-9)


def test_obstacles_are_where_they_have_moved_to():
    moving = Obstacle(SHAPES["cone"], STILL, 0.3, (4.0, -2.0, 1.0), 1e3)
    there = moving._replace(p_n=(20.0, -10.0, 5.0))
    goal, p, v = goal_frame((300.0, 0.0, 0.0), 0.0, 0.0), (-10.0, -40.0, 0.0), (20.0, 1.0, 2.0)
    late = composite_field(goal, p, v, 5.0, obstacle_rows([moving]), NOBODY, SPACING)
    early = composite_field(goal, p, v, 0.0, obstacle_rows([there]), NOBODY, SPACING)
    assert 0.0 < late.chi[0] < 1.0
    for a, b in zip(late, early, strict=True):
        np.testing.assert_allclose(a, b, rtol=1e-12)
    still = composite_field(
        goal, p, v, 0.0, obstacle_rows([there._replace(v_n=STILL)]), NOBODY, SPACING
    )
    assert still.F == early.F
    assert np.abs(np.subtract(still.Omega_a, early.Omega_a)).max() > 1e-3


def test_a_robot_is_a_moving_sphere_with_a_unit_normal():
    """eq_F_CA_i, written out."""
    goal, p, other = goal_frame((200.0, 0.0, 0.0), 0.0, 0.0), (0.0, 10.0, 0.0), (50.0, 20.0, 5.0)
    here = composite_field(
        goal, p, STILL, 0.0, NOTHING, np.array([[*other, 0.0, 0.0, 0.0]]), SPACING
    )
    d = np.subtract(p, other)
    distance = np.linalg.norm(d)
    n, s = d / distance, (distance - 20.0) / 80.0
    chi = 1.0 / (1.0 + math.exp(1.0 / s - 1.0 / (1.0 - s)))
    F = np.array(navigation_field_n(goal, p))
    np.testing.assert_allclose(
        here.F, chi * F + (1.0 - chi) * np.cross(np.cross(n, F), n), rtol=1e-12
    )


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("distance", [0.0, 20.0, 30.0, 30.5, 40.0, 50.0, 59.0, 70.0])
def test_along_the_goals_axis_through_an_obstacle_on_it(distance, side):
    """The frame is whole all the way, and turns as it says when the robot moves on the axis."""
    goal, v = GoalFrame((200.0, 0.0, 0.0), AT_ORIGIN.R_ng), np.array([[20.0, 0.0, 0.0]])
    obstacles = one_obstacle(shape.sphere(30.0))
    p = np.array([[side * distance, 0.0, 0.0]])
    here = composite_fields(goal, p, v, 0.0, obstacles, NOBODY, SPACING)
    gram = here.R_na[0].T @ here.R_na[0]
    np.testing.assert_allclose(gram, np.eye(3), atol=1e-12)
    assert np.linalg.norm(here.F) > 0.0
    np.testing.assert_allclose(here.R_na[0, :, 2], (0.0, 0.0, 1.0), atol=1e-12)
    rate = turn_rates(goal, p, v, obstacles, NOBODY, 1e-3)
    np.testing.assert_allclose(here.Omega_a, rate, atol=1e-7)


@pytest.mark.parametrize("z", [1.0, -1.0])
def test_where_chi_is_zero_and_n_is_orthogonal_to_g_the_frame_keeps_to_g(z):
    """Abreast of the goal F = -e_x and G is away from it; the obstacle is ahead."""
    p, G = (0.0, 0.0, 100.0 * z), (0.0, 0.0, z)
    behind = obstacle_rows([Obstacle(shape.sphere(30.0), (-18.0, 24.0, 100.0 * z))])
    here = composite_field(AT_ORIGIN, p, (1.0, 2.0, 3.0), 0.0, behind, NOBODY, SPACING)
    assert here.chi[0] == 0.0
    np.testing.assert_allclose(here.G, G, atol=1e-12)
    np.testing.assert_allclose(np.array(here.R_na)[:, 2], G, atol=1e-12)
    assert np.isfinite(here.Omega_a).all()


def test_f_collinear_with_n_off_the_axis():
    """A sphere whose centre F points at: F_OA = chi F + (1 - chi) G."""
    p = (-60.0, 80.0, 0.0)
    F = np.array(navigation_field_n(AT_ORIGIN, p))
    G = np.array(normal_field_n(AT_ORIGIN, p))
    ahead = floats(p + 45.0 * F / np.linalg.norm(F))
    obstacles = obstacle_rows([Obstacle(shape.sphere(30.0), ahead)])
    here = composite_field(AT_ORIGIN, p, (5.0, 6.0, 7.0), 0.0, obstacles, NOBODY, SPACING)
    n = np.subtract(p, ahead)
    assert np.linalg.norm(np.cross(n, F)) <= COLLINEAR * np.linalg.norm(n) * np.linalg.norm(F)
    chi = here.chi[0]
    assert 0.0 < chi < 1.0
    np.testing.assert_allclose(here.F, chi * F + (1.0 - chi) * G, rtol=1e-12)
    expected = chi * (F @ F) * G - (1.0 - chi) * (G @ G) * F
    np.testing.assert_allclose(here.G, expected, rtol=1e-9)


def test_at_the_goal_and_in_the_middle_of_things_the_frame_is_whole():
    goal = goal_frame((10.0, 20.0, 30.0), 0.5, 0.1)
    around_goal = obstacle_rows([Obstacle(shape.sphere(30.0), goal.p_n)])
    here = composite_field(goal, goal.p_n, (1.0, 2.0, 3.0), 0.0, around_goal, NOBODY, SPACING)
    assert (here.F, here.R_na, here.Omega_a) == (STILL, goal.R_ng, STILL)
    for body in SHAPES.values():
        at_centre = composite_field(
            goal, STILL, (1.0, 2.0, 3.0), 0.0, one_obstacle(body), NOBODY, SPACING
        )
        gram = np.array(at_centre.R_na).T @ at_centre.R_na
        np.testing.assert_allclose(gram, np.eye(3), atol=1e-12)
        assert np.isfinite(at_centre.Omega_a).all()


def test_extremes_stay_finite():
    rng = np.random.default_rng(12)
    body = shape.superquadric((0.5, 0.5, 0.5), (8.0, 8.0, 8.0))
    obstacles = obstacle_rows([Obstacle(body, STILL, reactive_level=1e30)])
    for p in random_directions(rng, 200) * 10.0 ** rng.uniform(-9.0, 6.0, (200, 1)):
        goal = random_goal(rng, 1e6)
        here = composite_field(goal, floats(p), (20.0, 0.0, 0.0), 0.0, obstacles, NOBODY, SPACING)
        for part in here:
            assert np.isfinite(part).all()


@every_shape
def test_the_field_is_continuous_where_the_reactive_area_begins(body):
    obstacles, goal = one_obstacle(body), goal_frame((500.0, 100.0, 50.0), 0.2, 0.1)
    edge = at_level(obstacles, random_directions(np.random.default_rng(13), 100), 4.0)
    for p in (edge, edge * (1.0 - 1e-4)):
        here = composite_fields(goal, p, STILL, 0.0, obstacles, NOBODY, SPACING)
        free = composite_fields(goal, p, STILL, 0.0, NOTHING, NOBODY, SPACING)
        np.testing.assert_allclose(here.R_na, free.R_na, atol=1e-9)


def test_arrays_broadcast_and_equal_the_scalar_function():
    rng = np.random.default_rng(14)
    goal, p, v, obstacles, others = random_scene(rng)
    while len(others) == 0:
        goal, p, v, obstacles, others = random_scene(rng)
    p, t = p.reshape(5, 10, 3), np.linspace(0.0, 1.0, 10)
    many = composite_fields(goal, p, v[0], t, obstacles, others, SPACING)
    assert [a.shape[:2] for a in many] == len(many) * [(5, 10)]
    for i, j in np.ndindex(5, 10):
        one = composite_field(goal, floats(p[i, j]), floats(v[0]), t[j], obstacles, others, SPACING)
        for a, b in zip(many, one, strict=True):
            np.testing.assert_allclose(a[i, j], b, rtol=1e-9, atol=1e-12 * np.abs(b).max())
    one_each = np.broadcast_to(others, (5, 10, *others.shape))
    same = composite_fields(goal, p, v[0], t, obstacles, one_each, SPACING)
    for a, b in zip(many, same, strict=True):
        np.testing.assert_array_equal(a, b)
    nowhere = composite_fields(goal, np.empty((0, 3)), v[0], 0.0, obstacles, NOBODY, SPACING)
    assert isinstance(nowhere, CompositeArrays)
    assert nowhere.R_na.shape == (0, 3, 3)


def test_without_obstacles_attitudes_are_those_of_the_free_field():
    p, v = np.random.default_rng(15).normal(size=(2, 1000, 3)) * 100.0
    here = composite_fields(AT_ORIGIN, p, v, 0.0, NOTHING, NOBODY, SPACING)
    np.testing.assert_allclose(here.R_na, arrays.attitudes(p), atol=1e-15)
    np.testing.assert_allclose(here.Omega_a, arrays.attitude_rates(p, v), rtol=1e-12)
