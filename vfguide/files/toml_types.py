"""Types of values in TOML files: strict tables, bounded numbers, vectors, words."""

from collections.abc import Sequence
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, model_validator
from pydantic_core import PydanticCustomError

from vfguide.files.data import close_match


class Table(BaseModel):
    """A table whose keys are all known, whose types are exact and whose numbers are finite."""

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True, allow_inf_nan=False)

    @model_validator(mode="before")
    @classmethod
    def _known_keys(cls, table: Any) -> Any:
        """Refuse unknown keys before anything else, since a mistyped key explains other errors."""
        for key in table if isinstance(table, dict) else ():
            if key not in cls.model_fields:
                names = list(cls.model_fields)
                rule = f"unknown key{close_match(key, names)}; allowed: {', '.join(names)}"
                raise PydanticCustomError("key", "{rule}", {"key": key, "rule": rule})
        return table


def rule_broken(rule: str) -> PydanticCustomError:
    """The error of a value that breaks `rule`; validators raise it."""
    return PydanticCustomError("rule", "{rule}", {"rule": rule})


def between(low: float, high: float) -> AfterValidator:
    """A validator that allows numbers from `low` to `high`, both included."""

    def check(value: float) -> float:
        if not low <= value <= high:
            side = "too small" if value < low else "too large"
            raise rule_broken(f"{side}, allowed {in_words(low)} to {in_words(high)}")
        return value

    return AfterValidator(check)


def above(low: float, high: float) -> AfterValidator:
    """A validator that allows numbers greater than `low`, up to `high`."""

    def check(value: float) -> float:
        if not low < value <= high:
            side = "too small" if value <= low else "too large"
            raise rule_broken(f"{side}, allowed above {in_words(low)}, up to {in_words(high)}")
        return value

    return AfterValidator(check)


def word(*names: str) -> BeforeValidator:
    """A validator that allows one of `names`."""
    allowed = "allowed " + ", ".join(f'"{name}"' for name in names)

    def check(value: object) -> object:
        if value not in names:
            raise rule_broken(f"unknown{close_match(str(value), names)}; {allowed}")
        return value

    return BeforeValidator(check)


def listed(names: Sequence[str]) -> str:
    """Names as a list in words: a, b and c."""
    *first, last = names
    return f"{', '.join(first)} and {last}" if first else last


def in_words(number: float) -> str:
    """A number as messages show it: 17.5, 90, 4294967295."""
    return str(number) if isinstance(number, int) else f"{number:.10g}"


def _three(value: object) -> object:
    if not isinstance(value, list | tuple):
        raise rule_broken("wrong type, a list of three numbers is required")
    if len(value) != 3:
        raise rule_broken(f"{len(value)} values, a list of three numbers is required")
    return tuple(value)


Vector = Annotated[tuple[float, float, float], BeforeValidator(_three)]
"""Three finite numbers."""
Angle = Annotated[float, between(-360, 360)]
"""A heading, a course or an attitude angle [deg]."""


def _reachable(position: tuple[float, float, float]) -> tuple[float, float, float]:
    if max(abs(part) for part in position) > 100_000:
        raise rule_broken("too far from the origin, allowed -100000 to 100000 on each axis")
    return position


Position = Annotated[Vector, AfterValidator(_reachable)]
"""North, east, down of the origin [m]."""
Attitude = Annotated[tuple[Angle, Angle, Angle], BeforeValidator(_three)]
"""Roll, pitch and yaw [deg]."""
