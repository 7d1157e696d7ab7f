"""Annunciations of the autopilot's clock and date where they go wrong."""

from vfguide.geometry.units import MS, US
from vfguide.telemetry.date import LEAP_LASTS
from vfguide.telemetry.knowledge import Knowledge

LEAP_NOTE_INTERVAL = 10_000
"""Least time between two notes of leaps of the counter, or of the date [ms]; chosen."""
COUNTER_LEAPT = "the autopilot's clock has leapt by {leap:+.0f} s: not followed"
"""Note where the time since boot leaps, as after a restart of the autopilot."""
DATE_LEAPT = (
    "the autopilot's date has leapt by {leap:+.0f} s: not followed unless it lasts {lasts:.0f} s"
)
"""Note where the date does not agree with the time since boot."""
DATE_FOLLOWED = "the autopilot's new date has lasted: followed"
"""Note where the date has leapt and stayed so."""


class TimeAnnunciator:
    """Makes notes of leaps, and remembers when it made the last one."""

    def __init__(self) -> None:
        self._told: int | None = None
        self._told_date: int | None = None

    def notes(self, before: Knowledge, after: Knowledge) -> list[str]:
        """The notes of one message, from what was known around it."""
        if after.clock is not before.clock:
            return self._counter_notes(before, after)
        was, now = before.date, after.date
        if was is None or now is None or now.leap == was.leap:
            return []
        if now.leap:
            return self._date_notes(now.leap, after.time_ms)
        leapt = now.unix - was.unix - (now.time_ms - was.time_ms) * (MS / US)
        return [DATE_FOLLOWED] if abs(leapt - was.leap) < abs(leapt) else []

    def _date_notes(self, leap: int, now: int) -> list[str]:
        """The note of a date that has leapt, by `leap` [us], at the autopilot's time `now` [ms]."""
        if self._told_date is not None and now - self._told_date < LEAP_NOTE_INTERVAL:
            return []
        self._told_date = now
        return [DATE_LEAPT.format(leap=leap * US, lasts=LEAP_LASTS * MS)]

    def _counter_notes(self, before: Knowledge, after: Knowledge) -> list[str]:
        """The note of a leap, none where the counter leaps back."""
        clock, was = after.clock, before.clock
        if clock is None or was is None or clock.leaps == was.leaps:
            return []
        if clock.returns != was.returns:
            return []
        if self._told is not None and clock.time_ms - self._told < LEAP_NOTE_INTERVAL:
            return []
        self._told = clock.time_ms
        return [COUNTER_LEAPT.format(leap=clock.leap)]
