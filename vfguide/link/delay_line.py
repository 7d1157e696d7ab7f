"""Delay line: one direction of a link that delivers frames in order, after a delay."""

from collections import deque
from collections.abc import Sequence


class DelayLine:
    """Frames in transit. Times in us."""

    def __init__(self, delay: int) -> None:
        """An empty line that holds every frame for `delay` [us]."""
        self._delay = delay
        self._in_transit: deque[tuple[int, bytes]] = deque()
        """Times of arrival, and the frames that were put in at once."""

    def send(self, now: int, frames: Sequence[bytes]) -> None:
        """Put frames in at `now`."""
        if frames:
            self._in_transit.append((now + self._delay, b"".join(frames)))

    def arrived(self, now: int) -> bytes:
        """Take out what has arrived at `now`, one frame after the other."""
        arrived, in_transit = b"", self._in_transit
        while in_transit:
            due, frames = in_transit.popleft()
            if due > now:
                in_transit.appendleft((due, frames))
                break
            arrived += frames
        return arrived
