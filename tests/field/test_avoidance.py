"""The paper's statements about F_OA, G_OA and H_OA, with its errors corrected."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from obstacle_samples import NOBODY, SPACING, STILL, at_level, one_obstacle, random_goal
from shape_samples import SHAPES, every_shape, floats, random_directions

from vfguide.field.avoidance import (
    COLLINEAR,
    Barrier,
    avoidance_field,
    avoidance_normal,
    collinear,
    deflect,
    no_deflection,
    tangent,
)
from vfguide.field.composite import composite_field, free_field
from vfguide.field.composite_arrays import composite_fields
from vfguide.field.goal_frame import goal_frame
from vfguide.field.obstacle import obstacle_surface
from vfguide.geometry import dual
from vfguide.geometry.dual import Dual, Dual3
from vfguide.geometry.vector import cross, dot, norm, scale, sub

pytestmark = pytest.mark.slow

AT_ORIGIN = goal_frame(STILL, 0.0, 0.0)
coordinates = st.floats(-3.0, 3.0).filter(lambda x: x == 0.0 or abs(x) > 1e-3)
vectors = st.tuples(coordinates, coordinates, coordinates)
off_axis = vectors.filter(lambda p: math.hypot(p[1], p[2]) > 0.1)
normals = vectors.filter(lambda n: norm(n) > 0.1)
transitions = st.floats(0.0, 1.0)


def constant(a):
    return Dual3(a, STILL)


def fields(p, *barriers):
    """F, G of free space and F_OA, G' behind barriers of (chi, n), all in the goal frame."""
    free = free_field(AT_ORIGIN, constant(p))
    by = no_deflection()
    for chi, n in barriers:
        by = deflect(by, free, Barrier(dual.rest(chi), constant(n)))
    return (
        free.F.value,
        free.G.value,
        avoidance_field(free, by).value,
        avoidance_normal(free, by).value,
    )


def hat(a):
    return np.array([[0.0, -a[2], a[1]], [a[2], 0.0, -a[0]], [-a[1], a[0], 0.0]])


def xi(chi, n):
    """Xi_OA of eq_Xi_OA."""
    return chi * np.eye(3) + (chi - 1.0) * hat(n) @ hat(n)


@every_shape
def test_the_field_never_penetrates_a_surface(body):
    """Theorem 3 (1): F_OA . n = 0 on U = 1; with the obstacle turned and shapes of every kind."""
    rng = np.random.default_rng(8)
    obstacles = one_obstacle(body, heading=0.6)
    p = at_level(obstacles, random_directions(rng, 500), 1.0)
    for _ in range(4):
        here = composite_fields(random_goal(rng, 1e3), p, STILL, 0.0, obstacles, NOBODY, SPACING)
        n = surface_normals(obstacles, p)
        inward = np.abs(np.sum(here.F * n, axis=1))
        assert np.all(inward <= 1e-12 * np.linalg.norm(here.F, axis=1))
        assert np.all(here.chi == 0.0)


def surface_normals(obstacles, p):
    n = np.array([obstacle_surface(obstacles, 0, constant(floats(q)), 0.0).n.value for q in p])
    return n / np.linalg.norm(n, axis=1, keepdims=True)


@every_shape
def test_the_field_vanishes_nowhere_in_the_reactive_area(body):
    """Theorem 3 (2), also on the surface."""
    rng = np.random.default_rng(9)
    obstacles = one_obstacle(body)
    goal = random_goal(rng, 1e3)
    for level in (1.0, 1.001, 1.5, 3.9):
        p = at_level(obstacles, random_directions(rng, 500), level)
        here = composite_fields(goal, p, STILL, 0.0, obstacles, NOBODY, SPACING)
        assert np.linalg.norm(here.F, axis=1).min() > 0.0
        assert np.isfinite(here.R_na).all()


@given(off_axis, normals, transitions)
def test_field_and_determinant_of_xi(p, n, chi):
    """eq_F_OA_with_hat, and the determinant whose first term is printed as chi, not chi^3."""
    F, _, F_OA, _ = fields(p, (chi, n))
    if not collinear(n, F):
        expected = floats(xi(chi, n) @ F)
        assert norm(sub(F_OA, expected)) <= 1e-13 * (1.0 + dot(n, n)) * norm(F)
    n2 = dot(n, n)
    determinant = chi * (chi + (1.0 - chi) * n2) ** 2
    assert np.linalg.det(xi(chi, n)) == pytest.approx(determinant, abs=1e-12 * (1.0 + n2**2))
    as_sum = chi**3 + 2.0 * chi**2 * (1.0 - chi) * n2 + chi * (1.0 - chi) ** 2 * n2**2
    assert determinant == pytest.approx(as_sum, rel=1e-12)


@given(off_axis, normals)
def test_tangent_lies_in_the_plane_of_f_and_n_and_within_90_degrees_of_f(p, n):
    """The remark after Theorem 3."""
    F, _, _, _ = fields(p)
    tau_a, tau_b = cross(n, F), tangent(constant(n), constant(F)).value
    size = norm(n) ** 2 * norm(F)
    assert abs(dot(tau_b, tau_a)) <= 1e-14 * size * norm(tau_a)
    assert abs(dot(tau_b, n)) <= 1e-14 * size * norm(n)
    assert dot(F, tau_b) >= 0.0
    assert dot(F, tau_b) == pytest.approx(dot(tau_a, tau_a), abs=1e-13 * size * norm(F))


def test_components_of_tau_a_worked_by_hand():
    """T^a_z is dU/dx F_y - dU/dy F_x; the print has F_z in its last term."""
    n, F = (1.0, 2.0, 3.0), (5.0, -7.0, 11.0)
    assert cross(n, F) == (2.0 * 11.0 + 3.0 * 7.0, 3.0 * 5.0 - 11.0, -7.0 - 2.0 * 5.0)


@given(off_axis, normals, transitions)
def test_lemma_5(p, n, chi):
    """G' is orthogonal to F_OA, and G' x F_OA is H_OA times the denominator of mu.

    eq_H_OA has tau_a for n x tau_b, which is |n|^2 tau_a.
    """
    F, G, F_OA, G_OA = fields(p, (chi, n))
    if collinear(n, F):
        return
    n2 = dot(n, n)
    size = (1.0 + n2) ** 2 * norm(F) * norm(G)
    assert abs(dot(F_OA, G_OA)) <= 1e-14 * size
    H, tau_a = np.cross(G, F), np.cross(n, F)
    tau_b = np.cross(tau_a, n)
    # mu and 1 - mu times the denominator chi + (1 - chi) n.G
    mu, rest = chi, (1.0 - chi) * dot(n, G)
    H_OA = chi * mu * H + (1.0 - chi) * rest * n2 * tau_a
    H_OA += mu * (1.0 - chi) * np.cross(G, tau_b) + chi * rest * np.cross(n, F)
    assert np.abs(np.cross(G_OA, F_OA) - H_OA).max() <= 1e-13 * size


@given(off_axis, normals, st.floats(0.01, 0.99))
def test_the_printed_mu_and_where_its_g_is_parallel_to_ours(p, n, chi):
    """eq_mu is chi / (chi + (1 - chi) n.G); where that changes sign, the printed G_OA flips."""
    F, G, F_OA, ours = fields(p, (chi, n))
    tau_b = tangent(constant(n), constant(F)).value
    denominator = chi + (1.0 - chi) * dot(n, G)
    along = dot(F, n)
    if abs(along) < 1e-3 * norm(F) * norm(n) or abs(denominator) < 1e-3 or collinear(n, F):
        return
    mu = chi * along / (chi * along + (chi - 1.0) * dot(tau_b, G))
    assert mu == pytest.approx(chi / denominator, rel=1e-6)
    printed = mu * np.array(G) + (1.0 - mu) * np.array(n)
    side = math.copysign(1.0, denominator)
    assert np.abs(ours - denominator * printed).max() <= 1e-6 * norm(ours) + 1e-9
    assert np.dot(printed, ours) * side > 0.0
    assert abs(np.dot(printed, F_OA)) <= 1e-6 * np.linalg.norm(printed) * norm(F_OA) * (
        1.0 + abs(mu)
    )


@given(off_axis, st.floats(0.1, 3.0), st.floats(0.0, 0.99), st.sampled_from([-1.0, 1.0]))
def test_collinear_with_the_normal(p, k, chi, side):
    """F_OA = chi F + (1 - chi) G, and G' = chi |F|^2 G - (1 - chi) |G|^2 F is orthogonal to it."""
    F, G, _, _ = fields(p)
    n = scale(side * k / norm(F), F)
    assert collinear(n, F)
    _, _, F_OA, G_OA = fields(p, (chi, n))
    expected = chi * np.array(F) + (1.0 - chi) * np.array(G)
    assert np.abs(F_OA - expected).max() <= 1e-14 * (norm(F) + norm(G))
    expected = chi * dot(F, F) * np.array(G) - (1.0 - chi) * dot(G, G) * np.array(F)
    assert np.abs(G_OA - expected).max() <= 1e-13 * (norm(F) ** 2 * norm(G) + dot(G, G) * norm(F))
    assert abs(dot(F_OA, G_OA)) <= 1e-13 * norm(F_OA) * norm(G_OA)
    assert norm(F_OA) > 0.0


def test_the_bound_of_collinearity():
    F, n = (1.0, 0.0, 0.0), (2.0, 0.0, 0.0)
    assert collinear((2.0, 1.9 * COLLINEAR, 0.0), F)
    assert not collinear((2.0, 2.1 * COLLINEAR, 0.0), F)
    assert collinear(scale(-1.0, n), F)
    assert collinear(STILL, F)


@pytest.mark.parametrize("distance", [30.0, 30.001, 35.0, 45.0, 59.0])
def test_an_obstacle_straight_ahead_on_the_goals_axis(distance):
    """The print has F_OA = 0 on the surface; here the robot goes round to the goal's right."""
    goal = goal_frame((200.0, 0.0, 0.0), 0.0, 0.0)
    obstacles = one_obstacle(SHAPES["sphere"]._replace(semi_axes=(30.0, 30.0, 30.0)))
    here = composite_field(goal, (-distance, 0.0, 0.0), STILL, 0.0, obstacles, NOBODY, SPACING)
    chi, size = here.chi[0], (200.0 + distance) ** 2
    np.testing.assert_allclose(here.F, (chi * size, (1.0 - chi) * size, 0.0), rtol=1e-12)
    np.testing.assert_allclose(here.G, (0.0, 0.0, 1.0), atol=1e-15)
    assert chi < 1.0


@given(off_axis, st.lists(st.tuples(transitions, normals), min_size=1, max_size=4))
def test_several_obstacles_together_do_not_stop_the_field_either(p, barriers):
    """F . F_OA = (prod chi_i) |F|^2 + sum (1 - chi_i) |n_i x F|^2, which is above zero."""
    F, _, F_OA, _ = fields(p, *barriers)
    if any(collinear(n, F) for _, n in barriers):
        return
    expected = math.prod(chi for chi, _ in barriers) * dot(F, F)
    expected += sum((1.0 - chi) * dot(cross(n, F), cross(n, F)) for chi, n in barriers)
    size = (1.0 + sum(dot(n, n) for _, n in barriers)) * dot(F, F)
    assert dot(F, F_OA) == pytest.approx(expected, abs=1e-13 * size)
    assert expected > 0.0


def test_two_obstacles_at_once_can_lead_into_one():
    """Theorem 3 (1) is for one: on the surface of the first, the second's tau_b has a part inwards.

    F = (1, 0, 0); tau_b is (1, -1, 0) / 2 for n = (-1, -1, 0) / sqrt 2 and F for n = (0, -1, 0).
    """
    n = (-math.sqrt(0.5), -math.sqrt(0.5), 0.0)
    _, _, alone, _ = fields((1.0, 0.0, 0.0), (0.0, n))
    assert alone == pytest.approx((0.5, -0.5, 0.0))
    _, _, both, _ = fields((1.0, 0.0, 0.0), (0.0, n), (0.0, (0.0, -1.0, 0.0)))
    assert both == pytest.approx((1.5, -0.5, 0.0))
    assert dot(both, n) / norm(both) == pytest.approx(-1.0 / math.sqrt(5.0))


def inward_deg(unit):
    """How steeply the field runs into a sphere of 40 m where U = 2, lengths in another unit."""
    p, goal = scale(unit, (-40.0, 40.0, 0.0)), goal_frame((500.0 * unit, 0.0, 0.0), 0.0, 0.0)
    sphere = SHAPES["sphere"]._replace(semi_axes=(40.0 * unit, 40.0 * unit, 40.0 * unit))
    here = composite_field(goal, p, STILL, 0.0, one_obstacle(sphere), NOBODY, SPACING)
    return -math.degrees(math.asin(dot(here.F, p) / norm(here.F) / norm(p)))


def test_the_law_depends_on_the_unit_of_length():
    """tau_b grows with |n|^2 [1/m^2] and F does not: the same scene in metres and kilometres."""
    assert inward_deg(1.0) == pytest.approx(52.9, abs=0.1)
    assert inward_deg(1e-3) == pytest.approx(0.0, abs=0.01)


@pytest.mark.parametrize("bearing", [0.0, 1.0, 2.0, 4.0])
def test_around_the_point_straight_ahead_the_field_turns_all_the_way_round(bearing):
    """No field tangential to a ball is continuous and without a zero: it jumps at this point."""
    goal = goal_frame((500.0, 0.0, 0.0), 0.0, 0.0)
    off = (0.0, 1e-4 * math.cos(bearing), 1e-4 * math.sin(bearing))
    p = scale(40.0 / math.hypot(1.0, 1e-4), (-1.0, off[1], off[2]))
    here = composite_field(goal, p, STILL, 0.0, one_obstacle(SHAPES["sphere"]), NOBODY, SPACING)
    found = scale(1.0 / norm(here.F), here.F)
    assert found == pytest.approx((1e-4, math.cos(bearing), math.sin(bearing)), abs=1e-3)


@given(off_axis, normals, normals, transitions, transitions)
def test_several_obstacles(p, n1, n2, chi1, chi2):
    """eq_F_OA_multi_obs, whatever the order; G' is the weighted sum."""
    F, G, F_OA, G_OA = fields(p, (chi1, n1), (chi2, n2))
    if collinear(n1, F) or collinear(n2, F):
        return
    expected, normal = chi1 * chi2 * np.array(F), chi1 * chi2 * np.array(G)
    for chi, n in ((chi1, n1), (chi2, n2)):
        expected += (1.0 - chi) * np.cross(np.cross(n, F), n)
        normal += (1.0 - chi) * np.dot(n, G) * np.array(n)
    size = (1.0 + dot(n1, n1) + dot(n2, n2)) * norm(F)
    assert np.abs(F_OA - expected).max() <= 1e-14 * size
    assert np.abs(G_OA - normal).max() <= 1e-14 * size * norm(G) / norm(F)
    _, _, swapped, _ = fields(p, (chi2, n2), (chi1, n1))
    assert swapped == pytest.approx(F_OA, abs=1e-14 * size)


@given(off_axis, normals, normals, transitions)
def test_an_obstacle_out_of_range_changes_nothing(p, n, other, chi):
    assert fields(p, (chi, n), (1.0, other)) == fields(p, (chi, n))
    assert fields(p, (1.0, other)) == fields(p)


@given(off_axis, vectors, normals, vectors, transitions, st.floats(-1.0, 1.0))
def test_rates_are_central_differences(p, v, n, n_rate, chi, chi_rate):
    """Of F_OA and G' when position, normal and transition move."""
    chi = 0.1 + 0.8 * chi

    def there(h):
        moved = Dual3(floats(np.add(p, h * np.array(v))), v)
        free = free_field(AT_ORIGIN, moved)
        normal = Dual3(floats(np.add(n, h * np.array(n_rate))), n_rate)
        barrier = Barrier(Dual(chi + h * chi_rate, chi_rate), normal)
        by = deflect(no_deflection(), free, barrier)
        return avoidance_field(free, by), avoidance_normal(free, by)

    if norm(cross(n, fields(p)[0])) < 1e-2:
        return
    h = 1e-5
    for here, after, before in zip(there(0.0), there(h), there(-h), strict=True):
        rate = np.subtract(after.value, before.value) / (2.0 * h)
        size = 1.0 + np.abs(rate).max() + norm(here.value)
        assert np.abs(here.rate - rate).max() <= 1e-6 * size
