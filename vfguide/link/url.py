"""Where an autopilot is reached: the URLs of the command line."""

from dataclasses import dataclass
from enum import StrEnum


class UrlError(ValueError):
    """A text that is none of the allowed forms; the message lists them."""

    def __init__(self, text: str, reason: str) -> None:
        super().__init__(
            f"{text!r}: {reason}. Allowed: udpin:HOST:PORT (listen there), udpout:HOST:PORT"
            " (send there), for example udpin:127.0.0.1:14540;"
            " not yet: tcp:HOST:PORT, serial:DEVICE:BAUD"
        )


class Transport(StrEnum):
    """How to reach a host."""

    UDPIN = "udpin"
    """Listen, answer to where the last datagram came from."""
    UDPOUT = "udpout"
    TCP = "tcp"


@dataclass(frozen=True)
class NetworkUrl:
    """`udpin:HOST:PORT`, `udpout:HOST:PORT` or `tcp:HOST:PORT`."""

    transport: Transport
    """Kind of the link."""
    host: str
    """A name or an address, that of IPv6 without its brackets."""
    port: int
    """Number of the port, 1 to 65535."""

    def __str__(self) -> str:
        host = f"[{self.host}]" if ":" in self.host else self.host
        return f"{self.transport}:{host}:{self.port}"


@dataclass(frozen=True)
class SerialUrl:
    """`serial:DEVICE:BAUD`."""

    device: str
    """Path of the device."""
    baud: int
    """Rate of the line [bit/s]."""

    def __str__(self) -> str:
        return f"serial:{self.device}:{self.baud}"


Url = NetworkUrl | SerialUrl


def parse_url(text: str) -> Url:
    """The record of a URL; `str` of it gives the text again.

    Raises:
        UrlError: the text is none of the forms.
    """
    scheme, _, rest = text.partition(":")
    if scheme == "serial":
        return _serial(text, *_parts(text, rest, "device", "baud rate"))
    if scheme in list(Transport):
        return _network(text, Transport(scheme), *_parts(text, rest, "host", "port"))
    raise UrlError(text, f"{scheme!r} does not reach an autopilot")


def _parts(text: str, rest: str, place: str, number: str) -> tuple[str, str]:
    """Place and number behind the scheme, by whose names they are missed."""
    before, colon, after = rest.rpartition(":")
    if colon and not rest.endswith("]"):
        if not before:
            raise UrlError(text, f"the {place} is missing")
        return before, after
    if not rest:
        raise UrlError(text, f"the {place} and the {number} are missing")
    raise UrlError(text, f"the {place if rest.isdigit() else number} is missing")


def _serial(text: str, device: str, number: str) -> SerialUrl:
    baud = _positive(number)
    if baud is None:
        raise UrlError(text, "the baud rate must be a whole number above 0")
    return SerialUrl(device, baud)


def _network(text: str, transport: Transport, host: str, number: str) -> NetworkUrl:
    if host.startswith("[") and host.endswith("]"):
        host = host[1:-1]
    elif ":" in host:
        raise UrlError(text, "an IPv6 address stands in brackets, as [::1]")
    if not host:
        raise UrlError(text, "the host is missing")
    port = _positive(number)
    if port is None or port > 65535:
        raise UrlError(text, "the port must be a whole number, 1 to 65535")
    return NetworkUrl(transport, host, port)


def _positive(digits: str) -> int | None:
    """The number above 0 in plain digits, None if there is none."""
    number = int(digits) if digits.isascii() and digits.isdigit() and len(digits) < 10 else 0
    return number or None
