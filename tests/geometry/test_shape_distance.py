import numpy as np
import pytest
from scipy.spatial import KDTree
from shape_samples import (
    distances_at,
    every_odd_shape,
    floats,
    levels_at,
    points_around,
    random_directions,
    surface_points,
)

from vfguide.geometry.shapes import shape
from vfguide.geometry.shapes.cone import TIP
from vfguide.geometry.shapes.distance import onto_surface, signed_distance
from vfguide.geometry.shapes.shape import shape_level
from vfguide.geometry.vector import norm


@every_odd_shape
def test_the_sign_is_that_of_the_level(body):
    x = points_around(body)
    inside = levels_at(body, x) < 1.0
    np.testing.assert_array_equal(distances_at(body, x) < 0.0, inside)
    assert 50 < np.count_nonzero(inside) < 550


@every_odd_shape
def test_no_point_of_the_surface_is_nearer(body):
    x = points_around(body)
    distance = np.abs(distances_at(body, x))
    found, _ = KDTree(surface_points(body)).query(x)
    assert np.all(distance <= found * (1.0 + 5e-4) + 1e-6 * max(body.semi_axes))


@every_odd_shape
def test_along_a_normal_from_the_surface_the_distance_is_the_length(body):
    """Exact outside, because the body is convex; inside it is an upper bound."""
    rng = np.random.default_rng(5)
    foot = surface_points(body, 500)
    normal = np.array([shape_level(body, floats(y)).gradient for y in foot])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    d = 10.0 ** rng.uniform(-3.0, 4.0, 500)
    outside = distances_at(body, foot + d[:, None] * normal)
    np.testing.assert_allclose(outside, d, rtol=2e-4)
    d = min(body.semi_axes) * rng.uniform(0.0, 0.3, 500)
    inside = -distances_at(body, foot - d[:, None] * normal)
    assert np.all(inside <= d * (1.0 + 1e-3) + 1e-9)


@every_odd_shape
def test_the_ball_of_that_radius_around_a_point_inside_is_inside(body):
    x = points_around(body)
    distance = distances_at(body, x)
    x, radius = x[distance < 0.0][:100], -distance[distance < 0.0][:100]
    directions = random_directions(np.random.default_rng(6), 2000)
    ball = x[:, None] + 0.995 * radius[:, None, None] * directions
    assert levels_at(body, ball.reshape(-1, 3)).max() <= 1.0


@pytest.mark.parametrize("d", [-40.0, -39.9, -20.0, -1e-6, 0.0, 1e-9, 0.1, 1e3, 1e6])
def test_sphere(d):
    for direction in random_directions(np.random.default_rng(4), 20):
        x = floats((40.0 + d) * direction)
        assert signed_distance(shape.sphere(40.0), x) == pytest.approx(d, rel=1e-9, abs=1e-9)


def test_faces_edges_and_apex():
    box = shape.box((20.0, 60.0, 100.0))
    assert signed_distance(box, (25.0, 0.0, 0.0)) == pytest.approx(15.0, rel=1e-4)
    assert signed_distance(box, (6.0, 0.0, 0.0)) == pytest.approx(-4.0, rel=1e-3)
    assert signed_distance(box, (0.0, 0.0, 0.0)) == pytest.approx(-10.0, rel=1e-3)
    cylinder = shape.cylinder(15.0, 120.0)
    assert signed_distance(cylinder, (0.0, 0.0, -90.0)) == pytest.approx(30.0, rel=1e-4)
    assert signed_distance(cylinder, (12.0, 16.0, 0.0)) == pytest.approx(5.0, rel=1e-4)
    cone = shape.cone(50.0, 80.0)
    assert signed_distance(cone, (0.0, 0.0, -100.0)) == pytest.approx(60.0 + 40.0 * TIP, rel=1e-4)
    assert signed_distance(cone, (0.0, 0.0, 50.0)) == pytest.approx(10.0, rel=1e-4)


@every_odd_shape
def test_points_onto_the_surface(body):
    for x in points_around(body)[1:100]:
        y = onto_surface(body, floats(x))
        assert abs(shape_level(body, y).U - 1.0) <= 1e-9
        assert norm(y) * norm(floats(x)) == pytest.approx(np.dot(x, y), rel=1e-12)


@every_odd_shape
def test_far_away_the_distance_is_that_of_the_centre(body):
    for direction in random_directions(np.random.default_rng(6), 20):
        distance = signed_distance(body, floats(1e6 * direction))
        assert 1e6 - 1.8 * max(body.semi_axes) <= distance <= 1e6 + 1.0
