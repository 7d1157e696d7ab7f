"""Every phase of the companion under every event."""

import pytest

from vfguide.autopilots.engagement import FINAL_PHASES, SENDING, TRANSITIONS, Event, Phase

ALL = [(phase, event) for phase in Phase for event in Event]
CONTROL = {Phase.FLYING, Phase.INTERRUPTED, Phase.RETURNING}
"""The companion's setpoints are flown, or may be."""
MAY_FLY = {Phase.ASKING, Phase.FLYING, Phase.INTERRUPTED}
"""They are flown, or will be as soon as the autopilot says so."""


def reachable(*begin):
    """All phases that can come after these."""
    found = set(begin)
    while more := {TRANSITIONS[phase, event] for phase in found for event in Event} - found:
        found |= more
    return found


def test_every_pair_has_an_entry():
    assert set(TRANSITIONS) == set(ALL)


@pytest.mark.parametrize("phase", [Phase.RELEASED, Phase.ENDED, Phase.UNCONFIRMED])
def test_who_was_released_or_has_ended_never_sends_again(phase):
    assert not reachable(phase) & set(SENDING)


@pytest.mark.parametrize("phase", [Phase.ENDED, Phase.UNCONFIRMED])
def test_the_end_is_the_end(phase):
    assert reachable(phase) == {phase}


def test_every_phase_can_come_about():
    assert reachable(Phase.SEARCHING) == set(Phase)


def test_only_the_autopilot_makes_it_fly():
    ways = {
        event for (phase, event), after in TRANSITIONS.items() if after is Phase.FLYING is not phase
    }
    assert ways == {Event.FOLLOWING_SEEN}


@pytest.mark.parametrize("phase", Phase)
def test_a_mode_of_the_autopilots_own_ends_control_at_once(phase):
    after = TRANSITIONS[phase, Event.OTHER_MODE_SEEN]
    assert after not in CONTROL
    if phase in CONTROL:
        assert after not in SENDING


@pytest.mark.parametrize("phase", Phase)
def test_a_stop_leads_to_the_end_or_to_the_hand_over(phase):
    after = TRANSITIONS[phase, Event.STOP_ASKED]
    assert after in {*FINAL_PHASES, Phase.RETURNING}
    may_be_flown = phase in {Phase.ASKING, Phase.FLYING, Phase.YIELDING, Phase.RETURNING}
    assert (after is Phase.RETURNING) == may_be_flown


@pytest.mark.parametrize("phase", Phase)
def test_without_a_link_nothing_is_sent(phase):
    assert TRANSITIONS[phase, Event.LINK_LOST] not in SENDING


@pytest.mark.parametrize("phase", Phase)
def test_who_cannot_guide_sends_nothing_that_is_flown(phase):
    after = TRANSITIONS[phase, Event.UNABLE]
    assert after not in {Phase.ASKING, Phase.FLYING}
    assert after is (Phase.YIELDING if phase in MAY_FLY else phase)


@pytest.mark.parametrize("phase", Phase)
def test_what_the_failsafe_does_is_not_taken_for_the_operators_wish(phase):
    after = TRANSITIONS[phase, Event.FALLBACK_SEEN]
    assert after is not Phase.RELEASED or phase is Phase.RELEASED
    assert after is not Phase.FLYING
    assert (after is Phase.YIELDING) == (phase in MAY_FLY - {Phase.ASKING} | {Phase.YIELDING})


def test_who_yielded_can_be_chosen_again_and_waits_for_that():
    assert Phase.FLYING in reachable(Phase.YIELDING)
    nexts = {TRANSITIONS[Phase.YIELDING, event] for event in Event} - {Phase.YIELDING}
    assert nexts == {Phase.OFFERING, Phase.RETURNING, Phase.ENDED}


@pytest.mark.parametrize("phase", Phase)
def test_only_who_yielded_can_be_able_again(phase):
    after = TRANSITIONS[phase, Event.ABLE_AGAIN]
    assert after is (Phase.OFFERING if phase is Phase.YIELDING else phase)


@pytest.mark.parametrize("phase", Phase)
def test_it_asks_only_while_the_autopilot_flies_in_a_mode_of_its_own(phase):
    after = TRANSITIONS[phase, Event.FOLLOWING_ASKED]
    assert after is (Phase.ASKING if phase is Phase.OFFERING else phase)


@pytest.mark.parametrize("phase", Phase)
def test_giving_up_the_question_touches_nothing_else(phase):
    after = TRANSITIONS[phase, Event.ASKING_GIVEN_UP]
    assert after is (Phase.OFFERING if phase is Phase.ASKING else phase)


@pytest.mark.parametrize("phase", Phase)
def test_somebody_elses_setpoints_are_never_joined(phase):
    """OFFBOARD that was there before the companion is not its own."""
    if phase is Phase.SEARCHING:
        assert TRANSITIONS[phase, Event.FOLLOWING_SEEN] is Phase.SEARCHING
    assert TRANSITIONS[phase, Event.FOLLOWING_SEEN] in {phase, Phase.FLYING}


@pytest.mark.parametrize(("phase", "event"), ALL)
def test_the_same_event_twice_is_no_news(phase, event):
    after = TRANSITIONS[phase, event]
    assert TRANSITIONS[after, event] is after
