"""Writing of the log of ground stations, `.tlog`: whole records, whatever ends the program."""

import os
import struct
from collections.abc import Sequence
from pathlib import Path
from typing import Self

from vfguide.link.frame import frame_length
from vfguide.link.tlog import TIME, TIME_BYTES, TlogError


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
        time = TIME.pack(time_us)
    except struct.error as error:
        raise ValueError(f"{time_us} is no time in microseconds since 1970") from error
    return time + time.join(frames)


def end_of_record(data: bytes, start: int) -> int:
    """Where the record that begins at `start` ends, by the length that its frame says."""
    frame = start + TIME_BYTES
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

    def __exit__(self, *_: object) -> None:
        self.close()
