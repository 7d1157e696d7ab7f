"""What commands print: text as it is, brackets included."""

from collections.abc import Sequence

from rich.console import Console

out = Console(highlight=False, markup=False, soft_wrap=True)
"""Standard output."""
err = Console(stderr=True, highlight=False, markup=False, soft_wrap=True)
"""Standard error: progress and complaints."""


def complain(message: str) -> None:
    """One message on standard error."""
    err.print(f"vfguide: {message}", style="red")


def warn(messages: Sequence[str]) -> None:
    """Messages on standard error about what may go wrong."""
    for message in messages:
        err.print(f"vfguide: warning: {message}", style="yellow")
