"""Speakers: whether one autopilot alone speaks with the address of the vehicle.

Two of them behind one router have one address, and their messages are mixed: attitude of one,
position of the other. Their counters of the time since boot differ, unless they were switched on
together, and so do their places: counter or place leaps from one to the other and back again.
"""

import math
from collections import deque

from vfguide.earth.projection import EARTH_RADIUS
from vfguide.geometry.angles import wrap
from vfguide.geometry.units import CM_S, DEG_E7, SECOND
from vfguide.link.boot_time import BootClock, elapsed
from vfguide.link.messages import GlobalPositionInt

RETURNS = 8
"""Number of leaps back to where it was before, of the counter within RETURN_TIME or of the place
within PLACE_TIME, that show two autopilots; chosen above what single wrong messages make."""
RETURN_TIME = SECOND
"""Time within which the leaps of the counter have to come [us]; chosen, attitudes come 10 times a
second or more."""
PLACE_TIME = 4 * SECOND
"""Time within which the leaps of the place have to come [us]; chosen, GLOBAL_POSITION_INT comes
twice a second or more where two are to be told apart by it."""
ELSEWHERE = 50.0
"""Distance from where a vehicle should be by its last place and velocity, above which it is at
another place [m]; chosen above what a turn makes of the two seconds for which that is asked."""
LONGEST_BETWEEN = 2.0
"""Longest time between two places of one vehicle that are compared [s]; chosen, since two whose
counters are farther apart than that are known by their counters."""
ALONE_AFTER = 10 * SECOND
"""Time since counter or place last leapt so often after which one speaks alone again [us];
chosen."""
TWO_SPEAK = "more than one autopilot speaks as vehicle {sysid}: their {what} differ"
"""Reason for silence where it is unknown which of the autopilots sent a message."""
CLOCKS = "clocks"
"""Text for what differs where counters leap (no unit)."""
PLACES = "places"
"""Text for what differs where places leap (no unit)."""


class Speakers:
    """Watches counter and place of one vehicle."""

    def __init__(self) -> None:
        self.what = CLOCKS
        """By what two were last told apart."""
        self._returns: deque[int] = deque(maxlen=RETURNS)
        self._place_returns: deque[int] = deque(maxlen=RETURNS)
        self._left: GlobalPositionInt | None = None
        """The place before the last leap."""
        self._two_at: int | None = None

    def hear(self, now: int, before: BootClock | None, after: BootClock | None) -> None:
        """Note the clock around a message that arrives at `now` [us]."""
        if before is None or after is None or before.returns == after.returns:
            return
        self._count(self._returns, RETURN_TIME, now, CLOCKS)

    def hear_place(
        self, now: int, before: GlobalPositionInt | None, after: GlobalPositionInt
    ) -> None:
        """Note the place before a message that arrives at `now` [us], and the one it tells."""
        if before is None or goes_on(before, after):
            return
        if self._left is not None and goes_on(self._left, after):
            self._count(self._place_returns, PLACE_TIME, now, PLACES)
        self._left = before

    def _count(self, returns: deque[int], within: int, now: int, what: str) -> None:
        """Count a leap back at `now` [us]; RETURNS of them `within` a time [us] are of two."""
        returns.append(now)
        if len(returns) == RETURNS and now - min(returns) <= within:
            self._two_at, self.what = now, what

    def are_two(self, now: int) -> bool:
        """Whether more than one speaks at `now` [us]."""
        return self._two_at is not None and now - self._two_at <= ALONE_AFTER


def goes_on(before: GlobalPositionInt, after: GlobalPositionInt) -> bool:
    """Whether two places are of one vehicle that has flown on."""
    dt = elapsed(before.time_boot_ms, after.time_boot_ms)
    if abs(dt) > LONGEST_BETWEEN:
        return False
    north = (after.lat - before.lat) * DEG_E7 * EARTH_RADIUS
    east = wrap((after.lon - before.lon) * DEG_E7) * math.cos(after.lat * DEG_E7) * EARTH_RADIUS
    return math.hypot(north - before.vx * CM_S * dt, east - before.vy * CM_S * dt) <= ELSEWHERE
