"""Names and ids that may stand only once."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.files.errors import InputError
from vfguide.files.source import Source

SOURCE = Source(Path("x.toml"))


@given(st.lists(st.integers(0, 9), max_size=8))
def test_the_first_value_that_stands_twice_is_named_with_its_first_place(values):
    second = next((i for i, value in enumerate(values) if value in values[:i]), None)
    if second is None:
        SOURCE.check_distinct("vehicle", "id", values)
        return
    value = values[second]
    with pytest.raises(InputError) as error:
        SOURCE.check_distinct("vehicle", "id", values)
    assert str(error.value) == (
        f"x.toml: vehicle[{second}].id = {value}: already the id of "
        f"vehicle[{values.index(value)}], each needs its own"
    )
