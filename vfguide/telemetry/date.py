"""The date that an autopilot reports, checked against its own counter of the time since boot.

SYSTEM_TIME has both, and they must go on by the same time. A date that leaps, as after a wrong week
of the GPS, is not believed until it has lasted.
"""

from typing import NamedTuple

from vfguide.geometry.units import MS, SECOND, US
from vfguide.link.boot_time import US_PER_MS, BootClock, counted
from vfguide.link.messages import SystemTime

FIRST_DATE = 946_684_800_000_000
"""Earliest date that counts as one, the year 2000 [us since 1970]; chosen, since clocks that were
never set are earlier."""
LAST_DATE = 7_258_118_400_000_000
"""Date from which on a date counts as none, the year 2200 [us since 1970]; chosen as in
scenarios."""
TOLERANCE = SECOND
"""Largest difference between date and counter that is no leap [us]; chosen above leap seconds and
what a clock that is set anew after its first fix is off."""
LEAP_LASTS = 60_000
"""Time for which a date that has leapt must last before it is followed [ms]; chosen above the
seconds that wrong weeks of the GPS were seen for."""


class Date(NamedTuple):
    """A date, and when it was so."""

    unix: int
    """The date [us since 1970]."""
    time_ms: int
    """When it was so, on the clock of the autopilot [ms]."""
    boot_ms: int
    """The time_boot_ms in the same message [ms]."""
    leap: int = 0
    """By how much the dates that are reported now differ from this one [us]; 0: they do not."""
    since: int = 0
    """When a date that differs so was first reported [ms]."""

    def at(self, time_ms: int, epoch: int) -> float:
        """Time from `epoch` [us since 1970] until a time of the autopilot [s]."""
        return (self.unix - epoch) * US + (time_ms - self.time_ms) * MS


def date_after(before: Date | None, said: SystemTime, clock: BootClock | None) -> Date | None:
    """The date after a SYSTEM_TIME; the autopilot's `clock` is None before it is known."""
    if not FIRST_DATE <= said.time_unix_usec < LAST_DATE:
        return before
    time_ms = said.time_boot_ms if clock is None else clock.at(said.time_boot_ms)
    newest = Date(said.time_unix_usec, time_ms, said.time_boot_ms)
    if before is None:
        return newest
    leap = newest.unix - before.unix - (time_ms - before.time_ms) * US_PER_MS
    if abs(leap) <= TOLERANCE or is_backlog(before, newest):
        return newest
    if before.leap == 0 or abs(leap - before.leap) > TOLERANCE:
        return before._replace(leap=leap, since=time_ms)
    return newest if time_ms - before.since >= LEAP_LASTS else before


def is_backlog(before: Date, newest: Date) -> bool:
    """Whether date and counter moved on by the same time, as where messages between were lost."""
    moved, counter = newest.unix - before.unix, counted(before.boot_ms, newest.boot_ms)
    return 0 < counter < LEAP_LASTS and abs(moved - counter * US_PER_MS) <= TOLERANCE
