"""Frames in a stream of bytes: found, checked, counted; MAVLink 1 and 2, signed or not.

A frame is true if its checksum is, whatever precedes or follows it. Nothing that a peer sends
raises: what is wrong with the stream is counted (`LinkCounters`).

The wire (n bytes of payload, checksum over all but the magic byte, then the CRC_EXTRA byte):

    MAVLink 1: FE n seq sysid compid msgid(1) payload checksum(2)
    MAVLink 2: FD n incompat compat seq sysid compid msgid(3) payload checksum(2) [signature(13)]
"""

import re
import struct
from collections.abc import Callable
from dataclasses import dataclass, field
from enum import Enum, auto
from functools import partial
from typing import NamedTuple

from fastcrc.crc16 import mcrf4xx

from vfguide.link.dialect import CRC_EXTRA

MAGIC_1 = 0xFE
"""First byte of a frame of MAVLink 1, as a number (MAV_STX)."""
MAGIC_2 = 0xFD
"""First byte of a frame of MAVLink 2, as a number (MAV_STX)."""
SIGNED = 0x01
"""Incompatibility flag of a frame whose checksum is followed by 13 bytes of signature
(MAVLINK_IFLAG_SIGNED), the only one that is defined."""

_MAGICS = (MAGIC_2, MAGIC_1)
_MAGIC = re.compile(b"[\xfd\xfe]")
_HEADER_1 = struct.Struct("<6B")
_HEADER_2 = struct.Struct("<7BHB")


class Frame(NamedTuple):
    """One frame whose checksum is right."""

    sysid: int
    """System of the sender."""
    compid: int
    """Component of the sender."""
    seq: int
    """Number of the frame among those of its sender, 0 to 255."""
    msgid: int
    """Id of the message."""
    payload: bytes
    """Fields as on the wire: MAVLink 2 cuts zeros off their end."""
    raw: bytes
    """The whole frame, a signature included."""
    version: int
    """Version of MAVLink, 1 or 2."""

    @property
    def signed(self) -> bool:
        """Whether it carries a signature, which is not checked."""
        return self.version == 2 and bool(self.raw[2] & SIGNED)


_frame: Callable[[tuple[int, int, int, int, bytes, bytes, int]], Frame]
_frame = partial(tuple.__new__, Frame)
"""Frame of its values: the class called by its name takes three times as long."""


class Flaw(Enum):
    """Why no frame can be read at a place that looks like the start of one."""

    INCOMPLETE = auto()
    """More bytes are needed to decide."""
    FOREIGN = auto()
    """Undefined flags: its length cannot be known."""
    UNKNOWN = auto()
    """A message that the dialect does not have: its checksum cannot be known."""
    BAD_CRC = auto()


def frame_length(data: bytes, start: int) -> int:
    """Length of the frame at `start` by what its first three bytes say, `start` on its magic."""
    if data[start] == MAGIC_1:
        return data[start + 1] + 8
    return data[start + 1] + (25 if data[start + 2] & SIGNED else 12)


def frame_at(data: bytes, start: int) -> Frame | Flaw:
    """The frame that begins at `start`, where its magic byte must be, or why there is none."""
    if len(data) - start < 3:
        return Flaw.INCOMPLETE
    if data[start] == MAGIC_2 and data[start + 2] & ~SIGNED:
        return Flaw.FOREIGN
    whole = frame_length(data, start)
    raw = data[start : start + whole]
    if len(raw) < whole:
        return Flaw.INCOMPLETE
    if raw[0] == MAGIC_2:
        begin, version = 10, 2
        _, length, _, _, seq, sysid, compid, low, high = _HEADER_2.unpack_from(raw)
        msgid = low | high << 16
    else:
        begin, version = 6, 1
        _, length, seq, sysid, compid, msgid = _HEADER_1.unpack_from(raw)
    extra = CRC_EXTRA.get(msgid)
    if extra is None:
        return Flaw.UNKNOWN
    end = begin + length
    if mcrf4xx(raw[1:end] + extra) != raw[end] | raw[end + 1] << 8:
        return Flaw.BAD_CRC
    return _frame((sysid, compid, seq, msgid, raw[begin:end], raw, version))


def next_magic(data: bytes, position: int) -> int:
    """Where the next frame may begin, at `position` or behind it; len(data) if nowhere."""
    found = _MAGIC.search(data, position)
    return found.start() if found else len(data)


@dataclass(slots=True)
class LinkCounters:
    """What has come in so far, good and bad."""

    frames: int = 0
    """Number of good frames."""
    bad_crc: int = 0
    """Number of places that look like a frame but for the checksum."""
    unknown: int = 0
    """Number of frames of messages that the dialect does not have."""
    junk_bytes: int = 0
    """Number of bytes that belong to no frame."""
    lost: dict[tuple[int, int], int] = field(default_factory=dict[tuple[int, int], int])
    """Number of frames that are missing by their sequence numbers, by (sysid, compid)."""


class Parser:
    """Finds the frames of one stream, however it is cut into pieces.

    Behind a place that turns out to be no frame the search goes on with the very next byte: junk
    never costs a true frame, though it may keep one back until 280 bytes more are there.
    """

    def __init__(self) -> None:
        self.counters = LinkCounters()
        self._rest = b""
        self._unknown_end = 0  # in _rest: up to here an unknown frame claims the bytes
        self._last_seq: dict[tuple[int, int], int] = {}

    def feed(self, data: bytes, *, whole: bool = False) -> list[Frame]:
        """Takes the next bytes of the stream; returns the frames that they complete.

        `whole`: nothing of what ends here goes on in the next piece, as with a datagram; what is
        incomplete is junk.
        """
        buffer = self._rest + data
        frames: list[Frame] = []
        position = 0
        while position < len(buffer):
            if buffer[position] not in _MAGICS:
                start = next_magic(buffer, position)
                self._skip(position, start)
                position = start
                continue
            found = frame_at(buffer, position)
            if isinstance(found, Frame):
                frames.append(found)
                self._count(found)
                position += len(found.raw)
            elif found is Flaw.INCOMPLETE and not whole:
                break
            else:
                self._reject(found, buffer, position)
                position += 1
        self._rest = buffer[position:]
        self._unknown_end = max(0, self._unknown_end - position)
        return frames

    def _skip(self, start: int, end: int) -> None:
        """Counts bytes of no frame."""
        if start < end:
            self.counters.junk_bytes += max(0, end - max(start, self._unknown_end))

    def _reject(self, flaw: Flaw, buffer: bytes, start: int) -> None:
        """Counts a place that is no frame, unless it lies within an unknown frame."""
        if start >= self._unknown_end:
            if flaw is Flaw.UNKNOWN:
                self.counters.unknown += 1
                self._unknown_end = start + frame_length(buffer, start)
            elif flaw is Flaw.BAD_CRC:
                self.counters.bad_crc += 1
        self._skip(start, start + 1)

    def _count(self, frame: Frame) -> None:
        """Counts a frame and those that its sequence number says are missing before it."""
        counters = self.counters
        counters.frames += 1
        self._unknown_end = 0
        sender, seq = (frame.sysid, frame.compid), frame.seq
        lost = (seq - self._last_seq.get(sender, seq - 1) - 1) & 0xFF
        if lost < 128:  # else it is late or came twice
            self._last_seq[sender] = seq
            if lost:
                counters.lost[sender] = counters.lost.get(sender, 0) + lost
