"""The link over UDP: a datagram holds whole frames, and anybody on the network can send one."""

import socket
from collections.abc import Iterator
from contextlib import suppress
from typing import Any

from vfguide.autopilots.makes import autopilot_of
from vfguide.daemon.transport import ConnectError
from vfguide.link.codec import Frame, Parser, decode
from vfguide.link.enums import MavComponent
from vfguide.link.messages import Heartbeat
from vfguide.link.url import NetworkUrl

MAX_DATAGRAM = 65_535
"""Largest size of a UDP datagram, a number of bytes (RFC 768)."""
MOST_AT_ONCE = 256
"""Largest number of datagrams that are taken at once; chosen, so that a flood does not keep the
companion from its other duties."""
PEER_SILENT = 3_000_000
"""Time of silence after which a peer may be replaced by another [us]; chosen."""
LONGEST_UNSEEN = 500_000
"""Time between two looks at the socket above which this program stood still, so that nobody was
silent [us]; chosen, it looks 20 times a second."""
MAX_STRANGERS = 5
"""Largest number of other senders of which the operator is warned; chosen."""

Address = tuple[Any, ...]
"""Host and port of a socket, and what its family adds to them."""


class UdpLink:
    """A socket and the one peer that counts; datagrams of all others are left alone."""

    def __init__(self, opened: socket.socket, sysid: int, peer: Address | None) -> None:
        """A link to the autopilot of system `sysid`.

        Args:
            opened: bound or connected, and never blocking.
            sysid: of the vehicle.
            peer: where its autopilot is; None: where a heartbeat of one that can be flown with
                comes from first, and from elsewhere only after a silence. Until then, where
                anything is heard from first that speaks as it: the companion says who that is.
        """
        self.socket = opened
        self.warnings: list[str] = []
        """What the operator should read; the caller takes it away."""
        self._sysid = sysid
        self._peer = peer
        self._learns = peer is None
        self._is_sure = False
        self._heard = 0
        self._looked: int | None = None
        self._strangers: set[Address] = set()
        self._parser = Parser()

    def fileno(self) -> int:
        """The socket's number, to wait for."""
        return self.socket.fileno()

    def receive(self, now: int) -> list[Frame]:
        """The frames of the peer that have arrived by `now` [us], in their order."""
        frames: list[Frame] = []
        self._look(now)
        for data, sender in datagrams(self.socket):
            found = self._parser.feed(data, whole=True)
            for sysid in autopilots(found):
                self._hear(now, sender, sysid, is_flown=has_flown_autopilot(found, sysid))
            if sender == self._peer:
                frames += found
        return frames

    def send(self, raw: bytes) -> None:
        """Send one frame to the peer; before it is known, nowhere."""
        if self._peer is not None:
            with suppress(OSError):  # as on a radio: what cannot be sent is lost
                self.socket.sendto(raw, self._peer)

    def close(self) -> None:
        """Give the port back."""
        self.socket.close()

    def _look(self, now: int) -> None:
        """Note that the socket is looked at: nobody is silent while this program stands still."""
        pause = 0 if self._looked is None else now - self._looked
        self._looked = now
        if pause > LONGEST_UNSEEN:
            self._heard += pause

    def _hear(self, now: int, sender: Address, sysid: int, *, is_flown: bool) -> None:
        """Note the sender of our autopilot, which says so itself if it `is_flown`; warn of others.

        Once it has, nobody takes its place who does not.
        """
        if sysid != self._sysid:
            self._tell_of(sender, f"vehicle {sysid} is heard, waited for is {self._sysid}")
            return
        if self._learns and self._may_follow(now, is_flown=is_flown):
            self._peer, self._is_sure = sender, is_flown
        if sender == self._peer:
            self._heard = now
        else:
            place = name_of(self._peer)
            self._tell_of(sender, f"ignored as vehicle {sysid}, whose autopilot is at {place}")

    def _may_follow(self, now: int, *, is_flown: bool) -> bool:
        """Whether a sender may be the peer from `now` [us] on."""
        if not self._is_sure:
            return self._peer is None or is_flown
        return is_flown and now - self._heard > PEER_SILENT

    def _tell_of(self, stranger: Address, text: str) -> None:
        """Warn the operator once of each of the first strangers."""
        if stranger not in self._strangers and len(self._strangers) < MAX_STRANGERS:
            self._strangers.add(stranger)
            self.warnings.append(f"{name_of(stranger)}: {text}")


def autopilots(frames: list[Frame]) -> set[int]:
    """Systems whose autopilot sent one of these frames."""
    return {frame.sysid for frame in frames if frame.compid == MavComponent.AUTOPILOT1}


def has_flown_autopilot(frames: list[Frame], sysid: int) -> bool:
    """Whether one of these frames is a heartbeat of that system that can be flown with."""
    beats = (
        decode(frame)
        for frame in frames
        if (frame.sysid, frame.compid) == (sysid, MavComponent.AUTOPILOT1)
        and frame.msgid == Heartbeat.MSGID
    )
    return any(isinstance(beat, Heartbeat) and autopilot_of(beat) is not None for beat in beats)


def listen(url: NetworkUrl, sysid: int) -> UdpLink:
    """A link that waits at `url` to be spoken to.

    Raises:
        ConnectError: the port is in use, or the host is not this machine.
    """
    opened, address = open_socket(url)
    try:
        opened.bind(address)
    except OSError as error:
        opened.close()
        raise ConnectError(f"{url}: cannot listen there: {error.strerror}") from error
    return UdpLink(opened, sysid, None)


def call(url: NetworkUrl, sysid: int) -> UdpLink:
    """A link that sends first, to `url`, and receives from there alone.

    Raises:
        ConnectError: there is no route to that host.
    """
    opened, address = open_socket(url)
    try:
        opened.connect(address)
    except OSError as error:
        opened.close()
        raise ConnectError(f"{url}: cannot send there: {error.strerror}") from error
    return UdpLink(opened, sysid, opened.getpeername())


def open_socket(url: NetworkUrl) -> tuple[socket.socket, Address]:
    """A socket that never blocks, and the address of `url`.

    Raises:
        ConnectError: the host is unknown, or what is given is no name of one.
    """
    try:
        family, kind, protocol, _, address = socket.getaddrinfo(
            url.host, url.port, type=socket.SOCK_DGRAM
        )[0]
    except OSError as error:
        raise ConnectError(f"{url}: unknown host: {error.strerror}") from error
    except UnicodeError as error:
        raise ConnectError(f"{url}: not the name of a host") from error
    opened = socket.socket(family, kind, protocol)
    opened.setblocking(False)
    return opened, address


def datagrams(opened: socket.socket) -> Iterator[tuple[bytes, Address]]:
    """What waits in a socket, with its senders, at most MOST_AT_ONCE datagrams."""
    for _ in range(MOST_AT_ONCE):
        try:
            yield opened.recvfrom(MAX_DATAGRAM)
        except ConnectionError:
            continue  # an earlier datagram met a closed port
        except OSError:
            return  # nothing more, or the network is down: it may come back


def name_of(address: Address | None) -> str:
    """Host and port of an address, in words."""
    return f"{address[0]}:{address[1]}" if address else "nowhere"
