"""The log of ground stations, `.tlog`: every frame behind 8 bytes of time, big-endian.

The time counts microseconds since 1970.
"""

import os
import struct
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Self

from vfguide.link.frame import Flaw, Frame, frame_at, frame_length, next_magic

_TIME = struct.Struct(">Q")
_TIME_BYTES = 8
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


def tlog_record(time_us: int, raw: bytes) -> bytes:
    """One frame, as it is on the wire, behind its time [us since 1970].

    Raises:
        ValueError: the time is negative or beyond 64 bits.
    """
    return tlog_records(time_us, (raw,))


def tlog_records(time_us: int, frames: Sequence[bytes]) -> bytes:
    """At least one frame, each behind the same time [us since 1970].

    Raises:
        ValueError: the time is negative or beyond 64 bits.
    """
    try:
        time = _TIME.pack(time_us)
    except struct.error as error:
        raise ValueError(f"{time_us} is no time in microseconds since 1970") from error
    return time + time.join(frames)


def end_of_record(data: bytes, start: int) -> int:
    """Where the record that begins at `start` ends, by the length that its frame says."""
    frame = start + _TIME_BYTES
    return frame + frame_length(data, frame)


class TlogWriter:
    """Writes a log; a context manager.

    Records gather in memory and go to the file in one piece. Whatever ends the program in an
    orderly way, Ctrl-C or a full disk, what is in the file then are whole records.
    """

    def __init__(self, path: Path, buffer_bytes: int = 1 << 16) -> None:
        """Creates the file, or empties it.

        Args:
            path: the file.
            buffer_bytes: how much to gather in memory.

        Raises:
            TlogError: the file cannot be opened.
        """
        self.path = path
        self._buffer_bytes = buffer_bytes
        self._pending: list[bytes] = []
        self._pending_bytes = 0
        self._end = 0  # of the records in the file
        try:
            self._file = path.open("wb", buffering=0)
        except OSError as error:
            raise TlogError(path, error) from error

    def write(self, time_us: int, raw: bytes) -> None:
        """Adds one frame, as it is on the wire, with its time [us since 1970].

        Raises:
            ValueError: the time is negative or beyond 64 bits.
            TlogError: the file cannot be written; the records in memory are lost.
        """
        self.append(tlog_record(time_us, raw))

    def write_all(self, time_us: int, frames: Sequence[bytes]) -> None:
        """Adds at least one frame, all with the same time; raises as `write` does."""
        self.append(tlog_records(time_us, frames))

    def append(self, records: bytes) -> None:
        """Adds what `tlog_record` or `tlog_records` made.

        Raises:
            TlogError: the file cannot be written; the records in memory are lost.
        """
        self._pending.append(records)
        self._pending_bytes += len(records)
        if self._pending_bytes >= self._buffer_bytes:
            self.flush()

    def flush(self) -> None:
        """Puts all records into the file.

        Raises:
            TlogError: the file cannot be written; of the records those that fitted are in it.
        """
        data = b"".join(self._pending)
        written = 0
        try:
            while written < len(data):
                # at a place, not at the end: after Ctrl-C in here, the next flush starts anew
                written += os.pwrite(self._file.fileno(), data[written:], self._end + written)
        except OSError as error:
            self._keep_whole(data, written)
            raise TlogError(self.path, error) from error
        self._forget(self._end + len(data))

    def _keep_whole(self, data: bytes, written: int) -> None:
        """Cuts the file behind the last record of `data` that was written as a whole."""
        whole = 0
        while whole < written and (end := end_of_record(data, whole)) <= written:
            whole = end
        self._forget(self._end + whole)
        if written > whole:
            os.ftruncate(self._file.fileno(), self._end)

    def _forget(self, end: int) -> None:
        """Drops the records in memory, since the file holds them up to `end`."""
        self._end, self._pending, self._pending_bytes = end, [], 0

    def close(self) -> None:
        """Flushes and closes the file; once is enough, twice does no harm.

        Raises:
            TlogError: the file cannot be written; it is closed nevertheless.
        """
        try:
            if not self._file.closed:
                self.flush()
        finally:
            self._file.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()


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
            self._note_damage(end, start - _TIME_BYTES)
            end = start + frame_length(self._data, start)
        self._note_damage(end, len(self._data))

    def _note_damage(self, begin: int, end: int) -> None:
        if end > begin:
            self.damage.append(Damage(begin, end - begin))

    def _next(self, end: int) -> int | None:
        """Where the next frame begins, true or of an unknown message; None: nowhere."""
        expected = end + _TIME_BYTES
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
        following = after + _TIME_BYTES
        return after == len(self._data) or self._data[following : following + 1] in _MAGICS

    def _time(self, end: int, start: int, last_us: int) -> int:
        """The time of the frame at `start`; the last one if its own is missing or cannot be."""
        if start < end + _TIME_BYTES:
            return last_us
        (time_us,) = _TIME.unpack_from(self._data, start - _TIME_BYTES)
        damaged = start > end + _TIME_BYTES and end > 0
        return last_us if damaged and abs(time_us - last_us) > _DAY_US else time_us


class UsableTimes:
    """The records of a log; a time that cannot be is that of the frame before."""

    def __init__(self, log: TlogReader) -> None:
        self._log = log
        self.wrong = 0
        """Frames whose time is beyond LAST_TIME."""

    def __iter__(self) -> Iterator[tuple[int, Frame]]:
        self.wrong = 0
        last_us = 0
        for time_us, frame in self._log:
            if time_us > LAST_TIME:
                self.wrong += 1
            else:
                last_us = time_us
            yield last_us, frame
