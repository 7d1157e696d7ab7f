"""Whether a file that the user names exists; where the system refuses to tell, it is bad input."""

from pathlib import Path

from vfguide.files.errors import InputError

LONGEST_SHOWN = 80
"""Largest number of characters of a path in a message; chosen as a line of a terminal."""


def is_file(path: Path) -> bool:
    """Whether there is a file at `path`.

    Raises:
        InputError: it cannot be looked up: its name is too long, or a folder may not be entered.
    """
    try:
        return path.is_file()
    except OSError as error:
        raise refused(path, error) from error


def is_there(path: Path) -> bool:
    """Whether there is anything at `path`.

    Raises:
        InputError: it cannot be looked up: its name is too long, or a folder may not be entered.
    """
    try:
        return path.exists()
    except OSError as error:
        raise refused(path, error) from error


def refused(path: Path, error: OSError) -> InputError:
    """The error of a path that the system refuses to look up, cut to LONGEST_SHOWN."""
    text = str(path)
    shown = text if len(text) <= LONGEST_SHOWN else f"{text[: LONGEST_SHOWN - 3]}..."
    return InputError(f"{shown}: cannot be looked for: {error.strerror or error}")
