"""Standard output and standard error that can neither end the program nor delay it.

Text is handed to a thread that writes it, so that a reader that does not read, such as a stopped
terminal, delays nothing. Characters that the stream cannot encode are escaped. When the reader has
gone, the disk is full or the terminal was closed, text is lost from then on.
"""

import io
import os
import select
import sys
import threading
from collections.abc import Generator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from queue import Queue
from typing import TextIO, cast

MAX_PENDING = 10_000
"""Largest number of pieces of text that wait for a reader; chosen. Further ones are lost, since a
flight cannot wait."""


class TolerantStream(io.TextIOBase):
    """A text stream in front of another one, behind, which may fail or block."""

    def __init__(self, behind: TextIO | None) -> None:
        """A stream in front of `behind`; None: there is none, and all text is lost."""
        self.failure: OSError | None = None
        """Why text is lost from now on; None: it is not."""
        self._behind = behind
        self._encoding = getattr(behind, "encoding", None) or "utf-8"
        self._pending = 0
        self._concluded = False
        self._changed = threading.Condition()
        self._queue = Queue[str]()
        self._writer: threading.Thread | None = None

    @property
    def encoding(self) -> str:  # pyright: ignore[reportIncompatibleVariableOverride]
        """Encoding of the stream behind."""
        return self._encoding

    def isatty(self) -> bool:
        """Whether the stream behind is a terminal."""
        return self._behind is not None and self._behind.isatty()

    def fileno(self) -> int:
        """File descriptor of the stream behind.

        Raises:
            UnsupportedOperation: it has none.
        """
        if self._behind is None:
            raise io.UnsupportedOperation("fileno")
        return self._behind.fileno()

    def writable(self) -> bool:
        """Whether text can be written, which is always so."""
        return True

    def write(self, s: str, /) -> int:
        """Queue a text, to be written when the reader takes it; returns its length at once.

        Raises:
            TypeError: it is no text.
        """
        if not isinstance(s, str):  # pyright: ignore[reportUnnecessaryIsInstance]
            raise TypeError(f"{type(s).__name__} is no text")
        with self._changed:
            if not self._concluded and self._pending < MAX_PENDING:
                self._put(s)
        return len(s)

    def conclude(self, words: str) -> None:
        """Queue the last words; text that is written after them is lost."""
        with self._changed:
            self._concluded = True
            self._put(words)

    def drain(self, seconds: float | None) -> None:
        """Wait until the queue is empty, for at most `seconds`; None: for as long as it takes."""
        with self._changed:
            self._changed.wait_for(lambda: not self._pending, seconds)

    def _put(self, text: str) -> None:
        if self._behind is not None and self.failure is None:
            self._pending += 1
            self._queue.put(text)
            self._start()

    def _start(self) -> None:
        if self._writer is None:
            self._writer = threading.Thread(target=self._show_all, daemon=True)
            self._writer.start()

    def _show_all(self) -> None:
        while True:
            text = self._queue.get()
            try:
                if self.failure is None:
                    self._show(text)
            finally:
                with self._changed:
                    self._pending -= 1
                    self._changed.notify_all()

    def _show(self, text: str) -> None:
        data = text.encode(self._encoding, "backslashreplace")
        try:
            put_out(cast("TextIO", self._behind), data)
        except ValueError:  # the stream behind is closed
            self.failure = OSError("closed")
        except OSError as error:
            self.failure = error


def put_out(stream: TextIO, data: bytes) -> None:
    """Write all of `data` to a stream, past its buffers, which would keep and repeat what failed.

    Raises:
        OSError: it cannot be written.
        ValueError: it is closed.
    """
    try:
        number = stream.fileno()
    except io.UnsupportedOperation:  # a stream in memory
        stream.write(data.decode(stream.encoding))
        return
    while data:
        try:
            data = data[os.write(number, data) :]
        except BlockingIOError:
            select.select((), (number,), ())


@contextmanager
def tolerant_streams() -> Generator[tuple[TolerantStream, TolerantStream]]:
    """Replace standard output and standard error by tolerant streams, inside the context."""
    out, err = map(TolerantStream, (sys.stdout, sys.stderr))
    with redirect_stdout(cast("TextIO", out)), redirect_stderr(cast("TextIO", err)):
        yield out, err
