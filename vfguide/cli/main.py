"""The program `vfguide`: its streams, its signals, and how it ends.

Everything else is imported when these are in order, so that nothing that is printed can end it,
and Ctrl-C ends it from the first moment.
"""

import logging
import os
import sys
from collections.abc import Iterable
from functools import partial
from typing import NoReturn

from vfguide.terminal.exit_status import BAD_INPUT, GOOD
from vfguide.terminal.signals import INTERRUPTION, REQUESTS, Ended, Ending
from vfguide.terminal.streams import TolerantStream, tolerant_streams

LAST_WORDS = 0.3
"""Longest time that a program waits for its reader after it was asked to end [s]; chosen."""


ENDINGS = {
    "fly": Ending(GOOD, "ended before anything was sent"),
    "sim": Ending(GOOD, "ended before the flight"),
}
"""How commands end that are asked to before their loop looks for it; the others are interrupted."""


def main() -> None:
    """Run the command line; bad input and Ctrl-C end with one line and their exit status."""
    with tolerant_streams() as streams:
        ending = ENDINGS.get(next(iter(sys.argv[1:]), ""), INTERRUPTION)
        with REQUESTS.heard(ending, partial(end_at_once, streams)):
            try:
                status = run_command()
                for stream in streams:
                    stream.drain(LAST_WORDS if REQUESTS.wanted() else None)
            except (Exception, Ended):
                if not REQUESTS.raised:
                    raise
                REQUESTS.claim_end()
                end_at_once(streams, REQUESTS.ending)
    sys.exit(status)


def end_at_once(streams: Iterable[TolerantStream], ending: Ending) -> NoReturn:
    """End the process, with its last words; taking it down in good order may take a second."""
    sys.stderr.write(f"vfguide: {ending.words}\n")
    for stream in streams:
        stream.drain(LAST_WORDS)
    os._exit(ending.status)


def run_command() -> int:
    """Run a command; the exit status of those that end of themselves."""
    from vfguide.cli.app import app
    from vfguide.files.errors import InputError
    from vfguide.terminal.console import complain, tell_warnings

    logging.getLogger("matplotlib").setLevel(logging.ERROR)  # it warns of a cache of its own
    tell_warnings()
    sys.unraisablehook = tell_unless_ending
    try:
        app()
    except InputError as error:
        complain(str(error))
        return BAD_INPUT
    except SystemExit as ended:
        return ended.code if isinstance(ended.code, int) else 0
    return 0


def tell_unless_ending(unraisable: "sys.UnraisableHookArgs") -> None:
    """Tell of an exception that nothing can take, but not of those that a request leads to."""
    if not REQUESTS.raised:
        sys.__unraisablehook__(unraisable)
