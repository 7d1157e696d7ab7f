"""The open link that a URL names."""

from vfguide.daemon.transport import ConnectError, Transport
from vfguide.daemon.udp import call, listen
from vfguide.link.url import NetworkUrl, Url
from vfguide.link.url import Transport as Kind


def connect(url: Url, sysid: int) -> Transport:
    """The link to the autopilot of system `sysid` at `url`.

    Raises:
        ConnectError: it cannot be opened, or this kind of link cannot be flown yet.
    """
    match url:
        case NetworkUrl(transport=Kind.UDPIN):
            return listen(url, sysid)
        case NetworkUrl(transport=Kind.UDPOUT):
            return call(url, sysid)
        case _:
            raise ConnectError(
                f"{url}: not supported yet, allowed are udpin:HOST:PORT and udpout:HOST:PORT"
            )
