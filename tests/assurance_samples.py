"""The assurance of two aircraft, asked for decisions."""

import numpy as np
from aeroplanes import AEROSONDE, EASYSTAR
from hazard_samples import STILL

from vfguide.aircraft.performance import Gains
from vfguide.assurance.decision import assurance, assure, no_backup
from vfguide.field.obstacle import Obstacle
from vfguide.geometry.shapes import shape

FLOWN = assurance(AEROSONDE, Gains(25.0))
SMALL = assurance(EASYSTAR, Gains(11.0))
LEVEL = (0.0, 0.0)


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
