import numpy as np
import pytest
from shape_samples import (
    every_odd_shape,
    floats,
    points_around,
    random_directions,
    random_shape,
    surface_points,
)

from vfguide.airspace.distance_bound import distance_bound
from vfguide.field.obstacle import Obstacle, obstacle_distance, obstacle_rows
from vfguide.geometry.shapes import shape
from vfguide.geometry.shapes.cone import TIP
from vfguide.geometry.shapes.shape import shape_level
from vfguide.kernels.compiled import compiled

PLACE, MOVING, TIME = (40.0, -70.0, -90.0), (3.0, -5.0, 1.0), 7.0


def placed(body, heading=0.7):
    return obstacle_rows([Obstacle(body, PLACE, heading, MOVING)])


def in_world(x, heading=0.7):
    c, s = np.cos(heading), np.sin(heading)
    turned = np.column_stack([c * x[:, 0] - s * x[:, 1], s * x[:, 0] + c * x[:, 1], x[:, 2]])
    return turned + np.array(PLACE) + TIME * np.array(MOVING)


def both(body, x):
    """The bound and the distance at points `x` in the body's axes [m]."""
    rows, points = placed(body), [floats(p) for p in in_world(x)]
    bound = np.array([distance_bound(rows, 0, p, TIME) for p in points])
    return bound, np.array([obstacle_distance(rows, 0, p, TIME) for p in points])


def assert_below(bound, distance, size):
    slack = np.where(distance > 0.0, 1e-9 * (size + distance), 1e-3 * (size - distance))
    assert np.all(bound <= distance + slack)


@every_odd_shape
def test_never_above_the_distance(body):
    bound, distance = both(body, points_around(body))
    assert_below(bound, distance, max(body.semi_axes))
    assert np.all(bound[distance < 0.0] <= 0.0)


def test_never_above_the_distance_from_random_shapes():
    rng = np.random.default_rng(11)
    for _ in range(150):
        body = random_shape(rng)
        x = rng.normal(size=(40, 3)) * body.semi_axes * 10.0 ** rng.uniform(-1.0, 1.5, (40, 1))
        bound, distance = both(body, x)
        assert_below(bound, distance, max(body.semi_axes))


@every_odd_shape
def test_far_away_at_most_the_size_too_low(body):
    rng = np.random.default_rng(12)
    bound, distance = both(body, 1e4 * random_directions(rng, 50))
    assert np.all(distance - bound <= 1.1 * max(body.semi_axes))


@every_odd_shape
def test_finite_at_any_distance(body):
    rng = np.random.default_rng(13)
    far = random_directions(rng, 60) * 10.0 ** rng.uniform(0.0, 7.0, (60, 1))
    assert np.all(np.isfinite(both(body, far)[0]))


@every_odd_shape
def test_tight_at_the_surface(body):
    """A step outwards of a hundredth of the least size costs less than a quarter of itself."""
    foot, step = surface_points(body, 200), 1e-2 * min(body.semi_axes)
    rows = obstacle_rows([Obstacle(body, (0.0, 0.0, 0.0))])
    outside = foot * (1.0 + step / np.linalg.norm(foot, axis=1, keepdims=True))
    bound = np.array([distance_bound(rows, 0, floats(p), 0.0) for p in outside])
    distance = np.array([obstacle_distance(rows, 0, floats(p), 0.0) for p in outside])
    assert np.all(bound >= 0.75 * distance - 1e-9)


def random_cones(count):
    """From needles to discs, and points around each from deep inside to ten sizes away."""
    rng = np.random.default_rng(14)
    for radius, height in 10.0 ** rng.uniform(0.3, 2.0, (count, 2)):
        body = shape.cone(float(radius), float(height))
        near = surface_points(body, 100) * 10.0 ** rng.uniform(-0.1, 0.3, (100, 1)) ** 3
        far = rng.normal(size=(100, 3)) * body.semi_axes * 10.0 ** rng.uniform(-1.0, 1.0, (100, 1))
        far[::3, :2] = near[::5, :2] = 0.0  # on the axis
        yield body, np.vstack((near, far))


def test_a_cone_is_at_most_the_rounding_of_its_edge_too_near():
    """f = U^(1/8) is TIP at the centre and convex: this far from the edge inwards it is below 1."""
    for body, x in random_cones(60):
        bound, distance = both(body, x)
        radius, _, half_height = body.semi_axes
        assert_below(bound, distance, max(radius, half_height))
        outside = distance > 0.0
        edge = shape_level(body, (radius, 0.0, half_height)).U ** 0.125
        rounding = (edge - 1.0) / (edge - TIP) * np.hypot(radius, half_height)
        assert np.all((distance - bound)[outside] <= rounding + 1e-4 * distance[outside])


@pytest.mark.parametrize(("off", "lost"), [(0.1, 0.002), (1.0, 0.1), (5.0, 1.3), (200.0, 5.0)])
def test_near_a_cone_little_is_lost_beside_its_edge_and_next_to_nothing_elsewhere(off, lost):
    body = shape.cone(50.0, 80.0)
    foot = surface_points(body, 500)
    normal = np.array([shape_level(body, floats(y)).gradient for y in foot])
    x = foot + off * normal / np.linalg.norm(normal, axis=1, keepdims=True)
    bound, _ = both(body, x)
    assert off - bound.min() <= lost
    assert off - np.quantile(bound, 0.2) <= 0.05 * lost


@pytest.mark.parametrize("d", [1e-6, 1.0, 100.0, 1e5])
def test_exact_from_a_sphere(d):
    x = (40.0 + d) * random_directions(np.random.default_rng(4), 20)
    bound, _ = both(shape.sphere(40.0), x)
    np.testing.assert_allclose(bound, d, rtol=1e-9, atol=1e-8)


def test_compiled_code_gets_the_same_numbers():
    @compiled
    def called(rows, p):
        return distance_bound(rows, 0, p, TIME)

    rows = placed(shape.box((20.0, 60.0, 100.0)))
    assert called(rows, (1.0, 2.0, 3.0)) == distance_bound(rows, 0, (1.0, 2.0, 3.0), TIME)
