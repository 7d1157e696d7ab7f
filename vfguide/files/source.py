"""TOML files with overrides of the command line, and error messages that name both."""

import json
import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any, TypeVar

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from vfguide.files.errors import InputError
from vfguide.files.overrides import Override, apply_override

Location = tuple[int | str, ...]
"""Keys and indices that lead to a value of a file."""
Model = TypeVar("Model", bound=BaseModel)

_TYPES = {
    "bool_type": "true or false",
    "datetime_type": "a date and time such as 2026-01-01T00:00:00Z",
    "float_type": "a number",
    "int_type": "a whole number",
    "list_type": "a list of tables",
    "model_type": "a table",
    "string_type": "a string",
    "timezone_aware": "a time with its zone, such as 2026-01-01T00:00:00Z,",
}
_NO_VALUE = object()


@dataclass(frozen=True)
class Source:
    """A TOML file and the overrides of the command line on top of it."""

    path: Path
    overrides: tuple[Override, ...] = ()

    def read(self) -> dict[str, Any]:
        """The table of the file with the overrides applied.

        Raises:
            InputError: the file is not readable or not TOML, or an override names no key.
        """
        table = read_toml(self.path)
        for override in self.overrides:
            apply_override(table, override, self.path)
        return table

    def parse(self, model: type[Model]) -> Model:
        """The values of the file as a `model`.

        Raises:
            InputError: the file cannot be read, or a value is wrong; the message names the first
                one, unknown keys before wrong values.
        """
        try:
            return model.model_validate(self.read())
        except ValidationError as invalid:
            errors = invalid.errors()
            first = next((e for e in errors if e["type"] == "key"), errors[0])
            raise self._from_pydantic(first) from None

    def error(self, location: Location, rule: str, value: object = _NO_VALUE) -> InputError:
        """The error of the value at `location`, which breaks `rule`."""
        shown = "" if value is _NO_VALUE else f" = {as_toml(value)}"
        return InputError(f"{self._origin(location)}: {dotted(location)}{shown}: {rule}")

    def check_distinct(self, table: str, key: str, values: Sequence[object]) -> None:
        """Check that no two tables of the list `table` have the same value of `key`.

        `values` has that of each table, in order.

        Raises:
            InputError: two have.
        """
        for index, value in enumerate(values):
            if value in values[:index]:
                rule = f"already the {key} of {table}[{values.index(value)}], each needs its own"
                raise self.error((table, index, key), rule, value)

    def _origin(self, location: Location) -> str:
        """The file, with the override that set something at, above or below `location`, if any."""
        for override in reversed(self.overrides):
            shorter = min(len(override.location), len(location))
            if override.location[:shorter] == location[:shorter]:
                return f"{self.path}, {override.origin}"
        return str(self.path)

    def _from_pydantic(self, error: ErrorDetails) -> InputError:
        kind, location, context = error["type"], error["loc"], error.get("ctx", {})
        if kind == "key":
            return self.error((*location, context["key"]), context["rule"])
        if kind == "missing":
            return self.error(location, "missing, but required")
        if kind == "too_short":
            return self.error(location, "empty, at least one is required")
        return self.error(location, _rule(kind, error), error["input"])


def _rule(kind: str, error: ErrorDetails) -> str:
    if kind in _TYPES:
        return f"wrong type, {_TYPES[kind]} is required"
    if kind == "finite_number":
        return "not a number that can be used, a finite one is required"
    return error["msg"]


def read_toml(path: Path) -> dict[str, Any]:
    """The table of a TOML file.

    Raises:
        InputError: it cannot be read or is not TOML; the message says in which line.
    """
    try:
        return tomllib.loads(path.read_text("utf-8-sig"))
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise InputError(f"{path}: not a text file in UTF-8") from None
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path}: not valid TOML: {error}") from None


def dotted(location: Location) -> str:
    """A location as messages show it: `vehicle[0].goal[1].heading_deg`."""
    parts = (f"[{part}]" if isinstance(part, int) else f".{part}" for part in location)
    return "".join(parts).removeprefix(".")


def as_toml(value: object) -> str:
    """A value as it is written in TOML, cut to 80 characters; a table is not written out."""
    if isinstance(value, datetime):
        return value.isoformat()
    if isinstance(value, dict):
        return "a table"
    text = json.dumps(value, default=str).replace("NaN", "nan").replace("Infinity", "inf")
    return text if len(text) <= 80 else f"{text[:77]}..."
