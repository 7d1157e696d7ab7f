"""The traffic picture: other aircraft by their reports, and which of the reports are used."""

from vfguide.geometry.vector import Vec3, norm, sub
from vfguide.link.boot_time import elapsed
from vfguide.link.messages import AdsbVehicle
from vfguide.surveillance.heard import Heard, taken
from vfguide.surveillance.height_notes import HeightNotes
from vfguide.surveillance.heights import UNKNOWN_DATUM, HeightDatum
from vfguide.surveillance.own_track import OwnTrack, extended
from vfguide.surveillance.ownship_echo import after_report
from vfguide.surveillance.report import Ownship, Report, Volume, placed_at, refusal, report_of

LONGEST_SILENCE = 20.0
"""Age at which a report is dropped [s]; chosen: twenty reports were missed, and its volume has
doubled."""
MAX_AIRCRAFT = 200
"""Largest number of aircraft that are remembered; chosen, further ones are ignored."""


OWN_FOUND = "transponder {icao:06X} is this aircraft's own"
"""Note where a transponder is recognised as the ownship's."""
OWN_LOST = "transponder {icao:06X} is not this aircraft's own: it counts as traffic"
"""Note where a recognised transponder does not agree with the ownship any more."""
REFUSED = "a report of traffic is not used: {why}"
"""Note where a report is refused, once for each reason."""


class Picture:
    """The newest reports of other aircraft, by their addresses."""

    def __init__(self, origin: Vec3, volume: Volume, own_icao: int = 0) -> None:
        """An empty picture.

        Args:
            origin: latitude, longitude [rad] and altitude [m] of the plan's frame.
            volume: volume to keep out of around each aircraft.
            own_icao: address of the own transponder; 0: it is not known.
        """
        self._origin, self._volume, self._own_icao = origin, volume, own_icao
        self._heard: dict[int, Heard] = {}
        self._track = OwnTrack()
        self._told: set[str] = set()
        self._height_notes = HeightNotes()
        self._told_own: set[int] = set()
        self.refused = 0
        """Number of implausible reports."""

    def __len__(self) -> int:
        return len(self._heard)

    @property
    def is_empty(self) -> bool:
        """Whether there is no aircraft in it."""
        return not self._heard

    def follow(self, ownship: Ownship) -> None:
        """Take the ownship's state; later than before."""
        self._track = extended(self._track, ownship)

    def hear(
        self,
        said: AdsbVehicle,
        now_ms: int,
        ownship: Ownship | None = None,
        datum: HeightDatum = UNKNOWN_DATUM,
    ) -> list[str]:
        """Take a report; returns notes for the operator.

        Args:
            said: the message.
            now_ms: time_boot_ms of the autopilot when it arrives [ms].
            ownship: the ownship then; None: its state is not known.
            datum: how reported heights relate to those above mean sea level.
        """
        if said.ICAO_address == self._own_icao != 0:
            return []
        report = report_of(said, now_ms, self._origin, self._volume, datum)
        if report is None:
            self.refused += 1
            return self._once(REFUSED.format(why=refusal(said)))
        self._take(report, ownship)
        known, notes = self._heard.get(report.icao), self._own_notes(report.icao)
        if known is not None and not known.recognition.is_ignored:
            notes += self._height_notes.notes(said, datum, now_ms)
        return notes

    def _take(self, report: Report, ownship: Ownship | None) -> None:
        """Take a report that can be true; further aircraft than MAX_AIRCRAFT are ignored."""
        known = self._heard.get(report.icao)
        if known is None and len(self._heard) >= MAX_AIRCRAFT:
            return
        heard = (
            Heard(report, past=(report,)) if known is None else taken(known, report, self._volume)
        )
        self.refused += heard.odd is report
        if ownship is not None:
            recognition = after_report(heard.recognition, report, ownship, self._track)
            heard = heard._replace(recognition=recognition)
        self._heard[report.icao] = heard

    def _own_notes(self, icao: int) -> list[str]:
        """Notes of whether an aircraft is recognised as the ownship, where that is new."""
        known = self._heard.get(icao)
        is_own = known is not None and known.recognition.is_own
        if is_own == (icao in self._told_own):
            return []
        if is_own:
            self._told_own.add(icao)
            return [OWN_FOUND.format(icao=icao)]
        self._told_own.remove(icao)
        return [OWN_LOST.format(icao=icao)]

    def _once(self, note: str) -> list[str]:
        """The note, unless it was told before."""
        if note in self._told:
            return []
        self._told.add(note)
        return [note]

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
        """All reports but those of the ownship's own transponder, the nearest first."""
        there = (each.report for each in self._heard.values() if not each.recognition.is_ignored)
        return sorted(
            there, key=lambda each: norm(sub(placed_at(each, ownship.time_ms), ownship.p_n))
        )

    def newest(self, icao: int) -> Report | None:
        """The newest report of an aircraft; None if it was dropped."""
        known = self._heard.get(icao)
        return None if known is None else known.report
