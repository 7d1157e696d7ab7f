"""The circle that the software autopilot holds, as wide as its bank allows downwind."""

import math
from typing import NamedTuple

from vfguide.aircraft.performance import Performance, turn_length
from vfguide.earth.geodesy import TangentPlane
from vfguide.geometry.units import G0
from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled

HOLD_RADIUS = 1.57
"""Radius of the circle of a hold [turn lengths]; chosen, 100 m at 25 m/s. Wind and bank may make it
larger. On PX4 the operator sets NAV_LOITER_RAD for his aircraft."""
BANK_SHARE = 0.85
"""Share of the aircraft's largest bank that is asked for; chosen, gusts take the rest."""
RADIUS_MARGIN = 1.15
"""Ratio of the radius to the smallest that this bank allows downwind; chosen."""
SLOW_LOAD = 1.05
"""Load factor that is flown however slow the aircraft is, 18 degrees of bank; chosen."""


class Circle(NamedTuple):
    """Where to fly, and how fast."""

    plane: TangentPlane
    """Plane with its origin at the height of the circle."""
    north: float
    """North of the plane's origin, of the centre [m]."""
    east: float
    """East of the plane's origin, of the centre [m]."""
    airspeed: float
    """True airspeed to fly [m/s]."""


@compiled
def largest_bank(aircraft: Performance, airspeed: float) -> float:
    """Bank that the wing carries level at a true airspeed [m/s], with some to spare [rad]."""
    load = min(aircraft.load_max, max(SLOW_LOAD, (airspeed / aircraft.airspeed_min) ** 2))
    return min(BANK_SHARE * aircraft.bank_max, math.acos(1.0 / load))


@compiled
def radius_in(wind_n: Vec3, airspeed: float, aircraft: Performance) -> float:
    """Radius of the circle [m], wide enough downwind at a true airspeed in a wind, NED [m/s]."""
    downwind = airspeed + math.hypot(wind_n[0], wind_n[1])
    bank = largest_bank(aircraft, airspeed)
    tightest = RADIUS_MARGIN * downwind * downwind / (G0 * math.tan(bank))
    return max(HOLD_RADIUS * turn_length(airspeed), tightest)
