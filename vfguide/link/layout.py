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


BodyPacker = Callable[[int, int, int, Message], bytes]
"""Function of sequence number, system, component and message that gives header and payload."""


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
        self.body = self._body_packer(record, fields)
        """Function of sequence number, system, component and message that gives the bytes between
        magic byte and checksum of a frame: header and payload.

        No flags; zeros are cut off the end of the payload, but for its first byte. It raises
        `EncodeError` where a field does not fit.
        """
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

    def _body_packer(self, record: type[Message], fields: list[WireField]) -> BodyPacker:
        """The function `body`.

        It is written out: one call for a message takes half the time of one for each array. Taking
        the record apart at once takes a third of the time of reading its fields by name, and taking
        an array apart refuses one of another length.
        """
        codes = "".join(field.code for field in fields)
        size, body = struct.calcsize("<" + codes), struct.Struct(_HEADER_CODES + codes)
        header = f"{size}, 0, 0, seq, sysid, compid, {record.MSGID.to_bytes(3, 'little')}"
        values = ", ".join(_value(field) for field in fields)
        source = f"""def body(seq, sysid, compid, record):
    try:
        {", ".join(_target(self._fields[name]) for name in record._fields)}, = record
        body = pack({header}, {values})
    except MISFITS as error:
        raise misfit(record) from error
    return body if body[-1] else without_zeros(body)"""
        scope = {
            "pack": body.pack,
            "text": _text_bytes,
            "without_zeros": _without_zeros,
            "misfit": self._misfit,
            "MISFITS": _MISFITS,
        }
        return source_function(source, "body", scope)

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


def _parts(field: WireField) -> str:
    """The variables of the elements of an array."""
    return ", ".join(f"its_{field.name}_{i}" for i in range(field.size))


def _target(field: WireField) -> str:
    """The source of what a field is assigned to."""
    return f"({_parts(field)},)" if field.is_array else f"its_{field.name}"


def _value(field: WireField) -> str:
    """The source of the arguments with which a field is packed."""
    if field.is_text:
        return f"text(its_{field.name}, {field.size})"
    return _parts(field) if field.is_array else f"its_{field.name}"


def _without_zeros(body: bytes) -> bytes:
    """Header and payload without the zeros at its end, but for its first byte."""
    kept = max(len(body.rstrip(b"\0")), HEADER_BYTES + 1)
    return bytes((kept - HEADER_BYTES,)) + body[1:kept]


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
