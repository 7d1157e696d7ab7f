"""Exit statuses of every command."""

GOOD = 0
BAD = 1
"""Done, and the verdict is bad."""
BAD_INPUT = 2
INTERRUPTED = 130
