"""Azimuth, path angle and horizontal part of a velocity."""

import math

from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled


@compiled
def azimuth_of(v_n: Vec3) -> float:
    """Azimuth of a velocity, NED [rad]: over ground it is the course."""
    return math.atan2(v_n[1], v_n[0])


@compiled
def horizontal_norm(a_n: Vec3) -> float:
    """Length of the horizontal part of a velocity or any other vector, NED, in its unit."""
    return math.hypot(a_n[0], a_n[1])


@compiled
def velocity_along(azimuth: float, path: float, speed: float) -> Vec3:
    """The velocity, NED, of an azimuth, a path angle, up positive [rad], and a speed [m/s]."""
    level = speed * math.cos(path)
    return level * math.cos(azimuth), level * math.sin(azimuth), -speed * math.sin(path)


@compiled
def path_of(air: Vec3, speed: float) -> float:
    """Path angle of an air velocity, NED, whose length is `speed` [m/s]: [rad], up positive."""
    return math.asin(max(-1.0, min(1.0, -air[2] / speed)))
