"""The folder of a campaign held by one program: no second one writes its files meanwhile."""

import fcntl
import os
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path

from vfguide.files.errors import InputError


@contextmanager
def hold(folder: Path) -> Generator[None]:
    """Hold a folder until the block ends, or the program does, in whatever way.

    On a file system that knows no locks it is not held.

    Raises:
        InputError: another program holds it.
        OSError: it cannot be opened.
    """
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        if not is_free(descriptor):
            raise InputError(f"--out {folder}: another program flies a campaign there")
        yield
    finally:
        os.close(descriptor)


def is_free(descriptor: int) -> bool:
    """Whether nobody else holds an open folder, which is held from now on."""
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:  # the file system knows no locks
        return True
    return True
