"""Delay line: one direction of a link that delivers frames in order, after a delay."""

from collections import deque
from collections.abc import Sequence


class DelayLine:
    """Frames in transit. Times in us."""

    def __init__(self, delay: int) -> None:
        """An empty line that holds every frame for `delay` [us]."""
        self._delay = delay
        self._on_the_way: deque[tuple[int, bytes]] = deque()
        """Times of arrival, and the frames that were put in at once."""

    def send(self, now: int, frames: Sequence[bytes]) -> None:
        """Put frames in at `now`."""
        if frames:
            self._on_the_way.append((now + self._delay, b"".join(frames)))

    def arrived(self, now: int) -> bytes:
        """Take out what has arrived at `now`, one frame after the other."""
        arrived, on_the_way = b"", self._on_the_way
        while on_the_way:
            due, frames = on_the_way.popleft()
            if due > now:
                on_the_way.appendleft((due, frames))
                break
            arrived += frames
        return arrived
