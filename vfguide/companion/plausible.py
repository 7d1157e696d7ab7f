"""Which messages can be true: one that cannot is as good as not heard."""

import math

from vfguide.geometry.units import DEG_E7, MM
from vfguide.link.messages import (
    AttitudeQuaternion,
    GpsGlobalOrigin,
    LocalPositionNed,
    Message,
    VfrHud,
    WindCov,
)

FARTHEST = 1e6
"""From the origin of the local frame, each axis [m]."""
FASTEST = 500.0
"""Over ground, each axis, and through the air [m/s]."""
STRONGEST_WIND = 150.0
"""Each axis [m/s]."""
LOWEST, HIGHEST = -1000.0, 30_000.0
"""Altitudes [m]."""
SPIN = 50.0
"""Body rates [rad/s]."""


def is_plausible(message: Message) -> bool:
    """Whether what the companion flies on can be true; not-a-number never is."""
    match message:
        case AttitudeQuaternion(_, w, x, y, z, p, q, r):
            return 0.5 < w * w + x * x + y * y + z * z < 2.0 and within(SPIN, p, q, r)
        case LocalPositionNed(_, x, y, z, vx, vy, vz):
            return within(FARTHEST, x, y, z) and within(FASTEST, vx, vy, vz)
        case VfrHud(airspeed=airspeed, alt=altitude):
            return 0.0 <= airspeed < FASTEST and LOWEST < altitude < HIGHEST
        case WindCov(_, x, y, z):
            return within(STRONGEST_WIND, x, y, z)
        case GpsGlobalOrigin(latitude=latitude, altitude=altitude):
            return within(0.5 * math.pi, latitude * DEG_E7) and LOWEST < altitude * MM < HIGHEST
        case _:
            return True


def within(most: float, *values: float) -> bool:
    """Whether no value is larger, to either side; false for not-a-number."""
    return all(abs(value) <= most for value in values)
