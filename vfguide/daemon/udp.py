"""Links over UDP: a datagram holds whole frames, and anybody on the network can send one."""

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
"""Largest number of datagrams that are taken in one go; chosen, so that a flood does not keep the
companion from its other duties."""
PEER_SILENT = 3_000_000
"""Time of silence after which a peer may be replaced by another sender [us]; chosen."""
LONGEST_UNSEEN = 500_000
"""Time between two reads of the socket above which this program stood still, which is no silence of
the peer [us]; chosen as ten POLL_INTERVALs."""
MAX_STRANGERS = 5
"""Largest number of senders other than the peer of which the operator is warned; chosen."""

Address = tuple[Any, ...]
"""Address of a socket: host, port, and what its address family adds."""


class UdpLink:
    """A socket and the one peer whose frames are taken; datagrams of all others are ignored."""

    def __init__(self, opened: socket.socket, sysid: int, peer: Address | None) -> None:
        """A link to the autopilot of system `sysid`.

        Args:
            opened: the socket, bound or connected, which does not block.
            sysid: MAVLink system of the vehicle.
            peer: address of its autopilot. None: it is learned. It is at first that of the first
                sender that speaks as this autopilot. A sender with a heartbeat of an autopilot that
                the companion can fly replaces it. After that another one with such a heartbeat does
                so only after PEER_SILENT.
        """
        self.socket = opened
        self.warnings: list[str] = []
        """Warnings for the operator; the caller removes them."""
        self._sysid = sysid
        self._peer = peer
        self._learns = peer is None
        self._is_sure = False
        self._heard = 0
        self._looked: int | None = None
        self._strangers: set[Address] = set()
        self._parser = Parser()

    def fileno(self) -> int:
        """File descriptor of the socket, to wait for."""
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
        """Send one frame to the peer; it is lost while no peer is known."""
        if self._peer is not None:
            with suppress(OSError):  # as on a radio: what cannot be sent is lost
                self.socket.sendto(raw, self._peer)

    def close(self) -> None:
        """Close the socket, which frees its port."""
        self.socket.close()

    def _look(self, now: int) -> None:
        """Note that the socket is read; a pause of this program is no silence of the peer."""
        pause = 0 if self._looked is None else now - self._looked
        self._looked = now
        if pause > LONGEST_UNSEEN:
            self._heard += pause

    def _hear(self, now: int, sender: Address, sysid: int, *, is_flown: bool) -> None:
        """Note who speaks as the autopilot of system `sysid`, and warn of all but the peer.

        `is_flown` says that a heartbeat is among its frames of an autopilot that can be flown.
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
        """Whether a sender may become the peer at `now` [us], as `__init__` explains."""
        if not self._is_sure:
            return self._peer is None or is_flown
        return is_flown and now - self._heard > PEER_SILENT

    def _tell_of(self, stranger: Address, text: str) -> None:
        """Warn the operator once of each of the first MAX_STRANGERS other senders."""
        if stranger not in self._strangers and len(self._strangers) < MAX_STRANGERS:
            self._strangers.add(stranger)
            self.warnings.append(f"{name_of(stranger)}: {text}")


def autopilots(frames: list[Frame]) -> set[int]:
    """MAVLink systems whose autopilot sent one of these frames."""
    return {frame.sysid for frame in frames if frame.compid == MavComponent.AUTOPILOT1}


def has_flown_autopilot(frames: list[Frame], sysid: int) -> bool:
    """Whether a heartbeat of system `sysid`, of an autopilot that can be flown, is among frames."""
    beats = (
        decode(frame)
        for frame in frames
        if (frame.sysid, frame.compid) == (sysid, MavComponent.AUTOPILOT1)
        and frame.msgid == Heartbeat.MSGID
    )
    return any(isinstance(beat, Heartbeat) and autopilot_of(beat) is not None for beat in beats)


def listen(url: NetworkUrl, sysid: int) -> UdpLink:
    """A link that listens at `url` until an autopilot speaks.

    Raises:
        ConnectError: the host is unknown or not this machine, or the port is in use.
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
        ConnectError: the host is unknown, or there is no route to it.
    """
    opened, address = open_socket(url)
    try:
        opened.connect(address)
    except OSError as error:
        opened.close()
        raise ConnectError(f"{url}: cannot send there: {error.strerror}") from error
    return UdpLink(opened, sysid, opened.getpeername())


def open_socket(url: NetworkUrl) -> tuple[socket.socket, Address]:
    """A socket that does not block, and the address of `url`.

    Raises:
        ConnectError: the host is unknown, or its name is not valid.
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
    """The datagrams that wait in a socket, at most MOST_AT_ONCE, each with its sender."""
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
