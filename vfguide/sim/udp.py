"""The UDP side of a simulated vehicle: one socket a channel, numbered as PX4 numbers them."""

import socket
from contextlib import suppress
from typing import NamedTuple

from vfguide.sim.autopilot.mavlink_channel import MavlinkChannel
from vfguide.sim.vehicle import Vehicle

LOOPBACK = "127.0.0.1"
"""Address of this machine alone, on which the simulator listens."""
MAX_DATAGRAM = 65_535
"""Largest size of a UDP datagram, a number of bytes (RFC 768)."""
MOST_PER_STEP = 64
"""Largest number of datagrams that are taken before the vehicle flies on; chosen, so that a flood
does not delay it."""
PORT_GAP = 1000
"""Number by which the companions' ports lie higher from the eleventh vehicle on, since port 14550
is that of ground stations."""

Address = tuple[str, int]


class Numbers(NamedTuple):
    """The two ends of a channel."""

    own: int
    """Port the vehicle sends from."""
    peer: int
    """Port it sends to until another peer sends to it."""


def offboard_numbers(sysid: int) -> Numbers:
    """Ports of the channel to the companion."""
    k = sysid - 1
    return Numbers(14580 + k, 14540 + k + (PORT_GAP if k >= 10 else 0))


def ground_numbers(sysid: int) -> Numbers:
    """Ports of the channel to the ground station; it hears all vehicles on one."""
    return Numbers(18570 + sysid - 1, 14550)


class PortTakenError(Exception):
    """A socket cannot be had; the message names the port and says why."""


class Channel:
    """One channel of a vehicle over a socket of its own.

    It sends to whoever spoke last on it, as PX4 does: to the sender of the last datagram with a
    true frame in it.
    """

    def __init__(
        self, vehicle: Vehicle, rates: dict[int, float], bound: socket.socket, numbers: Numbers
    ) -> None:
        """A channel with these streams [Hz] over the socket `bound` to its own port."""
        self.vehicle = vehicle
        self.numbers = numbers
        self.peer: Address = (LOOPBACK, numbers.peer)
        self.socket = bound
        self._port: MavlinkChannel = vehicle.connect(rates)

    def receive(self) -> None:
        """Take what has arrived, and answer it at once."""
        for _ in range(MOST_PER_STEP):
            try:
                data, sender = self.socket.recvfrom(MAX_DATAGRAM)
            except BlockingIOError:
                return
            except ConnectionError:
                continue  # an earlier datagram met a closed port
            before = self._port.parser.counters.frames
            answers = self.vehicle.receive(self._port, data)
            if self._port.parser.counters.frames > before:
                self.peer = sender
            self._send(answers)

    def transmit(self) -> None:
        """Send what is due."""
        self._send(self.vehicle.transmit(self._port))

    def _send(self, frames: list[bytes]) -> None:
        for frame in frames:
            with suppress(OSError):  # as on a radio: what cannot be sent is lost
                self.socket.sendto(frame, self.peer)


def bound_socket(number: int) -> socket.socket:
    """A socket that never blocks, bound to a port of this machine alone.

    Raises:
        PortTakenError: the port is in use.
    """
    made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    made.setblocking(False)
    try:
        made.bind((LOOPBACK, number))
    except OSError as error:
        made.close()
        raise PortTakenError(
            f"UDP port {LOOPBACK}:{number} cannot be had: {error.strerror}; "
            "is another simulation running?"
        ) from error
    return made
