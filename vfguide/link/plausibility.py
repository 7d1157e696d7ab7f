"""Plausibility of messages: an implausible one counts as not received."""

import math
from collections.abc import Callable
from typing import Any

from vfguide.geometry.units import CM_S, DEG_E7, MM
from vfguide.link.enums import AdsbFlags, GpsFixType
from vfguide.link.messages import (
    AdsbVehicle,
    AttitudeQuaternion,
    GlobalPositionInt,
    GpsGlobalOrigin,
    GpsRawInt,
    LocalPositionNed,
    Message,
    VfrHud,
    WindCov,
)

FARTHEST = 1e6
"""Largest plausible distance from the origin of the local frame on each axis [m]; chosen."""
FASTEST = 500.0
"""Largest plausible speed over ground on each axis, and through the air [m/s]; chosen."""
STRONGEST_WIND = 150.0
"""Largest plausible wind on each axis [m/s]; chosen."""
LOWEST = -1000.0
"""Least plausible altitude [m]; chosen."""
HIGHEST = 30_000.0
"""Greatest plausible altitude [m]; chosen."""
SPIN = 50.0
"""Largest plausible body rate [rad/s]; chosen."""
MAX_CLIMB = 100.0
"""Largest plausible vertical speed of another aircraft [m/s]; chosen."""
LARGEST_UNDULATION = 120.0
"""Largest plausible height of mean sea level above or below the ellipsoid [m]; the geoid EGM96 is
within -107 to 86 m."""
FULL_CIRCLE = 36_000
"""Number of headings in a full circle of ADSB_VEHICLE [0.01 deg]."""


def is_plausible(message: Message) -> bool:
    """Whether the values of a message that guidance uses are plausible; not-a-number never is."""
    check = _CHECKS.get(type(message))
    return check is None or check(message)


def _attitude(said: AttitudeQuaternion) -> bool:
    _, w, x, y, z, p, q, r, _ = said
    return 0.5 < w * w + x * x + y * y + z * z < 2.0 and within(SPIN, p, q, r)


def _position(said: LocalPositionNed) -> bool:
    _, x, y, z, vx, vy, vz = said
    return within(FARTHEST, x, y, z) and within(FASTEST, vx, vy, vz)


def _hud(said: VfrHud) -> bool:
    """Plausible airspeed and altitude; the airspeed is not a number where no sensor is trusted."""
    known = 0.0 <= said.airspeed < FASTEST or math.isnan(said.airspeed)
    return known and LOWEST < said.alt < HIGHEST


def _wind(said: WindCov) -> bool:
    return within(STRONGEST_WIND, said.wind_x, said.wind_y, said.wind_z)


def _origin(said: GpsGlobalOrigin) -> bool:
    latitude, altitude = said.latitude * DEG_E7, said.altitude * MM
    return abs(latitude) <= 0.5 * math.pi and LOWEST < altitude < HIGHEST


def _place(said: GlobalPositionInt) -> bool:
    latitude, altitude = said.lat * DEG_E7, said.alt * MM
    return abs(latitude) <= 0.5 * math.pi and LOWEST < altitude < HIGHEST


def _satellites(said: GpsRawInt) -> bool:
    """Plausible altitudes; 0 above the ellipsoid is what a sender without that field says."""
    return (
        said.fix_type >= GpsFixType.GPS_FIX_TYPE_3D_FIX
        and said.alt_ellipsoid != 0
        and abs(undulation_of(said)) <= LARGEST_UNDULATION
    )


def undulation_of(said: GpsRawInt) -> float:
    """Height of mean sea level above the ellipsoid [m], where the message is plausible."""
    return (said.alt_ellipsoid - said.alt) * MM


def _traffic(said: AdsbVehicle) -> bool:
    """Fields that its flags do not call valid may hold anything."""
    flags = said.flags
    return (
        abs(said.lat) * DEG_E7 <= 0.5 * math.pi
        and abs(said.lon) * DEG_E7 <= math.pi
        and (not flags & AdsbFlags.VALID_ALTITUDE or LOWEST < said.altitude * MM < HIGHEST)
        and (not flags & AdsbFlags.VALID_VELOCITY or said.hor_velocity * CM_S < FASTEST)
        and (not flags & AdsbFlags.VALID_HEADING or said.heading <= FULL_CIRCLE)
        and (
            not flags & AdsbFlags.VERTICAL_VELOCITY_VALID
            or abs(said.ver_velocity) * CM_S <= MAX_CLIMB
        )
    )


_CHECKS: dict[type[Message], Callable[[Any], bool]] = {
    AttitudeQuaternion: _attitude,
    LocalPositionNed: _position,
    VfrHud: _hud,
    WindCov: _wind,
    GpsGlobalOrigin: _origin,
    GlobalPositionInt: _place,
    GpsRawInt: _satellites,
    AdsbVehicle: _traffic,
}


def within(most: float, a: float, b: float, c: float) -> bool:
    """Whether none is larger, to either side; false for not-a-number."""
    return -most <= a <= most and -most <= b <= most and -most <= c <= most
