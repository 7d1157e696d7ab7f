"""The rigid body against SciPy: its step is the exact solution of eq. (2)."""

import math

import numpy as np
import pymap3d
import pytest
from continuous_law import GOAL, rows
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from vfguide.geometry.so3 import from_euler
from vfguide.kernels.rows import columns
from vfguide.sim.kinematic import (
    Bodies,
    Commands,
    Sighting,
    advance,
    mean_direction,
    move,
    sightings,
)

RATES = st.tuples(*[st.floats(-6.0, 6.0)] * 3)
ANGLES = st.tuples(st.floats(-3.1, 3.1), st.floats(-1.5, 1.5), st.floats(-3.1, 3.1))
START = (12.0, -7.0, 30.0)


def hat(w):
    return np.array([[0.0, -w[2], w[1]], [w[2], 0.0, -w[0]], [-w[1], w[0], 0.0]])


def random_bodies(rng, count):
    R_nb = Rotation.from_quat(rng.normal(size=(count, 4))).as_matrix()
    return Bodies(rng.uniform(-500.0, 500.0, (count, 3)), np.ascontiguousarray(R_nb))


def random_commands(rng, count):
    return Commands(rng.uniform(-5.0, 30.0, count), rng.uniform(-4.0, 4.0, (count, 3)))


@given(ANGLES, RATES, st.floats(-10.0, 40.0), st.floats(0.01, 3.0))
def test_a_step_solves_the_differential_equations(angles, rates, speed, dt):
    R_nb = from_euler(*angles)

    def derivative(_, y):
        R = y[3:].reshape(3, 3)
        return np.concatenate((speed * R[:, 0], (R @ hat(rates)).ravel()))

    start = np.concatenate((START, np.ravel(R_nb)))
    solved = solve_ivp(derivative, (0.0, dt), start, method="DOP853", rtol=1e-11, atol=1e-11)
    R_after, p_after = move(R_nb, START, speed, rates, dt)
    assert p_after == pytest.approx(solved.y[:3, -1], abs=1e-7)
    assert np.ravel(R_after) == pytest.approx(solved.y[3:, -1], abs=1e-8)
    turned = Rotation.from_matrix(R_nb) * Rotation.from_rotvec(dt * np.array(rates))
    assert np.array(R_after) == pytest.approx(turned.as_matrix(), abs=1e-12)


@given(ANGLES, RATES, st.floats(-10.0, 40.0), st.floats(0.01, 3.0), st.floats(0.0, 1.0))
def test_two_parts_of_a_step_make_the_whole(angles, rates, speed, dt, part):
    R_nb = from_euler(*angles)
    whole = move(R_nb, START, speed, rates, dt)
    between = move(R_nb, START, speed, rates, part * dt)
    parts = move(*between, speed, rates, (1.0 - part) * dt)
    assert parts[1] == pytest.approx(whole[1], abs=1e-11)
    assert np.array(parts[0]) == pytest.approx(np.array(whole[0]), abs=1e-13)


def test_after_100000_steps_the_attitude_is_still_a_rotation():
    rng = np.random.default_rng(4)
    bodies, dt = random_bodies(rng, 1), 0.02
    rates = np.array([[0.7, -1.3, 2.1]])
    start = Rotation.from_matrix(bodies.R_nb[0])
    for _ in range(100_000):
        bodies = advance(bodies, Commands(np.array([5.0]), rates), dt)
    (R,) = bodies.R_nb
    assert pytest.approx(np.eye(3), abs=1e-14) == R @ R.T
    assert np.linalg.det(R) == pytest.approx(1.0, abs=1e-14)
    turn = math.remainder(2000.0 * np.linalg.norm(rates), 2.0 * math.pi)
    expected = start * Rotation.from_rotvec(turn * rates[0] / np.linalg.norm(rates))
    assert (expected.inv() * Rotation.from_matrix(R)).magnitude() < 1e-9


@pytest.mark.parametrize("angle", [0.0, 1e-300, 1e-160, 1e-12, 1e-8, 1e-5, 1e-3, 0.1, 3.0, 40.0])
def test_mean_direction_down_to_the_smallest_angles(angle):
    axis = np.array([0.48, -0.6, 0.64])
    w = tuple((angle * axis).tolist())
    s = (np.arange(4000) + 0.5) / 4000
    mean = Rotation.from_rotvec(s[:, None] * np.array(w)).apply((1.0, 0.0, 0.0)).mean(axis=0)
    assert mean_direction(w) == pytest.approx(mean, abs=max(1e-15, 1e-8 * angle**2))
    straight_on = np.array((1.0, 0.5 * w[2], -0.5 * w[1]))
    assert mean_direction(w) == pytest.approx(straight_on, abs=max(1e-16, angle**2 / 6.0))


@pytest.mark.parametrize("axis", [(1.0, 0.0, 0.0), (-1.0, 0.0, 0.0)])
def test_a_body_that_only_rolls_flies_straight_on(axis):
    R_nb = from_euler(0.3, 0.2, 1.1)
    rates = tuple(7.0 * a for a in axis)
    _, p_n = move(R_nb, START, 20.0, rates, 0.9)
    ahead = np.array(START) + 18.0 * np.array(R_nb)[:, 0]
    assert p_n == pytest.approx(ahead, abs=1e-12)


def test_all_bodies_move_as_each_alone():
    rng = np.random.default_rng(5)
    bodies, commands = random_bodies(rng, 7), random_commands(rng, 7)
    after = advance(bodies, commands, 0.3)
    for i in range(7):
        R_nb = tuple(map(tuple, bodies.R_nb[i].tolist()))
        p_n, omega_b = tuple(bodies.p_n[i].tolist()), tuple(commands.omega_b[i].tolist())
        R_alone, p_alone = move(R_nb, p_n, float(commands.speed[i]), omega_b, 0.3)
        assert np.array_equal(after.R_nb[i], R_alone)
        assert np.array_equal(after.p_n[i], p_alone)


def seen_from(vector, there, here):
    """A vector north-east-down at one place, north-east-down at another; degrees."""
    north, east, down = vector
    in_space = pymap3d.enu2uvw(east, north, -down, *there)
    east, north, up = pymap3d.uvw2enu(*in_space, *here)
    return np.array((north, east, -up))


def test_sightings_are_geodetic_and_level_where_the_body_is():
    rng = np.random.default_rng(6)
    bodies, commands = random_bodies(rng, 20), random_commands(rng, 20)
    bodies = Bodies(100.0 * bodies.p_n, bodies.R_nb)  # up to 50 km away
    origin = (47.4, 8.5, 488.0)
    rows = sightings(bodies, commands, (math.radians(47.4), math.radians(8.5), 488.0))
    each = map(Sighting, *columns(Sighting, rows))
    for p_n, R_nb, speed, seen in zip(*bodies, commands.speed, each, strict=True):
        lat, lon, alt = pymap3d.ned2geodetic(*p_n, *origin)
        place = np.degrees((seen.latitude, seen.longitude))
        assert place == pytest.approx((lat, lon), abs=1e-9)
        assert seen.altitude == pytest.approx(alt, abs=1e-5)
        R_lb = np.column_stack([seen_from(axis, origin[:2], (lat, lon)) for axis in R_nb.T])
        assert seen.v_l == pytest.approx(speed * R_lb[:, 0], abs=1e-8)
        w, x, y, z = seen.q_lb
        assert Rotation.from_quat((x, y, z, w)).as_matrix() == pytest.approx(R_lb, abs=1e-9)


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
    R_after, p_after = move(R_nb, GOAL.p_n, 25.0, tuple(map(float, w)), 1.5)
    np.testing.assert_allclose(p_after, end[:3], atol=1e-8)
    np.testing.assert_allclose(R_after, end[3:].reshape(3, 3), atol=1e-9)
