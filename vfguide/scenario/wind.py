"""The wind of a scenario as a vector."""

import math

from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Vec3


def blowing(speed: float, from_deg: float) -> Vec3:
    """The vector, NED [m/s], of a wind of a speed [m/s] that comes from `from_deg` [deg]."""
    toward = from_deg * DEG + math.pi
    return (speed * math.cos(toward), speed * math.sin(toward), 0.0)
