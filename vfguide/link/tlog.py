"""The log of ground stations, `.tlog`: every frame behind 8 bytes of time, big-endian.

The time counts microseconds since 1970.
"""

import struct
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Self

from vfguide.link.frame import Flaw, Frame, frame_at, frame_length, next_magic

TIME = struct.Struct(">Q")
"""The time before each frame, big-endian [us since 1970]."""
TIME_BYTES = TIME.size
"""Number of bytes of that time."""
_MAGICS = (b"\xfd", b"\xfe")
_DAY_US = 86_400_000_000
LAST_TIME = 2**63 // 1000 - 1
"""Latest time of a frame [us since 1970], in the year 2262: MAVLink's TIMESYNC counts nanoseconds
in 64 bits with a sign."""


class TlogError(Exception):
    """A log cannot be read or written; the message names the file and says why."""

    def __init__(self, path: Path, error: OSError) -> None:
        super().__init__(f"{path}: {error.strerror or error}")
        self.path = path


@dataclass(frozen=True)
class Damage:
    """Bytes of no record."""

    at: int
    """Place of the first one, from 0."""
    bytes: int
    """How many they are."""


class TlogReader:
    """The records of a log, as (time [us since 1970], frame); can be iterated again and again.

    A damaged place costs the records that it hits and no other one. A frame behind it whose own
    time is missing has that of the frame before.
    """

    def __init__(self, data: bytes) -> None:
        self._data = data
        self.frames = 0
        """Frames read so far."""
        self.unknown = 0
        """Frames left out since the dialect does not have their message."""
        self.damage: list[Damage] = []
        """Places of no record, a last record that was cut off among them."""
        self.steps_back = 0
        """Frames that are older than the one before."""

    @classmethod
    def open(cls, path: Path) -> Self:
        """The log in a file.

        Raises:
            TlogError: the file cannot be read.
        """
        try:
            return cls(path.read_bytes())
        except OSError as error:
            raise TlogError(path, error) from error

    @property
    def junk_bytes(self) -> int:
        """Bytes of no record."""
        return sum(each.bytes for each in self.damage)

    def __iter__(self) -> Iterator[tuple[int, Frame]]:
        self.frames = self.unknown = self.steps_back = 0
        self.damage = []
        time_us = 0
        end = 0  # of the record before
        while (start := self._next(end)) is not None:
            found = frame_at(self._data, start)
            if isinstance(found, Frame):
                self.frames += 1
                last_us, time_us = time_us, self._time(end, start, time_us)
                self.steps_back += time_us < last_us
                yield time_us, found
            else:
                self.unknown += 1
            self._note_damage(end, start - TIME_BYTES)
            end = start + frame_length(self._data, start)
        self._note_damage(end, len(self._data))

    def _note_damage(self, begin: int, end: int) -> None:
        if end > begin:
            self.damage.append(Damage(begin, end - begin))

    def _next(self, end: int) -> int | None:
        """Where the next frame begins, true or of an unknown message; None: nowhere."""
        expected = end + TIME_BYTES
        if self._is_record(expected):
            return expected
        start = next_magic(self._data, end)
        while start < len(self._data):
            if isinstance(frame_at(self._data, start), Frame):
                return start
            start = next_magic(self._data, start + 1)
        return None

    def _is_record(self, start: int) -> bool:
        """Whether a frame begins at `start`, where one is expected.

        One of an unknown message counts if another record, or nothing, follows it.
        """
        if self._data[start : start + 1] not in _MAGICS:
            return False
        found = frame_at(self._data, start)
        if found is not Flaw.UNKNOWN:
            return isinstance(found, Frame)
        after = start + frame_length(self._data, start)
        following = after + TIME_BYTES
        return after == len(self._data) or self._data[following : following + 1] in _MAGICS

    def _time(self, end: int, start: int, last_us: int) -> int:
        """The time of the frame at `start`; the last one if its own is missing or cannot be."""
        if start < end + TIME_BYTES:
            return last_us
        (time_us,) = TIME.unpack_from(self._data, start - TIME_BYTES)
        damaged = start > end + TIME_BYTES and end > 0
        return last_us if damaged and abs(time_us - last_us) > _DAY_US else time_us


class UsableTimes:
    """The records of a log; a time that cannot be is that of the frame before."""

    def __init__(self, log: TlogReader) -> None:
        self._log = log
        self.wrong = 0
        """Frames whose time is beyond LASTTIME."""

    def __iter__(self) -> Iterator[tuple[int, Frame]]:
        self.wrong = 0
        last_us = 0
        for time_us, frame in self._log:
            if time_us > LAST_TIME:
                self.wrong += 1
            else:
                last_us = time_us
            yield last_us, frame
