"""The guard: what is known when, and how an escape is flown."""

import math

import numpy as np
import pytest
from assurance_samples import ball, hazards
from hypothesis import given
from hypothesis import strategies as st

from vfguide.field.obstacle import VISIBLE_FROM
from vfguide.flight.memory import Wish
from vfguide.safety.assurance import Decision, Reason
from vfguide.safety.guard import KNOWN, OUT_OF_SIGHT, as_decided, fresh_guard, in_sight

HERE = (0.0, 0.0, -150.0)
WISH = Wish(0.0, 0.0, 0.02, 0.1, 1.0, 500.0, 1, 80.0)


def with_sight(seen, *obstacles):
    known = hazards(obstacles)
    known.obstacles[:, VISIBLE_FROM] = seen
    return known


def test_an_obstacle_is_known_from_its_distance_on_and_stays_known():
    everything, guard = with_sight(100.0, ball((200.0, 0.0, -150.0))), fresh_guard(1)
    assert in_sight(everything, guard, HERE, 0.0).obstacles[0, 1] == OUT_OF_SIGHT
    assert guard[KNOWN] == 0.0
    near = (61.0, 0.0, -150.0)
    assert in_sight(everything, guard, near, 0.0).obstacles[0, 1] == 200.0
    assert guard[KNOWN] == 1.0
    assert in_sight(everything, guard, (-5000.0, 0.0, -150.0), 0.0).obstacles[0, 1] == 200.0
    assert everything.obstacles[0, 1] == 200.0, "what is looked at is left as it was"


def test_one_that_moves_comes_into_sight_by_itself():
    everything = with_sight(100.0, ball((400.0, 0.0, -150.0), v_n=(-20.0, 0.0, 0.0)))
    guard = fresh_guard(1)
    in_sight(everything, guard, HERE, 12.9)
    assert guard[KNOWN] == 0.0
    in_sight(everything, guard, HERE, 13.1)
    assert guard[KNOWN] == 1.0


def test_without_obstacles_there_is_nothing_to_see():
    nothing, guard = hazards(floor=100.0), fresh_guard(0)
    assert in_sight(nothing, guard, HERE, 0.0) is not None
    assert len(guard) == KNOWN


def test_a_wish_that_is_clear_is_flown_as_it_is():
    decision = Decision(1.0, -0.1, Reason.CLEAR, 12.0, math.inf, -1)
    assert as_decided(WISH, decision, 0.2) == WISH


@given(st.floats(-0.9, 0.9), st.floats(-0.2, 0.2), st.floats(0.3, 0.9))
def test_an_escape_is_flown_with_the_bank_that_the_wing_carries(bank, gamma, most):
    flown = as_decided(WISH, Decision(bank, gamma, Reason.ESCAPE, 12.0, 3.0, 0), most)
    assert flown.bank == np.clip(bank, -most, most)
    assert flown.gamma == gamma
    assert flown.load == pytest.approx(math.cos(gamma) / math.cos(flown.bank))
