"""The logs of a run."""

from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path

from vfguide.link.tlog import TlogWriter, tlog_record
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

    def write_vehicle(self, vehicle: Vehicle) -> Write:
        """What takes the frames between one companion and its autopilot."""
        path = self._folder / f"vehicle-{vehicle.id}.tlog"
        own = self._stack.enter_context(TlogWriter(path))

        def write(time_us: int, raw: bytes) -> None:
            record = tlog_record(time_us, raw)
            self._all.append(record)
            own.append(record)

        return write
