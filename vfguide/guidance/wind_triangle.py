"""The wind triangle: from a course over ground to a direction through the air.

R. W. Beard and T. W. McLain, Small Unmanned Aircraft: Theory and Practice, 2012, Chapter 2.
"""

import math
from typing import NamedTuple

from vfguide.kernels.compiled import compiled
from vfguide.planning.excess_wind import EXCESS_RATIO


class Heading(NamedTuple):
    """A wanted direction of the horizontal air velocity."""

    psi: float
    """Azimuth [rad]."""
    psi_rate: float
    """Rate of the azimuth [rad/s]."""
    groundspeed: float
    """Speed over ground along the course [m/s]."""


@compiled
def heading_for_course(
    chi: float, chi_rate: float, wind: tuple[float, float], airspeed: float
) -> Heading:
    """Azimuth of the air velocity that makes good the course `chi` [rad] at `airspeed` [m/s].

    V sin(psi - chi) = -(wind to the right of the course); the rate follows from the derivative.
    The crab angle is limited where the cross wind exceeds EXCESS_RATIO of the airspeed.

    Args:
        chi: course over ground [rad].
        chi_rate: its rate [rad/s].
        wind: wind to the north and to the east, blowing toward [m/s].
        airspeed: horizontal part of the true airspeed [m/s].
    """
    c, s = math.cos(chi), math.sin(chi)
    along = wind[0] * c + wind[1] * s
    across = -wind[0] * s + wind[1] * c
    sine = max(-EXCESS_RATIO, min(EXCESS_RATIO, -across / airspeed))
    forward = airspeed * math.sqrt(1.0 - sine * sine)
    groundspeed = forward + along
    return Heading(chi + math.asin(sine), chi_rate * groundspeed / forward, groundspeed)
