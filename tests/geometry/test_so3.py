import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from vfguide.geometry import so3
from vfguide.geometry.vector import cross, dot, matmul, matvec, norm, scale, transpose

pytestmark = pytest.mark.slow

EPS = 1e-14
AXES = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, -1.0), (0.6, 0.0, -0.8), (-0.48, 0.6, 0.64)]
ANGLES_AT_THE_EDGES = [
    0.0, 1e-300, 1e-160, 1e-20, 1e-12, 1e-9, 1e-8, 1e-5, 1e-3,
    math.pi - 1e-3, math.pi - 1e-7, math.pi - 1e-9, math.pi - 1e-12, math.pi - 4e-16, math.pi,
]  # fmt: skip

components = st.floats(-1.0, 1.0)
directions = (
    st.tuples(components, components, components)
    .filter(lambda a: norm(a) > 1e-3)
    .map(lambda a: scale(1.0 / norm(a), a))
)
angles = st.one_of(st.floats(0.0, math.pi), st.sampled_from(ANGLES_AT_THE_EDGES))
rotation_vectors = st.builds(scale, angles, directions)
rotations = rotation_vectors.map(so3.exp)
full_turn = st.floats(-math.pi, math.pi)


def assert_close(a, b, tolerance=EPS):
    np.testing.assert_allclose(np.array(a), np.array(b), rtol=0.0, atol=tolerance)


@given(rotations, rotations)
def test_products_stay_in_the_group(A, B):
    C = np.array(matmul(A, B))
    assert_close(C.T @ C, np.eye(3))
    assert np.linalg.det(C) == pytest.approx(1.0, abs=EPS)


@given(rotation_vectors)
def test_the_opposite_vector_gives_the_inverse(w):
    assert_close(so3.exp(scale(-1.0, w)), transpose(so3.exp(w)))
    assert_close(matmul(so3.exp(scale(-1.0, w)), so3.exp(w)), np.eye(3))


def test_zero_is_the_identity():
    assert so3.exp((0.0, 0.0, 0.0)) == so3.IDENTITY
    assert so3.log(so3.IDENTITY) == (0.0, 0.0, 0.0)


@given(directions, st.floats(-4.0, 4.0), st.floats(-4.0, 4.0))
def test_rotations_about_one_axis_add(axis, a, b):
    both = matmul(so3.exp(scale(a, axis)), so3.exp(scale(b, axis)))
    assert_close(both, so3.exp(scale(a + b, axis)))


@given(rotations, rotation_vectors)
def test_conjugation_rotates_the_axis(R, w):
    conjugate = matmul(matmul(R, so3.exp(w)), transpose(R))
    assert_close(conjugate, so3.exp(matvec(R, w)))


@given(rotations, directions, directions)
def test_rotations_keep_dot_and_cross_products(R, a, b):
    assert dot(matvec(R, a), matvec(R, b)) == pytest.approx(dot(a, b), abs=EPS)
    assert_close(cross(matvec(R, a), matvec(R, b)), matvec(R, cross(a, b)))


@given(rotation_vectors)
def test_exp_is_scipys(w):
    assert_close(so3.exp(w), Rotation.from_rotvec(w).as_matrix())


@given(rotation_vectors)
def test_exp_undoes_log(w):
    R = so3.exp(w)
    assert norm(so3.log(R)) <= math.pi * (1.0 + 1e-15)
    assert_close(so3.exp(so3.log(R)), R)


@pytest.mark.parametrize("axis", AXES)
@pytest.mark.parametrize("angle", ANGLES_AT_THE_EDGES)
def test_log_at_small_angles_and_near_pi(axis, angle):
    w = so3.log(so3.exp(scale(angle, axis)))
    assert norm(w) == pytest.approx(angle, rel=1e-14, abs=2e-15)
    # At pi, to rounding, w and -w are the same rotation.
    sign = math.copysign(1.0, dot(w, axis)) if math.pi - angle < 1e-15 else 1.0
    assert_close(w, scale(sign * angle, axis))


@pytest.mark.parametrize("axis", AXES)
def test_log_keeps_relative_precision_of_tiny_rotations(axis):
    np.testing.assert_allclose(so3.log(so3.exp(scale(1e-40, axis))), scale(1e-40, axis), 1e-14)


@pytest.mark.parametrize("half_turn", [(1, -1, -1), (-1, 1, -1), (-1, -1, 1)])
def test_log_of_an_exact_half_turn_is_pi_about_the_positive_axis(half_turn):
    R = tuple(tuple(float(x) for x in row) for row in np.diag(half_turn))
    assert so3.log(R) == tuple(math.pi if k == 1 else 0.0 for k in half_turn)


@given(rotations)
def test_quaternion_is_scipys_and_comes_back(R):
    q = so3.to_quaternion(R)
    w, x, y, z = q
    assert w >= 0.0
    assert math.hypot(*q) == pytest.approx(1.0, abs=EPS)
    assert_close(Rotation.from_quat([x, y, z, w]).as_matrix(), R)
    assert_close(so3.from_quaternion(q), R)


@given(rotations, st.floats(1e-3, 1e3), st.sampled_from([-1.0, 1.0]))
def test_length_and_sign_of_a_quaternion_do_not_matter(R, length, sign):
    w, x, y, z = so3.to_quaternion(R)
    k = sign * length
    assert_close(so3.from_quaternion((k * w, k * x, k * y, k * z)), R)


@given(full_turn, st.floats(-math.pi / 2, math.pi / 2), full_turn)
def test_euler_angles_are_scipys_and_come_back(roll, pitch, yaw):
    R = so3.from_euler(roll, pitch, yaw)
    assert_close(R, Rotation.from_euler("ZYX", [yaw, pitch, roll]).as_matrix())
    assert_close(so3.from_euler(*so3.to_euler(R)), R)


@given(st.floats(-3.1, 3.1), st.floats(-1.5, 1.5), st.floats(-3.1, 3.1))
def test_euler_angles_themselves_come_back(roll, pitch, yaw):
    assert_close(so3.to_euler(so3.from_euler(roll, pitch, yaw)), (roll, pitch, yaw), 1e-13)


@pytest.mark.parametrize("pitch", [math.pi / 2, -math.pi / 2])
@pytest.mark.parametrize("short_by", [0.0, 1e-16, 1e-12, 1e-8])
def test_euler_angles_at_the_gimbal_lock(pitch, short_by):
    R = so3.from_euler(0.4, pitch - math.copysign(short_by, pitch), -2.0)
    there = so3.exp((0.3, -0.7, 0.5))
    rounded = matmul(transpose(there), matmul(there, R))
    for attitude in (R, rounded):
        assert_close(so3.from_euler(*so3.to_euler(attitude)), attitude)


def test_euler_angles_of_an_aeroplane():
    right, nose, clockwise = so3.rot_x(0.1), so3.rot_y(0.1), so3.rot_z(0.1)
    assert matvec(right, (0.0, 1.0, 0.0))[2] > 0.0  # the right wing goes down
    assert matvec(nose, (1.0, 0.0, 0.0))[2] < 0.0  # the nose goes up
    assert matvec(clockwise, (1.0, 0.0, 0.0))[1] > 0.0  # the nose goes east
    assert so3.from_euler(0.1, 0.0, 0.0) == right
    assert so3.from_euler(0.0, 0.1, 0.0) == nose
    assert so3.from_euler(0.0, 0.0, 0.1) == clockwise


@given(full_turn, st.floats(-1.5, 1.5), full_turn)
def test_the_bank_of_an_attitude_is_its_roll(roll, pitch, yaw):
    R_nb = so3.from_euler(roll, pitch, yaw)
    off = so3.bank_angle(R_nb) - roll
    assert math.remainder(off, 2.0 * math.pi) == pytest.approx(0.0, abs=1e-9)
