"""Scalar formulas over arrays: a kernel for one point becomes a function of many.

As in NumPy's generalised ufuncs, the layout "(n),(m,k)->(m)" names the last axes that the kernel
takes and fills; the axes before them are of points, and broadcast against each other.
"""

import re
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from vfguide.kernels.compiled import compiled, compiled_source
from vfguide.kernels.written_functions import source_function

Axes = tuple[str, ...]
"""Names of the last axes of one argument."""


class Layout(NamedTuple):
    """What a kernel takes and fills."""

    inputs: tuple[Axes, ...]
    output: Axes


class Points(NamedTuple):
    """One argument as rows of points."""

    rows: Any
    """All points, or one that stands for all."""
    step: int
    """Rows from one point to the next: 1, or 0 where one row stands for all points."""


def over_points(layout: str) -> Callable[[Callable[..., None]], Callable[..., Any]]:
    """A decorator that makes a kernel a function of arrays, which returns the array of results.

    The kernel's last argument is the array that it fills at one point.
    """
    axes = parsed(layout)

    def decorate(kernel: Callable[..., None]) -> Callable[..., Any]:
        loop = loop_over(kernel, len(axes.inputs))

        def over_arrays(*arguments: Any) -> Any:
            """The kernel at every point."""
            arrays = [np.asarray(each, float) for each in arguments]
            sizes = sizes_of(axes.inputs, arrays)
            lead = np.broadcast_shapes(
                *(each.shape[: each.ndim - len(last)] for each, last in paired(axes, arrays))
            )
            points = [points_of(each, lead, len(last)) for each, last in paired(axes, arrays)]
            shape = tuple(sizes[name] for name in axes.output)
            filled = np.empty((int(np.prod(lead)), *shape))
            loop(*(part for each in points for part in each), filled)
            return filled.reshape(lead + shape)

        over_arrays.__name__ = kernel.__name__
        over_arrays.__doc__ = kernel.__doc__
        return over_arrays

    return decorate


def parsed(layout: str) -> Layout:
    """A layout from its text."""
    *inputs, output = (
        tuple(filter(None, names.split(","))) for names in re.findall(r"\(([^)]*)\)", layout)
    )
    return Layout(tuple(inputs), output)


def paired(layout: Layout, arrays: Sequence[Any]) -> Sequence[tuple[Any, Axes]]:
    """Each argument and its axes."""
    return list(zip(arrays, layout.inputs, strict=True))


def sizes_of(inputs: Sequence[Axes], arrays: Sequence[Any]) -> dict[str, int]:
    """The length of each axis by its name.

    Raises:
        ValueError: an axis is missing, or is not as long as its namesake.
    """
    sizes = dict[str, int]()
    for axes, array in zip(inputs, arrays, strict=True):
        if array.ndim < len(axes):
            raise ValueError(f"shape {array.shape} lacks the dimensions {axes}")
        for name, length in zip(axes, array.shape[array.ndim - len(axes) :], strict=True):
            if sizes.setdefault(name, length) != length:
                raise ValueError(f"dimension {name} is {sizes[name]}, and {length} elsewhere")
    return sizes


def points_of(array: Any, lead: tuple[int, ...], last: int) -> Points:
    """An argument with `last` axes of its own as rows of points of the shape `lead`."""
    core = array.shape[array.ndim - last :]
    one = int(np.prod(array.shape[: array.ndim - last])) == 1
    rows = array if one else np.broadcast_to(array, lead + core)
    count = 1 if one else int(np.prod(lead))
    return Points(np.require(rows.reshape((count, *core)), requirements=["C", "W"]), int(not one))


def loop_over(kernel: Callable[..., None], inputs: int) -> Callable[..., None]:
    """A compiled loop of a kernel over points; it takes the rows and the step of each input."""
    name = re.sub(r"\W+", "_", f"over_points_{kernel.__module__}_{kernel.__qualname__}")
    names = [f"a{index}" for index in range(inputs)]
    arguments = ", ".join(f"{each}, {each}_step" for each in names)
    points = ", ".join(f"{each}[i * {each}_step]" for each in names)
    source = (
        f"def {name}({arguments}, filled):\n"
        f"    for i in range(len(filled)):\n"
        f"        kernel({points}, filled[i])"
    )
    loop = source_function(source, name, {"kernel": compiled(kernel)})
    loop.__module__ = kernel.__module__
    return compiled_source(loop, kernel)
