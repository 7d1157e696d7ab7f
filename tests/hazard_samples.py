"""Obstacles, traffic and fences for the tests of what keeps clear of them."""

import math

from vfguide.aircraft.point_mass import PointMass
from vfguide.airspace.fence import fences
from vfguide.airspace.hazards import Hazards, traffic_rows
from vfguide.field.obstacle import Obstacle, obstacle_rows
from vfguide.geometry.shapes import shape

STILL = (0.0, 0.0, 0.0)


def hazards(obstacles=(), intruders=(), zones=(), floor=-math.inf, ceiling=math.inf):
    rows = obstacle_rows(list(obstacles))
    return Hazards(rows, traffic_rows(list(intruders)), fences(list(zones)), floor, ceiling)


def motion(p_n=(0.0, 0.0, -150.0), azimuth=0.0, bank=0.0, gamma=0.0, airspeed=25.0):
    return PointMass(p_n, azimuth, bank, gamma, airspeed)


def ball(p_n, radius=40.0, v_n=STILL):
    return Obstacle(shape.sphere(radius), p_n, v_n=v_n)
