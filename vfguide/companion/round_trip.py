"""How late the link is: the time from a question to the autopilot until its answer.

A state that arrives now is as old as the way down took, and a setpoint sent now arrives after the
way back: together the round trip, for which the clocks need not agree.
"""

from collections import deque
from statistics import median

from vfguide.geometry.units import US
from vfguide.link.messages import Timesync

NANOSECONDS = 1000
"""In a microsecond."""
EVERY = 200_000
"""Between two questions [us]."""
LONGEST = 4_000_000
"""A longer round trip is the answer to somebody else's question [us]."""
KEPT = 5
"""The delay is the median of so many answers."""
SLOW = 0.2
"""With more delay than this the gains are too high [s]."""


class RoundTrip:
    """The delay of one link, both ways together."""

    def __init__(self) -> None:
        self.delay = 0.0
        """[s]; 0 until the first answer."""
        self._asked_at: int | None = None
        self._latest: deque[int] = deque(maxlen=KEPT)

    def due(self, now: int) -> list[Timesync]:
        """The question to send now [us], if it is time for one."""
        if self._asked_at is not None and now - self._asked_at < EVERY:
            return []
        self._asked_at = now
        return [Timesync(0, now * NANOSECONDS)]

    def hear(self, now: int, message: Timesync) -> str | None:
        """Note an answer that arrives at `now` [us]; returns a note when the link becomes slow."""
        took = now - message.ts1 // NANOSECONDS
        if message.tc1 == 0 or not 0 <= took <= LONGEST:
            return None
        before, self.delay = self.delay, self._with(took)
        if before <= SLOW < self.delay:
            return f"slow link: a setpoint acts {self.delay:.1f} s after the state it is made for"
        return None

    def _with(self, took: int) -> float:
        """The delay when one more round trip took so long."""
        self._latest.append(took)
        return median(self._latest) * US
