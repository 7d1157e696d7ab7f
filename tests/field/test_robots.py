import pytest
from obstacle_samples import SPACING, STILL

from vfguide.field.robots import robot_barrier
from vfguide.geometry.dual import Dual3


@pytest.mark.parametrize(
    ("distance", "chi"), [(1e-3, 0.0), (10.0, 0.0), (20.0, 0.0), (60.0, 0.5), (100.0, 1.0)]
)
def test_chi_is_zero_up_to_two_safety_radii_and_one_from_the_range_on(distance, chi):
    barrier = robot_barrier(Dual3((0.0, distance, 0.0), (3.0, 4.0, 5.0)), SPACING)
    assert barrier.chi.value == chi
    assert barrier.n.value == (0.0, 1.0, 0.0)
    assert barrier.n.rate == pytest.approx((3.0 / distance, 0.0, 5.0 / distance))
    if distance == 60.0:
        assert barrier.chi.rate == pytest.approx(2.0 / 80.0 * 4.0)


@pytest.mark.parametrize("x", [0.0, 1e-200])
def test_a_robot_in_the_same_place_has_no_normal(x):
    barrier = robot_barrier(Dual3((x, 0.0, 0.0), (3.0, 4.0, 5.0)), SPACING)
    assert barrier == ((0.0, 0.0), (STILL, STILL))
