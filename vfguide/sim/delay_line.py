"""Delay line: one direction of a link that delivers frames in order, after a delay."""

from collections import deque
from collections.abc import Sequence
from typing import NamedTuple


class Parcel(NamedTuple):
    """Frames that were put in at once."""

    due: int
    """Time of arrival [us]."""
    frames: bytes


class DelayLine:
    """Frames in transit. Times in us."""

    def __init__(self, delay: int) -> None:
        """An empty line that holds every frame for `delay` [us]."""
        self._delay = delay
        self._in_transit: deque[Parcel] = deque()

    def send(self, now: int, frames: Sequence[bytes]) -> None:
        """Put frames in at `now`."""
        if frames:
            self._in_transit.append(Parcel(now + self._delay, b"".join(frames)))

    def arrived(self, now: int) -> bytes:
        """Take out what has arrived at `now`, one frame after the other."""
        arrived = b""
        while self._in_transit and self._in_transit[0].due <= now:
            arrived += self._in_transit.popleft().frames
        return arrived
