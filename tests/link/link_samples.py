"""Random records, and the same messages as pymavlink writes them."""

import inspect
import math
import struct
from typing import Any

from hypothesis import strategies as st
from pymavlink.dialects.v20 import all as dialect

from vfguide.link.messages import RECORDS

ASCII = st.characters(min_codepoint=1, max_codepoint=126)


def pymavlink_class(record: type) -> Any:
    return dialect.mavlink_map[record.MSGID]


def extensions(record: type) -> list[str]:
    """Fields that came to the message later: pymavlink's constructor can do without them."""
    parameters = inspect.signature(pymavlink_class(record).__init__).parameters.values()
    return [p.name for p in parameters if p.default is not inspect.Parameter.empty]


def number(kind: str) -> st.SearchStrategy:
    if kind == "float":
        return st.floats(width=32)
    bits = int("".join(filter(str.isdigit, kind.removesuffix("_t"))))
    low = 0 if kind.startswith("u") else -(2 ** (bits - 1))
    return st.integers(low, low + 2**bits - 1)


def field_values(record: type, name: str) -> st.SearchStrategy:
    message = pymavlink_class(record)
    kind = message.fieldtypes[message.fieldnames.index(name)]
    size = message.array_lengths[message.ordered_fieldnames.index(name)]
    if kind == "char":
        return st.text(ASCII, max_size=size)
    if size:
        return st.tuples(*[number(kind)] * size)
    return number(kind)


def records_of(record: type) -> st.SearchStrategy:
    return st.builds(record, *(field_values(record, name) for name in record._fields))


any_record = st.one_of([records_of(record) for record in RECORDS])
magic_rich = st.lists(
    st.sampled_from([0xFD, 0xFE, 0, 1, 9, 36, 255]) | st.integers(0, 255), max_size=60
).map(bytes)
"""Bytes among which a frame may seem to begin."""


def pymavlink_message(record: Any) -> Any:
    values = [value.encode() if isinstance(value, str) else value for value in record]
    return pymavlink_class(record)(*values)


def pymavlink_sender(sysid: int = 1, compid: int = 1, seq: int = 0) -> Any:
    sender = dialect.MAVLink(None, sysid, compid)
    sender.seq = seq
    return sender


def values_of(message: Any) -> list[Any]:
    """Fields of pymavlink's message, as our records hold them."""
    values = [getattr(message, name) for name in message.fieldnames]
    return [tuple(value) if isinstance(value, list) else value for value in values]


def unknown_frame(payload: bytes) -> bytes:
    """A frame of a message that no dialect has."""
    header = struct.pack("<10B", 0xFD, len(payload), 0, 0, 0, 1, 1, 0xF0, 0xFF, 0xFF)
    return header + payload + b"??"


def same(a: Any, b: Any) -> bool:
    """Equal, nan with nan."""
    if isinstance(a, tuple | list):
        return len(a) == len(b) and all(same(x, y) for x, y in zip(a, b, strict=True))
    return a == b or (isinstance(a, float) and math.isnan(a) and math.isnan(b))
