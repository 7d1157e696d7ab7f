"""What the operator reads of setpoints: that they go out, or that they do not, and why.

A note says what has happened: "setpoints go out" comes when one has gone out.
"""

import re
from collections.abc import Callable

from vfguide.geometry.units import SECOND
from vfguide.telemetry.round_trip import RoundTrip

SILENCE_TIMEOUT = SECOND
"""Time without a setpoint after which the operator is told why [us]; chosen."""
SLOW = "slow link: a setpoint acts {delay:.1f} s after the state it is made for"
"""Note where the link is slow."""
SENT = "setpoints go out"
"""Note where the first setpoint has gone out."""
SENT_AGAIN = f"{SENT} again"
"""Note where setpoints go out after a silence that was told."""
NOT_SENT = "no setpoints: {why}"
"""Note where no setpoints go out though the autopilot may follow."""


class SetpointAnnunciator:
    """Makes notes of setpoints that go out or fail to, and remembers which it made."""

    def __init__(self) -> None:
        self._silent_from = 0
        """Time since when the present reason has held, or of the last setpoint [us]."""
        self._is_slow = False
        """Whether the operator knows that the link is slow."""
        self._has_sent = False
        """Whether a setpoint has gone out since the autopilot was found."""
        self._is_told = False
        """Whether the operator knows that setpoints go out."""
        self._why: str | None = None
        """Why none go out, as the operator was told."""

    def find(self, now: int) -> None:
        """Record that an autopilot was found at `now` [us]: it has got no setpoint yet."""
        self._has_sent = False
        self.rest(now)

    def rest(self, now: int) -> None:
        """Record at `now` [us] that none may go out, which the notes of the phase say already."""
        self._silent_from, self._is_told, self._why = now, False, None

    def stand_still(self, now: int) -> None:
        """Record that this program stood still until `now` [us], which is told as such."""
        self._silent_from = now

    def follow(self) -> None:
        """Record that the autopilot follows, so that the operator knows that setpoints go out."""
        self._is_told |= self._why is None

    def send(self, now: int, what_follows: Callable[[], str]) -> list[str]:
        """The note of a setpoint that goes out at `now` [us], and of what follows, if anything."""
        note = SENT_AGAIN if self._has_sent else SENT
        self._silent_from, self._has_sent, self._why = now, True, None
        if self._is_told:
            return []
        self._is_told, follows = True, what_follows()
        return [f"{note}, {follows}" if follows else note]

    def lag(self, link: RoundTrip) -> list[str]:
        """The note of a setpoint that goes out over a link that has become slow."""
        was_slow, self._is_slow = self._is_slow, link.is_slow
        return [SLOW.format(delay=link.delay)] if link.is_slow and not was_slow else []

    def is_silent(self, now: int) -> bool:
        """Whether none has gone out for so long at `now` [us] that the operator wants to know why.

        A reason that was told is followed by another one only after that time too.
        """
        return now - self._silent_from > SILENCE_TIMEOUT

    def fail(self, now: int, why: str) -> list[str]:
        """The note of a silence and its reason at `now` [us], where they are new."""
        before, self._why = self._why, why
        self._silent_from, self._is_told = now, False
        is_new = before is None or without_numbers(why) != without_numbers(before)
        return [NOT_SENT.format(why=why)] if is_new else []


def without_numbers(why: str) -> str:
    """A reason without its numbers, which change while it stays the same."""
    return re.sub(r"\d", "", why)
