"""Functions that the program makes itself: from source text, and constructors of records."""

from collections.abc import Callable, Iterable
from functools import partial
from typing import Any, TypeVar

T = TypeVar("T", bound=tuple[Any, ...])


def source_function(source: str, name: str, scope: dict[str, Any]) -> Any:
    """The function `name` that `source` defines in `scope`."""
    exec(compile(source, f"<{name}>", "exec"), scope)
    return scope[name]


def maker(kind: type[T]) -> Callable[[Iterable[Any]], T]:
    """A fast constructor of a named tuple from its values; it does not check how many there are.

    It takes a third of the time of a call of the class, for records that are made at every step.
    """
    return partial(tuple.__new__, kind)
