"""Delay of the link: the time from a TIMESYNC question to the autopilot until its answer.

A state that arrives is as old as the downlink took, and a setpoint that is sent arrives after the
uplink: together they take a round trip, for which the clocks need not agree.
"""

from collections import deque
from statistics import median

from vfguide.geometry.units import NS_PER_US, US
from vfguide.link.messages import Timesync

QUESTION_INTERVAL = 200_000
"""Time between two TIMESYNC questions [us]; chosen."""
LONGEST_ROUND_TRIP = 4_000_000
"""Longest time until an answer that counts as one to our own question [us]; chosen."""
KEPT_ANSWERS = 5
"""Number of answers whose median is the delay; chosen, so that a late one is ignored."""
SLOW_LINK = 0.2
"""Delay above which the operator is warned that the gains are too high [s]; chosen."""


class RoundTrip:
    """The delay of one link, downlink and uplink together."""

    def __init__(self) -> None:
        self.delay = 0.0
        """Delay of both directions together [s]; 0 until the first answer."""
        self._asked_at: int | None = None
        self._latest: deque[int] = deque(maxlen=KEPT_ANSWERS)

    def due(self, now: int) -> list[Timesync]:
        """The question to send now [us], if it is time for one."""
        if self._asked_at is not None and now - self._asked_at < QUESTION_INTERVAL:
            return []
        self._asked_at = now
        return [Timesync(0, now * NS_PER_US)]

    def hear(self, now: int, message: Timesync) -> str | None:
        """Note an answer that arrives at `now` [us]; returns a note when the link becomes slow."""
        took = now - message.ts1 // NS_PER_US
        if message.tc1 == 0 or not 0 <= took <= LONGEST_ROUND_TRIP:
            return None
        before, self.delay = self.delay, self._with(took)
        if before <= SLOW_LINK < self.delay:
            return f"slow link: a setpoint acts {self.delay:.1f} s after the state it is made for"
        return None

    def _with(self, took: int) -> float:
        """The delay [s] after one more round trip, which took `took` [us]."""
        self._latest.append(took)
        return median(self._latest) * US
