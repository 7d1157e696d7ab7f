import dataclasses

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.link.url import NetworkUrl, SerialUrl, Transport, UrlError, parse_url


@pytest.mark.parametrize(
    ("text", "url"),
    [
        ("udpin:127.0.0.1:14540", NetworkUrl(Transport.UDPIN, "127.0.0.1", 14540)),
        ("udpin:0.0.0.0:1", NetworkUrl(Transport.UDPIN, "0.0.0.0", 1)),
        ("udpout:plane.local:65535", NetworkUrl(Transport.UDPOUT, "plane.local", 65535)),
        ("udpout:[::1]:14550", NetworkUrl(Transport.UDPOUT, "::1", 14550)),
        ("tcp:localhost:5760", NetworkUrl(Transport.TCP, "localhost", 5760)),
        ("serial:/dev/ttyACM0:57600", SerialUrl("/dev/ttyACM0", 57600)),
        (
            "serial:/dev/by-path/pci-0:14.0-usb-0:3:9600",
            SerialUrl("/dev/by-path/pci-0:14.0-usb-0:3", 9600),
        ),
        ("serial:COM3:921600", SerialUrl("COM3", 921600)),
    ],
)
def test_the_forms(text, url):
    assert parse_url(text) == url
    assert str(url) == text


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "does not reach"),
        ("udp:127.0.0.1:14540", "'udp' does not reach"),
        ("UDPIN:127.0.0.1:14540", "'UDPIN' does not reach"),
        ("127.0.0.1:14540", "does not reach"),
        ("udpin", "host"),
        ("udpin:", "host"),
        ("udpin:14540", "host"),
        ("udpin::14540", "host"),
        ("udpin:[]:14540", "host"),
        ("udpin:127.0.0.1", "the port is missing"),
        ("udpout:plane.local", "the port is missing"),
        ("udpin:[::1]", "the port is missing"),
        ("udpin:127.0.0.1:", "port"),
        ("udpin:127.0.0.1:0", "port"),
        ("udpin:127.0.0.1:65536", "port"),
        ("udpin:127.0.0.1:-1", "port"),
        ("udpin:127.0.0.1: 1", "port"),
        ("udpin:127.0.0.1:1_0", "port"),
        ("udpin:127.0.0.1:²", "port"),
        ("udpin:127.0.0.1:x", "port"),
        ("tcp:::1:5760", "brackets"),
        ("serial:57600", "device"),
        ("serial:/dev/ttyACM0", "the baud rate is missing"),
        ("serial:/dev/ttyACM0:", "baud"),
        ("serial:/dev/ttyACM0:0", "baud"),
        ("serial:/dev/ttyACM0:fast", "baud"),
    ],
)
def test_anything_else_is_refused_with_the_forms(text, reason):
    with pytest.raises(UrlError, match=reason) as caught:
        parse_url(text)
    for form in ("udpin:HOST:PORT", "udpout:HOST:PORT", "tcp:HOST:PORT", "serial:DEVICE:BAUD"):
        assert form in str(caught.value)


@given(
    st.sampled_from(["udpin", "udpout", "tcp", "serial", "udp"]),
    st.text(max_size=9) | st.ip_addresses().map(str) | st.ip_addresses(v=6).map("[{}]".format),
    st.integers(-1, 70_000).map(str) | st.text("0123456789 -_+", max_size=5),
)
def test_a_text_is_refused_or_its_record_says_the_same(scheme, place, number):
    try:
        url = parse_url(f"{scheme}:{place}:{number}")
    except UrlError:
        return
    assert parse_url(str(url)) == url


def test_the_record_cannot_be_changed():
    with pytest.raises(dataclasses.FrozenInstanceError):
        parse_url("tcp:localhost:5760").port = 1
