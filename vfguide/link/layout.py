"""How the fields of a record lie on the wire, worked out from the dialect's tables."""

import struct
from collections.abc import Callable
from operator import itemgetter
from typing import Any

from vfguide.kernels.written_functions import maker, source_function
from vfguide.link.dialect import CRC_EXTRA, WireField, wire_fields
from vfguide.link.messages import RECORDS, Message

_KINDS = {
    "b": "an integer, -128 to 127",
    "B": "an integer, 0 to 255",
    "h": "an integer, -32768 to 32767",
    "H": "an integer, 0 to 65535",
    "i": "an integer, -2147483648 to 2147483647",
    "I": "an integer, 0 to 4294967295",
    "q": "an integer of 64 bits",
    "Q": "an integer of 64 bits, not negative",
    "f": "a number within +-3.4e38, inf or nan",
    "d": "a number",
    "s": "text without NUL",
}
_MISFITS = (struct.error, ValueError, OverflowError, TypeError, AttributeError)
"""What `struct` and the conversions raise at a value that does not fit."""


_HEADER_CODES = "<6B3s"
"""Length, flags that change the frame, other flags, sequence, system, component, message id."""
HEADER_BYTES = 9
"""Number of bytes of a MAVLink 2 header after its first byte."""


class EncodeError(ValueError):
    """We asked for bytes that MAVLink cannot carry."""


class Layout:
    """Turns one class of records to payloads and back."""

    def __init__(self, record: type[Message]) -> None:
        self.crc_extra = CRC_EXTRA[record.MSGID]
        fields = _fields_of(record)
        self._fields = {field.name: field for field in fields}
        self._struct = struct.Struct("<" + "".join(field.code for field in fields))
        self._make: Callable[[Any], Message] = maker(record)
        self._pack_body = _body_packer(record.MSGID, fields)
        self._to_record = itemgetter(*_slots(record, fields))
        self._texts = [i for i, name in enumerate(record._fields) if self._fields[name].is_text]

    def unpack(self, payload: bytes) -> Message:
        """The record; what the payload lacks is zero, what it has beyond is left out."""
        values = self._to_record(self._struct.unpack_from(payload.ljust(self._struct.size, b"\0")))
        if self._texts:
            values = list(values)
            for i in self._texts:
                text, _, _ = values[i].partition(b"\0")
                values[i] = text.decode(errors="replace")
        return self._make(values)

    def body(self, seq: int, sysid: int, compid: int, message: Message) -> bytes:
        """The bytes between magic byte and checksum of a frame: header and payload.

        No flags; zeros are cut off the end of the payload, but for its first byte.

        Raises:
            EncodeError: a field does not fit.
        """
        try:
            body = self._pack_body(seq, sysid, compid, message)
        except _MISFITS as error:
            raise self._misfit(message) from error
        if body[-1]:
            return body
        kept = max(len(body.rstrip(b"\0")), HEADER_BYTES + 1)
        return bytes((kept - HEADER_BYTES,)) + body[1:kept]

    def _misfit(self, message: Message) -> EncodeError:
        """The error that names the first field that does not fit."""
        field, value = next(
            (self._fields[name], value)
            for name, value in zip(message._fields, message, strict=True)
            if not _fits(value, self._fields[name])
        )
        return EncodeError(f"{message.NAME}.{field.name} = {value!r}: must be {_kind(field)}")


def _fields_of(record: type[Message]) -> list[WireField]:
    """Fields of a record in wire order, without extensions at the end that it leaves out."""
    fields = wire_fields(record.MSGID)
    while fields[-1].name not in record._fields:
        fields.pop()
    return fields


def _slots(record: type[Message], fields: list[WireField]) -> list[int | slice]:
    """For each field of the record, where it is among the values that `struct` unpacks."""
    slots: dict[str, int | slice] = {}
    position = 0
    for field in fields:
        width = field.size if field.is_array else 1
        slots[field.name] = slice(position, position + width) if field.is_array else position
        position += width
    return [slots[name] for name in record._fields]


def _body_packer(msgid: int, fields: list[WireField]) -> Callable[[int, int, int, Message], bytes]:
    """A function of sequence number, system, component and record that gives header and payload.

    It is written out: one call for a message takes half the time of one for each array. Taking an
    array apart by names refuses one of another length.
    """
    codes = "".join(field.code for field in fields)
    size, body = struct.calcsize("<" + codes), struct.Struct(_HEADER_CODES + codes)
    lines, values = ["def pack_body(seq, sysid, compid, r):"], list[str]()
    for field in fields:
        if field.is_text:
            values.append(f"text(r.{field.name}, {field.size})")
        elif field.is_array:
            parts = [f"{field.name}_{i}" for i in range(field.size)]
            lines.append(f"    {', '.join(parts)}, = r.{field.name}")
            values += parts
        else:
            values.append(f"r.{field.name}")
    header = f"{size}, 0, 0, seq, sysid, compid, {msgid.to_bytes(3, 'little')}"
    lines.append(f"    return pack({header}, {', '.join(values)})")
    scope = {"pack": body.pack, "text": _text_bytes}
    return source_function("\n".join(lines), "pack_body", scope)


def _text_bytes(text: str, size: int) -> bytes:
    data = text.encode()
    if len(data) > size or b"\0" in data:
        raise ValueError
    return data


def _fits(value: Any, field: WireField) -> bool:
    try:
        if field.is_text:
            _text_bytes(value, field.size)
        else:
            struct.pack("<" + field.code, *(value if field.is_array else (value,)))
    except _MISFITS:
        return False
    return True


def _kind(field: WireField) -> str:
    """What values a field takes, in words."""
    kind = _KINDS[field.code[-1]]
    if field.is_text:
        return f"{kind}, at most {field.size} bytes of UTF-8"
    return f"{field.size} values, each {kind}" if field.is_array else kind


LAYOUTS: dict[type[Message], Layout] = {record: Layout(record) for record in RECORDS}
"""The layout of every message that the codec reads and writes, by its class."""
