"""The entry point of the program `vfguide`, where signals that ask for its end are held back.

What takes long to import is imported after that, so that Ctrl-C ends the program in good order from
the first moment.
"""

import signal


def main() -> None:
    """Block the signals that ask for an end until they can be heard, and run the command line."""
    signal.pthread_sigmask(signal.SIG_BLOCK, (signal.SIGINT, signal.SIGTERM, signal.SIGHUP))
    from vfguide.cli.program import run_program

    run_program()
