import numpy as np
import pytest
from shape_samples import floats

from vfguide.field import arrays, navigation
from vfguide.field.attitude import goal_attitude

AT_REST = (0.0, 0.0, 0.0)
POINTS = np.random.default_rng(5).normal(size=(2, 6, 3)) * 100.0
VELOCITIES = np.random.default_rng(6).normal(size=(2, 6, 3)) * 20.0

PAIRS = [
    (arrays.navigation_fields, navigation.navigation_field),
    (arrays.normal_fields, navigation.normal_field),
    (arrays.binormal_fields, navigation.binormal_field),
    (arrays.attitudes, lambda p: goal_attitude(p, AT_REST)[0]),
]


@pytest.mark.parametrize(("over_array", "scalar"), PAIRS)
def test_arrays_equal_the_scalar_functions(over_array, scalar):
    result = over_array(POINTS)
    assert result.shape[:2] == (2, 6)
    for index in np.ndindex(2, 6):
        np.testing.assert_allclose(result[index], scalar(floats(POINTS[index])), rtol=1e-15)


@pytest.mark.parametrize(("over_array", "scalar"), PAIRS)
def test_one_point_is_an_array_of_three(over_array, scalar):
    np.testing.assert_allclose(over_array((1.0, 2.0, 3.0)), scalar((1.0, 2.0, 3.0)), rtol=1e-15)


def test_attitude_rates_equal_the_scalar_function():
    result = arrays.attitude_rates(POINTS, VELOCITIES)
    for index in np.ndindex(2, 6):
        _, expected = goal_attitude(floats(POINTS[index]), floats(VELOCITIES[index]))
        np.testing.assert_allclose(result[index], expected, rtol=1e-13)


def test_one_velocity_serves_many_points():
    v = VELOCITIES[0, 0]
    everywhere = np.broadcast_to(v, POINTS.shape)
    np.testing.assert_array_equal(
        arrays.attitude_rates(POINTS, v), arrays.attitude_rates(POINTS, everywhere)
    )


def test_shapes():
    assert arrays.attitudes(POINTS).shape == (2, 6, 3, 3)
    assert arrays.attitudes(POINTS[0, 0]).shape == (3, 3)
    assert arrays.attitude_rates(POINTS[0, 0], VELOCITIES).shape == (2, 6, 3)
    assert arrays.navigation_fields(np.empty((0, 3))).shape == (0, 3)


@pytest.mark.parametrize(("over_array", "_"), PAIRS)
@pytest.mark.parametrize("components", [1, 2, 4])
def test_points_of_other_than_three_components_are_refused(over_array, _, components):
    with pytest.raises(ValueError, match="three components"):
        over_array(np.ones((5, components)))


def test_velocities_of_other_than_three_components_are_refused():
    with pytest.raises(ValueError, match="dimension"):
        arrays.attitude_rates(POINTS, VELOCITIES[..., :2])
