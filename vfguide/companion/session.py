"""A companion behind bytes: what its link delivers, what it answers, and the record of both."""

from collections.abc import Callable, Sequence

from vfguide.companion.companion import HANDLED, Companion
from vfguide.link.codec import Encoder, Frame, Parser, decode
from vfguide.link.enums import MavComponent
from vfguide.link.messages import Message

Record = Callable[[int, Sequence[bytes]], None]
"""Takes a time [us since 1970] and the bytes of the frames that came or went then, at least one."""


AUTOPILOT = int(MavComponent.AUTOPILOT1)
"""Component number of the autopilot as a plain integer: the name of a member costs more time than
the rest of the comparison."""


class Session:
    """One companion on one link to its autopilot."""

    def __init__(self, companion: Companion, record: Record) -> None:
        """A session that has received nothing yet; `record` takes the frames in and out."""
        self.companion = companion
        self.parser = Parser()
        self._record = record
        self._encoder = Encoder(companion.sysid, MavComponent.PATHPLANNER)

    def receive(self, now: int, data: bytes) -> list[bytes]:
        """Takes bytes that arrived at `now` [us since 1970]; returns the frames to send."""
        return self._take_all(now, self.parser.feed(data))

    def take(self, now: int, frame: Frame) -> list[bytes]:
        """Takes a frame that arrived at `now` [us since 1970]; returns the frames to send."""
        return self._take_all(now, (frame,))

    def _take_all(self, now: int, frames: Sequence[Frame]) -> list[bytes]:
        """Takes frames in turn, and records them at the end, each before its answers.

        They are recorded even if one raises: the record of a fault has the frame that caused it.
        """
        vehicle, kept, answers = self.companion.sysid, list[bytes](), list[bytes]()
        try:
            for frame in frames:
                sysid, compid, _, msgid, _, raw, _ = frame
                if sysid != vehicle or compid != AUTOPILOT:
                    continue
                kept.append(raw)
                message = decode(frame) if msgid in HANDLED else None
                if message and (said := self.companion.receive(now, message)):
                    sent = self._encoded(said)
                    kept += sent
                    answers += sent
        finally:
            if kept:
                self._record(now, kept)
        return answers

    def recall(self, now: int, frame: Frame) -> list[bytes]:
        """Takes a frame that this companion sent at `now` [us since 1970], as a log has it.

        Returns the frames that are due then though nothing was received.
        """
        message = decode(frame)
        return self._send(now, self.companion.recall(now, message)) if message else []

    def poll(self, now: int) -> list[bytes]:
        """The frames that are due at `now` [us since 1970], though nothing was received."""
        return self._send(now, self.companion.poll(now))

    def stop(self, now: int) -> list[bytes]:
        """The operator ends the companion at `now` [us since 1970]; returns the frames to send."""
        return self._send(now, self.companion.stop(now))

    def _send(self, now: int, messages: Sequence[Message]) -> list[bytes]:
        """Encode and record what goes out."""
        frames = self._encoded(messages)
        if frames:
            self._record(now, frames)
        return frames

    def _encoded(self, messages: Sequence[Message]) -> list[bytes]:
        """The frames of messages, numbered."""
        return [self._encoder.encode(message) for message in messages]
