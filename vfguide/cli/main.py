"""Where the program `vfguide` begins: the requests to end are held back until they can be heard.

Whatever takes time is imported after that, so that Ctrl-C ends it as told from the first moment.
"""

import signal


def main() -> None:
    """Run the command line; bad input and Ctrl-C end with one line and their exit status."""
    signal.pthread_sigmask(signal.SIG_BLOCK, (signal.SIGINT, signal.SIGTERM, signal.SIGHUP))
    from vfguide.cli.program import run_program

    run_program()
