"""SIGINT, SIGTERM and SIGHUP, the requests to end, heard at every moment.

A loop that looks for requests enters `REQUESTS`, and ends in good order by itself. Everywhere else
the first request ends the command at once: by the exception `Ended`, and where Python does not get
to raise it, as while LLVM compiles, or something swallows it, by a thread.
"""

import os
import signal
import threading
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType, TracebackType
from typing import Any, Self

from vfguide.terminal.exit_status import INTERRUPTED

STOP_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
"""The signals that ask a command to end: Ctrl-C, `kill`, and a terminal that was closed."""
GRACE = 0.3
"""Time in which a command ends in good order before it is ended [s]; chosen, so that it is over
within a second."""


@dataclass(frozen=True)
class Ending:
    """How a command ends that is asked to outside a loop that looks for it."""

    status: int
    words: str


INTERRUPTION = Ending(INTERRUPTED, "interrupted")
"""How most commands end."""


class Ended(BaseException):
    """A request to end, at a place that does not look for one."""


class Requests:
    """Counts the requests to end; a loop enters it while it looks for them."""

    def __init__(self) -> None:
        self.count = 0
        """Number of requests so far."""
        self.ending = INTERRUPTION
        """How the command ends where no loop looks."""
        self.raised = False
        """A request was raised as an exception, which others may have taken the place of."""
        self._looking = 0
        self._over = threading.Event()
        self._claimed = threading.Lock()

    def wanted(self) -> bool:
        """Whether the user wants an end."""
        return self.count > 0

    def __enter__(self) -> Self:
        self._looking += 1
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._looking -= 1

    @contextmanager
    def heard(self, ending: Ending, end: Callable[[Ending], None]) -> Generator[None]:
        """Hear the signals.

        Args:
            ending: how the command ends where no loop looks.
            end: ends the process where nothing else does.
        """
        self.__init__()
        self.ending = ending
        reading, writing = os.pipe()
        os.set_blocking(writing, False)
        before: dict[signal.Signals, Any] = {
            number: signal.signal(number, self._note) for number in wanted_signals()
        }
        wakeup = signal.set_wakeup_fd(writing, warn_on_full_buffer=False)
        watch = threading.Thread(target=self._watch, args=(reading, end), daemon=True)
        watch.start()
        try:
            yield
        finally:
            self._over.set()
            signal.set_wakeup_fd(wakeup)
            for number, handler in before.items():
                signal.signal(number, handler)
            os.close(writing)
            watch.join()
            os.close(reading)

    def claim_end(self) -> None:
        """Claim the ending of the process: who comes second waits for it."""
        self._claimed.acquire()

    def _note(self, _: int, __: FrameType | None) -> None:
        self.count += 1
        if self.count == 1 and not self._looking:
            self.raised = True
            raise Ended

    def _watch(self, reading: int, end: Callable[[Ending], None]) -> None:
        """End the process if a request is not heeded in time."""
        while os.read(reading, 1):
            if not self._looking and not self._over.wait(GRACE) and not self._looking:
                self.claim_end()
                end(self.ending)


REQUESTS = Requests()
"""What this process is asked: there is one table of signals in it."""


def wanted_signals() -> list[signal.Signals]:
    """The signals to hear: not SIGHUP where it is ignored, as below `nohup`."""
    return [
        number
        for number in STOP_SIGNALS
        if number != signal.SIGHUP or signal.getsignal(number) != signal.SIG_IGN
    ]
