"""Silence of the autopilot, stalls of this program, and what the autopilot's failsafe does then."""

import pytest
from conversations import (
    SECOND,
    TICK,
    Conversation,
    flying,
    heartbeat,
    modes_asked,
    setpoints,
    state,
)
from hypothesis import given
from hypothesis import strategies as st

from vfguide.autopilots.engagement import Phase
from vfguide.autopilots.px4 import PX4, Px4Mode
from vfguide.link.enums import MavAutopilot, MavState, MavType
from vfguide.link.messages import CurrentMode, Heartbeat, VfrHud
from vfguide.telemetry.contact import LINK_TIMEOUT, LONGEST_HICCUP, MODE_UNKNOWN, Contact

pytestmark = pytest.mark.slow

OFFBOARD, HOLD, RETURN = Px4Mode.OFFBOARD, Px4Mode.HOLD, Px4Mode.RETURN
MANUAL = Px4Mode.MANUAL


def failsafe(mode):
    """A heartbeat of an autopilot whose failsafe has chosen a mode."""
    return Heartbeat(MavType.FIXED_WING, MavAutopilot.PX4, 0, mode, MavState.CRITICAL)


def stall(talk, seconds, mode=OFFBOARD):
    """This program stands still; what the autopilot sent meanwhile comes at once, then."""
    since, talk.now = talk.boot_ms, talk.now + round(seconds * SECOND)
    talk.boot_ms += round(seconds * 1000)
    out = []
    for boot_ms in range(since + 20, talk.boot_ms, 20):
        out += talk.hear(*state(boot_ms, 0.025 * boot_ms))
    return out + talk.hear(heartbeat(mode) if mode is OFFBOARD else failsafe(mode))


@given(st.floats(0.55, 0.99))
def test_a_short_stall_is_told_and_the_flight_goes_on_with_what_is_new(seconds):
    talk = flying()
    assert not setpoints(stall(talk, seconds))
    assert setpoints(talk.fly(0.1, OFFBOARD))
    assert talk.companion.phase is Phase.FLYING
    assert sum("stood still" in note for note in talk.told) == 1


@given(st.floats(0.0, 0.4))
def test_a_hiccup_is_nothing(seconds):
    talk = flying()
    stall(talk, seconds)
    assert not any("stood still" in note for note in talk.told)
    assert setpoints(talk.fly(0.1, OFFBOARD))


@given(st.floats(1.01, 5.0), st.sampled_from([HOLD, RETURN]))
def test_after_a_long_stall_it_is_silent_and_a_later_choice_engages_again(seconds, fallback):
    talk = flying()
    said = stall(talk, seconds)
    for _ in range(3):
        talk.hear(failsafe(fallback))
        said += talk.fly(1.0, mode=None)
    assert not setpoints(said)
    assert talk.companion.phase is Phase.YIELDING
    assert sum("stood still" in note for note in talk.told) == 1
    assert not any("released" in note for note in talk.told)
    assert set(modes_asked(said)) <= {HOLD}
    assert setpoints(talk.fly(1.0, HOLD))  # somebody has chosen it: the failsafe is over
    assert OFFBOARD not in modes_asked(talk.fly(5.0, HOLD))
    assert setpoints(talk.fly(0.5, OFFBOARD))
    assert talk.companion.phase is Phase.FLYING


def test_a_failsafe_that_holds_is_made_a_chosen_hold_and_one_that_returns_is_left_alone():
    """Else the autopilot would follow by itself as soon as setpoints go out."""
    for fallback, asked in ((HOLD, True), (RETURN, False)):
        talk = flying()
        said = stall(talk, 1.5, fallback)
        for _ in range(5):
            talk.hear(failsafe(fallback))
            said += talk.fly(1.0, mode=None)
        assert (HOLD in modes_asked(said)) is asked
        assert not setpoints(said)


def test_an_autopilot_that_follows_on_in_spite_of_the_silence_is_asked_for_hold():
    talk = flying()
    said = stall(talk, 1.5) + talk.fly(1.9, OFFBOARD)
    assert not modes_asked(said)
    assert HOLD in modes_asked(talk.fly(1.0, OFFBOARD))
    assert not setpoints(talk.fly(1.0, OFFBOARD))


def test_a_mode_that_somebody_chose_meanwhile_is_left_alone():
    talk = flying()
    stall(talk, 1.5)
    assert not modes_asked(talk.fly(5.0, RETURN))


@pytest.mark.parametrize("chosen", [RETURN, MANUAL])
@pytest.mark.parametrize("late", [0.0, 0.3, 0.9])
def test_for_a_mode_that_waited_nothing_is_asked(chosen, late):
    """The failsafe is told by what waited, here or at a router; what was chosen then was lost."""
    talk = flying()
    said = stall(talk, 4.0, HOLD) + talk.fly(late, None)
    said += talk.hear(CurrentMode(0, HOLD, OFFBOARD), failsafe(HOLD))
    said += talk.fly(1.0, mode=None) + talk.fly(5.0, chosen)
    assert not modes_asked(said)
    assert talk.companion.phase is Phase.OFFERING


def test_a_stall_before_the_flight_is_no_lost_link():
    talk = Conversation(engage=False)
    talk.fly(1.0)
    stall(talk, 4.0, HOLD)
    talk.fly(2.0)
    assert sum("stood still" in note for note in talk.told) == 1
    assert not any("link lost" in note or "no setpoints" in note for note in talk.told)
    assert sum("the autopilot is found" in note for note in talk.told) == 1


@given(st.floats(1.0, 60.0), st.floats(0.0, 0.9))
def test_where_most_of_what_waited_was_lost_no_clock_leaps(seconds, kept):
    """A socket keeps what came first, until it is full."""
    talk = flying()
    since, talk.now = talk.boot_ms, talk.now + round(seconds * SECOND)
    talk.boot_ms += round(seconds * 1000)
    for boot_ms in range(since + 20, since + round(kept * seconds * 1000), 20):
        talk.hear(*state(boot_ms, 0.025 * boot_ms))
    talk.fly(1.0)
    assert not any("leapt" in note for note in talk.told)


@pytest.mark.parametrize(
    "said", [failsafe(RETURN), CurrentMode(0, RETURN, OFFBOARD)], ids=["heartbeat", "current mode"]
)
def test_the_failsafe_is_not_the_operators_wish(said):
    talk = flying()
    assert not setpoints(talk.hear(said, *state(talk.boot_ms + 20)))
    assert talk.companion.phase is Phase.YIELDING
    assert any("fallen back on RETURN by itself" in note for note in talk.told)


def test_a_mode_that_was_chosen_releases_it_for_good():
    talk = flying()
    talk.hear(CurrentMode(0, RETURN, RETURN))
    assert talk.companion.phase is Phase.RELEASED


def test_a_stop_while_it_yields_hands_over_or_ends():
    talk = flying()
    stall(talk, 1.5)
    assert modes_asked(talk.stop()) == [HOLD]
    talk = flying()
    stall(talk, 1.5, RETURN)
    assert not talk.stop()
    assert talk.companion.phase is Phase.ENDED


def test_answers_that_waited_do_not_make_the_link_slow():
    talk = flying()
    asked = [m for m in talk.said if type(m).__name__ == "Timesync"]
    stall(talk, 0.9)
    for question in asked[-20:]:
        talk.hear(question._replace(tc1=5))
    assert not any("slow" in note for note in talk.told)


@pytest.mark.parametrize("lost", range(1, int(MODE_UNKNOWN / SECOND)))
def test_the_link_holds_while_states_arrive(lost):
    talk = flying()
    assert len(setpoints(talk.fly(lost, mode=None))) > 40 * lost
    assert talk.companion.phase is Phase.FLYING


def test_without_a_heartbeat_for_long_the_mode_is_unknown():
    talk = flying()
    talk.fly(MODE_UNKNOWN / SECOND + 1.0, mode=None)
    assert talk.companion.phase is Phase.INTERRUPTED
    assert any("link lost, no heartbeat for 10 s" in note for note in talk.told)


def test_what_cannot_be_true_does_not_keep_the_link():
    talk = flying()
    for _ in range(round(3.5 * SECOND / TICK)):
        talk.now += TICK
        talk.hear(VfrHud(-1.0, 0.0, 0, 0, 500.0, 0.0))
        talk.poll()
    assert talk.companion.phase is Phase.INTERRUPTED
    assert any("link lost, nothing heard for 3 s" in note for note in talk.told)


def test_a_silent_autopilot_is_no_stall_while_this_program_runs():
    talk = flying()
    talk.fly(2.5, mode=None, flying=False)
    assert talk.companion.phase is Phase.FLYING
    assert not any("stood still" in note for note in talk.told)
    assert LONGEST_HICCUP < SECOND < PX4.loss_time + 1


@given(
    st.lists(
        st.tuples(
            st.sampled_from(
                (0, 1, LONGEST_HICCUP, LONGEST_HICCUP + 1, LINK_TIMEOUT, LINK_TIMEOUT + 1)
            ),
            st.sampled_from(("hear", "hear_heartbeat", "nothing")),
        ),
        max_size=30,
    )
)
def test_where_it_goes_on_neither_this_program_nor_the_link_is_late(events):
    """`goes_on` says in one call what `wake`, `act` and `silence` say, and leaves the same."""
    now, quick, slow = 0, Contact(), Contact()
    for step, event in events:
        now += step
        gap = slow.wake(now)
        slow.act(now)
        assert quick.goes_on(now) == (gap == 0 and slow.silence(now) is None)
        if gap:
            assert quick.wake(now) == gap
        quick.act(now)
        assert vars(quick) == vars(slow)
        for contact in (quick, slow):
            getattr(contact, event, lambda _: None)(now)
