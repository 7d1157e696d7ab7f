import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from vfguide.field import navigation
from vfguide.geometry.so3 import rot_x
from vfguide.geometry.vector import cross, dot, matvec, norm, scale, sub

coordinates = st.floats(-1e3, 1e3).filter(lambda x: x == 0.0 or abs(x) > 1e-6)
points = st.tuples(coordinates, coordinates, coordinates)
RATES = [
    (navigation.navigation_field, navigation.navigation_field_rate, 2),
    (navigation.normal_field, navigation.normal_field_rate, 3),
]
FIELDS = [
    (navigation.navigation_field, 2),
    (navigation.normal_field, 3),
    (navigation.binormal_field, 5),
]
"""Fields, and the degrees of their components."""


def test_numbers_worked_by_hand():
    p = (1.0, 2.0, 3.0)
    assert navigation.navigation_field(p) == (-12.0, 4.0, 6.0)
    assert navigation.normal_field(p) == (26.0, 24.0, 36.0)
    assert navigation.binormal_field(p) == (0.0, -588.0, 392.0)


@given(points)
def test_lengths(p):
    distance, r = norm(p), math.hypot(p[1], p[2])
    assert norm(navigation.navigation_field(p)) == pytest.approx(distance**2, rel=1e-13)
    assert norm(navigation.normal_field(p)) == pytest.approx(r * distance**2, rel=1e-13)
    assert norm(navigation.binormal_field(p)) == pytest.approx(r * distance**4, rel=1e-13)


@given(points)
def test_f_and_g_are_orthogonal_and_h_is_their_product(p):
    F, G, H = (field(p) for field, _ in FIELDS)
    assert dot(F, G) == pytest.approx(0.0, abs=1e-14 * norm(F) * norm(G))
    assert norm(sub(cross(G, F), H)) <= 1e-14 * norm(G) * norm(F)


@given(points, st.floats(-math.pi, math.pi))
@pytest.mark.parametrize("field", [field for field, _ in FIELDS])
def test_fields_turn_with_the_point_about_the_goal_axis(field, p, angle):
    turned, expected = field(matvec(rot_x(angle), p)), matvec(rot_x(angle), field(p))
    assert norm(sub(turned, expected)) <= 1e-13 * norm(expected)


@given(points, st.floats(1e-2, 1e2))
@pytest.mark.parametrize(("field", "degree"), FIELDS)
def test_fields_are_homogeneous(field, degree, p, k):
    expected = scale(k**degree, field(p))
    assert norm(sub(field(scale(k, p)), expected)) <= 1e-13 * norm(expected)


@given(points, points)
@pytest.mark.parametrize(("field", "rate", "degree"), RATES)
def test_rates_are_central_differences(field, rate, degree, p, v):
    h = 1e-4
    after, before = (field(tuple(np.add(p, scale(k, v)))) for k in (h, -h))
    difference = scale(0.5 / h, sub(after, before))
    size = (norm(p) + norm(v)) ** degree
    assert norm(sub(rate(p, v), difference)) <= 1e-6 * size


@pytest.mark.parametrize(("field", "rate", "degree"), RATES)
def test_rate_along_the_position_is_eulers_theorem(field, rate, degree):
    p = (3.0, -4.0, 5.0)
    assert rate(p, p) == pytest.approx(scale(degree, field(p)), rel=1e-14)


@pytest.mark.parametrize("x", [-7.0, 7.0])
def test_on_the_axis_the_field_points_along_it_and_the_frame_is_lost(x):
    p = (x, 0.0, 0.0)
    assert navigation.navigation_field(p) == (x * x, 0.0, 0.0)
    assert norm(navigation.normal_field(p)) == 0.0
    assert norm(navigation.binormal_field(p)) == 0.0


@pytest.mark.parametrize(
    "start",
    [(-100.0, 40.0, -30.0), (200.0, 5.0, 1.0), (0.0, 0.0, 80.0), (-5.0, -300.0, 10.0)],
)
def test_integral_curves_are_circles_into_the_goal_along_e_x(start):
    """Theorem 1: rho = C sin(phi) in a plane theta = const, tangent to e_x at the origin."""

    def along(_, p):
        F = navigation.navigation_field(tuple(p))
        return np.array(F) / norm(F)

    def near_the_goal(_, p):
        return np.linalg.norm(p) - 1e-3 * diameter

    near_the_goal.terminal = True
    diameter = norm(start) ** 2 / math.hypot(start[1], start[2])
    length = math.pi * diameter
    path = solve_ivp(along, (0.0, length), start, rtol=1e-10, atol=1e-9, events=near_the_goal)
    assert path.status == 1
    x, y, z = path.y
    r = np.hypot(y, z)
    assert len(x) > 10
    np.testing.assert_allclose((x**2 + r**2) / r, diameter, rtol=1e-5)
    np.testing.assert_allclose(y / r, start[1] / math.hypot(*start[1:]), atol=1e-5)
    np.testing.assert_allclose(z / r, start[2] / math.hypot(*start[1:]), atol=1e-5)
    assert along(0.0, path.y[:, -1]) == pytest.approx((1.0, 0.0, 0.0), abs=3e-3)
