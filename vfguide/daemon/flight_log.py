"""The log of a flight, which goes on without its log if the disk fails."""

from collections.abc import Sequence

from vfguide.link.tlog import TlogError
from vfguide.link.tlog_writer import TlogWriter

FLUSH_INTERVAL = 1_000_000
"""Longest time for which frames stay in memory before they are written [us]; chosen as what a power
cut may cost."""


class FlightLog:
    """Writes a log until the disk fails, and then warns the operator."""

    def __init__(self, writer: TlogWriter) -> None:
        self.warnings: list[str] = []
        """Warnings for the operator; the caller removes them."""
        self._writer: TlogWriter | None = writer
        self._flushed = 0
        self._left_out = 0

    def write(self, time_us: int, frames: Sequence[bytes]) -> None:
        """Add frames with their time [us since 1970]; they may stay in memory for a while.

        Frames with a time that no log can hold are left out.
        """
        if self._writer is not None:
            try:
                self._writer.write_all(time_us, frames)
            except TlogError as error:
                self._give_up(error)
            except ValueError as error:
                self._leave_out(error)

    def flush(self, now: int) -> None:
        """Write what is in memory to the file, every FLUSH_INTERVAL; `now` is the time [us]."""
        if self._writer is None or now - self._flushed < FLUSH_INTERVAL:
            return
        self._flushed = now
        try:
            self._writer.flush()
        except TlogError as error:
            self._give_up(error)

    def close(self) -> None:
        """Write what is in memory to the file and close it."""
        try:
            if self._writer is not None:
                self._writer.close()
        except TlogError as error:
            self._give_up(error)

    def _leave_out(self, error: ValueError) -> None:
        """Note that frames are left out; warns of the first time."""
        self._left_out += 1
        if self._left_out == 1:
            self.warnings.append(f"not in the log: {error}; the flight goes on")

    def _give_up(self, error: TlogError) -> None:
        self._writer = None
        self.warnings.append(f"no log any more, the flight goes on: {error}")
