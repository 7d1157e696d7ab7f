"""Random sequences of lies about a point mass, of which roll, pitch and position are told truly."""

import math

import pytest
from measure_lies import BANK_LIMIT, HEIGHT_LIMIT, is_outside, measure

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def seen():
    return measure(1_000_000, 1500, "aerosonde")


def test_no_sequence_leaves_the_limits_of_bank_and_height(seen):
    assert max(each.bank for each in seen) <= BANK_LIMIT
    assert max(each.lost for each in seen) <= HEIGHT_LIMIT


def test_every_setpoint_is_made_of_numbers(seen):
    assert all(each.is_finite for each in seen)


def test_the_load_factor_is_outside_in_hardly_any_and_not_by_much(seen):
    """That it is in none is not reached, see docs/limitations.md."""
    assert sum(map(is_outside, seen)) <= 0.001 * len(seen)
    assert min(each.least_load for each in seen) > -0.6


def test_the_sequences_are_lies(seen):
    """A good part of them is found to be wrong about roll or pitch, as wrong body rates are."""
    assert 0.1 < sum(math.isfinite(each.silent_from) for each in seen) / len(seen) < 0.4
