"""What commands print: text as it is, brackets included, with control characters escaped."""

import sys
import warnings
from collections.abc import Sequence
from typing import Any, TextIO

from rich.console import Console

from vfguide.files.errors import InputError
from vfguide.terminal.streams import TolerantStream


def shown(text: str) -> str:
    r"""The text with every character that is not printable escaped, as ``\x1b``."""
    return "".join(each if each.isprintable() else escaped(each) for each in text)


def escaped(character: str) -> str:
    """A character as Python's escape sequence."""
    return character.encode("unicode_escape").decode("ascii")


class Printer(Console):
    """A console whose text is not markup, and cannot control the terminal."""

    def __init__(self, *, stderr: bool = False) -> None:
        super().__init__(stderr=stderr, highlight=False, markup=False, soft_wrap=True)

    def print(self, *objects: Any, **options: Any) -> None:
        """Print texts, with control characters escaped, and tables."""
        super().print(*(shown(o) if isinstance(o, str) else o for o in objects), **options)


out = Printer()
"""Standard output."""
err = Printer(stderr=True)
"""Standard error: progress and complaints."""


def deliver(text: str) -> None:
    """Print the result of a command, ASCII text, on standard output.

    A reader that closes its end early has read enough, and is no error.

    Raises:
        InputError: it cannot be written for another reason.
    """
    sys.stdout.write(f"{text}\n")
    if isinstance(sys.stdout, TolerantStream):
        sys.stdout.drain(None)
        failure = sys.stdout.failure
        if failure is not None and not isinstance(failure, BrokenPipeError):
            raise InputError(f"standard output cannot be written: {failure.strerror or failure}")


def complain(message: str) -> None:
    """Print an error on standard error."""
    err.print(f"vfguide: {message}", style="red")


def warn(messages: Sequence[str]) -> None:
    """Print warnings on standard error."""
    for message in messages:
        err.print(f"vfguide: warning: {message}", style="yellow")


def show_warning(
    message: Warning | str,
    category: type[Warning],
    filename: str,
    lineno: int,
    file: TextIO | None = None,
    line: str | None = None,
) -> None:
    """Print a warning of a library as one of our own; takes the place of `warnings.showwarning`."""
    warn([str(message)])


def tell_warnings() -> None:
    """Print warnings of libraries as our own from now on."""
    warnings.showwarning = show_warning
