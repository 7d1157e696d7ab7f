"""Points of polylines, and where they come nearest to the origin."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from vfguide.geometry.polyline import nearest_to_origin, points_at

COORDINATES = st.floats(-100.0, 100.0)


@pytest.mark.parametrize(
    ("path", "distance", "along"),
    [
        ([(3.0, 4.0, 0.0)], 5.0, 0.0),
        ([(-1.0, 2.0, 0.0), (3.0, 2.0, 0.0)], 2.0, 0.25),
        ([(5.0, 0.0, 0.0), (9.0, 0.0, 0.0)], 5.0, 0.0),
        ([(9.0, 0.0, 0.0), (7.0, 0.0, 0.0), (5.0, 0.0, 0.0)], 5.0, 2.0),
        ([(6.0, 0.0, 0.0), (6.0, 0.0, 0.0), (0.0, 0.0, 6.0)], 6.0 / 2.0**0.5, 1.5),
    ],
)
def test_worked_by_hand(path, distance, along):
    assert nearest_to_origin(np.array(path)) == pytest.approx((distance, along))


@given(st.integers(1, 6).flatmap(lambda n: arrays(float, (n, 3), elements=COORDINATES)))
def test_no_point_of_the_polyline_is_nearer_and_the_nearest_is_on_it(path):
    nearest = nearest_to_origin(path)
    whole = np.arange(len(path))
    finely = np.linspace(0.0, len(path) - 1.0, 50 * len(path))
    points = np.column_stack([np.interp(finely, whole, axis) for axis in path.T])
    assert (np.linalg.norm(points, axis=1) >= nearest.distance - 1e-9).all()
    there = [np.interp(nearest.along, whole, axis) for axis in path.T]
    assert np.linalg.norm(there) == pytest.approx(nearest.distance, abs=1e-9)


def test_points_of_a_path_at_times():
    points = np.array([[0.0, 0.0, 0.0], [10.0, 20.0, -5.0], [10.0, 0.0, 5.0]])
    found = points_at(np.array([-1.0, 1.0, 2.0, 3.0, 9.0]), np.array([0.0, 2.0, 4.0]), points)
    expected = [points[0], [5.0, 10.0, -2.5], points[1], [10.0, 10.0, 0.0], points[2]]
    np.testing.assert_allclose(found, expected)
