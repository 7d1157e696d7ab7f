"""The types of the columns of a campaign's table, derived from the records that it holds."""

import types
from collections.abc import Iterable, Mapping
from dataclasses import is_dataclass
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

import pyarrow as pa

from vfguide.campaign.rows import FlightRow

_SCALARS = {float: pa.float64(), int: pa.int64(), bool: pa.bool_(), str: pa.string()}


_VALUES: Mapping[pa.DataType, object] = {
    pa.float64(): 0.5,
    pa.int64(): 1,
    pa.bool_(): True,
    pa.string(): "a word",
}
COLUMN_WORDS: Mapping[str, tuple[str, ...]] = {
    "verdict": get_args(get_type_hints(FlightRow)["verdict"])
}
"""All words that a column can hold, where they are known."""


def schema_of(varied: Iterable[str]) -> pa.Schema:
    """The columns of a `FlightRow`, the command that flies it, then those of the varied keys."""
    drawn = [pa.field(key, pa.float64()) for key in varied]
    return pa.schema([*fields_of(FlightRow), pa.field("command", pa.string()), *drawn])


def simple_columns(schema: pa.Schema) -> list[str]:
    """Names of the columns that hold numbers, words, true or false: no lists."""
    return [field.name for field in schema if not pa.types.is_nested(field.type)]


def values_in(schema: pa.Schema) -> dict[str, object]:
    """A value that each of the simple columns can hold."""
    return {name: _VALUES[schema.field(name).type] for name in simple_columns(schema)}


def fields_of(record: Any) -> list[Any]:
    """The `pyarrow.Field` of each field of a dataclass, in their order."""
    return [pa.field(name, arrow_type(kind)) for name, kind in get_type_hints(record).items()]


def arrow_type(kind: Any) -> pa.DataType:
    """The type that holds values of a type of ours.

    Raises:
        TypeError: there is none.
    """
    if kind in _SCALARS:
        return _SCALARS[kind]
    if is_dataclass(kind):
        return pa.struct(fields_of(kind))
    origin, parts = get_origin(kind), get_args(kind)
    if origin is Literal:
        return pa.string()
    if origin in (Union, types.UnionType):
        (present,) = set(parts) - {type(None)}
        return arrow_type(present)
    if origin is tuple:
        (element,) = set(parts) - {Ellipsis}
        return pa.list_(arrow_type(element))
    raise TypeError(f"no column can hold {kind}")
