"""What is printed can neither end the program nor delay it."""

import errno
import io
import os
import threading
import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.terminal.console import shown
from vfguide.terminal.streams import MAX_PENDING, TolerantStream

ANY_TEXT = st.text(st.characters(exclude_categories=()))
"""Half characters among it, of which a path or a callsign that is no text consists."""


class Terminal(io.TextIOWrapper):
    """A stream in memory of any encoding."""

    def __init__(self, encoding):
        self.taken = io.BytesIO()
        super().__init__(self.taken, encoding=encoding, write_through=True)


@given(ANY_TEXT, st.sampled_from(["ascii", "latin-1", "utf-8"]))
def test_any_text_is_shown_on_any_terminal(text, encoding):
    terminal = Terminal(encoding)
    stream = TolerantStream(terminal)
    assert stream.write(text) == len(text)
    stream.drain(None)
    assert stream.failure is None
    assert terminal.taken.getvalue().decode(encoding) == terminal.taken.getvalue().decode(
        encoding, "replace"
    )


@given(ANY_TEXT)
def test_nothing_that_is_shown_steers_the_terminal(text):
    assert shown(text).isprintable()


@pytest.mark.parametrize(
    ("text", "escaped"),
    [
        ("Zürich 42", "Zürich 42"),
        ("AB\x1b[2J", r"AB\x1b[2J"),
        ("one\ntwo", r"one\ntwo"),
        ("\u202eback", r"\u202eback"),
        ("\udcff", r"\udcff"),
        ("\x00\x7f\x9b", r"\x00\x7f\x9b"),
    ],
)
def test_control_characters_are_escaped(text, escaped):
    assert shown(text) == escaped


@pytest.mark.parametrize(
    "number", [errno.EPIPE, errno.ENOSPC, errno.EIO, errno.EBADF, errno.ECONNRESET]
)
def test_a_stream_that_fails_loses_the_text_and_nothing_else(number):
    class Failing(Terminal):
        def write(self, text):
            raise OSError(number, os.strerror(number))

    stream = TolerantStream(Failing("utf-8"))
    for _ in range(3):
        assert stream.write("lost") == 4
        stream.drain(None)
    assert stream.failure.errno == number


def test_a_stream_that_is_closed_or_missing():
    closed = Terminal("utf-8")
    closed.close()
    for behind in (closed, None):
        stream = TolerantStream(behind)
        assert stream.write("lost") == 4
        stream.drain(None)
        assert not stream.isatty() if behind is None else True


def test_a_reader_that_does_not_read_delays_nothing():
    released = threading.Event()

    class Stopped(Terminal):
        def write(self, text):
            released.wait()
            return super().write(text)

    behind = Stopped("utf-8")
    stream = TolerantStream(behind)
    started = time.monotonic()
    for _ in range(3 * MAX_PENDING):
        stream.write("x")
    stream.drain(0.05)
    assert time.monotonic() - started < 2.0
    assert behind.taken.getvalue() == b""
    released.set()
    stream.drain(None)
    assert behind.taken.getvalue() == b"x" * MAX_PENDING


def test_what_is_no_text_is_refused_so_that_libraries_know_it_for_a_text_stream():
    with pytest.raises(TypeError, match="bytes is no text"):
        TolerantStream(Terminal("utf-8")).write(b"")
