"""The stage of assurance: how an escape is flown, and what passes as it is."""

import math

import numpy as np
import pytest
from assurance_samples import FLOWN, decide
from flight_states import VEHICLE, motion
from hazard_samples import ball, hazards
from hypothesis import given
from hypothesis import strategies as st

from vfguide.aircraft.command import GuidanceCommand, unknown_rates
from vfguide.aircraft.path_limits import ZOOM_RATIO
from vfguide.aircraft.state import FlightState
from vfguide.airspace.detection import Airspace
from vfguide.airspace.keep_out import NO_FENCE
from vfguide.assurance import assurance
from vfguide.assurance.assurance import (
    LASTING,
    LEAST_ROOM,
    NARROW_ROUTE,
    as_decided,
    fresh_assurance,
    in_air,
    in_room,
    point_mass_of,
    raised,
)
from vfguide.assurance.backup_manoeuvre import Manoeuvre, climb_of
from vfguide.assurance.decision import Decision, Reason
from vfguide.estimation.estimation import known_state
from vfguide.geometry.so3 import IDENTITY

HERE = (0.0, 0.0, -150.0)
WISH = GuidanceCommand(0.0, 0.0, 0.02, 0.02, 0.1, 1.0, 500.0, 1, 80.0, unknown_rates())
NORTHWARD = FlightState(1.0, HERE, (25.0, 0.0, 0.0), IDENTITY, 25.0, (0.0, 0.0, 0.0))


def test_a_wish_that_is_clear_is_flown_as_it_is():
    decision = Decision(1.0, -0.1, Reason.NOMINAL, 12.0, math.inf, -1)
    assert as_decided(WISH, decision, (0.1, 0.2), 0.2) == WISH


@given(st.floats(-0.9, 0.9), st.floats(-0.2, 0.2), st.floats(-0.5, 0.5), st.floats(0.3, 0.9))
def test_an_escape_is_flown_as_aircraft_and_air_allow(bank, gamma, climb, most):
    decision = Decision(bank, gamma, Reason.RECOVERY, 12.0, 3.0, 0)
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
        ZOOM_RATIO * math.sin(its.climb_max) - 0.4 * LASTING
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
    assert decision.reason != Reason.NOMINAL
    assert math.isfinite(decision.bank + decision.gamma)


def test_tracks_begin_with_the_path_over_the_ground():
    """Level over the ground through air that sinks: no track may begin with a climb."""
    here = FlightState(0.0, HERE, (25.0, 0.0, 0.0), IDENTITY, 25.0, (0.0, 0.0, 5.0))
    assert point_mass_of(here).gamma == 0.0


def test_a_way_with_little_room_has_a_smaller_margin():
    """Else the assurance would forbid it; never a larger one, and never less than some."""
    assert in_room(FLOWN, 0.0) == in_room(FLOWN, -1.0) == in_room(FLOWN, 25.0) == FLOWN
    assert in_room(FLOWN, NARROW_ROUTE * FLOWN.margin) == FLOWN
    narrow = in_room(FLOWN, 8.0)
    assert narrow.margin == pytest.approx(8.0 / NARROW_ROUTE)
    assert narrow == FLOWN._replace(margin=narrow.margin)
    assert in_room(FLOWN, 1.0).margin == LEAST_ROOM


def judged(airspace, is_on=True, wish=WISH, state=NORTHWARD):
    nav = known_state(state, 0.98)
    return assurance.update(nav, wish, airspace, is_on, 25.0, fresh_assurance(), VEHICLE)


def among(*obstacles):
    return Airspace(hazards(obstacles), NO_FENCE, 0.0, 1.0)


NEAR = ball((105.0, 0.0, -150.0))
TOO_NEAR = ball((90.0, 0.0, -150.0))
FAR = ball((9000.0, 0.0, -150.0))


def test_a_command_that_leaves_a_way_out_passes_as_it_is():
    command, after = judged(among(FAR))
    assert command == WISH
    assert after.decision.reason == Reason.NOMINAL


@pytest.mark.parametrize(
    ("obstacle", "reason"), [(NEAR, Reason.RECOVERY), (TOO_NEAR, Reason.BEST_EFFORT)]
)
def test_a_command_that_leaves_none_is_not_flown(obstacle, reason):
    command, after = judged(among(obstacle))
    assert after.decision.reason == reason
    assert after.backup.acting == 1.0
    assert abs(command.bank) > abs(WISH.bank)
    assert command.load == pytest.approx(math.cos(command.gamma) / math.cos(command.bank))
    kept = ("course", "azimuth", "remaining", "phase", "radius")
    assert [getattr(command, name) for name in kept] == [getattr(WISH, name) for name in kept]


@pytest.mark.parametrize(("airspace", "is_on"), [(None, True), (among(NEAR), False)])
def test_where_nothing_is_known_or_the_law_is_not_assured_everything_passes(airspace, is_on):
    assert judged(airspace, is_on) == (WISH, fresh_assurance())
