"""Functions that the program makes: of a source that it writes, and constructors of records."""

from collections.abc import Callable, Iterable
from functools import partial
from typing import Any, TypeVar

T = TypeVar("T", bound=tuple[Any, ...])


def source_function(source: str, name: str, scope: dict[str, Any]) -> Any:
    """The function `name` that `source` defines in `scope`."""
    exec(compile(source, f"<{name}>", "exec"), scope)
    return scope[name]


def maker(kind: type[T]) -> Callable[[Iterable[Any]], T]:
    """A function that makes a named tuple of its values, whose number it does not check.

    A third of the time of the class called by its name: for records that are made at every step.
    """
    return partial(tuple.__new__, kind)
