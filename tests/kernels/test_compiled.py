"""Functions are compiled as parts of their callers, and whole when Python calls them."""

import numpy as np
import pytest
from numba import TypingError

from vfguide.kernels.compiled import EntryPoint, compiled, compiled_source
from vfguide.kernels.rows import source_function


@compiled
def doubled(x):
    return 2.0 * x


@compiled
def doubled_and_more(x):
    return doubled(x) + 1.0


@compiled
def root(x):
    if x < 0.0:
        raise ValueError("below zero")
    return np.sqrt(x)


@compiled
def root_of_double(x):
    return root(doubled(x))


def test_a_part_is_not_compiled_for_python():
    assert doubled_and_more(3.0) == 7.0
    assert isinstance(doubled, EntryPoint)
    assert len(doubled.overloads) == 0
    assert len(doubled.part.overloads) <= 1  # none where the caller came from the cache


def test_the_same_function_is_called_from_python_too():
    assert doubled_and_more(1.0) == doubled(1.0) + 1.0
    assert doubled(x=2.0) == 4.0
    assert doubled(np.array([1.0, 2.0])).tolist() == [2.0, 4.0]


def test_an_error_of_a_part_reaches_python():
    with pytest.raises(ValueError, match="below zero"):
        root_of_double(-1.0)
    assert root_of_double(8.0) == 4.0


def test_a_function_without_a_file():
    source = "def twice_doubled(x):\n    return doubled(doubled(x))"
    twice_doubled = source_function(source, "twice_doubled", {"doubled": doubled})
    assert compiled_source(twice_doubled)(1.5) == 6.0


def test_what_cannot_be_compiled_is_an_error():
    @compiled
    def wrong(x):
        return x.no_such_thing

    with pytest.raises(TypingError):
        wrong(1.0)
