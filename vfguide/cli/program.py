"""The program `vfguide`: its streams, its signals, and how it ends.

Everything else is imported when these are set up, so that no failure to print can end the program,
and Ctrl-C can from the first moment.
"""

import atexit
import logging
import os
import sys
from collections.abc import Callable, Sequence
from functools import partial
from typing import NoReturn

from vfguide.terminal.exit_status import BAD_INPUT, GOOD
from vfguide.terminal.signals import INTERRUPTION, REQUESTS, CommandEnd
from vfguide.terminal.streams import TolerantStream, tolerant_streams

LAST_WORDS = 0.3
"""Longest time for which the program waits for the reader of its output after it was asked to end
[s]; chosen."""
WIPE_BAR = "\r\x1b[2K\x1b[?25h"
"""Text that erases the line of a progress bar and shows the cursor again (EL of ECMA-48, DECTCEM of
DEC terminals; no unit)."""

ENDINGS = {
    "fly": CommandEnd(GOOD, "ended before anything was sent"),
    "sim": CommandEnd(GOOD, "ended before the flight"),
}
"""Ends of commands that are asked to end before their loop looks for requests; other commands are
interrupted."""


def end_in_good_order(status: int) -> NoReturn:
    """End the process, which has done its work, after the exit functions of libraries.

    Python does not end as usual: with the machine code in it that takes a second, in which a signal
    would change the exit status.
    """
    atexit._run_exitfuncs()  # pyright: ignore[reportPrivateUsage]
    os._exit(status)


def run_program(leave: Callable[[int], NoReturn] = end_in_good_order) -> NoReturn:
    """Run the command line; bad input and Ctrl-C end with one line and an exit status of their own.

    `leave` ends the process with an exit status when the work is done.
    """
    ending = ENDINGS.get(next(iter(sys.argv[1:]), ""), INTERRUPTION)
    with (
        tolerant_streams() as streams,
        REQUESTS.heard(ending, partial(end_at_once, streams)),
    ):
        REQUESTS.let_through()
        status = run_command()
        for stream in streams:
            stream.drain(LAST_WORDS if REQUESTS.wanted() else None)
        REQUESTS.close()
        leave(status)


def end_at_once(streams: Sequence[TolerantStream], ending: CommandEnd) -> NoReturn:
    """Erase a progress bar, print the last words, and end the process."""
    *_, err = streams
    bar = WIPE_BAR if err.isatty() else ""
    err.conclude(f"{bar}vfguide: {ending.words}\n")
    for stream in streams:
        stream.drain(LAST_WORDS)
    os._exit(ending.status)


def run_command() -> int:
    """Run the command of the command line; returns its exit status."""
    from vfguide.cli.app import app
    from vfguide.files.errors import InputError
    from vfguide.terminal.console import complain, tell_warnings

    logging.getLogger("matplotlib").setLevel(logging.ERROR)  # it warns of a cache of its own
    tell_warnings()
    try:
        app()
    except InputError as error:
        complain(str(error))
        return BAD_INPUT
    except SystemExit as ended:
        return ended.code if isinstance(ended.code, int) else 0
    return 0
