"""Exit statuses of all commands."""

GOOD = 0
"""Exit status of a command that ended with a good result."""
BAD = 1
"""Exit status of a command that ended with a bad result, such as a bad verdict."""
BAD_INPUT = 2
"""Exit status of a command that was given bad input."""
INTERRUPTED = 130
"""Exit status of a command that was interrupted: 128 plus the number of SIGINT, as shells have
it."""
