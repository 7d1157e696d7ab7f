"""Every public constant is explained, and the check of it can fail."""

import check_docstrings
import pytest

GOOD = [
    'RATE = 0.5\n"""Largest rate of the nose [rad/s]; chosen."""',
    'SHARE: float = 0.5\n"""Share of the thrust that is kept."""',
    'LAW = Law()\n"""The law that flies a plan."""',
    'TIMES = (1.0, 2.0)\n"""Times of both turns [s]."""',
    "_HIDDEN = 1.0",
    'T = TypeVar("T")',
    "rate = 0.5",
]
BAD = [
    ("RATE = 0.5", "has no docstring"),
    ('RATE = 0.5\nother()\n"""Rate of the nose [rad/s]."""', "has no docstring"),
    ('RATE = 0.5\n"""rate of the nose [rad/s]."""', "capital letter"),
    ('RATE = 0.5\n"""Rate of the nose [rad/s], ..."""\nNEXT = 1', "full stop"),
    ('RATE = 0.5\n"""Rate of the nose [rad/s]"""', "full stop"),
    ('RATE = 0.5\n"""Of the nose [rad/s]."""', "hangs on another"),
    ('RATE = 0.5\n"""The same about the other axis [rad/s]."""', "hangs on another"),
    ('RATE = 0.5\n"""Largest rate of the nose."""', "neither the unit"),
    ('RATES = (-0.5, 2 * LEAST)\n"""Least and largest rate of the nose."""', "neither the unit"),
    ('LOW, HIGH = 1.0, 2.0\n"""Least and largest rate [rad/s]."""', "share one assignment"),
]


def test_every_constant_is_explained():
    assert list(check_docstrings.violations()) == []


@pytest.mark.parametrize("source", GOOD)
def test_what_is_explained_is_accepted(source):
    assert list(check_docstrings.faults(source)) == []


@pytest.mark.parametrize(("source", "fault"), BAD)
def test_what_is_not_explained_is_refused(source, fault):
    line, text = next(check_docstrings.faults(source))
    assert line == 1
    assert fault in text
