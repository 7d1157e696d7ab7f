"""Gusts along a path of any airspeeds and headings."""

import math
from collections.abc import Sequence

import numpy as np

from vfguide.geometry.vector import Vectors
from vfguide.sim.turbulence import Gusts, Noise, Scales, Stages, flown_on

UNIT = Scales(1.0, 300.0, 1.0, 200.0)


def flown(speeds: Sequence[float], headings: Sequence[float], dt: float, seed: int) -> Vectors:
    """(n, 3) gusts of `UNIT` along a level path, NED."""
    rng = np.random.default_rng(seed)
    first = rng.normal(size=5).tolist()
    gusts, rows = Gusts(first[0], first[1], first[2], Stages(first[3], first[4])), []
    noises = rng.normal(size=(len(speeds), 5)).tolist()
    for speed, heading, noise in zip(speeds, headings, noises, strict=True):
        v_air_n = (speed * math.cos(heading), speed * math.sin(heading), 0.0)
        gusts = flown_on(gusts, v_air_n, dt, UNIT, Noise(*noise))
        rows.append((gusts.north, gusts.east, gusts.vertical.gust))
    return np.array(rows)


def straight(speed: float, dt: float, n: int) -> Vectors:
    """(n, 3) gusts u, v, w of `UNIT` on a straight path."""
    return flown([speed] * n, [0.0] * n, dt, 1)
