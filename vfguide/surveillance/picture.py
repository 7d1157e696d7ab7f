"""The traffic picture: other aircraft by their reports, and which of the reports are used."""

from typing import NamedTuple

from vfguide.geometry.vector import Vec3, norm, sub
from vfguide.link.boot_time import elapsed
from vfguide.link.messages import AdsbVehicle
from vfguide.surveillance.report import Ownship, Report, Volume, placed_at, report_of

LONGEST_SILENCE = 20.0
"""Age at which a report is dropped [s]; chosen: twenty reports were missed, and its volume has
doubled."""
JUMP_DISTANCE = 300.0
"""Distance from the prediction of the last report beyond which a report is used only if the next
one agrees with it [m]; chosen."""
JUMP_SPEED = 100.0
"""Growth of that distance with the time between the reports [m/s]; chosen."""
ECHO_DISTANCE = 15.0
"""Distance from the ownship within which a report may be an echo of its own transponder [m];
chosen."""
ECHO_SPEED = 3.0
"""Difference of the velocities within which such a report is an echo [m/s]; chosen."""
MAX_AIRCRAFT = 200
"""Largest number of aircraft that are remembered; chosen, further ones are ignored."""


class Heard(NamedTuple):
    """The reports that are kept of one aircraft."""

    report: Report
    """The newest one that is used."""
    odd: Report | None = None
    """A later one that did not fit; None: none since."""


def fits(before: Report, after: Report) -> bool:
    """Whether both reports can come from one aircraft."""
    apart = norm(sub(placed_at(before, after.time_ms), after.intruder.p_n))
    return apart <= JUMP_DISTANCE + JUMP_SPEED * abs(elapsed(before.time_ms, after.time_ms))


def is_ownship_echo(report: Report, ownship: Ownship) -> bool:
    """Whether a report has the position and the velocity of the ownship."""
    near = norm(sub(placed_at(report, ownship.time_ms), ownship.p_n)) < ECHO_DISTANCE
    return near and norm(sub(report.intruder.v_n, ownship.v_n)) < ECHO_SPEED


class Picture:
    """The newest reports of other aircraft, by their addresses."""

    def __init__(self, origin: Vec3, volume: Volume, own_icao: int = 0) -> None:
        """An empty picture.

        Args:
            origin: latitude, longitude [rad] and altitude [m] of the plan's frame.
            volume: volume to keep out of around each aircraft.
            own_icao: address of the own transponder; 0: there is none.
        """
        self._origin, self._volume, self._own_icao = origin, volume, own_icao
        self._heard: dict[int, Heard] = {}
        self.refused = 0
        """Number of implausible reports."""

    def __len__(self) -> int:
        return len(self._heard)

    @property
    def is_empty(self) -> bool:
        """Whether there is no aircraft in it."""
        return not self._heard

    def hear(self, said: AdsbVehicle, now_ms: int) -> None:
        """Take a report that arrives at the autopilot's time `now_ms`, its time_boot_ms [ms]."""
        if said.ICAO_address == self._own_icao != 0:
            return
        report = report_of(said, now_ms, self._origin, self._volume)
        if report is None:
            self.refused += 1
            return
        known = self._heard.get(report.icao)
        if known is None:
            if len(self._heard) < MAX_AIRCRAFT:
                self._heard[report.icao] = Heard(report)
        elif elapsed(known.report.time_ms, report.time_ms) < 0.0:
            return
        elif fits(known.report, report) or (known.odd is not None and fits(known.odd, report)):
            self._heard[report.icao] = Heard(report)
        else:
            self.refused += 1
            self._heard[report.icao] = Heard(known.report, report)

    def forget(self, now_ms: int) -> None:
        """Drop aircraft silent for LONGEST_SILENCE, or all after a restart of the autopilot.

        `now_ms` is its time_boot_ms [ms].
        """
        self._heard = {
            icao: each
            for icao, each in self._heard.items()
            if abs(elapsed(each.report.time_ms, now_ms)) < LONGEST_SILENCE
        }

    def others(self, ownship: Ownship) -> list[Report]:
        """All reports but echoes of the ownship, the nearest first."""
        there = (
            each.report
            for each in self._heard.values()
            if not is_ownship_echo(each.report, ownship)
        )
        return sorted(
            there, key=lambda each: norm(sub(placed_at(each, ownship.time_ms), ownship.p_n))
        )

    def newest(self, icao: int) -> Report | None:
        """The newest report of an aircraft; None if it was dropped."""
        known = self._heard.get(icao)
        return None if known is None else known.report
