"""Every flight mode of the software autopilot under every event."""

import pytest

from vfguide.autopilots.px4 import Px4Mode
from vfguide.sim.autopilot.flight_mode import (
    ASKED_BY,
    FAILSAFE_MODES,
    NEXT_MODE,
    REPORTED,
    Event,
    Mode,
)

ALL = [(mode, event) for mode in Mode for event in Event]
OWN = {Mode.HOLD, Mode.RETURN}
"""Modes in which no setpoint counts."""
ASKED = {
    Event.HOLD_ASKED: Mode.HOLD,
    Event.RETURN_ASKED: Mode.RETURN,
    Event.OFFBOARD_ASKED: Mode.OFFBOARD,
}
ENDED = {
    Event.STREAM_LOST_HOLD: Mode.LOST_TO_HOLD,
    Event.STREAM_LOST_RETURN: Mode.LOST_TO_RETURN,
}


def test_every_pair_has_an_entry():
    assert set(NEXT_MODE) == set(ALL)


@pytest.mark.parametrize("mode", Mode)
@pytest.mark.parametrize("event", ASKED)
def test_what_is_asked_for_is_flown_from_everywhere(mode, event):
    assert NEXT_MODE[mode, event] is ASKED[event]


@pytest.mark.parametrize("mode", Mode)
@pytest.mark.parametrize("event", ENDED)
def test_the_end_of_the_stream_matters_in_offboard_alone(mode, event):
    assert NEXT_MODE[mode, event] is (ENDED[event] if mode is Mode.OFFBOARD else mode)


@pytest.mark.parametrize("mode", Mode)
def test_a_stream_that_resumes_takes_over_only_where_it_was_lost(mode):
    assert NEXT_MODE[mode, Event.STREAM_BACK] is (Mode.OFFBOARD if mode in FAILSAFE_MODES else mode)


@pytest.mark.parametrize("event", [Event.HOLD_ASKED, Event.RETURN_ASKED])
@pytest.mark.parametrize("lost", [Mode.LOST_TO_HOLD, Mode.LOST_TO_RETURN])
def test_an_explicit_mode_cancels_the_way_back(lost, event):
    chosen = NEXT_MODE[lost, event]
    assert chosen in OWN
    assert NEXT_MODE[chosen, Event.STREAM_BACK] is chosen


@pytest.mark.parametrize(("mode", "event"), ALL)
def test_offboard_comes_from_being_asked_or_from_the_stream_that_was_lost(mode, event):
    if NEXT_MODE[mode, event] is Mode.OFFBOARD and mode is not Mode.OFFBOARD:
        assert event is Event.OFFBOARD_ASKED or (
            mode in FAILSAFE_MODES and event is Event.STREAM_BACK
        )


def test_the_heartbeat_names_what_is_flown():
    assert set(REPORTED) == set(Mode)
    assert [mode for mode in Mode if REPORTED[mode] is Px4Mode.OFFBOARD] == [Mode.OFFBOARD]
    assert {REPORTED[mode] for mode in FAILSAFE_MODES} == {Px4Mode.HOLD, Px4Mode.RETURN}


def test_a_mode_that_is_asked_for_is_reported_by_its_name():
    for px4_mode, event in ASKED_BY.items():
        assert REPORTED[NEXT_MODE[Mode.HOLD, event]] is px4_mode
