"""Azimuth and path angle of a velocity."""

import math

from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled


@compiled
def azimuth_of(air: Vec3) -> float:
    """Azimuth of the velocity through the air, NED [rad]."""
    return math.atan2(air[1], air[0])


@compiled
def path_of(air: Vec3, speed: float) -> float:
    """Path angle of an air velocity, NED, whose length is `speed` [m/s]: [rad], up positive."""
    return math.asin(max(-1.0, min(1.0, -air[2] / speed)))
