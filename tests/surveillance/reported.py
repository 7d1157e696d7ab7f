"""Reports of other aircraft, made for tests."""

import math

from vfguide.earth.geodesy import ned_to_geodetic, tangent_plane
from vfguide.geometry.units import CDEG, CM_S, DEG, DEG_E7, MM
from vfguide.link.enums import AdsbAltitudeType, AdsbFlags
from vfguide.link.messages import AdsbVehicle

ORIGIN = (47.4 * DEG, 8.5 * DEG, 488.0)
PLANE = tangent_plane(*ORIGIN)

ALL = int(
    AdsbFlags.VALID_COORDS
    | AdsbFlags.VALID_ALTITUDE
    | AdsbFlags.VALID_HEADING
    | AdsbFlags.VALID_VELOCITY
    | AdsbFlags.VALID_CALLSIGN
    | AdsbFlags.VERTICAL_VELOCITY_VALID
    | AdsbFlags.SIMULATED
)


def said(p_n=(1000.0, 500.0, -150.0), *, icao=0xABC123, flags=ALL, **changes) -> AdsbVehicle:
    """A report of an aircraft at 30 m/s to the east that climbs by 2 m/s."""
    latitude, longitude, altitude = ned_to_geodetic(PLANE, p_n)
    place = (round(latitude / DEG_E7), round(longitude / DEG_E7))
    message = AdsbVehicle(
        icao,
        *place,
        AdsbAltitudeType.GEOMETRIC,
        round(altitude / MM),
        9000,
        3000,
        200,
        "D-EABC",
        1,
        0,
        flags,
        0,
    )
    return message._replace(**changes)


def moving(p_n, v_n, **changes) -> AdsbVehicle:
    """A report of an aircraft at `p_n` that flies with `v_n`."""
    course, speed = math.atan2(v_n[1], v_n[0]), math.hypot(v_n[0], v_n[1])
    flown = {
        "heading": round(course / CDEG) % 36_000,
        "hor_velocity": round(speed / CM_S),
        "ver_velocity": round(-v_n[2] / CM_S),
    }
    return said(p_n, **{**flown, **changes})
