"""Obstacles, traffic and fences for the tests of what keeps clear of them."""

import math

from vfguide.airspace.fence import fences
from vfguide.airspace.hazards import Hazards, traffic_rows
from vfguide.field.obstacle import Obstacle, obstacle_rows
from vfguide.geometry.shapes import shape

STILL = (0.0, 0.0, 0.0)


def hazards(obstacles=(), intruders=(), zones=(), floor=-math.inf, ceiling=math.inf):
    rows = obstacle_rows(list(obstacles))
    return Hazards(rows, traffic_rows(list(intruders)), fences(list(zones)), floor, ceiling)


def ball(p_n, radius=40.0, v_n=STILL):
    return Obstacle(shape.sphere(radius), p_n, v_n=v_n)
