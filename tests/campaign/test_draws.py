"""Draws: reproducible, independent of each other, in their ranges, the same on the command line."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.campaign.draws import SEEDS, draw
from vfguide.files.overrides import parse_override
from vfguide.files.vary import Normal, Uniform

VARY = {"wind.speed_mps": Uniform(0.0, 8.0), "vehicle.0.heading_deg": Normal(90.0, 10.0)}
SEED = st.integers(0, SEEDS - 1)
INDEX = st.integers(0, 10**7)


@given(SEED, INDEX)
def test_a_draw_depends_on_seed_and_index_alone(seed, index):
    assert draw(seed, index, VARY) == draw(seed, index, dict(VARY))


@given(SEED, INDEX)
def test_a_key_that_is_added_changes_no_other_one(seed, index):
    one = draw(seed, index, {"wind.speed_mps": VARY["wind.speed_mps"]})
    both = draw(seed, index, VARY)
    assert (one.seed, *one.values) == (both.seed, *both.values[:1])


@given(SEED, INDEX)
def test_overrides_as_text_give_the_same_value_to_the_bit(seed, index):
    for override in draw(seed, index, VARY).overrides:
        typed = parse_override(override.text)
        assert (typed.location, typed.value) == (override.location, override.value)


@given(SEED, INDEX, st.floats(-1e6, 1e6), st.floats(0.0, 1e6))
def test_uniform_values_are_in_their_range(seed, index, low, width):
    ((_, value),) = draw(seed, index, {"x": Uniform(low, low + width)}).values
    assert low <= value <= low + width


@pytest.mark.parametrize("index", [0, 1])
def test_a_range_of_one_value(index):
    assert draw(1, index, {"x": Uniform(3.0, 3.0)}).values == (("x", 3.0),)
    assert draw(1, index, {"x": Normal(3.0, 0.0)}).values == (("x", 3.0),)


def test_flights_differ_and_have_the_distributions():
    draws = [draw(7, index, VARY) for index in range(2000)]
    assert len({each.seed for each in draws}) == len(draws)
    speed, heading = np.array([[value for _, value in each.values] for each in draws]).T
    assert speed.mean() == pytest.approx(4.0, abs=0.2)
    assert speed.std() == pytest.approx(8.0 / np.sqrt(12.0), rel=0.05)
    assert heading.mean() == pytest.approx(90.0, abs=0.8)
    assert heading.std() == pytest.approx(10.0, rel=0.06)
    assert abs(np.corrcoef(speed, heading)[0, 1]) < 0.07


def test_campaigns_differ_by_their_seed():
    assert draw(1, 0, VARY) != draw(2, 0, VARY)
