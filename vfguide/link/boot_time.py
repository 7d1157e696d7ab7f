"""The clock of an autopilot on MAVLink: milliseconds since it booted.

The counter rolls over, begins anew when the autopilot restarts, and messages come twice, late or
with a wrong one. `BootClock` is the one place where it becomes a time that never goes back.
"""

from typing import NamedTuple

from vfguide.geometry.units import MS
from vfguide.kernels.written_functions import maker

ROLLOVER = 2**32
"""Number of milliseconds after which time_boot_ms begins again, 49.7 days."""
LATE_TIME = 2000
"""Time by which a message may be late and is only ignored [ms]; chosen. One that is from longer ago
tells that the counter began anew."""
AHEAD = 2000
"""Time by which the counter may get ahead of our own clock from one message to the next [ms];
chosen, since what waited on the way comes at once. What it was behind comes on top: where much
waited and the rest was lost, the counter goes on from the past to the present at once."""
SAME_TIMELINE = 500
"""Largest difference between our own clock and a counter that goes on where it did before a leap
[ms]; chosen as the age above which no state is flown on."""
US_PER_MS = 1000
"""Number of microseconds in a millisecond, a ratio."""


def counted(before_ms: int, after_ms: int) -> int:
    """Time from one time_boot_ms to another [ms], also across the rollover."""
    half = ROLLOVER // 2
    return (after_ms - before_ms + half) % ROLLOVER - half


def elapsed(before_ms: int, after_ms: int) -> float:
    """Time from one time_boot_ms to another [s], also across the rollover."""
    return counted(before_ms, after_ms) * MS


class BootClock(NamedTuple):
    """A time made of the counter, which never goes back and never runs ahead of our own clock."""

    counter: int
    """The newest time_boot_ms [ms]."""
    time_ms: int
    """The time then: the counter without its rollovers and leaps [ms]."""
    heard: int
    """Time when it was heard on our own clock [us]."""
    leaps: int = 0
    """How often the counter has leapt."""
    leap: float = 0.0
    """By how much it leapt last [s]."""
    left: int | None = None
    """Counter less our own clock before the last leap [ms]."""
    returns: int = 0
    """How often it has leapt back to where it went on before the leap."""
    behind: int = 0
    """Time by which the counter is behind our own clock, where messages are late [ms]. Our own
    time is rounded down at each of them, so that this ends by itself, and clocks that drift apart
    are not taken for it."""

    def at(self, boot_ms: int) -> int:
        """The time at another time_boot_ms [ms]."""
        return self.time_ms + counted(self.counter, boot_ms)


_boot_clock = maker(BootClock)


def is_late(before_ms: int, after_ms: int) -> bool:
    """Whether a message with the time_boot_ms `after_ms` is older than one with `before_ms`."""
    return -LATE_TIME < counted(before_ms, after_ms) < 0


def moved_on(clock: BootClock | None, boot_ms: int, now: int) -> BootClock | None:
    """The clock after a message that says `boot_ms` and arrives at `now` [us] on our own clock.

    None: the message is one that was heard before, or late. Where the counter leaps, the time goes
    on by our own clock.
    """
    if clock is None:
        return BootClock(boot_ms, boot_ms, now)
    counter, time_ms, heard, leaps, leap, left, returns, behind = clock
    step, own = counted(counter, boot_ms), max(now - heard, 0) // US_PER_MS
    if -LATE_TIME < step <= 0:
        return None
    if 0 < step <= own + behind + AHEAD:
        behind = max(behind + own - step, 0)
        return _boot_clock((boot_ms, time_ms + step, now, leaps, leap, left, returns, behind))
    before, ahead = counter - heard // US_PER_MS, boot_ms - now // US_PER_MS
    back = left is not None and abs(counted(left, ahead)) <= SAME_TIMELINE
    leap = (step - own) * MS
    return BootClock(boot_ms, time_ms + own, now, leaps + 1, leap, before, returns + back)
