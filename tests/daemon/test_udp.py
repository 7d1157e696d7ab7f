"""Who is heard on a UDP link."""

import socket

import pytest

from vfguide.autopilots.px4 import Px4Mode
from vfguide.daemon.transport import ConnectError
from vfguide.daemon.udp import PEER_SILENT, UdpLink, call, listen
from vfguide.link.codec import Encoder
from vfguide.link.enums import MavAutopilot, MavState, MavType
from vfguide.link.messages import Heartbeat
from vfguide.link.url import parse_url

BEAT = Heartbeat(MavType.FIXED_WING, MavAutopilot.PX4, 0, Px4Mode.HOLD, MavState.ACTIVE)
AUTOPILOT = Encoder(1, 1).encode(BEAT)
CAMERA = Encoder(1, 100).encode(BEAT)
OTHER = Encoder(2, 1).encode(BEAT)


class Peer:
    def __init__(self, link):
        self.link = link
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.socket.settimeout(0.2)

    def send(self, *datagrams):
        for data in datagrams:
            self.socket.sendto(data, self.link.socket.getsockname())

    def hears(self):
        try:
            return self.socket.recv(1000)
        except TimeoutError:
            return None


@pytest.fixture
def link():
    opened = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    opened.setblocking(False)
    opened.bind(("127.0.0.1", 0))
    made = UdpLink(opened, 1, None)
    yield made
    made.close()


@pytest.fixture
def peers(link):
    made = [Peer(link), Peer(link)]
    yield made
    for peer in made:
        peer.socket.close()


def raws(frames):
    return [frame.raw for frame in frames]


def test_nothing_is_sent_before_anybody_is_heard(link):
    link.send(AUTOPILOT)
    assert link.receive(0) == []


def test_the_first_autopilot_is_the_peer(link, peers):
    first, second = peers
    second.send(b"junk", OTHER, CAMERA)
    assert link.receive(0) == []
    first.send(AUTOPILOT, CAMERA)
    assert raws(link.receive(0)) == [AUTOPILOT, CAMERA]
    link.send(b"answer")
    assert first.hears() == b"answer"
    assert second.hears() is None


def test_another_one_is_ignored_and_told_once(link, peers):
    first, second = peers
    first.send(AUTOPILOT)
    link.receive(0)
    second.send(AUTOPILOT, AUTOPILOT, CAMERA)
    assert link.receive(1000) == []
    (warning,) = link.warnings
    assert str(second.socket.getsockname()[1]) in warning


def test_the_autopilot_of_another_vehicle_is_told(link, peers):
    peers[0].send(OTHER, OTHER)
    assert link.receive(0) == []
    (warning,) = link.warnings
    assert warning.endswith("vehicle 2 is heard, waited for is 1")


def test_after_a_silence_another_one_may_be_the_peer(link, peers):
    first, second = peers
    first.send(AUTOPILOT)
    link.receive(0)
    second.send(AUTOPILOT)
    assert raws(link.receive(PEER_SILENT + 1)) == [AUTOPILOT]
    link.send(b"answer")
    assert second.hears() == b"answer"


def test_junk_does_not_hide_the_frames_of_the_next_datagram(link, peers):
    first, second = peers
    for junk in (b"", b"\xfd\xff\x00", b"\xfe\xff", AUTOPILOT[:12], bytes(2000)):
        second.send(junk)
        first.send(junk, AUTOPILOT, junk + AUTOPILOT)
        assert raws(link.receive(0)) == [AUTOPILOT, AUTOPILOT]


def test_a_called_peer_need_not_be_there(peers):
    quiet = peers[0].socket.getsockname()[1]
    peers[0].socket.close()
    link = call(parse_url(f"udpout:127.0.0.1:{quiet}"), 1)
    for _ in range(5):
        link.send(AUTOPILOT)
        assert link.receive(0) == []
    link.close()


def test_a_called_peer_is_the_only_one(link, peers):
    first, second = peers
    called = call(parse_url(f"udpout:127.0.0.1:{first.socket.getsockname()[1]}"), 1)
    for peer in (second, first):
        peer.socket.sendto(AUTOPILOT, called.socket.getsockname())
    assert len(called.receive(0)) == 1
    called.close()


@pytest.mark.parametrize("host", ["a" * 64, "a" * 300, "a..b", "\u00fc" * 70, "\udcff"])
def test_what_is_no_name_of_a_host_is_told(host):
    """Names are encoded before they are asked for, in labels of 63 characters."""
    with pytest.raises(ConnectError, match=r"(not the name of a|unknown) host"):
        listen(parse_url(f"udpin:{host}:14540"), 1)


def test_an_unknown_host_is_told():
    with pytest.raises(ConnectError, match="unknown host"):
        listen(parse_url("udpin:no.such.host.invalid:14540"), 1)
