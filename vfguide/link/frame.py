"""Frames in a stream of bytes: found, checked, counted; MAVLink 1 and 2, signed or not.

A frame is true if its checksum is, whatever precedes or follows it. Nothing that a peer sends
raises: what is wrong with the stream is counted (`LinkCounters`).

The wire (n bytes of payload, checksum over all but the magic byte, then the CRC_EXTRA byte):

    MAVLink 1: FE n seq sysid compid msgid(1) payload checksum(2)
    MAVLink 2: FD n incompat compat seq sysid compid msgid(3) payload checksum(2) [signature(13)]
"""

import re
import struct
from dataclasses import dataclass, field
from enum import Enum, auto
from typing import NamedTuple

from fastcrc.crc16 import mcrf4xx

from vfguide.kernels.written_functions import maker
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
_HEADER_1 = struct.Struct("<x5B")
_HEADER_2 = struct.Struct("<x2Bx3BI")
_HEADER_1_BYTES = 6
_HEADER_2_BYTES = 10
_CHECKSUM_BYTES = 2
_SIGNATURE_BYTES = 13
_MSGID_BITS = 0xFFFFFF


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


_frame = maker(Frame)


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
    payload = data[start + 1]
    if data[start] == MAGIC_1:
        return _HEADER_1_BYTES + payload + _CHECKSUM_BYTES
    signature = _SIGNATURE_BYTES if data[start + 2] & SIGNED else 0
    return _HEADER_2_BYTES + payload + _CHECKSUM_BYTES + signature


def frame_at(data: bytes, start: int) -> Frame | Flaw:
    """The frame that begins at `start`, where its magic byte must be, or why there is none."""
    if data[start] == MAGIC_1:
        return _frame_1_at(data, start)
    there = len(data) - start
    if there < _HEADER_2_BYTES + _CHECKSUM_BYTES:
        is_foreign = there > 2 and data[start + 2] & ~SIGNED
        return Flaw.FOREIGN if is_foreign else Flaw.INCOMPLETE
    length, flags, seq, sysid, compid, msgid = _HEADER_2.unpack_from(data, start)
    if flags & ~SIGNED:
        return Flaw.FOREIGN
    end = _HEADER_2_BYTES + length
    whole = end + (_CHECKSUM_BYTES + _SIGNATURE_BYTES if flags else _CHECKSUM_BYTES)
    if there < whole:
        return Flaw.INCOMPLETE
    msgid &= _MSGID_BITS  # the byte behind it is none of it
    raw = data[start : start + whole]
    if flaw := _flaw(raw, msgid, end):
        return flaw
    return _frame((sysid, compid, seq, msgid, raw[_HEADER_2_BYTES:end], raw, 2))


def _frame_1_at(data: bytes, start: int) -> Frame | Flaw:
    """The same of MAVLink 1."""
    there = len(data) - start
    if there < _HEADER_1_BYTES + _CHECKSUM_BYTES or there < frame_length(data, start):
        return Flaw.INCOMPLETE
    length, seq, sysid, compid, msgid = _HEADER_1.unpack_from(data, start)
    end = _HEADER_1_BYTES + length
    raw = data[start : start + end + _CHECKSUM_BYTES]
    if flaw := _flaw(raw, msgid, end):
        return flaw
    return _frame((sysid, compid, seq, msgid, raw[_HEADER_1_BYTES:end], raw, 1))


def _flaw(raw: bytes, msgid: int, end: int) -> Flaw | None:
    """What is wrong with a frame whose checksum begins at `end`; None: nothing."""
    extra = CRC_EXTRA.get(msgid)
    if extra is None:
        return Flaw.UNKNOWN
    is_true = mcrf4xx(raw[1:end] + extra) == raw[end] | raw[end + 1] << 8
    return None if is_true else Flaw.BAD_CRC


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
        self._next_seq: dict[tuple[int, int], int] = {}

    def feed(self, data: bytes, *, whole: bool = False) -> list[Frame]:
        """Takes the next bytes of the stream; returns the frames that they complete.

        `whole`: nothing of what ends here goes on in the next piece, as with a datagram; what is
        incomplete is junk.
        """
        buffer = self._rest + data
        frames: list[Frame] = []
        position, end = 0, len(buffer)
        while position < end:
            if buffer[position] not in _MAGICS:
                start = next_magic(buffer, position)
                self._skip(position, start)
                position = start
                continue
            found = frame_at(buffer, position)
            if isinstance(found, Frame):
                frames.append(found)
                position += len(found.raw)
                self._unknown_end = 0
            elif found is Flaw.INCOMPLETE and not whole:
                break
            else:
                self._reject(found, buffer, position)
                position += 1
        self._rest = buffer[position:]
        self._unknown_end = max(0, self._unknown_end - position)
        self._count(frames)
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

    def _count(self, frames: list[Frame]) -> None:
        """Counts frames and those that their sequence numbers say are missing before them."""
        self.counters.frames += len(frames)
        for sysid, compid, seq, _, _, _, _ in frames:
            sender = sysid, compid
            expected = self._next_seq.get(sender, seq)
            lost = (seq - expected) & 0xFF
            if lost < 128:  # else it is late or came twice
                self._next_seq[sender] = seq + 1
            if 0 < lost < 128:
                self.counters.lost[sender] = self.counters.lost.get(sender, 0) + lost
