"""How frames come from the autopilot and go to it."""

import socket
from typing import Protocol

from vfguide.link.codec import Frame


class ConnectError(Exception):
    """The autopilot cannot be reached this way; the message names the URL and says why."""


class Transport(Protocol):
    """One link to one autopilot. Nothing in it blocks, and nothing that a peer does raises."""

    socket: socket.socket
    """What to wait for."""
    warnings: list[str]
    """What the operator should read; the caller takes it away."""

    def receive(self, now: int) -> list[Frame]:
        """The frames that have arrived since the last call, in their order; `now` [us]."""
        ...

    def send(self, raw: bytes) -> None:
        """Send one frame; what cannot be sent is lost."""
        ...

    def close(self) -> None:
        """Give the link back."""
        ...
