"""Reports of other aircraft: ADSB_VEHICLE as a volume to keep out of.

It has no clock: times are the autopilot's `time_boot_ms`. A report gets the time of the newest
attitude, less the age that it contains.
"""

import math
from typing import NamedTuple

from vfguide.airspace.hazards import Intruder
from vfguide.earth.geodesy import place_in_plane
from vfguide.geometry.units import CDEG, CM_S, DEG_E7, MS
from vfguide.geometry.vector import Vec3, add, scale
from vfguide.link.boot_time import elapsed
from vfguide.link.enums import AdsbFlags
from vfguide.link.messages import AdsbVehicle
from vfguide.link.plausibility import is_plausible
from vfguide.surveillance.heights import UNKNOWN_DATUM, HeightDatum, height_of

ASSUMED_SPEED = 60.0
"""Speed that is assumed of an aircraft that reports no velocity [m/s]; chosen as the cruise of
small aircraft."""
ASSUMED_CLIMB = 5.0
"""Vertical speed that is assumed of an aircraft that reports none [m/s]; chosen, 1000 ft/min."""
NO_POSITION = "it has no position"
"""Reason to refuse a report without VALID_COORDS."""
IMPLAUSIBLE = "it cannot be true"
"""Reason to refuse a report with a value that no aircraft has."""


class Volume(NamedTuple):
    """The volume to keep out of around another small aircraft, an upright cylinder.

    The radius contains 10 m for the wings of both, 10 m each for their receivers and 20 m that a
    report of a second ago is off in a turn; the half height is the 100 ft of a near miss that
    ASTM F3442 draws. Its radius of 500 ft is meant for crewed aircraft.
    """

    radius: float = 50.0
    """Radius [m]."""
    half_height: float = 30.0
    """Half height [m]."""
    uncertainty_rate: float = 3.0
    """Growth of the radius with the age of a report [m/s]."""
    uncertainty_rate_up: float = 1.5
    """Growth of the half height with the age of a report [m/s]."""


SMALL_AIRCRAFT = Volume()
"""The volume around a small aircraft, which scenarios may change."""


class Report(NamedTuple):
    """The newest report of one aircraft."""

    icao: int
    """ICAO address of its transponder, 24 bits, or another number in its reports; 0 for none."""
    name: str
    """Callsign, or the address in hexadecimal digits where none is reported."""
    time_ms: int
    """Time at which it had this position, as time_boot_ms [ms]."""
    intruder: Intruder
    """The aircraft as a hazard; its time is not set."""
    height_doubt: float = 0.0
    """Doubt of the reported height, which the volume contains [m]."""
    tells_velocity: bool = True
    """Whether it has speed and course over ground."""
    tells_climb: bool = True
    """Whether it has a vertical speed."""


class Ownship(NamedTuple):
    """State of the ownship at a time, in the frame of the plan."""

    time_ms: int
    """Time as time_boot_ms [ms]."""
    p_n: Vec3
    """Position, NED [m]."""
    v_n: Vec3
    """Velocity over ground, NED [m/s]."""


def report_of(
    said: AdsbVehicle,
    now_ms: int,
    origin: Vec3,
    volume: Volume,
    datum: HeightDatum = UNKNOWN_DATUM,
) -> Report | None:
    """The report in the tangent plane at `origin`; None if it is implausible or has no position.

    Args:
        said: the message.
        now_ms: time_boot_ms of the autopilot when it arrives [ms].
        origin: latitude, longitude [rad] and altitude [m] of the plan's frame.
        volume: volume to keep out of around an aircraft that reports everything.
        datum: how reported heights relate to those above mean sea level.
    """
    if refusal(said) is not None:
        return None
    height = height_of(said, datum, origin[2])
    place = (said.lat * DEG_E7, said.lon * DEG_E7, height.altitude)
    p_n, v_n = place_in_plane(origin, *place, velocity_of(said))
    intruder = Intruder(p_n, v_n, 0.0, *volume_of(said, volume, height.doubt))
    name = said.callsign.strip() if said.flags & AdsbFlags.VALID_CALLSIGN else ""
    return Report(
        said.ICAO_address,
        name or f"{said.ICAO_address:06X}",
        now_ms - round(said.tslc / MS),
        intruder,
        height.doubt,
        tells_velocity(said),
        bool(said.flags & AdsbFlags.VERTICAL_VELOCITY_VALID),
    )


def refusal(said: AdsbVehicle) -> str | None:
    """Why a report is not used, in words; None: it is."""
    if not said.flags & AdsbFlags.VALID_COORDS:
        return NO_POSITION
    return None if is_plausible(said) else IMPLAUSIBLE


def tells_velocity(said: AdsbVehicle) -> bool:
    """Whether a report has both speed and course over ground."""
    return bool(said.flags & AdsbFlags.VALID_VELOCITY and said.flags & AdsbFlags.VALID_HEADING)


def velocity_of(said: AdsbVehicle) -> Vec3:
    """Velocity, north-east-down at the aircraft [m/s]; zero where it is not reported."""
    up = said.ver_velocity * CM_S if said.flags & AdsbFlags.VERTICAL_VELOCITY_VALID else 0.0
    if not tells_velocity(said):
        return (0.0, 0.0, -up)
    speed, course = said.hor_velocity * CM_S, said.heading * CDEG
    return (speed * math.cos(course), speed * math.sin(course), -up)


def volume_of(said: AdsbVehicle, volume: Volume, height_doubt: float) -> Volume:
    """The volume of a report, larger or growing faster where something is not reported.

    Its half height is that of `volume` and the doubt of the reported height [m].
    """
    radius, half_height, uncertainty_rate, uncertainty_rate_up = volume
    if not said.flags & AdsbFlags.VALID_VELOCITY:
        uncertainty_rate += ASSUMED_SPEED
    elif not said.flags & AdsbFlags.VALID_HEADING:
        uncertainty_rate += said.hor_velocity * CM_S
    if not said.flags & AdsbFlags.VERTICAL_VELOCITY_VALID:
        uncertainty_rate_up += ASSUMED_CLIMB
    return Volume(radius, half_height + height_doubt, uncertainty_rate, uncertainty_rate_up)


def placed_at(report: Report, time_ms: int) -> Vec3:
    """Position of a reported aircraft at a time_boot_ms [ms] if it flies straight on, NED [m]."""
    each = report.intruder
    return add(each.p_n, scale(elapsed(report.time_ms, time_ms), each.v_n))
