"""What pymavlink's tables say of the messages on the wire; the only module that knows it."""

import re
from typing import NamedTuple

from pymavlink.dialects.v20 import all as dialect


class WireField(NamedTuple):
    """One field as it lies on the wire."""

    name: str
    """Name of the field in the dialect."""
    code: str
    """Its `struct` format: "B" a byte, "4f" an array, "16s" a text."""

    @property
    def size(self) -> int:
        """How many elements an array has, bytes a text; 1 for a number."""
        return int(self.code[:-1] or 1)

    @property
    def is_text(self) -> bool:
        """Whether the field is a text."""
        return self.code[-1] == "s"

    @property
    def is_array(self) -> bool:
        """Whether the field is an array of numbers."""
        return len(self.code) > 1 and not self.is_text


def wire_fields(msgid: int) -> list[WireField]:
    """Fields of a message in their order on the wire: the widest first, extensions last."""
    message = dialect.mavlink_map[msgid]
    codes = re.findall(r"\d*[a-zA-Z]", message.unpacker.format)
    return [
        WireField(name, code) for name, code in zip(message.ordered_fieldnames, codes, strict=True)
    ]


CRC_EXTRA: dict[int, bytes] = {
    msgid: bytes((message.crc_extra,)) for msgid, message in dialect.mavlink_map.items()
}
"""The byte by which the checksum of a message depends on its definition, by message id (CRC_EXTRA
of MAVLink)."""
