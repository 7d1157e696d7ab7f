"""`[vary]`: the keys of a scenario that a campaign draws at random, and how."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import AfterValidator, BeforeValidator

from vfguide.files.overrides import location_of
from vfguide.files.toml_types import rule_broken

FORMS = "allowed is [low, high], drawn evenly, or {mean = ..., std = ...}, a normal distribution"
"""The two ways in which a value can be drawn, in words."""
LARGEST = 1e300
"""Largest amount of a number of a distribution, in whatever unit; chosen, so that no draw is
infinite."""


@dataclass(frozen=True)
class Uniform:
    """A value that is drawn evenly between two others."""

    low: float
    high: float


@dataclass(frozen=True)
class Normal:
    """A value of a normal distribution."""

    mean: float
    std: float
    """Standard deviation."""


Distribution = Uniform | Normal


def _distribution(value: Any) -> Distribution:
    """The distribution that is written.

    Raises:
        PydanticCustomError: it is neither of the two forms.
    """
    if isinstance(value, list) and len(value) == 2 and all(map(_is_number, value)):
        low, high = map(float, value)
        if low > high:
            raise rule_broken(f"upside down, {FORMS}")
        return Uniform(low, high)
    if isinstance(value, dict) and set(value) == {"mean", "std"}:
        mean, std = value["mean"], value["std"]
        if _is_number(mean) and _is_number(std) and std >= 0.0:
            return Normal(float(mean), float(std))
    raise rule_broken(f"not a distribution, {FORMS}")


def _is_number(value: Any) -> bool:
    """Whether a value of a TOML file is a number, and none beyond all others."""
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return is_number and abs(value) <= LARGEST


def _dotted(keys: Mapping[str, Distribution]) -> Mapping[str, Distribution]:
    """Only keys of values, as `--set` takes them; a run has one seed, which the campaign gives."""
    places: dict[tuple[int | str, ...], str] = {}
    for key in keys:
        if not re.fullmatch(r"\w+([.\[]\w+\]?)*", key):
            raise rule_broken(f'"{key}" is no key, allowed is one such as "wind.speed_mps"')
        if key == "seed":
            raise rule_broken("seed: the campaign gives every flight a seed of its own")
        if (other := places.setdefault(location_of(key), key)) != key:
            raise rule_broken(f'"{key}" and "{other}" are the same key, allowed is one of them')
    return keys


Vary = Annotated[
    dict[str, Annotated[Distribution, BeforeValidator(_distribution)]], AfterValidator(_dotted)
]
"""The distributions by the dotted key that each is for."""
