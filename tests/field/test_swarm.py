import numpy as np
import pytest
from obstacle_samples import NOTHING, SPACING, random_goal
from shape_samples import floats, random_shape

from vfguide.field.composite import composite_field
from vfguide.field.composite_arrays import composite_fields
from vfguide.field.goal_frame import goal_frame, navigation_field_n, normal_field_n
from vfguide.field.neighbours import robots_with_priority
from vfguide.field.obstacle import Obstacle, obstacle_rows
from vfguide.field.swarm import fields_of_robots, goal_rows

COUNT = 60


@pytest.fixture(scope="module")
def swarm():
    rng = np.random.default_rng(20)
    robots = np.hstack([rng.uniform(-150.0, 150.0, (COUNT, 3)), 20.0 * rng.normal(size=(COUNT, 3))])
    goals = [random_goal(rng) for _ in range(COUNT)]
    bodies = [Obstacle(random_shape(rng), floats(rng.uniform(-150, 150, 3))) for _ in range(5)]
    return goals, robots, obstacle_rows(bodies)


def test_each_robot_has_the_field_of_one_that_gives_way_to_those_above(swarm):
    goals, robots, obstacles = swarm
    fields = fields_of_robots(goal_rows(goals), robots, 2.0, obstacles, SPACING)
    neighbours = robots_with_priority(robots[:, :3], SPACING.detection_range)
    assert len(neighbours.others) > 2 * COUNT
    for i, robot in enumerate(robots):
        above = robots[neighbours.others[neighbours.start[i] : neighbours.start[i + 1]]]
        alone = composite_field(
            goals[i], floats(robot[:3]), floats(robot[3:]), 2.0, obstacles, above, SPACING
        )
        for a, b in zip(fields, alone, strict=True):
            np.testing.assert_allclose(a[i], b, rtol=1e-9, atol=1e-12 * np.abs(b).max(initial=0.0))
        everybody_above = composite_field(
            goals[i], floats(robot[:3]), floats(robot[3:]), 2.0, obstacles, robots[:i], SPACING
        )
        np.testing.assert_allclose(everybody_above.R_na, alone.R_na, atol=1e-12)


def test_robot_1_is_not_influenced_and_nobody_by_those_below(swarm):
    goals, robots, obstacles = swarm
    whole = fields_of_robots(goal_rows(goals), robots, 0.0, obstacles, SPACING)
    for count in (1, 7, 30):
        part = fields_of_robots(goal_rows(goals[:count]), robots[:count], 0.0, obstacles, SPACING)
        for a, b in zip(whole, part, strict=True):
            np.testing.assert_array_equal(a[:count], b)
    p, v = robots[0, :3], robots[0, 3:]
    alone = composite_fields(goals[0], p, v, 0.0, obstacles, np.zeros((0, 6)), SPACING)
    for a, b in zip(whole, alone, strict=True):
        np.testing.assert_array_equal(a[0], b)


def test_the_field_keeps_centres_two_safety_radii_apart():
    """At Psi_j = 2 r_c the lower robot's field does not point inwards; the upper one's may."""
    rng = np.random.default_rng(21)
    for direction in rng.normal(size=(200, 3)):
        n = direction / np.linalg.norm(direction)
        pair = np.array([[*(-10.0 * n), 0.0, 0.0, 0.0], [*(10.0 * n), 0.0, 0.0, 0.0]])
        goals = [random_goal(rng), random_goal(rng)]
        fields = fields_of_robots(goal_rows(goals), pair, 0.0, NOTHING, SPACING)
        F = fields.F[1]
        assert abs(F @ n) <= 1e-12 * np.linalg.norm(F)


def test_nobody():
    empty = fields_of_robots(goal_rows([]), np.zeros((0, 6)), 0.0, NOTHING, SPACING)
    assert empty.F.shape == (0, 3)


def test_head_on_off_the_axis_a_robot_turns_along_its_own_g():
    """eq_tau_psi_b has G_i, Algorithm 1 prints G_j: robot 1, straight ahead, has another goal."""
    goals = [goal_frame((500.0, 300.0, 0.0), 1.0, 0.2), goal_frame((0.0, 0.0, 0.0), 0.0, 0.0)]
    p = np.array((-60.0, 80.0, 0.0))
    F, G = navigation_field_n(goals[1], floats(p)), normal_field_n(goals[1], floats(p))
    ahead = p + 20.0 * np.array(F) / np.linalg.norm(F)
    robots = np.array([[*ahead, 0.0, 0.0, 0.0], [*p, 0.0, 0.0, 0.0]])
    fields = fields_of_robots(goal_rows(goals), robots, 0.0, NOTHING, SPACING)
    np.testing.assert_allclose(fields.F[1], G, rtol=1e-9)


def test_two_robots_head_on():
    """The first goes straight on, the second round it to its goal's right, which is west."""
    goals = [goal_frame((500.0, 0.0, 0.0), 0.0, 0.0), goal_frame((-500.0, 0.0, 0.0), np.pi, 0.0)]
    robots = np.array([[-30.0, 0.0, 0.0, 25.0, 0.0, 0.0], [30.0, 0.0, 0.0, -25.0, 0.0, 0.0]])
    first, second = fields_of_robots(goal_rows(goals), robots, 0.0, NOTHING, SPACING).F
    np.testing.assert_allclose(first / np.linalg.norm(first), (1.0, 0.0, 0.0), atol=1e-12)
    assert second[1] < 0.0
