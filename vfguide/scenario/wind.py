"""The wind of a scenario as a vector."""

import math

from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Vec3


def blowing(speed: float, from_deg: float) -> Vec3:
    """A wind of a speed [m/s], the direction it blows toward, NED [m/s]."""
    toward = from_deg * DEG + math.pi
    return (speed * math.cos(toward), speed * math.sin(toward), 0.0)
