"""Messages to frames and back.

Two kinds of error, by whose fault it is: a record of ours that the wire cannot carry raises
`EncodeError`; what a peer sends never raises, it is counted by the `Parser`.
"""

from fastcrc.crc16 import mcrf4xx

from vfguide.link.frame import MAGIC_2, Frame, LinkCounters, Parser
from vfguide.link.layout import LAYOUTS, EncodeError
from vfguide.link.messages import Message

__all__ = ["EncodeError", "Encoder", "Frame", "LinkCounters", "Parser", "decode"]

_MAGIC = bytes((MAGIC_2,))
_LAYOUTS_BY_ID = {record.MSGID: layout for record, layout in LAYOUTS.items()}


class Encoder:
    """Writes the messages of one component, numbering them."""

    def __init__(self, sysid: int, compid: int) -> None:
        if not (1 <= sysid <= 255 and 1 <= compid <= 255):
            raise EncodeError(f"system {sysid}, component {compid}: both must be 1 to 255")
        self.sysid = sysid
        self.compid = compid
        self.seq = 0
        """Sequence number of the next frame."""

    def encode(self, message: Message) -> bytes:
        """The MAVLink 2 frame of a message, unsigned, zeros cut off the end of its payload.

        Raises:
            EncodeError: a field does not fit, or `message` is none of the records.
        """
        try:
            layout = LAYOUTS[type(message)]
        except KeyError as error:
            raise EncodeError(f"{message!r} is none of the records of messages") from error
        body = layout.body(self.seq, self.sysid, self.compid, message)
        checksum = mcrf4xx(body + layout.crc_extra)
        self.seq = (self.seq + 1) & 0xFF
        return _MAGIC + body + checksum.to_bytes(2, "little")


def decode(frame: Frame) -> Message | None:
    """The message of a frame, None if there is no record of it.

    Fields that the payload lacks, cut off or unknown to an older sender, are zero. A text ends at
    its first NUL; what is not UTF-8 in it becomes U+FFFD.
    """
    layout = _LAYOUTS_BY_ID.get(frame.msgid)
    return layout.unpack(frame.payload) if layout else None
