"""The traffic picture: who else flies, from ADSB_VEHICLE, as volumes to keep out of.

No clock: times are the autopilot's `time_boot_ms`. What is heard gets the time of the newest
attitude, less the age that the report tells of itself.
"""

import math
from typing import NamedTuple

from vfguide.airspace.hazards import Intruder
from vfguide.companion.knowledge import elapsed
from vfguide.companion.plausibility import is_plausible
from vfguide.geometry.geodesy import place_in_plane
from vfguide.geometry.units import CDEG, CM_S, DEG_E7, MM, MS
from vfguide.geometry.vector import Vec3, add, norm, scale, sub
from vfguide.link.enums import AdsbAltitudeType, AdsbFlags
from vfguide.link.messages import AdsbVehicle

FORGOTTEN = 20.0
"""A report as old as this is dropped [s]: twenty were missed, and its volume is twice as wide."""
FASTEST = 60.0
"""Who does not tell a velocity may go anywhere as fast as this [m/s]: small aircraft cruise so."""
STEEPEST = 5.0
"""Who does not tell a vertical rate may climb or sink so fast [m/s], a thousand feet a minute."""
BARO_DOUBT = 20.0
"""Half height is larger by this where the height is a pressure altitude [m]."""
ANY_HEIGHT = 20_000.0
"""Half height of what does not tell its altitude [m]."""
JUMP, SWIFT = 300.0, 100.0
"""A report farther than this from where the last one is now, and this much a second [m, m/s], is
believed only when the next one agrees with it."""
ECHO, ECHO_SPEED = 15.0, 3.0
"""Nearer than this to the own position [m] and velocity [m/s] it is the own transponder."""
MOST = 200
"""Aircraft that are remembered; of more, those heard of last are not."""


class Volume(NamedTuple):
    """What to keep out of around another small aircraft.

    The radius holds 10 m for the wings of both, 10 m each for their receivers and 20 m that a
    report of a second ago is off in a turn; the half height is the 100 ft of a near miss that
    ASTM F3442 draws. Its radius of 500 ft is meant for crewed aircraft.
    """

    radius: float = 50.0
    half_height: float = 30.0
    """[m]."""
    uncertainty_rate: float = 3.0
    uncertainty_rate_up: float = 1.5
    """Of both with the age of a report [m/s]."""


SMALL_AIRCRAFT = Volume()


class Report(NamedTuple):
    """The newest word of one aircraft."""

    icao: int
    name: str
    time_ms: int
    """time_boot_ms of when it was there."""
    intruder: Intruder
    """Its time is not set."""


class Heard(NamedTuple):
    """What is kept of one aircraft."""

    report: Report
    odd: Report | None = None
    """A later one that did not fit; None: none since."""


class Ownship(NamedTuple):
    """Where the own vehicle is at a time, in the frame of the plan."""

    time_ms: int
    p_n: Vec3
    v_n: Vec3


def report_of(said: AdsbVehicle, now_ms: int, origin: Vec3, volume: Volume) -> Report | None:
    """The report in the tangent plane at `origin`; None: it cannot be true, or has no place."""
    flags = said.flags
    if not is_plausible(said) or not flags & AdsbFlags.VALID_COORDS:
        return None
    altitude = said.altitude * MM if flags & AdsbFlags.VALID_ALTITUDE else origin[2]
    place = (said.lat * DEG_E7, said.lon * DEG_E7, altitude)
    p_n, v_n = place_in_plane(origin, *place, velocity_of(said))
    intruder = Intruder(p_n, v_n, 0.0, *volume_of(said, volume))
    name = said.callsign.strip() if flags & AdsbFlags.VALID_CALLSIGN else ""
    address = said.ICAO_address
    return Report(address, name or f"{address:06X}", now_ms - round(said.tslc / MS), intruder)


def velocity_of(said: AdsbVehicle) -> Vec3:
    """North-east-down at the aircraft [m/s]; zero where it is not told."""
    up = said.ver_velocity * CM_S if said.flags & AdsbFlags.VERTICAL_VELOCITY_VALID else 0.0
    if not said.flags & AdsbFlags.VALID_VELOCITY or not said.flags & AdsbFlags.VALID_HEADING:
        return (0.0, 0.0, -up)
    speed, course = said.hor_velocity * CM_S, said.heading * CDEG
    return (speed * math.cos(course), speed * math.sin(course), -up)


def volume_of(said: AdsbVehicle, volume: Volume) -> Volume:
    """What to keep out of, larger or growing faster where something is not told."""
    radius, half_height, uncertainty_rate, uncertainty_rate_up = volume
    if not said.flags & AdsbFlags.VALID_ALTITUDE:
        half_height = ANY_HEIGHT
    elif said.altitude_type == AdsbAltitudeType.PRESSURE_QNH:
        half_height += BARO_DOUBT
    if not said.flags & AdsbFlags.VALID_VELOCITY:
        uncertainty_rate += FASTEST
    elif not said.flags & AdsbFlags.VALID_HEADING:
        uncertainty_rate += said.hor_velocity * CM_S
    if not said.flags & AdsbFlags.VERTICAL_VELOCITY_VALID:
        uncertainty_rate_up += STEEPEST
    return Volume(radius, half_height, uncertainty_rate, uncertainty_rate_up)


def placed_at(report: Report, time_ms: int) -> Vec3:
    """Where it is at a time if it flies straight on, NED [m]."""
    each = report.intruder
    return add(each.p_n, scale(elapsed(report.time_ms, time_ms), each.v_n))


def fits(before: Report, after: Report) -> bool:
    """Whether one aircraft can have sent both."""
    apart = norm(sub(placed_at(before, after.time_ms), after.intruder.p_n))
    return apart <= JUMP + SWIFT * abs(elapsed(before.time_ms, after.time_ms))


def is_ownship_echo(report: Report, ownship: Ownship) -> bool:
    """Whether it is where the own vehicle is and flies as it does."""
    near = norm(sub(placed_at(report, ownship.time_ms), ownship.p_n)) < ECHO
    return near and norm(sub(report.intruder.v_n, ownship.v_n)) < ECHO_SPEED


class Picture:
    """Who else flies, by their addresses."""

    def __init__(self, origin: Vec3, volume: Volume, own_icao: int = 0) -> None:
        """A picture of nobody.

        Args:
            origin: of the plan's frame.
            volume: to keep out of.
            own_icao: address of the own transponder; 0: there is none.
        """
        self._origin, self._volume, self._own_icao = origin, volume, own_icao
        self._heard: dict[int, Heard] = {}
        self.refused = 0
        """Number of reports that were not believed."""

    def __len__(self) -> int:
        return len(self._heard)

    @property
    def is_empty(self) -> bool:
        """Whether nobody is heard of."""
        return not self._heard

    def hear(self, said: AdsbVehicle, now_ms: int) -> None:
        """Take a report that arrives at the autopilot's time `now_ms`."""
        if said.ICAO_address == self._own_icao != 0:
            return
        report = report_of(said, now_ms, self._origin, self._volume)
        if report is None:
            self.refused += 1
            return
        known = self._heard.get(report.icao)
        if known is None:
            if len(self._heard) < MOST:
                self._heard[report.icao] = Heard(report)
        elif elapsed(known.report.time_ms, report.time_ms) < 0.0:
            return
        elif fits(known.report, report) or (known.odd is not None and fits(known.odd, report)):
            self._heard[report.icao] = Heard(report)
        else:
            self.refused += 1
            self._heard[report.icao] = Heard(known.report, report)

    def forget(self, now_ms: int) -> None:
        """Drop those not heard of for too long; an autopilot that began anew counts as that."""
        self._heard = {
            icao: each
            for icao, each in self._heard.items()
            if abs(elapsed(each.report.time_ms, now_ms)) < FORGOTTEN
        }

    def others(self, ownship: Ownship) -> list[Report]:
        """All but the own echo, the nearest first."""
        there = (
            each.report
            for each in self._heard.values()
            if not is_ownship_echo(each.report, ownship)
        )
        return sorted(
            there, key=lambda each: norm(sub(placed_at(each, ownship.time_ms), ownship.p_n))
        )

    def newest(self, icao: int) -> Report | None:
        """The newest report of one; None: it is forgotten."""
        known = self._heard.get(icao)
        return None if known is None else known.report
