import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from vfguide.field import goal_frame as gf
from vfguide.field import navigation
from vfguide.geometry.so3 import exp
from vfguide.geometry.vector import add, matmul, matvec, norm, scale, sub

HERE = (0.0, 0.0, 0.0)

coordinates = st.floats(-1e3, 1e3)
points = st.tuples(coordinates, coordinates, coordinates)
rotations = points.map(lambda w: exp(scale(1e-2, w)))
goals = st.builds(gf.goal_frame, points, st.floats(-math.pi, math.pi), st.floats(-1.57, 1.57))
FIELDS = [
    (gf.navigation_field_n, navigation.navigation_field, 2),
    (gf.normal_field_n, navigation.normal_field, 3),
]


def column(R, k):
    return (R[0][k], R[1][k], R[2][k])


@given(st.floats(-math.pi, math.pi), st.floats(-1.57, 1.57))
def test_direction_of_a_heading_and_a_climb(h, c):
    R_ng = gf.goal_frame(HERE, h, c).R_ng
    e_d = (math.cos(c) * math.cos(h), math.cos(c) * math.sin(h), -math.sin(c))
    assert column(R_ng, 0) == pytest.approx(e_d, abs=1e-15)
    oracle = Rotation.from_euler("ZY", [h, c]).as_matrix()
    np.testing.assert_allclose(R_ng, oracle, atol=1e-15)
    assert R_ng[2][1] == 0.0  # the goal's wings are level


@given(goals, points)
def test_positions_and_velocities_in_the_goal_frame(goal, p_n):
    p_g = gf.position_in_goal(goal, p_n)
    assert add(goal.p_n, matvec(goal.R_ng, p_g)) == pytest.approx(p_n, abs=1e-9)
    origin = goal._replace(p_n=HERE)
    assert gf.velocity_in_goal(goal, p_n) == gf.position_in_goal(origin, p_n)


@given(points)
@pytest.mark.parametrize(("field_n", "field", "_"), FIELDS)
def test_at_the_papers_own_goal_the_fields_are_the_papers(field_n, field, _, p):
    assert field_n(gf.goal_frame(HERE, 0.0, 0.0), p) == pytest.approx(field(p), rel=1e-14)


@given(goals, st.floats(-500.0, 500.0))
def test_on_the_goal_axis_the_field_points_along_the_goals_direction(goal, s):
    """Corollary 1, corrected; with the print's earth-frame differences it would not."""
    e_d = column(goal.R_ng, 0)
    F = gf.navigation_field_n(goal, add(goal.p_n, scale(s, e_d)))
    assert norm(sub(F, scale(s * s, e_d))) <= 1e-9 * (1.0 + abs(s))


def test_corollary_worked_by_hand():
    """Goal 10 m north, flown eastward: a point 3 m east and 1 m north of it."""
    goal = gf.goal_frame((10.0, 0.0, 0.0), math.pi / 2, 0.0)
    p_n = (11.0, 3.0, 0.0)
    assert gf.position_in_goal(goal, p_n) == pytest.approx((3.0, -1.0, 0.0), abs=1e-15)
    # F(3, -1, 0) = (8, -6, 0): 8 east and 6 north.
    assert gf.navigation_field_n(goal, p_n) == pytest.approx((6.0, 8.0, 0.0), abs=1e-14)


@given(goals, points, st.tuples(rotations, points))
@pytest.mark.parametrize(
    ("field_n", "degree"), [(field_n, degree) for field_n, _, degree in FIELDS]
)
def test_fields_turn_with_the_world(field_n, degree, goal, p_n, motion):
    turn, shift = motion
    there = gf.GoalFrame(add(shift, matvec(turn, goal.p_n)), matmul(turn, goal.R_ng))
    moved = field_n(there, add(shift, matvec(turn, p_n)))
    size = 1.0 + norm(p_n) + norm(goal.p_n) + norm(shift)
    assert norm(sub(moved, matvec(turn, field_n(goal, p_n)))) <= 1e-13 * size**degree
