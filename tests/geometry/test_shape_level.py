import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from shape_samples import every_shape, floats, levels_at, random_directions

from vfguide.geometry.shapes import shape
from vfguide.geometry.shapes.base import FAR, Kind, Shape, even_power
from vfguide.geometry.shapes.cone import TIP
from vfguide.geometry.shapes.shape import (
    section_at,
    shape_bound,
    shape_level,
    surface_rays,
    widest_at,
)

pytestmark = pytest.mark.slow

coordinates = st.floats(-2.0, 2.0)
points = st.tuples(coordinates, coordinates, coordinates)


def scaled(body, w):
    return floats(np.multiply(w, body.semi_axes))


def level(body, x):
    return shape_level(body, x).U


def questions(body, x):
    """Everything that is chosen by the kind of a shape."""
    angles = np.array([0.3])
    return (
        lambda: shape_level(body, x),
        lambda: shape_bound(body, x),
        lambda: section_at(body, 0.3),
        lambda: widest_at(body),
        lambda: surface_rays(body, angles, angles),
    )


@pytest.mark.parametrize("kind", Kind)
def test_every_kind_has_a_branch_in_every_choice(kind):
    body = Shape(kind.value, (3.0, 3.0, 4.0), (4.0, 4.0, 4.0))
    for question in questions(body, (5.0, 1.0, 1.0)):
        question()


def test_a_kind_without_a_branch_is_an_error_and_no_other_shape():
    body = Shape(max(Kind).value + 1, (3.0, 3.0, 4.0), (4.0, 4.0, 4.0))
    for question in questions(body, (5.0, 1.0, 1.0)):
        with pytest.raises(ValueError, match="no branch"):
            question()


def test_levels_worked_by_hand():
    at = (3.0, -4.0, 12.0)
    assert level(shape.sphere(6.5), at) == pytest.approx(4.0)
    assert level(shape.ellipsoid((3.0, 2.0, 4.0)), at) == pytest.approx(1.0 + 4.0 + 9.0)
    body = shape.superquadric((2.0, 4.0, 6.0), (1.0, 3.0, 1.5))
    assert level(body, at) == pytest.approx(2.25 + 1.0 + 8.0)
    assert level(shape.box((3.0, 8.0, 24.0)), at) == pytest.approx(256.0 + 1.0 + 1.0)
    assert level(shape.cylinder(5.0, 12.0), at) == pytest.approx(1.0 + 256.0)
    # Below the centre by the height: the base alone, at twice its distance.
    assert level(shape.cone(50.0, 12.0), (0.0, 0.0, 12.0)) == pytest.approx(256.0)


@every_shape
@given(w=points)
def test_gradient_and_hessian_are_central_differences(body, w):
    """In units of the semi-axes; steps small against the distance from the coordinate planes."""
    x, a = scaled(body, w), np.array(body.semi_axes)
    here = shape_level(body, x)
    size = 1e-3 + here.U
    for k in range(3):
        h = 1e-4 * max(abs(w[k]), 1e-2)
        step = h * np.eye(3)[k] * a
        after, before = (shape_level(body, floats(x + s * step)) for s in (1.0, -1.0))
        slope = (after.U - before.U) / (2.0 * h)
        assert abs(slope - here.gradient[k] * a[k]) <= 1e-3 * size
        bend = np.subtract(after.gradient, before.gradient) / (2.0 * h) * a
        assert np.abs(bend - np.array(here.hessian[k]) * a[k] * a).max() <= 0.1 * size


@every_shape
def test_derivatives_are_richardsons_differences_at_random_points(body):
    rng, a = np.random.default_rng(1), np.array(body.semi_axes)
    for w in random_directions(rng, 300) * rng.uniform(0.8, 1.5, (300, 1)):
        h = 2e-3 * max(np.abs(w).min(), 1e-3)
        e = a * random_directions(rng, 1)[0]

        def there(s, w=w, h=h, e=e):
            U, gradient, _ = shape_level(body, floats(a * w + s * h * e))
            return np.array([U, *(a * gradient)])

        rate = (8.0 * (there(0.5) - there(-0.5)) - (there(1.0) - there(-1.0))) / (6.0 * h)
        here = shape_level(body, floats(a * w))
        expected = np.array([here.gradient @ e, *(a * (np.array(here.hessian) @ e))])
        size = 1.0 + np.linalg.norm(a * here.gradient)
        assert np.abs(rate - expected).max() <= 1e-7 * size * max(body.exponents)


@every_shape
@given(w=points.filter(lambda w: max(map(abs, w)) > 0.2), k=st.floats(1.001, 3.0))
def test_levels_grow_along_every_ray_from_the_centre(body, w, k):
    x = scaled(body, w)
    here = shape_level(body, x)
    assert level(body, scaled(body, np.multiply(k, w))) > here.U
    assert np.dot(here.gradient, x) > 0.0


@every_shape
@given(w=points)
def test_levels_are_convex(body, w):
    hessian = np.array(shape_level(body, scaled(body, w)).hessian)
    a = np.array(body.semi_axes)
    bends = np.linalg.eigvalsh(hessian * np.outer(a, a))
    assert bends[0] >= -1e-12 * max(1.0, bends[-1])
    np.testing.assert_array_equal(hessian, hessian.T)


@every_shape
@pytest.mark.parametrize(
    "x",
    [
        (0.0, 0.0, 0.0),
        (1e-300, 0.0, 0.0),
        (7.0, 0.0, 0.0),
        (0.0, -7.0, 0.0),
        (0.0, 0.0, 7.0),
        (0.0, 0.0, -1e6),
        (1e6, 1e6, -1e6),
        (-1e9, 0.0, 1.0),
    ],
)
def test_all_is_finite_at_the_centre_on_the_axes_and_far_away(body, x):
    here = shape_level(body, x)
    assert np.isfinite([here.U, *here.gradient, *np.ravel(here.hessian)]).all()
    if max(map(abs, x)) >= 1e6:
        assert here.U > 1.0
        assert np.dot(here.gradient, x) > 0.0


def test_far_away_with_a_huge_exponent():
    body = shape.superquadric((0.5, 0.5, 0.5), (50.0, 8.0, 1.0))
    here = shape_level(body, (1e6, -1e6, 1e6))
    assert here.U > FAR
    assert np.isfinite([here.U, *here.gradient, *np.ravel(here.hessian)]).all()


@pytest.mark.parametrize("p", [1.0, 1.3, 4.0, 50.0])
def test_a_power_goes_on_smoothly_above_far(p):
    edge = FAR ** (0.5 / p)
    below, above = even_power(edge * (1.0 - 1e-12), p), even_power(edge * (1.0 + 1e-12), p)
    assert above == pytest.approx(below, rel=1e-9)
    far, value = even_power(3.0 * edge, p), even_power(-3.0 * edge, p)
    assert (value[0], -value[1], value[2]) == far
    if p == 1.0:
        assert far == pytest.approx((9.0 * edge**2, 6.0 * edge, 2.0))


@pytest.mark.parametrize("p", [1.0, 1.0 + 1e-9, 1.5, 2.0, 7.3])
def test_powers_on_the_axis(p):
    assert even_power(0.0, p) == (0.0, 0.0, 2.0 if p == 1.0 else 0.0)
    assert even_power(1.0, p) == pytest.approx((1.0, 2.0 * p, 2.0 * p * (2.0 * p - 1.0)))


def test_how_close_the_cone_is_to_a_sharp_one():
    """U^(1/8) against the sharp cone's own measure max(2 rho/R - 2 z/h, 2 z/h)."""
    angle = np.linspace(-math.pi / 2, math.pi / 2, 4001)
    w = np.stack([np.cos(angle), np.zeros_like(angle), np.sin(angle)], axis=1)
    sharp = np.maximum(2.0 * w[:, 0] - w[:, 2], w[:, 2])
    surface = w / sharp[:, None]
    ratio = levels_at(shape.cone(50.0, 80.0), surface * (50.0, 50.0, 40.0)) ** 0.125
    assert ratio.min() == pytest.approx(1.0, abs=1e-3)
    assert ratio.max() == pytest.approx(1.0 + TIP, abs=1e-3)
    cone = shape.cone(50.0, 80.0)
    assert level(cone, (50.0, 0.0, 40.0)) ** 0.125 == pytest.approx(1.091, abs=2e-3)
    assert level(cone, (25.0, 0.0, -1e-9)) ** 0.125 == pytest.approx(1.0, abs=6e-3)
    assert level(cone, (0.0, 0.0, 40.0)) == 1.0
    assert level(cone, (0.0, 0.0, -40.0 * (1.0 - TIP))) == pytest.approx(1.0)


@pytest.mark.parametrize("size", [0.0, -1.0, math.nan, math.inf])
def test_sizes_that_make_no_body_are_refused(size):
    for make in (
        lambda: shape.sphere(size),
        lambda: shape.ellipsoid((1.0, size, 1.0)),
        lambda: shape.superquadric((1.0, 1.0, size), (1.0, 1.0, 1.0)),
        lambda: shape.box((size, 1.0, 1.0)),
        lambda: shape.cylinder(1.0, size),
        lambda: shape.cone(size, 1.0),
    ):
        with pytest.raises(ValueError, match="must be positive"):
            make()


@pytest.mark.parametrize("exponent", [0.999, 0.0, -2.0, math.nan, math.inf])
def test_exponents_without_a_gradient_on_the_axes_are_refused(exponent):
    with pytest.raises(ValueError, match="at least 1"):
        shape.superquadric((1.0, 1.0, 1.0), (1.0, exponent, 1.0))
