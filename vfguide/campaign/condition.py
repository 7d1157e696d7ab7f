"""When a campaign has flown enough: `--until "rate(miss_m > 2) < 0.01 @ 0.95"`.

    rate( COLUMN COMPARISON VALUE ) WANTED LIMIT @ LEVEL

COMPARISON is one of `<`, `<=`, `>`, `>=`, `==`, `!=`, WANTED is `<` or `>`. COLUMN and VALUE are
words, bare or in quotes; a bare VALUE may be a number, `true` or `false`, and only numbers have an
order. Spaces between them are free. LIMIT is a rate between 0 and 1, LEVEL the confidence level of
the two-sided interval with which the decision is made.
"""

import math
import operator
import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Any, NamedTuple

import numpy as np

from vfguide.campaign.intervals import is_excluded
from vfguide.files.data import close_matches
from vfguide.files.errors import InputError

LONGEST_PART = 40
"""Largest number of characters of the wrong part in a message; chosen, half a line."""
EXAMPLE = "rate(COLUMN > VALUE) < LIMIT @ LEVEL, such as rate(miss_m > 2) < 0.01 @ 0.95"
"""What a condition looks like, for messages."""


class Comparison(StrEnum):
    """How a number or a word is compared with another."""

    LESS = "<"
    AT_MOST = "<="
    MORE = ">"
    AT_LEAST = ">="
    EQUAL = "=="
    UNEQUAL = "!="


COMPARE: Mapping[Comparison, Callable[[Any, Any], bool]] = {
    Comparison.LESS: operator.lt,
    Comparison.AT_MOST: operator.le,
    Comparison.MORE: operator.gt,
    Comparison.AT_LEAST: operator.ge,
    Comparison.EQUAL: operator.eq,
    Comparison.UNEQUAL: operator.ne,
}
"""The functions of all comparisons."""


class Part(NamedTuple):
    """What the text of a condition goes on with."""

    pattern: re.Pattern[str]
    allowed: str
    """In words."""


BARE = re.compile(r"""[^\s()<>=!@"']+""")
"""A word that needs no quotes."""
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
"""A number as it is written."""
WORD = rf"""(?:{BARE.pattern}|"[^"]*"|'[^']*')"""
"""A word, in quotes or not, as a regular expression."""


def _part(pattern: str, allowed: str) -> Part:
    return Part(re.compile(rf"\s*{pattern}"), allowed)


GRAMMAR = (
    _part(r"rate\b", "rate"),
    _part(r"\(", "( and a comparison"),
    _part(rf"(?P<column>{WORD})", "the name of a column"),
    _part(r"(?P<comparison><=|>=|==|!=|<|>)", "< or <= or > or >= or == or !="),
    _part(rf"(?P<value>{WORD})", "a number or a word"),
    _part(r"\)", ")"),
    _part(r"(?P<wanted>[<>])(?!=)", "< or > and a limit"),
    _part(rf"(?P<limit>{BARE.pattern})", "a limit between 0 and 1"),
    _part("@", "@ and a confidence level"),
    _part(rf"(?P<level>{BARE.pattern})", "a confidence level of at least 0.5, below 1"),
    _part(r"\s*\Z", "nothing more"),
)
"""The parts of a condition, in their order."""


@dataclass(frozen=True)
class Condition:
    """That a rate of flights is known to be below a limit, or above it."""

    column: str
    comparison: Comparison
    threshold: float | str | bool
    wanted: Comparison
    """LESS or MORE."""
    limit: float
    level: float

    def __str__(self) -> str:
        """The condition as it may be typed."""
        counted = f"{_written(self.column)} {self.comparison} {_written(self.threshold)}"
        numbers = f"{_written(self.limit)} @ {_written(self.level)}"
        return f"rate({counted}) {self.wanted} {numbers}"

    def holds(self, row: Mapping[str, object]) -> bool:
        """Whether a flight counts.

        Where its row has no value, None or NaN, as that of a failed flight, it counts against what
        is hoped for: as one more where the rate should be small, as none where it should be large.

        Raises:
            InputError: the row holds a word and the threshold is a number, or the reverse.
        """
        value = row.get(self.column)
        value = value.item() if isinstance(value, np.generic) else value
        if value is None or (isinstance(value, float) and math.isnan(value)):
            return self.wanted is Comparison.LESS
        kind = str if isinstance(self.threshold, str) else (float, int)
        if not isinstance(value, kind):
            reason = f"cannot be compared with {_written(value)}, which {self.column} holds"
            raise _refused(str(self), _written(self.threshold), reason)
        return COMPARE[self.comparison](value, self.threshold)

    def decided(self, successes: int, trials: int) -> bool | None:
        """Whether the condition is met; None: that is not known well enough yet.

        `successes` are the flights that count, of all `trials`. It is decided when the limit lies
        outside the confidence sequence at the level, two-sided (`is_excluded`), so that it may be
        asked after every flight: at most a share 1 - level of all campaigns decides wrongly.
        """
        if not is_excluded(self.limit, successes, trials, self.level):
            return None
        return COMPARE[self.wanted](successes / trials, self.limit)


def parse_condition(text: str) -> Condition:
    """The condition of `--until`.

    Raises:
        InputError: it is none; the message names the part that is wrong and what is allowed there.
    """
    parts = _split(text)
    condition = Condition(
        _unquoted(parts["column"]),
        Comparison(parts["comparison"]),
        _threshold(parts["value"]),
        Comparison(parts["wanted"]),
        _number(parts["limit"]),
        _number(parts["level"]),
    )
    _check(condition, text, parts)
    return condition


def check_column(condition: Condition, columns: Collection[str]) -> None:
    """Refuse a condition on a column that is not among those of a campaign.

    Raises:
        InputError: the message names the nearest columns, and all.
    """
    if condition.column not in columns:
        near = close_matches(condition.column, sorted(columns))
        allowed = f"no such column{near}; allowed: {', '.join(sorted(columns))}"
        raise _refused(str(condition), condition.column, allowed)


def check_threshold(
    condition: Condition, values: Mapping[str, object], words: Mapping[str, Collection[str]]
) -> None:
    """Refuse a condition whose value its column cannot hold.

    `values` has one that each column can hold, `words` all, where they are known.

    Raises:
        InputError: the column has no such value.
    """
    condition.holds(values)
    allowed = words.get(condition.column, ())
    if allowed and condition.threshold not in allowed:
        near = close_matches(str(condition.threshold), sorted(allowed))
        reason = f"{condition.column} is never that{near}; allowed: {', '.join(sorted(allowed))}"
        raise _refused(str(condition), _written(condition.threshold), reason)


def _split(text: str) -> dict[str, str]:
    """The named parts of a condition, as they are written."""
    found: dict[str, str] = {}
    place = 0
    for part in GRAMMAR:
        match = part.pattern.match(text, place)
        if match is None:
            rest = text[place:].strip() or "the end"
            raise _refused(text, rest, f"expected {part.allowed}; allowed is {EXAMPLE}")
        found |= match.groupdict()
        place = match.end()
    return found


def _check(condition: Condition, text: str, parts: Mapping[str, str]) -> None:
    """Refuse numbers outside their ranges, and an order of words."""
    if not condition.column:
        raise _refused(text, parts["column"], "allowed is the name of a column")
    if isinstance(condition.threshold, float) and math.isinf(condition.threshold):
        raise _refused(text, parts["value"], "allowed is a finite number")
    has_order = isinstance(condition.threshold, float)
    if not has_order and condition.comparison not in (Comparison.EQUAL, Comparison.UNEQUAL):
        allowed = f"after {condition.comparison} allowed is a number; a word after == and !="
        raise _refused(text, parts["value"], allowed)
    if not 0.0 < condition.limit < 1.0:
        raise _refused(text, parts["limit"], "allowed is a limit between 0 and 1")
    if not 0.5 <= condition.level < 1.0:
        allowed = "allowed is a confidence level of at least 0.5, below 1"
        raise _refused(text, parts["level"], allowed)


def _threshold(text: str) -> float | str | bool:
    if NUMBER.fullmatch(text):
        return float(text)
    return text == "true" if text in ("true", "false") else _unquoted(text)


def _number(text: str) -> float:
    """The number that is written; NaN, which is in no range: there is none."""
    return float(text) if NUMBER.fullmatch(text) else math.nan


def _unquoted(text: str) -> str:
    return text[1:-1] if text.startswith(('"', "'")) else text


def _written(value: object) -> str:
    """A number or a word as it may be typed."""
    if isinstance(value, bool):
        return str(value).lower()
    if not isinstance(value, str):
        return str(value).removesuffix(".0")
    quote = "'" if '"' in value else '"'
    is_plain = BARE.fullmatch(value) and isinstance(_threshold(value), str)
    return value if is_plain else f"{quote}{value}{quote}"


def _refused(text: str, wrong: str, reason: str) -> InputError:
    """What is told of a condition: the option, the text, the part that is wrong, and why."""
    shown = wrong if len(wrong) <= LONGEST_PART else f"{wrong[: LONGEST_PART - 3]}..."
    return InputError(f"--until {text}: {shown}: {reason}")
