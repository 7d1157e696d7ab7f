"""The interface of links over which frames come from an autopilot and go to it."""

from typing import Protocol

from vfguide.link.codec import Frame


class ConnectError(Exception):
    """A link cannot be opened; the message names its URL and says why."""


class Transport(Protocol):
    """One link to one autopilot; it never blocks, and raises nothing for what a peer does."""

    warnings: list[str]
    """Warnings for the operator; the caller removes them."""

    def fileno(self) -> int:
        """File descriptor to wait for, as `select` takes it."""
        ...

    def receive(self, now: int) -> list[Frame]:
        """The frames that have arrived since the last call, in order; `now` is the time [us]."""
        ...

    def send(self, raw: bytes) -> None:
        """Send one frame; if it cannot be sent, it is lost."""
        ...

    def close(self) -> None:
        """Close the link."""
        ...
