"""Logs that a command writes beside its work."""

from pathlib import Path

from vfguide.files.errors import InputError
from vfguide.files.looked_for import is_there
from vfguide.link.tlog import TlogError
from vfguide.link.tlog_writer import TlogWriter


def new_log(path: Path) -> TlogWriter:
    """A new log at `path`; its folder is made if need be.

    Raises:
        InputError: there is a file already, or the log cannot be made.
    """
    if is_there(path):
        raise InputError(f"--log {path}: already there, allowed is a new file")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        return TlogWriter(path)
    except OSError as error:
        reason = error.strerror or error
        raise InputError(f"--log {path.parent}: cannot be made: {reason}") from error
    except TlogError as error:
        raise InputError(f"--log {error}") from error
