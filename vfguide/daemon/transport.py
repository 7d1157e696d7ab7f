"""How frames come from the autopilot and go to it."""

from typing import Protocol

from vfguide.link.codec import Frame


class ConnectError(Exception):
    """The autopilot cannot be reached this way; the message names the URL and says why."""


class Transport(Protocol):
    """One link to one autopilot. Nothing in it blocks, and nothing that a peer does raises."""

    warnings: list[str]
    """What the operator should read; the caller takes it away."""

    def fileno(self) -> int:
        """The number of what to wait for, as `select` takes it."""
        ...

    def receive(self, now: int) -> list[Frame]:
        """The frames that have arrived since the last call, in their order, by `now` [us]."""
        ...

    def send(self, raw: bytes) -> None:
        """Send one frame; what cannot be sent is lost."""
        ...

    def close(self) -> None:
        """Give the link back."""
        ...
