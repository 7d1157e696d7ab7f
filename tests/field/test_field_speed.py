"""How long the fields take: the least of many repeats, printed with `pytest -s`.

The bounds are several times what an idle machine needs.
"""

import math
import time

import numpy as np
from obstacle_samples import NOBODY, NOTHING, SPACING, floats, random_goal

from vfguide.field import shape
from vfguide.field.composite import composite_field
from vfguide.field.composite_arrays import composite_fields
from vfguide.field.goal_frame import goal_frame
from vfguide.field.obstacle import Obstacle, obstacle_rows
from vfguide.field.swarm import fields_of_robots, goal_rows

NEIGHBOURS = 6.0
"""Robots within range of each on average, whatever their number."""


def least_time(call, repeats):
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return min(times)


def ten_obstacles():
    """Ten bodies of all kinds, the origin within the reactive area of each."""
    rng = np.random.default_rng(30)
    bodies = [
        shape.sphere(30.0),
        shape.box((40.0, 30.0, 50.0)),
        shape.cylinder(20.0, 60.0),
        shape.cone(30.0, 60.0),
        shape.superquadric((20.0, 30.0, 25.0), (1.5, 2.5, 3.5)),
    ]
    return obstacle_rows(
        [
            Obstacle(body, floats(rng.uniform(-25.0, 25.0, 3)), 0.3, (1.0, 2.0, 3.0), 1e5)
            for body in 2 * bodies
        ]
    )


def test_time_of_field_frame_and_angular_velocity_among_ten_obstacles():
    goal, obstacles = goal_frame((300.0, 40.0, 0.0), 0.3, 0.1), ten_obstacles()
    p = np.random.default_rng(31).uniform(-5.0, 5.0, (2000, 3))
    v = np.array([20.0, 1.0, 2.0])
    fields = composite_fields(goal, p, v, 0.0, obstacles, NOBODY, SPACING)
    assert np.mean(np.count_nonzero(fields.chi < 1.0, axis=1)) > 9.0

    def many():
        composite_fields(goal, p, v, 0.0, obstacles, NOBODY, SPACING)

    def one():
        composite_field(goal, (0.0, 0.0, 0.0), (20.0, 1.0, 2.0), 0.0, obstacles, NOBODY, SPACING)

    one()
    compiled, called = least_time(many, 30) / len(p), least_time(one, 300)
    print(f"\nten obstacles: {1e6 * compiled:.2f} us compiled, {1e6 * called:.1f} us from Python")
    assert compiled <= 10e-6


def test_time_of_ten_thousand_robots():
    steps = {}
    for count in (1000, 10_000):
        rng = np.random.default_rng(32)
        size = (count * 4.0 / 3.0 * math.pi * SPACING.detection_range**3 / NEIGHBOURS) ** (1 / 3)
        robots = np.hstack([rng.uniform(0.0, size, (count, 3)), 20.0 * rng.normal(size=(count, 3))])
        goals = goal_rows([random_goal(rng, size) for _ in range(count)])
        steps[count] = goals, robots
        fields_of_robots(goals, robots, 0.0, NOTHING, SPACING)
    least = {
        count: least_time(
            lambda step=step: fields_of_robots(*step, 0.0, NOTHING, SPACING), 200_000 // count
        )
        for count, step in steps.items()
    }
    growth = least[10_000] / least[1000] / 10.0
    print(f"\n10,000 robots: {1e3 * least[10_000]:.1f} ms a step, each {growth:.2f} x one of 1,000")
    assert least[10_000] <= 80e-3
    assert growth <= 3.0
