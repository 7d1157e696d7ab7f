"""SIGINT, SIGTERM and SIGHUP, the requests to end, heard at every moment.

A loop that looks for requests enters `REQUESTS`, and ends in good order by itself. A request that
came too late for the loop to see ends the command when the loop is left. Outside such loops the
first request ends the command at once, from a thread. No exception is raised: in the middle of a
library that calls Python back, as LLVM does, it may be swallowed or crash the process.
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
"""Time that a command that ends in good order still has when it is asked once more [s]; chosen, so
that it is over within a second."""


@dataclass(frozen=True)
class CommandEnd:
    """How a command ends where no loop looks for the request."""

    status: int
    """Exit status."""
    words: str
    """Last words of the program."""


INTERRUPTION = CommandEnd(INTERRUPTED, "interrupted")
"""End of most commands."""


class EndRequests:
    """Counter of the requests to end; a loop enters it while it looks for them."""

    def __init__(self) -> None:
        self._begin(INTERRUPTION, nobody_ends)

    def _begin(self, ending: CommandEnd, end: Callable[[CommandEnd], None]) -> None:
        """Start anew: no request has come, and the work is not done."""
        self.ending = ending
        """How the command ends where no loop looks for requests."""
        self._end = end
        self._count = 0
        self._seen = 0
        self._looking = 0
        self._counting = threading.Lock()
        self._over = threading.Event()
        self._claimed = threading.Lock()

    def wanted(self) -> bool:
        """Whether the user wants an end, which is then up to the caller."""
        return self.seen() > 0

    def seen(self) -> int:
        """Number of requests so far, which are then up to the caller."""
        self._seen = self._count
        return self._seen

    def __enter__(self) -> Self:
        with self._counting:
            self._looking += 1
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        with self._counting:
            self._looking -= 1
        if self._count and not self._seen and error is None:
            self._claim_end()

    @contextmanager
    def heard(self, ending: CommandEnd, end: Callable[[CommandEnd], None]) -> Generator[None]:
        """Count the signals as requests; those that are blocked come when they are let through.

        Args:
            ending: how the command ends where no loop looks for requests.
            end: ends the process that way.
        """
        self._begin(ending, end)
        reading, writing = os.pipe()
        os.set_blocking(writing, False)
        before: dict[signal.Signals, Any] = {
            number: signal.signal(number, leave_to_the_watch) for number in wanted_signals()
        }
        wakeup = signal.set_wakeup_fd(writing, warn_on_full_buffer=False)
        watch = threading.Thread(target=self._watch, args=(reading,), daemon=True)
        watch.start()
        try:
            yield
        finally:
            self.close()
            signal.set_wakeup_fd(wakeup)
            for number, handler in before.items():
                signal.signal(number, handler)
            os.close(writing)
            watch.join()
            os.close(reading)

    def let_through(self) -> None:
        """Unblock the signals; those that came before are heard first."""
        signal.pthread_sigmask(signal.SIG_UNBLOCK, STOP_SIGNALS)

    def close(self) -> None:
        """Note that the work is done: requests change nothing from now on."""
        with self._claimed:
            self._over.set()

    def _claim_end(self) -> None:
        """End the process, once, unless the work is done."""
        with self._claimed:
            if not self._over.is_set():
                self._end(self.ending)

    def _watch(self, reading: int) -> None:
        """Count requests, and end the process at those for which no loop looks.

        One more request while the command ends in good order takes effect after GRACE.
        """
        while os.read(reading, 1):
            with self._counting:
                self._count += 1
                heeded = self._looking > 0
            if not heeded and not (self._seen and self._over.wait(GRACE)):
                self._claim_end()


def nobody_ends(_: CommandEnd) -> None:
    """Do nothing, for requests that are not heard."""


def leave_to_the_watch(_: int, __: FrameType | None) -> None:
    """Do nothing in the thread that the signal interrupts: it wakes the thread that watches."""


def wanted_signals() -> list[signal.Signals]:
    """The signals to hear: STOP_SIGNALS, without SIGHUP where it is ignored, as under `nohup`."""
    return [
        number
        for number in STOP_SIGNALS
        if number != signal.SIGHUP or signal.getsignal(number) != signal.SIG_IGN
    ]


REQUESTS = EndRequests()
"""The requests to this process, one instance, as a process has one table of signals."""
