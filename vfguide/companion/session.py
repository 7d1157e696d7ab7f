"""A companion behind bytes: what its link delivers, what it answers, and the record of both."""

from collections.abc import Callable, Iterable

from vfguide.companion.companion import HANDLED, Companion
from vfguide.link.codec import Encoder, Frame, Parser, decode
from vfguide.link.enums import MavComponent
from vfguide.link.messages import Message

Record = Callable[[int, bytes], None]
"""Takes the time [us since 1970] and the bytes of one frame."""


AUTOPILOT = int(MavComponent.AUTOPILOT1)
"""Component number of the autopilot as a plain integer: the name of a member costs more time than
the rest of the comparison."""


class Session:
    """One companion on one link to its autopilot."""

    def __init__(self, companion: Companion, record: Record) -> None:
        """A session that has received nothing yet; `record` takes each frame in and out."""
        self.companion = companion
        self.parser = Parser()
        self._record = record
        self._encoder = Encoder(companion.sysid, MavComponent.PATHPLANNER)

    def receive(self, now: int, data: bytes) -> list[bytes]:
        """Takes bytes that arrived at `now` [us since 1970]; returns the frames to send."""
        return [answer for frame in self.parser.feed(data) for answer in self.take(now, frame)]

    def take(self, now: int, frame: Frame) -> list[bytes]:
        """Takes a frame that arrived at `now` [us since 1970]; returns the frames to send."""
        if frame.sysid != self.companion.sysid or frame.compid != AUTOPILOT:
            return []
        self._record(now, frame.raw)
        message = decode(frame) if frame.msgid in HANDLED else None
        answers = self.companion.receive(now, message) if message else []
        return self._send(now, answers) if answers else []

    def recall(self, now: int, frame: Frame) -> list[bytes]:
        """Takes a frame of its own that a log says went out at `now` [us since 1970].

        Returns the frames to send without anything received then.
        """
        message = decode(frame)
        return self._send(now, self.companion.recall(now, message)) if message else []

    def poll(self, now: int) -> list[bytes]:
        """The frames that are due at `now` [us since 1970] without anything received."""
        return self._send(now, self.companion.poll(now))

    def stop(self, now: int) -> list[bytes]:
        """The operator ends the companion at `now` [us since 1970]; returns the frames to send."""
        return self._send(now, self.companion.stop(now))

    def _send(self, now: int, messages: Iterable[Message]) -> list[bytes]:
        """Encode and record what goes out."""
        frames = [self._encoder.encode(message) for message in messages]
        for frame in frames:
            self._record(now, frame)
        return frames
