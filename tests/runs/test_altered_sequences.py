"""Random lies on the link of a JSBSim aeroplane: it stays inside, and sends only what it may."""

import pytest
from frame_lies import NAMES, draw_lies, seeded
from measure_altered import fly

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("number", range(10))
def test_no_flight_leaves_its_limits_or_sends_what_it_may_not(number):
    flown = fly(number, seed=7)
    assert flown.is_inside, flown


@pytest.mark.parametrize("number", [3476])
def test_a_flight_that_left_its_limits_does_not_any_more(number):
    """60 degrees of bank: the autopilot began to follow in a silence, unheard."""
    flown = fly(number, seed=1)
    assert flown.is_inside, flown


def test_every_lie_is_drawn():
    drawn = {name for k in range(200) for name in draw_lies(seeded(7, k), 40.0)}
    assert drawn == set(NAMES)
