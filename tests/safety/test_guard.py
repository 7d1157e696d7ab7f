"""The guard: what is known when, and how an escape is flown."""

import math

import numpy as np
import pytest
from assurance_samples import FLOWN, ball, decide, hazards, motion
from hypothesis import given
from hypothesis import strategies as st

from vfguide.field.obstacle import OUT_OF_SIGHT, PlacedObstacle
from vfguide.flight.memory import Wish
from vfguide.flight.state import FlightState
from vfguide.flight.vertical import ZOOM
from vfguide.geometry.rows import columns
from vfguide.geometry.so3 import IDENTITY
from vfguide.safety.assurance import Decision, Reason
from vfguide.safety.guard import (
    KNOWN,
    LASTING,
    as_decided,
    fresh_guard,
    in_air,
    in_sight,
    motion_of,
    raised,
)
from vfguide.safety.manoeuvre import Manoeuvre, climb_of

HERE = (0.0, 0.0, -150.0)
WISH = Wish(0.0, 0.0, 0.02, 0.02, 0.1, 1.0, 500.0, 1, 80.0)


def with_sight(seen, *obstacles):
    known = hazards(obstacles)
    columns(PlacedObstacle, known.obstacles).visible_from[:] = seen
    return known


def north(known):
    ((north, _, _),) = columns(PlacedObstacle, known.obstacles).p_n
    return north


def test_an_obstacle_is_known_from_its_distance_on_and_stays_known():
    everything, guard = with_sight(100.0, ball((200.0, 0.0, -150.0))), fresh_guard(1)
    assert north(in_sight(everything, guard, HERE, 0.0)) == OUT_OF_SIGHT
    assert guard[KNOWN] == 0.0
    near = (61.0, 0.0, -150.0)
    assert north(in_sight(everything, guard, near, 0.0)) == 200.0
    assert guard[KNOWN] == 1.0
    assert north(in_sight(everything, guard, (-5000.0, 0.0, -150.0), 0.0)) == 200.0
    assert north(everything) == 200.0, "what is looked at is left as it was"


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
    assert as_decided(WISH, decision, (0.1, 0.2), 0.2) == WISH


@given(st.floats(-0.9, 0.9), st.floats(-0.2, 0.2), st.floats(-0.5, 0.5), st.floats(0.3, 0.9))
def test_an_escape_is_flown_as_aircraft_and_air_allow(bank, gamma, climb, most):
    decision = Decision(bank, gamma, Reason.ESCAPE, 12.0, 3.0, 0)
    flown = as_decided(WISH, decision, (climb, climb + 0.1), most)
    assert flown.bank == np.clip(bank, -most, most)
    assert (flown.gamma, flown.climb) == (climb, climb + 0.1)
    assert flown.load == pytest.approx(math.cos(flown.gamma) / math.cos(flown.bank))


@given(st.floats(-1.5, 1.5), st.floats(-0.4, 0.4))
def test_what_the_air_does_is_made_good(gamma, sinking):
    flown = raised(gamma, sinking)
    assert math.sin(flown) == pytest.approx(np.clip(math.sin(gamma) + sinking, -1.0, 1.0))


def test_in_air_that_sinks_fast_escapes_climb_less_and_in_air_that_rises_they_descend_less():
    its = FLOWN.limits
    for weak in (-0.05, 0.0, 0.1):
        assert in_air(FLOWN, weak).limits.climb_max == its.climb_max
    assert in_air(FLOWN, 0.05).limits.descent_max == its.descent_max
    sinking = in_air(FLOWN, 0.4).limits
    assert math.sin(sinking.climb_max) == pytest.approx(
        ZOOM * math.sin(its.climb_max) - 0.4 * LASTING
    )
    assert sinking.descent_max == its.descent_max
    rising = in_air(FLOWN, -0.2).limits
    assert math.sin(rising.descent_max) == pytest.approx(math.sin(its.descent_max) - 0.2 * LASTING)
    assert rising.climb_max == its.climb_max


def test_where_the_air_sinks_faster_than_the_climb_no_escape_is_level():
    level, climb = Manoeuvre(0.0, 0.0, 0.0), Manoeuvre(1.0, 2.0, 1.0)
    sinking = in_air(FLOWN, 0.6).limits
    assert climb_of(level, sinking) == climb_of(climb, sinking) == sinking.climb_max < 0.0
    rising = in_air(FLOWN, -0.6).limits
    assert climb_of(level, rising) == -rising.descent_max > 0.0
    assert climb_of(level, in_air(FLOWN, 0.2).limits) == 0.0


@given(st.floats(-3.0, 3.0))
def test_air_that_moves_faster_than_any_limit_still_leaves_a_decision(sinking):
    aircraft = in_air(FLOWN, sinking)
    near = hazards([ball((60.0, 0.0, -150.0))])
    decision, _ = decide(motion(p_n=HERE), near, of=aircraft)
    assert decision.reason != Reason.CLEAR
    assert math.isfinite(decision.bank + decision.gamma)


def test_tracks_begin_with_the_path_over_the_ground():
    """Level over the ground through air that sinks: no track may begin with a climb."""
    here = FlightState(0.0, HERE, (25.0, 0.0, 0.0), IDENTITY, 25.0, (0.0, 0.0, 5.0))
    assert motion_of(here).gamma == 0.0
