"""Random scenes for the tests of the fields among obstacles."""

import math

import numpy as np
from shape_samples import floats

from vfguide.field.goal_frame import goal_frame
from vfguide.field.obstacle import Obstacle, PlacedObstacle, obstacle_rows
from vfguide.field.obstacle_arrays import levels
from vfguide.field.robots import Spacing
from vfguide.kernels.rows import columns

SPACING = Spacing(10.0, 100.0)
NOBODY = np.zeros((0, 6))
NOTHING = obstacle_rows([])
STILL = (0.0, 0.0, 0.0)


def random_goal(rng, distance=300.0):
    position = floats(rng.uniform(-distance, distance, 3))
    return goal_frame(position, rng.uniform(-math.pi, math.pi), rng.uniform(-1.0, 1.0))


def one_obstacle(body, **options):
    return obstacle_rows([Obstacle(body, (0.0, 0.0, 0.0), **options)])


def at_level(obstacles, directions, level):
    """Points on the rays from the first obstacle's centre, at t = 0, where U has a value."""
    centre = columns(PlacedObstacle, obstacles).p_n[0]
    low, high = np.zeros(len(directions)), np.full(len(directions), 1e4)
    for _ in range(70):
        middle = 0.5 * (low + high)
        points = centre + middle[:, None] * directions
        outside = levels(points, 0.0, obstacles)[:, 0] > level
        low, high = np.where(outside, low, middle), np.where(outside, middle, high)
    return centre + high[:, None] * directions
