"""Theorem 1 and its proof: planes, circles and the exact solution of p' = F(p).

In a plane theta = const with w = x + i r the field is w^2 (eq_VF_xrtheta_compo), and p' = F has
the solution w / (1 - w t): an oracle that shares nothing with the code.
"""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from vfguide.field.navigation import navigation_field, normal_field
from vfguide.geometry.vector import dot, norm

angles = st.floats(-math.pi, math.pi)
polar = st.floats(0.0, math.pi)
distances = st.floats(1e-2, 1e3)


def at(x, r, theta):
    """eq_transform_xyz_to_xrtheta."""
    return (x, r * math.cos(theta), r * math.sin(theta))


def cylindrical(a, theta):
    """Components of `a` along e_x, e_r, e_theta: eq_basis_transform_xyz_to_xrtheta."""
    c, s = math.cos(theta), math.sin(theta)
    return (a[0], c * a[1] + s * a[2], c * a[2] - s * a[1])


def solution(start, t):
    """Where p' = F takes a start (x, r), as x + i r."""
    w = complex(*start)
    return w / (1.0 - w * t)


def integrated(start, theta, duration):
    path = solve_ivp(
        lambda _, p: navigation_field(tuple(p)),
        (0.0, duration),
        at(*start, theta),
        rtol=1e-11,
        atol=1e-12 * norm(at(*start, theta)),
    )
    assert path.success
    return path.y[:, -1]


@given(distances, polar, angles)
def test_components_in_the_papers_three_frames(rho, phi, theta):
    """eq_VF_xrtheta_compo, eq_VF_rhophitheta_compo, eq_VF_G_xrtheta_compo; F_theta = G_theta = 0.

    So F and G lie in the plane of the x axis and the point.
    """
    x, r = rho * math.cos(phi), rho * math.sin(phi)
    p = at(x, r, theta)
    f, g = cylindrical(navigation_field(p), theta), cylindrical(normal_field(p), theta)
    assert f == pytest.approx((x * x - r * r, 2.0 * x * r, 0.0), abs=1e-14 * rho**2)
    assert g == pytest.approx((2.0 * x * r * r, r * (r * r - x * x), 0.0), abs=1e-14 * rho**3)
    c, s = math.cos(phi), math.sin(phi)
    in_polar = (c * f[0] + s * f[1], c * f[1] - s * f[0])
    assert in_polar == pytest.approx((rho**2 * c, rho**2 * s), abs=1e-14 * rho**2)


@given(st.floats(-1e3, 1e3), st.floats(-1e3, 1e3), st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))
def test_every_plane_through_the_axis_holds_its_field(x, s, a, b):
    """Theorem 1 (1): a y + b z = 0 implies a F_y + b F_z = 0; with s = 0 the x axis itself."""
    p = (x, -b * s, a * s)
    F, G = navigation_field(p), normal_field(p)
    assert abs(a * F[1] + b * F[2]) <= 1e-15 * dot(p, p)
    assert abs(a * G[1] + b * G[2]) <= 1e-15 * dot(p, p) * norm(p)
    if s == 0.0:
        assert navigation_field(p) == (x * x, 0.0, 0.0)


@given(distances, st.floats(0.01, math.pi - 0.01), angles)
def test_the_diameter_of_the_circle_does_not_change_along_the_field(rho, phi, theta):
    """eq_inte_curve: C = |p|^2 / r has no derivative along F, and tau_xi = F / r."""
    x, r = rho * math.cos(phi), rho * math.sin(phi)
    p = at(x, r, theta)
    F, diameter = navigation_field(p), rho**2 / r
    C_rate = 2.0 * dot(p, F) / r - rho**2 * (p[1] * F[1] + p[2] * F[2]) / r**3
    assert abs(C_rate) <= 1e-12 * rho**2 * diameter / r
    tau = (diameter - 2.0 * r, 2.0 * x * p[1] / r, 2.0 * x * p[2] / r)
    assert tau == pytest.approx(tuple(f / r for f in F), abs=1e-12 * diameter)


@pytest.mark.parametrize("theta", [0.0, 2.0])
@pytest.mark.parametrize(
    "start", [(-3.0, 1.0), (0.0, 2.0), (4.0, 0.5), (4.0, 1e-3), (-5.0, 0.0), (0.0, -1.0)]
)
@pytest.mark.parametrize("duration", [0.1, 1.0, 30.0])
def test_paths_are_the_exact_solution(start, theta, duration):
    """Theorem 1 (2), (3): with the negative half-axis; after t the distance is about 1 / t."""
    end = solution(start, duration)
    expected = at(end.real, end.imag, theta)
    assert integrated(start, theta, duration) == pytest.approx(expected, abs=1e-6 * abs(end))


@given(distances, polar.filter(lambda phi: phi > 1e-3), angles)
def test_the_exact_solution_ends_at_the_origin_along_e_x(rho, phi, theta):
    """Theorem 1 (2): from everywhere but the positive half-axis and the origin."""
    start = (rho * math.cos(phi), rho * math.sin(phi))
    late = solution(start, 1e9 / rho)
    assert abs(late) <= 1e-8 * rho
    F = navigation_field(at(late.real, late.imag, theta))
    assert tuple(f / norm(F) for f in F) == pytest.approx((1.0, 0.0, 0.0), abs=1e-5)


@pytest.mark.parametrize("x", [0.1, 1.0, 20.0])
@pytest.mark.parametrize("part", [0.5, 0.9, 0.999])
def test_from_the_positive_half_axis_paths_escape_in_finite_time(x, part):
    """eq_sol_fet: x(t) = -1 / (t - 1 / x_0)."""
    p = integrated((x, 0.0), 0.0, part / x)
    assert p == pytest.approx((x / (1.0 - part), 0.0, 0.0), rel=1e-6)


def test_the_origin_alone_is_singular():
    """Theorem 1 (3): |F| = |p|^2, so it is zero at the origin and nowhere else."""
    assert navigation_field((0.0, 0.0, 0.0)) == (0.0, 0.0, 0.0)
    for p in np.random.default_rng(40).normal(size=(1000, 3)) * 1e-3:
        assert norm(navigation_field(tuple(p))) == pytest.approx(p @ p, rel=1e-14)
