"""Delay of the link: the time from a TIMESYNC question to the autopilot until its answer.

A state that arrives is as old as the downlink took, and a setpoint that is sent arrives after the
uplink: together they take a round trip, for which the clocks need not agree.

Others ask the same autopilot, and a router brings the answers to everybody: only the stamp of a
question of our own that is still open makes an answer, and each counts once.
"""

from collections import deque
from statistics import median, median_low

from vfguide.geometry.units import NS_PER_US, US
from vfguide.link.messages import Timesync

QUESTION_INTERVAL = 200_000
"""Time between two TIMESYNC questions [us]; chosen."""
LONGEST_ROUND_TRIP = 4_000_000
"""Longest time until an answer that counts as one to our own question [us]; chosen."""
KEPT_ANSWERS = 5
"""Number of answers whose median is the delay; chosen, so that two late ones are ignored."""
SLOW_LINK = 0.2
"""Delay above which the operator is warned that the gains are too high [s]; chosen."""
FAST_LINK = 0.1
"""Delay below which a slow link is none any more [s]; chosen below SLOW_LINK, so that one about
there is told once."""
TOO_SLOW_LINK = 0.5
"""Delay above which nothing is guided [s]; chosen above 0.4, with which goals are missed by tens of
metres, and below 0.8, with which a prototype rolled inverted."""


class RoundTrip:
    """The delay of one link, downlink and uplink together."""

    def __init__(self) -> None:
        self.delay = 0.0
        """Delay of both directions together [s]; 0 until the second answer."""
        self.is_too_slow = False
        """Whether nothing can be guided over it: above TOO_SLOW_LINK, until it is below SLOW_LINK
        again."""
        self.is_slow = False
        """Whether the gains are too high for it: above SLOW_LINK, until it is below FAST_LINK."""
        self._asked_at: int | None = None
        self._open: deque[int] = deque(maxlen=LONGEST_ROUND_TRIP // QUESTION_INTERVAL)
        self._latest: deque[int] = deque(maxlen=KEPT_ANSWERS)

    def due(self, now: int) -> list[Timesync]:
        """The question to send now [us], if it is time for one."""
        if self._asked_at is not None and now - self._asked_at < QUESTION_INTERVAL:
            return []
        question = Timesync(0, now * NS_PER_US)
        self._asked_at = now
        self.asked(question)
        return [question]

    def asked(self, question: Timesync) -> None:
        """Note a question of our own: one that goes out, or that a log says went out."""
        if question.ts1 not in self._open:
            self._open.append(question.ts1)

    def forget_questions(self) -> None:
        """Take no answer to what was asked so far: how long it waited here is not known."""
        self._open.clear()

    def hear(self, now: int, message: Timesync) -> None:
        """Note an answer that arrives at `now` [us]."""
        if message.tc1 <= 0 or message.ts1 not in self._open:
            return
        self._open.remove(message.ts1)
        took = now - message.ts1 // NS_PER_US
        if not 0 <= took <= LONGEST_ROUND_TRIP:
            return
        self.delay = self._with(took)
        self.is_too_slow = self.delay > (SLOW_LINK if self.is_too_slow else TOO_SLOW_LINK)
        self.is_slow = self.delay > (FAST_LINK if self.is_slow else SLOW_LINK)

    def _with(self, took: int) -> float:
        """The delay [s] after one more round trip, which took `took` [us].

        No single one moves it: the first alone counts for nothing, of two the shorter counts.
        """
        self._latest.append(took)
        kept = len(self._latest)
        if kept == 1:
            return 0.0
        return (median_low if kept == 2 else median)(self._latest) * US
