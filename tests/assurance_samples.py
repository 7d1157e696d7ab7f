"""Aircraft, hazards and states for the tests of the assurance."""

import math

import numpy as np

from vfguide.aircraft.performance import Gains
from vfguide.aircraft.point_mass import PointMass
from vfguide.airspace.fence import fences
from vfguide.airspace.hazards import Hazards, traffic_rows
from vfguide.assurance.decision import assurance, assure, no_backup
from vfguide.field.obstacle import Obstacle, obstacle_rows
from vfguide.geometry.shapes import shape
from vfguide.scenario.aircraft_file import load_aircraft
from vfguide.scenario.data import find_aircraft

AEROSONDE = load_aircraft(find_aircraft("aerosonde")).performance()
EASYSTAR = load_aircraft(find_aircraft("easystar")).performance()
FLOWN = assurance(AEROSONDE, Gains(25.0))
SMALL = assurance(EASYSTAR, Gains(11.0))
STILL = (0.0, 0.0, 0.0)
LEVEL = (0.0, 0.0)


def hazards(obstacles=(), intruders=(), zones=(), floor=-math.inf, ceiling=math.inf):
    rows = obstacle_rows(list(obstacles))
    return Hazards(rows, traffic_rows(list(intruders)), fences(list(zones)), floor, ceiling)


def motion(p_n=(0.0, 0.0, -150.0), azimuth=0.0, bank=0.0, gamma=0.0, airspeed=25.0):
    return PointMass(p_n, azimuth, bank, gamma, airspeed)


def ball(p_n, radius=40.0, v_n=STILL):
    return Obstacle(shape.sphere(radius), p_n, v_n=v_n)


def decide(at, known, wish=LEVEL, wind_n=STILL, gust=0.0, t=0.0, dt=0.1, backup=None, of=FLOWN):
    return assure(at, wish, wind_n, gust, known, t, dt, of, backup or no_backup())


def random_field(rng, count=8):
    """Spheres and towers ahead and around, some of them moving."""
    for _ in range(count):
        p_n = (rng.uniform(60.0, 400.0), rng.uniform(-200.0, 200.0), rng.uniform(-200.0, -100.0))
        v_n = tuple(map(float, rng.normal(size=3) * (5.0, 5.0, 1.0) * rng.integers(2)))
        body = shape.sphere(rng.uniform(10.0, 40.0))
        if rng.random() < 0.5:
            body = shape.cylinder(rng.uniform(5.0, 30.0), rng.uniform(50.0, 300.0))
        yield Obstacle(body, p_n, float(rng.uniform(0.0, np.pi)), v_n)
