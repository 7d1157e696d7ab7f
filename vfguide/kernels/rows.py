"""Records as rows of numbers, by the names of their fields: no place in a row is written by hand.

A record is a `NamedTuple` whose fields are floats, ints, bools, records, tuples of these, and
arrays of a fixed shape (`Annotated[NDArray[np.float64], Shape(6, 6)]`). Its row holds all its
numbers in the order of the fields, a bool as 0 or 1. Rows cross from Python into compiled code
and back in a fraction of the time that records take, and many rows are a table.

`reader`, `writer` and `replacing` write the source of a function from the type and compile it:
the machine code is that of a function written by hand.
"""

import math
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache
from typing import Annotated, Any, NamedTuple, TypeVar, cast, get_args, get_origin, get_type_hints

import numpy as np
from numpy.typing import NDArray

from vfguide.kernels.compiled import compiled_source
from vfguide.kernels.written_functions import source_function

Row = NDArray[np.float64]
"""The numbers of one record, (width,)."""
Table = NDArray[np.float64]
"""The numbers of N records of one type, (N, width)."""

T = TypeVar("T")


class Shape(tuple[int, ...]):
    """The shape of an array that is a field of a record: `Shape(6, 6)`."""

    __slots__ = ()

    def __new__(cls, *sizes: int) -> "Shape":
        """The shape with a number of entries along each axis."""
        return super().__new__(cls, sizes)


OPEN = Shape(-1)
"""Shape of an array that takes the rest of a row, which only the last field may have; the width of
a record type does not count it."""


class Leaf(NamedTuple):
    """A number of a record, or an array."""

    kind: Any
    """`float`, `int`, `bool`, or the `Shape` of an array."""
    name: str
    """Dotted name, as `leg.path.radius` or `p_n.0`."""
    expression: str
    """The source that takes it from a record `r`."""

    @property
    def size(self) -> int:
        """Number of its floats."""
        return max(math.prod(self.kind), 0) if isinstance(self.kind, Shape) else 1

    def source(self, row: str, begin: int) -> str:
        """The source of its place in the row named `row`, from column `begin` on."""
        if self.kind == OPEN:
            return f"{row}[{begin}:]"
        if isinstance(self.kind, Shape):
            part = f"{row}[{begin}:{begin + self.size}]"
            return f"{part}.reshape({tuple(self.kind)})" if len(self.kind) > 1 else part
        return f"{row}[{begin}]"


def fields_of(kind: Any) -> dict[str, Any]:
    """The types of a record's fields by their names, with the shapes of arrays."""
    return get_type_hints(kind, include_extras=True)


def leaves(kind: Any, name: str = "", expression: str = "r") -> Iterator[Leaf]:
    """The numbers and arrays of a record type in the order of its row.

    Raises:
        TypeError: a field is neither a number nor a record, a tuple or an array of a fixed shape.
    """
    if kind in (float, int, bool):
        yield Leaf(kind, name, expression)
    elif get_origin(kind) is Annotated:
        yield Leaf(
            next(each for each in get_args(kind) if isinstance(each, Shape)), name, expression
        )
    else:
        for part, field in parts_of(kind, name).items():
            yield from leaves(field, dotted_name(name, part.strip(".[]")), f"{expression}{part}")


def dotted_name(name: str, part: str) -> str:
    """The dotted name of a part."""
    return f"{name}.{part}" if name else part


@cache
def width(kind: Any) -> int:
    """Number of floats in the row of a record type."""
    return sum(leaf.size for leaf in leaves(kind))


def place(kind: Any, name: str) -> slice:
    """Where in a row the numbers of one field are, by its dotted name.

    Raises:
        KeyError: the record type has no such field.
    """
    begin, places = 0, list[slice]()
    for leaf in leaves(kind):
        if leaf.name == name or leaf.name.startswith(f"{name}."):
            places.append(slice(begin, None if leaf.kind == OPEN else begin + leaf.size))
        begin += leaf.size
    if not places:
        raise KeyError(f"{kind.__name__} has no field {name}")
    return slice(places[0].start, places[-1].stop)


def part_of(kind: Any, name: str) -> Any:
    """The type of one field of a record type, by its dotted name.

    Raises:
        KeyError: the record type has no such field.
    """
    for field in name.split("."):
        kind = get_args(kind)[int(field)] if field.isdigit() else fields_of(kind)[field]
    return kind


def getter(kind: Any, name: str) -> Callable[[Row], Any]:
    """A Python function that takes one field out of a row, by its dotted name.

    Raises:
        KeyError: the record type has no such field.
    """
    there, read = place(kind, name), python_reader(part_of(kind, name))
    return lambda row: read(row[there])


def part_reader(kind: Any, name: str) -> Callable[[Row], Any]:
    """A compiled function that takes one field out of a row, by its dotted name.

    It compiles faster than a reader of the whole record.

    Raises:
        KeyError: the record type has no such field.
    """
    scope: dict[str, Any] = {}
    source = _reading(part_of(kind, name), scope, [place(kind, name).start])
    function = f"read_{symbol(name)}_of_{symbol(kind)}"
    text = f"def {function}(a):\n    return {source}"
    return compiled_source(source_function(text, function, scope))


def flattener(kind: type[T]) -> Callable[[T], tuple[float, ...]]:
    """A Python function that gives the numbers of a record in the order of its row."""
    return _flattener(kind)


@cache
def _flattener(kind: Any) -> Any:
    """The function of `flattener`, written once for each type: tables are made at every step."""
    lines, parts = ["def numbers(r):"], list[str]()
    _take_apart(kind, "r", lines, parts)
    lines.append(f"    return ({', '.join(parts)},)")
    return source_function("\n".join(lines), "numbers", {})


def _take_apart(kind: Any, name: str, lines: list[str], parts: list[str]) -> None:
    """Append the source that takes a variable apart, and the sources of its numbers.

    Unpacking all fields at once takes a third of the time of reading one by one by name.
    """
    if kind in (float, int, bool):
        parts.append(name)
    elif get_origin(kind) is Annotated:
        parts.append(f"*{name}.ravel()")
    elif all(each in (float, int, bool) for each in parts_of(kind, name).values()):
        parts.append(f"*{name}")
    else:
        of = parts_of(kind, name)
        fields = {f"{name}_{part.strip('.[]')}": each for part, each in of.items()}
        lines.append(f"    {', '.join(fields)}, = {name}")
        for field, each in fields.items():
            _take_apart(each, field, lines, parts)


def parts_of(kind: Any, name: str) -> dict[str, Any]:
    """The types of the fields of a record or a tuple by the source that takes them from it.

    Raises:
        TypeError: it is neither; `name` is what it is called.
    """
    if get_origin(kind) is tuple:
        return {f"[{index}]": part for index, part in enumerate(get_args(kind))}
    if isinstance(kind, type) and issubclass(kind, tuple) and hasattr(kind, "_fields"):
        return {f".{field}": part for field, part in fields_of(kind).items()}
    raise TypeError(f"{name}: a row cannot hold {kind}")


def row_of(record: Any) -> Row:
    """The row of a record."""
    return np.array(flattener(type(record))(record), dtype=float)


def table_of(kind: type[T], records: Iterable[T]) -> Table:
    """The rows of records of one type, (N, width); (0, width) for none."""
    numbers = flattener(kind)
    rows = [numbers(record) for record in records]
    return np.array(rows, dtype=float).reshape(-1, width(kind))


def columns(kind: type[T], table: Table) -> T:
    """The record of a table's columns: each number becomes (N,), each vector (N, 3), and so on."""
    record, _ = _columns(kind, table)
    return cast("T", record)


def _columns(kind: Any, table: Table) -> tuple[Any, Table]:
    """The columns of one field, and the table of those that follow."""
    if isinstance(kind, type) and hasattr(kind, "_fields"):
        parts: list[Any] = []
        for part in fields_of(kind).values():
            value, table = _columns(part, table)
            parts.append(value)
        return kind(*parts), table
    here, rest = np.split(table, [width(kind)], axis=1)
    return here.reshape(-1, *array_shape(kind)), rest


def array_shape(kind: Any) -> tuple[int, ...]:
    """The shape of a field as an array: () of a number, (3, 3) of a matrix.

    A record in a tuple counts as a vector of its numbers.

    Raises:
        TypeError: the parts of a tuple differ.
    """
    if kind in (float, int, bool):
        return ()
    if get_origin(kind) is Annotated:
        return tuple(next(leaves(kind)).kind)
    if hasattr(kind, "_fields"):
        return (width(kind),)
    shapes = {array_shape(part) for part in get_args(kind)}
    if len(shapes) != 1:
        raise TypeError(f"{kind} is no array")
    return (len(get_args(kind)), *shapes.pop())


def reader(kind: type[T]) -> Callable[[Row], T]:
    """A compiled function that makes the record of a row; its arrays are views of the row."""
    return compiled_source(python_reader(kind))


def python_reader(kind: type[T]) -> Callable[[Sequence[float] | Row], T]:
    """A reader in Python, also for a list of numbers."""
    scope: dict[str, Any] = {}
    source = _reading(kind, scope, [0])
    name = f"read_{symbol(kind)}"
    return source_function(f"def {name}(a):\n    return {source}", name, scope)


def _reading(kind: Any, scope: dict[str, Any], begin: list[int]) -> str:
    """The source that makes a field from row `a` at place `begin[0]`, which it moves past it."""
    at = begin[0]
    if kind in (float, int, bool):
        begin[0] += 1
        return {float: f"a[{at}]", int: f"int(a[{at}])", bool: f"a[{at}] != 0.0"}[kind]
    if get_origin(kind) is Annotated:
        begin[0] += width(kind)
        return next(leaves(kind)).source("a", at)
    if get_origin(kind) is tuple:
        return f"({', '.join(_reading(part, scope, begin) for part in get_args(kind))},)"
    scope[kind.__name__] = kind
    parts = (_reading(part, scope, begin) for part in fields_of(kind).values())
    return f"{kind.__name__}({', '.join(parts)})"


def writer(kind: type[T]) -> Callable[[T, Row], None]:
    """A compiled function that writes a record into a row."""
    name = f"write_{symbol(kind)}"
    lines, at = [f"def {name}(r, a):"], 0
    for leaf in leaves(kind):
        lines += written_lines(leaf, at)
        at += leaf.size
    return compiled_source(source_function("\n".join(lines), name, {}))


def written_lines(leaf: Leaf, begin: int) -> list[str]:
    """The source that writes a number or an array of a record `r` into a row `a`.

    Loops take a tenth of the time of an assignment to a reshaped part of the row, and two seconds
    less to compile than one to an open part.
    """
    if not isinstance(leaf.kind, Shape):
        return [f"    {leaf.source('a', begin)} = {leaf.expression}"]
    return _writing(leaf.expression, leaf.kind, begin)


def _writing(expression: str, shape: tuple[int, ...], begin: int) -> list[str]:
    """The source that writes an array into row `a`, from the place `begin` on."""
    lines, place_of = list[str](), str(begin)
    for axis, size in enumerate(shape):
        count = f"len({expression})" if shape == OPEN else size
        lines.append(f"{'    ' * (axis + 1)}for i{axis} in range({count}):")
        place_of += f" + i{axis} * {math.prod(shape[axis + 1 :])}"
    indices = ", ".join(f"i{axis}" for axis in range(len(shape)))
    return [*lines, f"{'    ' * (len(shape) + 1)}a[{place_of}] = {expression}[{indices}]"]


def replacing(kind: type[T], *names: str) -> Callable[..., T]:
    """A compiled function of a record and new values for the named fields, in that order.

    Raises:
        KeyError: the record type has no such field.
    """
    fields = list(fields_of(kind))
    if unknown := set(names) - set(fields):
        raise KeyError(f"{kind.__name__} has no field {', '.join(sorted(unknown))}")
    values = (name if name in names else f"r.{name}" for name in fields)
    name = f"replace_{'_'.join(names)}_of_{symbol(kind)}"
    call = f"{kind.__name__}({', '.join(values)})"
    source = f"def {name}(r, {', '.join(names)}):\n    return {call}"
    return compiled_source(source_function(source, name, {kind.__name__: kind}))


def unnester(kind: type[T]) -> Callable[[T], tuple[Any, ...]]:
    """A Python function that gives the fields of a record, and those of its records, as one tuple.

    Nested records cross into compiled code in 2.4 us, the same values as a plain tuple in 0.5.
    """
    source = f"def parts(r):\n    return ({', '.join(_parts(kind, 'r'))},)"
    return source_function(source, "parts", {})


def nester(kind: type[T]) -> Callable[[tuple[Any, ...]], T]:
    """A compiled function that makes the record of the tuple of an `unnester`."""
    scope: dict[str, Any] = {}
    places = iter(range(len(_parts(kind, "r"))))
    name = f"nest_{symbol(kind)}"
    source = f"def {name}(a):\n    return {_nesting(kind, scope, places)}"
    return compiled_source(source_function(source, name, scope))


def _parts(kind: Any, expression: str) -> list[str]:
    """The sources of all fields that are not records, of the record that `expression` names."""
    if not hasattr(kind, "_fields"):
        return [expression]
    fields = fields_of(kind).items()
    return [part for name, of in fields for part in _parts(of, f"{expression}.{name}")]


def _nesting(kind: Any, scope: dict[str, Any], places: Iterator[int]) -> str:
    """The source that makes a field from the tuple `a`, from the next of `places` on."""
    if not hasattr(kind, "_fields"):
        return f"a[{next(places)}]"
    scope[kind.__name__] = kind
    fields = fields_of(kind).values()
    return f"{kind.__name__}({', '.join(_nesting(of, scope, places) for of in fields)})"


def symbol(kind: Any) -> str:
    """A name for a record type that no other has.

    numba names machine code by the function's name, its argument types and a number that each
    process counts for itself. Functions of one name that were cached by different processes would
    be taken for each other.
    """
    return re.sub(r"\W+", "_", f"{getattr(kind, '__module__', '')}_{kind!r}")
