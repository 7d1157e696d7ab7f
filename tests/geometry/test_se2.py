"""SE(2) against matrices: the axioms of the group, and its exponential map."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import expm

from vfguide.geometry.angles import wrap
from vfguide.geometry.se2 import (
    ORIGIN,
    Pose,
    after_turn,
    centre_beside,
    composed,
    distance_between,
    point_from,
    rotated,
    seen_from,
    straight_on,
    unrotated,
)

PLACE, ANGLE = st.floats(-900.0, 900.0), st.floats(-6.0, 6.0)
POSES = st.builds(Pose, PLACE, PLACE, ANGLE)


def matrix(pose):
    """The homogeneous transform of a frame: axes 1 and 2 turn clockwise seen from above."""
    c, s = math.cos(pose.course), math.sin(pose.course)
    return np.array([[c, -s, pose.x], [s, c, pose.y], [0.0, 0.0, 1.0]])


def assert_same(pose, transform):
    assert np.allclose(matrix(pose), transform, atol=1e-8)


@given(POSES, POSES)
def test_composition_is_the_product_of_transforms(frame, pose):
    assert_same(composed(frame, pose), matrix(frame) @ matrix(pose))


@given(POSES, POSES)
def test_a_pose_is_seen_by_the_inverse_transform(frame, pose):
    seen = seen_from(frame, pose)
    assert_same(seen, np.linalg.inv(matrix(frame)) @ matrix(pose))
    assert -math.pi <= seen.course <= math.pi
    assert_same(composed(frame, seen), matrix(pose))
    assert np.allclose(point_from(frame, pose.x, pose.y), (seen.x, seen.y), atol=1e-8)


@given(POSES, POSES, POSES)
def test_the_axioms_of_the_group_hold(a, b, c):
    assert_same(composed(composed(a, b), c), matrix(composed(a, composed(b, c))))
    assert composed(a, ORIGIN) == a
    assert_same(composed(ORIGIN, a), matrix(a))
    assert_same(composed(a, seen_from(a, ORIGIN)), np.eye(3))


@given(PLACE, PLACE, ANGLE)
def test_a_rotation_and_its_inverse_cancel(x, y, angle):
    c, s = math.cos(angle), math.sin(angle)
    assert np.allclose(unrotated(*rotated(x, y, c, s), c, s), (x, y), atol=1e-9)


@given(POSES, st.floats(-500.0, 500.0))
def test_a_straight_is_the_exponential_of_a_translation(begin, distance):
    twist = np.array([[0.0, 0.0, distance], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    assert_same(straight_on(begin, distance), matrix(begin) @ expm(twist))


@given(POSES, st.sampled_from([1.0, -1.0]), st.floats(-6.0, 6.0), st.floats(10.0, 300.0))
def test_a_turn_is_the_exponential_of_a_twist(begin, side, arc, radius):
    turn, forward = side * arc, radius * arc
    twist = np.array([[0.0, -turn, forward], [turn, 0.0, 0.0], [0.0, 0.0, 0.0]])
    end = after_turn(begin, side, arc, radius)
    assert_same(end, matrix(begin) @ expm(twist))
    x, y = centre_beside(begin, side, radius)
    assert math.isclose(math.hypot(end.x - x, end.y - y), radius, rel_tol=1e-9)
    assert abs(wrap(end.course - begin.course - turn)) < 1e-9


@given(POSES, POSES, POSES)
def test_a_distance_does_not_depend_on_the_axes(frame, one, other):
    apart = distance_between(one, other)
    assert apart == distance_between(other, one)
    moved = distance_between(seen_from(frame, one), seen_from(frame, other))
    assert moved == pytest.approx(apart, abs=1e-9 * (1.0 + apart))
