"""Delay of the link: the time from a TIMESYNC question to the autopilot until its answer.

A state that arrives is as old as the downlink took, and a setpoint that is sent arrives after the
uplink: together they take a round trip, for which the clocks need not agree.

Others ask the same autopilot, and a router brings the answers to everybody: an answer counts only
if it has the stamp of an open question of our own, and only once.

Between two answers the states themselves show a downlink that becomes slower: they come later than
the fastest one did. Where no answer comes though states do, the delay is unknown.

F. Cristian, Probabilistic Clock Synchronization, 1989: what a round trip says of a remote clock.
"""

from collections import deque
from statistics import median, median_low

from vfguide.geometry.units import NS_PER_US, US
from vfguide.link.boot_time import US_PER_MS
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
MAX_UNANSWERED = 15
"""Number of questions in a row without an answer, while states arrive, after which the delay counts
as unknown; chosen, 3 s: where 30 % are lost each way, as many are lost in a row once in three
hours."""
TOO_LATE = "the attitudes arrive {late:.1f} s late"
"""Reason for silence where the states are too old when they arrive."""
UNANSWERED = "the autopilot does not answer TIMESYNC, so that the delay of the link is unknown"
"""Reason for silence where the delay is not measured, or not any more."""


class RoundTrip:
    """The delay of one link, downlink and uplink together."""

    def __init__(self) -> None:
        self.delay = 0.0
        """Delay of both directions together [s]; 0 until the second answer."""
        self.lateness = 0.0
        """Time by which the newest state came later than the fastest [s]."""
        self.is_too_slow = False
        """Whether nothing can be guided over it: above TOO_SLOW_LINK, until the latest answers all
        took less than SLOW_LINK."""
        self.is_slow = False
        """Whether the gains are too high for it: above SLOW_LINK, until it is below FAST_LINK."""
        self._asked_at: int | None = None
        self._open: deque[int] = deque(maxlen=LONGEST_ROUND_TRIP // QUESTION_INTERVAL)
        self._latest: deque[int] = deque(maxlen=KEPT_ANSWERS)
        self._unanswered = 0
        """Number of questions since the last answer before which a state arrived."""
        self._has_state = False
        """Whether a state has arrived since the last question."""
        self._offset = 0
        """Our own clock less that of the newest state, when it arrived [us]."""
        self._least_offset: int | None = None
        """Our own clock less that of the fastest state, when it arrived [us]."""

    @property
    def lead(self) -> float:
        """Age that the newest state will have when its setpoint acts [s]."""
        return max(self.delay, self.lateness)

    @property
    def is_known(self) -> bool:
        """Whether a setpoint can be made for the newest state: its age is known, and it is new."""
        return bool(self._latest) and self.lateness <= TOO_SLOW_LINK

    @property
    def objection(self) -> str | None:
        """Why no setpoint can be made for the newest state; None: one can."""
        if self.is_known:
            return None
        return TOO_LATE.format(late=self.lateness) if self._latest else UNANSWERED

    @property
    def is_unanswered(self) -> bool:
        """Whether the delay is unknown, for no answers come though states do."""
        return self._unanswered > MAX_UNANSWERED

    def due(self, now: int) -> list[Timesync]:
        """The question to send now [us], if it is time for one."""
        if self._asked_at is not None and now - self._asked_at < QUESTION_INTERVAL:
            return []
        question = Timesync(0, now * NS_PER_US)
        self.asked(question)
        return [question]

    def asked(self, question: Timesync) -> None:
        """Note a question of our own: one that goes out, or that a log says went out."""
        if question.ts1 in self._open:
            return
        self._asked_at = question.ts1 // NS_PER_US
        self._open.append(question.ts1)
        self._unanswered += self._has_state
        self._has_state = False

    def forget_questions(self) -> None:
        """Take no answer to what was asked so far: how long it waited here is not known."""
        self._open.clear()
        self._unanswered = 0

    def hear_state(self, now: int, time_ms: int) -> None:
        """Note a state of the autopilot's time `time_ms` [ms] that arrives at `now` [us]."""
        self._has_state = True
        self._offset = now - time_ms * US_PER_MS
        least = self._offset if self._least_offset is None else self._least_offset
        self._set_least(min(least, self._offset))

    def hear(self, now: int, message: Timesync) -> None:
        """Note an answer that arrives at `now` [us]."""
        if message.tc1 <= 0 or message.ts1 not in self._open:
            return
        self._open.remove(message.ts1)
        took = now - message.ts1 // NS_PER_US
        if not 0 <= took <= LONGEST_ROUND_TRIP:
            return
        self._unanswered = 0
        self._bound_lateness(took)
        self.delay = self._with(took)
        left = max(self._latest) * US < SLOW_LINK
        self.is_too_slow = not left if self.is_too_slow else self.delay > TOO_SLOW_LINK
        self.is_slow = self.delay > (FAST_LINK if self.is_slow else SLOW_LINK)

    def _bound_lateness(self, took: int) -> None:
        """Bound the lateness by a whole round trip, so that the two clocks may drift apart."""
        if self._least_offset is not None:
            self._set_least(max(self._least_offset, self._offset - took))

    def _set_least(self, offset: int) -> None:
        self._least_offset = offset
        self.lateness = (self._offset - offset) * US

    def _with(self, took: int) -> float:
        """The delay [s] after one more round trip, which took `took` [us].

        No single one moves it: the first alone counts for nothing, of two the shorter counts.
        """
        self._latest.append(took)
        kept = len(self._latest)
        if kept == 1:
            return 0.0
        return (median_low if kept == 2 else median)(self._latest) * US
