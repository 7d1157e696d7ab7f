"""Folders for results where the user names none."""

from datetime import UTC, datetime
from itertools import count
from pathlib import Path

from vfguide.files.errors import InputError


def new_folder(name: str) -> Path:
    """Make a new folder `runs/NAME-UTC`; where there is one already, a number is appended.

    Raises:
        InputError: it cannot be made.
    """
    first = Path("runs") / f"{name}-{datetime.now(UTC):%Y%m%dT%H%M%SZ}"
    folder, others = first, count(2)
    while not _made(folder):
        folder = first.with_name(f"{first.name}-{next(others)}")
    return folder


def _made(folder: Path) -> bool:
    """Make a folder; returns whether it is new.

    Raises:
        InputError: it cannot be made.
    """
    try:
        folder.mkdir(parents=True)
    except FileExistsError:
        return False
    except OSError as error:
        raise InputError(f"{folder}: cannot be made: {error.strerror or error}") from error
    return True
