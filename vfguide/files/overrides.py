"""Values of a file replaced: from the command line, `--set key=value`, or drawn at random."""

import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from vfguide.files.errors import InputError


@dataclass(frozen=True)
class Override:
    """One replaced value."""

    text: str
    """As typed: `vehicle.0.heading_deg=90`."""
    location: tuple[int | str, ...]
    """Keys and indices that lead to the value."""
    value: Any
    """The new value."""
    origin: str
    """What messages call it: `--set vehicle.0.heading_deg=90`."""


def parse_override(text: str) -> Override:
    """The override `key=value` with a dotted key and a value in TOML; a bare word is a string.

    Indices of lists count from 0, as in `vehicle.0.heading_deg` or `vehicle[0].heading_deg`.

    Raises:
        InputError: it is not of that form.
    """
    key, equals, value = text.partition("=")
    parts = _parts(key)
    if not equals or not all(parts):
        raise InputError(f"--set {text}: allowed is key=value, such as vehicle.0.heading_deg=90")
    return Override(text, location_of(key), _toml_value(value.strip()), f"--set {text}")


def drawn_override(key: str, value: float) -> Override:
    """The override of a value that was drawn for a dotted key of `[vary]`.

    Its text gives the same value to the last bit where it is parsed.
    """
    text = f"{key}={value!r}"
    return Override(text, location_of(key), value, f'[vary] "{key}", drawn {value!r}')


def _parts(key: str) -> list[str]:
    """The parts of a dotted key, of which places in lists may stand in brackets."""
    return [part.strip() for part in key.replace("[", ".").replace("]", "").split(".")]


def location_of(key: str) -> tuple[int | str, ...]:
    """The parts of a dotted key, places in lists as numbers."""
    return tuple(int(part) if part.isdecimal() else part for part in _parts(key))


def apply_override(table: dict[str, Any], override: Override, file: Path) -> None:
    """Replace one value of `table` in place; missing tables are made.

    Raises:
        InputError: the key leads through something that is not a table, or past the end of a list
            of the `file`.
    """
    origin = f"{file}, {override.origin}"
    place: Any = table
    for part in override.location[:-1]:
        _check_step(place, part, origin)
        place = place[part] if isinstance(part, int) else place.setdefault(part, {})
    last = override.location[-1]
    _check_step(place, last, origin)
    place[last] = override.value


def _check_step(place: Any, part: int | str, origin: str) -> None:
    if isinstance(place, list):
        if not isinstance(part, int) or part >= len(place):
            allowed = f"0 to {len(place) - 1}" if place else "nothing, the list is empty"
            raise InputError(f"{origin}: {part} is no index here, allowed {allowed}")
    elif not isinstance(place, dict) or isinstance(part, int):
        raise InputError(f"{origin}: unknown key, {part} leads to nothing")


def _toml_value(text: str) -> Any:
    try:
        table = tomllib.loads(f"value = {text}")
    except (ValueError, RecursionError):
        return text
    return table["value"] if len(table) == 1 else text
