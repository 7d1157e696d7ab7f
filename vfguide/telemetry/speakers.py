"""Speakers: whether one autopilot alone speaks with the address of the vehicle.

Two of them behind one router have one address, and their messages are mixed: attitude of one,
position of the other. Their counters of the time since boot differ, so that the counter leaps from
one to the other and back again.
"""

from collections import deque

from vfguide.geometry.units import SECOND
from vfguide.link.boot_time import BootClock

RETURNS = 8
"""Number of leaps of the counter back to where it was before, within RETURN_TIME, that show two
autopilots; chosen above what single wrong counters make."""
RETURN_TIME = SECOND
"""Time within which the leaps of the counter have to come [us]; chosen, attitudes come 10 times a
second or more."""
ALONE_AFTER = 10 * SECOND
"""Time since the counter last leapt so often after which one speaks alone again [us]; chosen."""
TWO_SPEAK = "more than one autopilot speaks as vehicle {sysid}: their clocks differ"
"""Reason for silence where it is unknown which of the autopilots sent a message."""


class Speakers:
    """Watches the counter of one vehicle."""

    def __init__(self) -> None:
        self._returns: deque[int] = deque(maxlen=RETURNS)
        self._two_at: int | None = None

    def hear(self, now: int, before: BootClock | None, after: BootClock | None) -> None:
        """Note the clock around a message that arrives at `now` [us]."""
        if before is None or after is None or before.returns == after.returns:
            return
        self._returns.append(now)
        if len(self._returns) == RETURNS and now - min(self._returns) <= RETURN_TIME:
            self._two_at = now

    def are_two(self, now: int) -> bool:
        """Whether more than one speaks at `now` [us]."""
        return self._two_at is not None and now - self._two_at <= ALONE_AFTER
