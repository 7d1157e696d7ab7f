"""The logs of a run."""

from collections.abc import Callable, Sequence
from contextlib import ExitStack
from pathlib import Path

from vfguide.companion.session import Record
from vfguide.link.tlog_writer import TlogWriter, tlog_records
from vfguide.scenario.resolved import Vehicle

Write = Callable[[int, bytes], None]
"""Takes a time [us since 1970] and the bytes of one frame."""


class Logs:
    """`flight.tlog` with everything, `vehicle-ID.tlog` with one companion's part."""

    def __init__(self, folder: Path, stack: ExitStack) -> None:
        """Logs in `folder`, closed with `stack`."""
        self._folder = folder
        self._stack = stack
        self._all = stack.enter_context(TlogWriter(folder / "flight.tlog"))
        self.write_all: Write = self._all.write

    def write_vehicle(self, vehicle: Vehicle) -> Record:
        """What takes the frames between one companion and its autopilot."""
        path = self._folder / f"vehicle-{vehicle.id}.tlog"
        own = self._stack.enter_context(TlogWriter(path))

        def write(time_us: int, frames: Sequence[bytes]) -> None:
            records = tlog_records(time_us, frames)
            self._all.append(records)
            own.append(records)

        return write
