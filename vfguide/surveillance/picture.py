"""The traffic picture: other aircraft by their reports, and which of the reports are used."""

from vfguide.geometry.units import KM
from vfguide.geometry.vector import Vec3, norm, sub
from vfguide.link.boot_time import elapsed
from vfguide.link.messages import AdsbVehicle
from vfguide.surveillance.height_notes import HeightNotes
from vfguide.surveillance.heights import UNKNOWN_DATUM, HeightDatum
from vfguide.surveillance.own_track import OwnTrack, extended
from vfguide.surveillance.ownship_echo import after_report
from vfguide.surveillance.report import Ownship, Report, Volume, refusal, report_of
from vfguide.surveillance.track import Track, distance_from, extended_track, nearest_fit, new_track

LONGEST_SILENCE = 20.0
"""Age at which a report is dropped [s]; chosen: twenty reports were missed, and its volume has
doubled."""
MAX_AIRCRAFT = 200
"""Largest number of aircraft that are remembered, the nearest ones; chosen."""
OWN_REACH = 1000.0
"""Distance from the ownship beyond which a report with its own address is another aircraft's [m];
chosen above what a report that is late can be away."""
OWN_REACH_REPORTS = 5
"""Number of reports in a row beyond the own reach after which the operator is told; chosen longer
than positions glitch."""
OWN_FOUND = "transponder {icao:06X} is this aircraft's own"
"""Note where a transponder is recognised as the ownship's."""
OWN_LOST = "transponder {icao:06X} is not this aircraft's own: it counts as traffic"
"""Note where a recognised transponder does not agree with the ownship any more."""
OWN_ADDRESS_ELSEWHERE = (
    "another aircraft reports this aircraft's own address {icao:06X}, {distance:.1f} km away: "
    "it is not avoided"
)
"""Note where the address that the plan calls the own one is somebody else's too."""
TOO_MANY = f"more than {MAX_AIRCRAFT} aircraft are heard: only the nearest are kept clear of"
"""Note where aircraft are not remembered."""
REFUSED = "a report of traffic is not used: {why}"
"""Note where a report is refused, once for each reason."""


class Picture:
    """The tracks of other aircraft."""

    def __init__(self, origin: Vec3, volume: Volume, own_icao: int = 0) -> None:
        """An empty picture.

        Args:
            origin: latitude, longitude [rad] and altitude [m] of the plan's frame.
            volume: volume to keep out of around each aircraft.
            own_icao: address of the own transponder; 0: it is not known.
        """
        self._origin, self._volume, self._own_icao = origin, volume, own_icao
        self._tracks: dict[int, Track] = {}
        """The tracks by their numbers."""
        self._number = 0
        self._track = OwnTrack()
        self._told: set[str] = set()
        self._height_notes = HeightNotes()
        self._told_own: set[int] = set()
        self._own_elsewhere = 0
        self.refused = 0
        """Number of implausible reports."""

    def __len__(self) -> int:
        return len(self._tracks)

    @property
    def is_empty(self) -> bool:
        """Whether there is no aircraft in it."""
        return not self._tracks

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
        report = report_of(said, now_ms, self._origin, self._volume, datum)
        if report is None:
            self.refused += 1
            return self._once(REFUSED.format(why=refusal(said)))
        if report.icao == self._own_icao != 0:
            return self._own_elsewhere_notes(report, ownship)
        track = self._taken(report)
        if ownship is not None:
            recognition = after_report(track.recognition, report, ownship, self._track)
            track = track._replace(recognition=recognition)
        self._tracks[track.number] = track
        notes = self._own_notes(track) + self._drop_farthest(ownship)
        if track.is_traffic:
            notes += self._height_notes.notes(said, datum, now_ms)
        return notes

    def _taken(self, report: Report) -> Track:
        """The track that a plausible report belongs to, with the report."""
        of_address = [each for each in self._tracks.values() if each.report.icao == report.icao]
        track = nearest_fit(of_address, report)
        if track is not None:
            return extended_track(track, report, self._volume)
        self._number += 1
        return new_track(self._number, report, is_first=not of_address)

    def _drop_farthest(self, ownship: Ownship | None) -> list[str]:
        """Forget the farthest where there are more than MAX_AIRCRAFT; returns a note of it."""
        if len(self._tracks) <= MAX_AIRCRAFT:
            return []
        farthest = max(self._tracks.values(), key=lambda each: _importance(each, ownship))
        del self._tracks[farthest.number]
        return self._once(TOO_MANY)

    def _own_elsewhere_notes(self, report: Report, ownship: Ownship | None) -> list[str]:
        """A note where the own address, as the plan has it, is somebody else's too."""
        away = 0.0 if ownship is None else norm(sub(report.intruder.p_n, ownship.p_n))
        self._own_elsewhere = self._own_elsewhere + 1 if away > OWN_REACH else 0
        if self._own_elsewhere != OWN_REACH_REPORTS:
            return []
        return [OWN_ADDRESS_ELSEWHERE.format(icao=report.icao, distance=away / KM)]

    def _own_notes(self, track: Track) -> list[str]:
        """Notes of whether a track is recognised as the ownship, where that is new."""
        is_own, icao = track.recognition.is_own, track.report.icao
        if is_own == (track.number in self._told_own):
            return []
        if is_own:
            self._told_own.add(track.number)
            return [OWN_FOUND.format(icao=icao)]
        self._told_own.remove(track.number)
        return [OWN_LOST.format(icao=icao)]

    def _once(self, note: str) -> list[str]:
        """The note, unless it was told before."""
        if note in self._told:
            return []
        self._told.add(note)
        return [note]

    def forget(self, now_ms: int) -> None:
        """Drop aircraft silent for LONGEST_SILENCE, or all after a restart of the autopilot.

        What was recognised as the own transponder is remembered. `now_ms` is the autopilot's
        time_boot_ms [ms].
        """
        self._tracks = {
            number: each
            for number, each in self._tracks.items()
            if abs(age := elapsed(each.report.time_ms, now_ms)) < LONGEST_SILENCE
            or (each.recognition.is_own and age > 0.0)
        }

    def others(self, ownship: Ownship) -> list[Track]:
        """All aircraft but the ownship's own transponder, the nearest first."""
        there = (each for each in self._tracks.values() if each.is_traffic)
        return sorted(there, key=lambda each: distance_from(each, ownship.p_n, ownship.time_ms))

    def newest(self, number: int) -> Report | None:
        """The newest report of the track of a number; None if it was dropped."""
        known = self._tracks.get(number)
        return None if known is None else known.report


def _importance(track: Track, ownship: Ownship | None) -> tuple[bool, float]:
    """The order in which aircraft are remembered: the own transponder, then the nearest."""
    here, now_ms = (
        ((0.0, 0.0, 0.0), track.report.time_ms)
        if ownship is None
        else (ownship.p_n, ownship.time_ms)
    )
    return not track.recognition.is_own, distance_from(track, here, now_ms)
