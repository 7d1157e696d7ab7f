"""The track of one aircraft: those reports of an address that can come from the same one.

An address need not be of one aircraft: two may have the same one by mistake, those without one
report 0, and somebody may send what is not there. So reports are associated by their positions, as
nearest neighbours (Bar-Shalom and Fortmann, *Tracking and Data Association*, 1988), and a second
place of an address is not avoided until another report confirms it.
"""

from collections.abc import Iterable
from typing import NamedTuple

from vfguide.geometry.vector import Vec3, norm, sub
from vfguide.link.boot_time import elapsed
from vfguide.surveillance.derived_velocity import past_reports, with_derived_velocity
from vfguide.surveillance.recognition import Recognition
from vfguide.surveillance.report import Report, Volume, placed_at

JUMP_DISTANCE = 300.0
"""Distance from the prediction of the last report up to which a report can come from the same
aircraft [m]; chosen."""
JUMP_SPEED = 100.0
"""Growth of the jump distance with the time between the reports [m/s]; chosen."""


class Track(NamedTuple):
    """The reports that are kept of one aircraft."""

    number: int
    """Number that no other track has."""
    report: Report
    """The newest one."""
    is_confirmed: bool
    """Whether it is avoided: two reports agree, or it was the first of its address."""
    past: tuple[Report, ...] = ()
    """Those from which a velocity is derived."""
    recognition: Recognition = Recognition()
    """Whether it is the ownship's own transponder."""

    @property
    def is_traffic(self) -> bool:
        """Whether it is to be kept clear of."""
        return self.is_confirmed and not self.recognition.is_ignored


def new_track(number: int, report: Report, *, is_first: bool) -> Track:
    """The track of a `number` that begins with a report; `is_first`: of its address."""
    return Track(number, report, is_first, (report,))


def extended_track(track: Track, report: Report, volume: Volume) -> Track:
    """The track with one more report of the aircraft; an older one changes nothing.

    `volume` is what to keep out of around an aircraft that reports everything.
    """
    if elapsed(track.report.time_ms, report.time_ms) < 0.0:
        return track
    newest = with_derived_velocity(report, track.past, volume)
    past = past_reports(track.past, report)
    return track._replace(report=newest, past=past, is_confirmed=True)


def nearest_fit(tracks: Iterable[Track], report: Report) -> Track | None:
    """The one of the tracks of an address that a report fits best; None: it fits none."""
    return min(
        (each for each in tracks if fits(each.report, report)),
        key=lambda each: miss_of(each.report, report),
        default=None,
    )


def fits(before: Report, after: Report) -> bool:
    """Whether both reports can come from one aircraft."""
    gap = abs(elapsed(before.time_ms, after.time_ms))
    return miss_of(before, after) <= JUMP_DISTANCE + JUMP_SPEED * gap


def miss_of(before: Report, after: Report) -> float:
    """Distance of a report from the prediction of another one [m].

    Of the difference of the heights, only what exceeds both doubts counts.
    """
    x, y, z = sub(placed_at(before, after.time_ms), after.intruder.p_n)
    return norm((x, y, max(0.0, abs(z) - before.height_doubt - after.height_doubt)))


def distance_from(track: Track, p_n: Vec3, time_ms: int) -> float:
    """Distance of the aircraft from a place, NED [m], at a time_boot_ms [ms], in [m]."""
    return norm(sub(placed_at(track.report, time_ms), p_n))
