"""SIGINT and SIGTERM as a number that loops look at, for commands that end in good order."""

import signal
from types import FrameType, TracebackType
from typing import Any, Self

STOP_SIGNALS = (signal.SIGINT, signal.SIGTERM)
"""The signals that ask a command to end."""


class Signals:
    """Counts the requests to end while it is entered."""

    def __init__(self) -> None:
        self.count = 0
        """Number of requests so far."""
        self._before: dict[signal.Signals, Any] = {}

    def wanted(self) -> bool:
        """Whether the user wants an end."""
        return self.count > 0

    def __enter__(self) -> Self:
        for number in STOP_SIGNALS:
            self._before[number] = signal.signal(number, self._note)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        for number, handler in self._before.items():
            signal.signal(number, handler)

    def _note(self, _: int, __: FrameType | None) -> None:
        self.count += 1
