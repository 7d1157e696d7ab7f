"""What commands print: text as it is, brackets included, what is no text escaped."""

import sys
import warnings
from collections.abc import Sequence
from typing import Any, TextIO

from rich.console import Console

from vfguide.files.errors import InputError
from vfguide.terminal.streams import TolerantStream


def shown(text: str) -> str:
    r"""A text in which characters that print nothing, or elsewhere, are escaped, as ``\x1b``."""
    return "".join(each if each.isprintable() else escaped(each) for each in text)


def escaped(character: str) -> str:
    """A character as it is written in Python."""
    return character.encode("unicode_escape").decode("ascii")


class Printer(Console):
    """A console whose text is not markup and cannot steer the terminal."""

    def __init__(self, *, stderr: bool = False) -> None:
        super().__init__(stderr=stderr, highlight=False, markup=False, soft_wrap=True)

    def print(self, *objects: Any, **options: Any) -> None:
        """Print texts, escaped where that is needed, and tables."""
        super().print(*(shown(o) if isinstance(o, str) else o for o in objects), **options)


out = Printer()
"""Standard output."""
err = Printer(stderr=True)
"""Standard error: progress and complaints."""


def deliver(text: str) -> None:
    """Print what a command was called for, ASCII, on standard output.

    Raises:
        InputError: it cannot be written, and the reader is not one that has read enough.
    """
    sys.stdout.write(f"{text}\n")
    if isinstance(sys.stdout, TolerantStream):
        sys.stdout.drain(None)
        failure = sys.stdout.failure
        if failure is not None and not isinstance(failure, BrokenPipeError):
            raise InputError(f"standard output cannot be written: {failure.strerror or failure}")


def complain(message: str) -> None:
    """One message on standard error."""
    err.print(f"vfguide: {message}", style="red")


def warn(messages: Sequence[str]) -> None:
    """Messages on standard error about what may go wrong."""
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
    """Show what a library warns of as a warning of our own; of `warnings.showwarning`'s form."""
    warn([str(message)])


def tell_warnings() -> None:
    """From now on warnings of libraries are shown as ours are."""
    warnings.showwarning = show_warning
