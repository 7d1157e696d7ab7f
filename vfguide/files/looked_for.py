"""Whether there is what the user names; where the system does not say, that is bad input."""

from pathlib import Path

from vfguide.files.errors import InputError

LONGEST_SHOWN = 80
"""Largest number of characters of a path in a message; chosen, a line of a terminal."""


def is_file(path: Path) -> bool:
    """Whether there is such a file.

    Raises:
        InputError: it cannot be looked for: its name is too long, or a folder may not be entered.
    """
    try:
        return path.is_file()
    except OSError as error:
        raise refused(path, error) from error


def is_there(path: Path) -> bool:
    """Whether there is anything of that name.

    Raises:
        InputError: it cannot be looked for, as of `is_file`.
    """
    try:
        return path.exists()
    except OSError as error:
        raise refused(path, error) from error


def refused(path: Path, error: OSError) -> InputError:
    """What is told of a path that the system refuses."""
    text = str(path)
    shown = text if len(text) <= LONGEST_SHOWN else f"{text[: LONGEST_SHOWN - 3]}..."
    return InputError(f"{shown}: cannot be looked for: {error.strerror or error}")
