"""What the companion does in the face of an autopilot that somebody plays."""

import math
from random import Random

import pytest
from conversations import (
    SECOND,
    Conversation,
    flying,
    heartbeat,
    modes_asked,
    plan,
    setpoints,
    state,
)
from hypothesis import given
from hypothesis import strategies as st

from vfguide.autopilots.engagement import FINAL_PHASES, Phase
from vfguide.autopilots.px4 import Px4Mode
from vfguide.companion.companion import Companion
from vfguide.link.enums import MavResult, MavState, MavType
from vfguide.link.messages import (
    AttitudeQuaternion,
    GpsGlobalOrigin,
    Heartbeat,
    LocalPositionNed,
    VfrHud,
    WindCov,
)

OFFBOARD, HOLD, RETURN = Px4Mode.OFFBOARD, Px4Mode.HOLD, Px4Mode.RETURN


def test_it_says_who_it_is_once_a_second_and_nothing_else_while_nobody_is_heard():
    talk = Conversation()
    said = talk.fly(5.0, mode=None, flying=False)
    assert len(said) == 5
    assert all(isinstance(m, Heartbeat) and m.type == MavType.ONBOARD_CONTROLLER for m in said)


def test_it_asks_for_offboard_once_setpoints_have_gone_out_for_a_while():
    talk = Conversation()
    before = talk.fly(0.2)
    assert setpoints(before)
    assert not modes_asked(before)
    assert modes_asked(talk.fly(0.1)) == [OFFBOARD]


def test_without_engage_it_only_offers():
    talk = Conversation(engage=False)
    said = talk.fly(5.0)
    assert len(setpoints(said)) == pytest.approx(250, abs=2)
    assert not modes_asked(said)
    assert any("waiting for the operator" in note for note in talk.told)


def test_it_insists_while_it_is_not_answered_or_refused():
    talk = Conversation()
    talk.fly(0.5)
    talk.acknowledge()
    talk.acknowledge(MavResult.TEMPORARILY_REJECTED)
    assert modes_asked(talk.fly(3.0)) == [OFFBOARD] * 3
    assert sum("refuses OFFBOARD" in note for note in talk.told) == 1


def test_an_autopilot_that_accepts_and_flies_something_else_is_left_alone():
    talk = Conversation()
    talk.fly(0.5)
    talk.acknowledge()
    assert not modes_asked(talk.fly(10.0))
    assert talk.companion.phase is Phase.OFFERING
    assert any("not asked again" in note for note in talk.told)


def test_a_mode_that_somebody_chooses_meanwhile_is_respected():
    talk = Conversation()
    talk.fly(0.1)
    assert not modes_asked(talk.fly(5.0, RETURN))
    assert any("changed to RETURN" in note for note in talk.told)


def test_somebody_elses_setpoints_are_not_joined():
    talk = Conversation()
    assert not setpoints(talk.fly(3.0, OFFBOARD))
    assert sum("somebody's setpoints" in note for note in talk.told) == 1
    assert setpoints(talk.fly(0.5, HOLD))


def test_the_operators_mode_silences_it_for_good():
    talk = flying()
    assert not setpoints(talk.fly(0.02, HOLD))
    said = talk.fly(5.0, HOLD) + talk.fly(5.0, OFFBOARD)
    assert not setpoints(said)
    assert not modes_asked(said)
    assert any("released: the mode was changed to HOLD" in note for note in talk.told)


def test_it_is_silent_while_the_link_is_lost_and_goes_on_afterwards():
    talk = flying()
    talk.fly(2.9, mode=None, flying=False)
    assert talk.companion.phase is Phase.FLYING
    talk.fly(0.2, mode=None, flying=False)
    assert talk.companion.phase is Phase.INTERRUPTED
    assert not setpoints(talk.fly(1.0, mode=None))
    beats = [m for m in talk.fly(1.0, mode=None) if isinstance(m, Heartbeat)]
    assert beats[-1].system_status == MavState.CRITICAL
    assert setpoints(talk.fly(0.5, OFFBOARD))
    assert talk.told.count("flying to goal 1 of 1") == 2


def test_a_stop_asks_for_hold_at_once_and_keeps_the_stream_until_it_is_flown():
    talk = flying()
    assert modes_asked(talk.stop()) == [HOLD]
    assert len(setpoints(talk.fly(0.5, mode=None))) == pytest.approx(25, abs=1)
    talk.hear(heartbeat(HOLD))
    assert talk.companion.phase is Phase.ENDED
    assert not setpoints(talk.fly(0.5, mode=None))


def test_a_stop_while_offboard_is_asked_for_takes_the_question_back():
    talk = Conversation()
    talk.fly(0.5)
    assert talk.companion.phase is Phase.ASKING
    assert modes_asked(talk.stop()) == [HOLD]


def test_hold_is_asked_for_again_until_it_is_accepted():
    talk = flying()
    talk.stop()
    assert modes_asked(talk.fly(2.5, OFFBOARD)) == [HOLD] * 2
    talk.acknowledge()
    assert not modes_asked(talk.fly(3.0, OFFBOARD))


def test_a_stop_without_a_link_is_no_hand_over():
    talk = flying()
    talk.fly(4.0, mode=None, flying=False)
    talk.stop()
    assert talk.companion.phase is Phase.UNCONFIRMED


def test_a_stop_before_it_flies_ends_at_once():
    talk = Conversation(engage=False)
    talk.fly(1.0)
    assert not talk.stop()
    assert talk.companion.phase in FINAL_PHASES


def test_it_says_once_why_no_setpoints_go_out():
    talk = Conversation()
    talk.fly(3.0, flying=False)
    (why,) = [note for note in talk.told if "no setpoints" in note]
    for name in ("attitude", "position", "airspeed", "origin"):
        assert name in why
    talk.fly(0.5)
    assert [note for note in talk.told if note.startswith("setpoints")] == [
        "setpoints go out, OFFBOARD will be asked for"
    ]


def test_an_old_airspeed_is_not_flown_on():
    talk = flying()
    before = len(setpoints(talk.said))
    for tick in range(130):
        if tick % 50 == 0:
            talk.hear(heartbeat(Px4Mode.OFFBOARD))
        talk.boot_ms += 20
        talk.now += 20_000
        talk.hear(*(m for m in state(talk.boot_ms) if not isinstance(m, VfrHud)))
    assert len(setpoints(talk.said)) == before + 130
    assert any("airspeed is estimated" in note for note in talk.told)


def test_an_autopilot_that_starts_anew_is_guided_again():
    talk = Conversation(engage=False)
    talk.fly(1.0)
    talk.boot_ms = 0
    assert len(setpoints(talk.fly(1.0))) == pytest.approx(50, abs=2)


def test_the_rollover_of_the_autopilots_clock_goes_unnoticed():
    talk = Conversation(engage=False)
    talk.boot_ms = 2**32 - 500
    sent = []
    for _ in range(50):
        talk.now += 20_000
        talk.boot_ms = (talk.boot_ms + 20) % 2**32
        sent += setpoints(talk.hear(heartbeat(), *state(talk.boot_ms)))
    assert len(sent) == pytest.approx(50, abs=2)


def test_setpoints_follow_from_what_was_heard_and_its_order_alone():
    """Neither polls nor the wish to engage change one of them: a replay knows of neither."""
    modes = [HOLD] * 3 + [OFFBOARD] * 4 + [None] * 8 + [OFFBOARD] * 4
    rng = Random(3)

    def fly(engage, polls):
        talk = Conversation(engage=engage)
        out = []
        for mode in modes:
            for tick in range(25):
                talk.now += 20_000
                talk.boot_ms += 20
                beat = [heartbeat(mode)] if mode is not None and tick == 0 else []
                out += talk.hear(*beat, *state(talk.boot_ms, 0.025 * talk.boot_ms))
                if rng.random() < polls:
                    talk.now += 1000
                    talk.poll()
                    talk.now -= 1000
        return setpoints(out)

    expected = fly(True, 1.0)
    assert len(expected) > 200
    assert fly(False, 0.0) == expected
    assert fly(True, 0.3) == expected


any_float = st.floats(width=32)
any_time = st.integers(0, 2**32 - 1)
any_state = st.one_of(
    st.builds(AttitudeQuaternion, any_time, *[any_float] * 7),
    st.builds(LocalPositionNed, any_time, *[any_float] * 6),
    st.builds(VfrHud, any_float, any_float, st.just(0), st.just(0), any_float, any_float),
    st.builds(WindCov, st.just(0), *[any_float] * 8),
    st.builds(GpsGlobalOrigin, *[st.integers(-(2**31), 2**31 - 1)] * 3),
)


@given(st.lists(any_state, max_size=8))
def test_no_state_however_wild_makes_it_send_what_is_no_number(wild):
    companion = Companion(1, plan(), engage=False)
    companion.receive(0, heartbeat(HOLD))
    companion.receive(0, heartbeat(OFFBOARD))
    for number in range(4):
        for message in [*state(20 * number), *wild, *state(20 * number + 10)]:
            for setpoint in setpoints(companion.receive(SECOND, message)):
                rates = (setpoint.body_roll_rate, setpoint.body_pitch_rate, setpoint.body_yaw_rate)
                assert all(map(math.isfinite, (*rates, setpoint.thrust, *setpoint.q)))


@pytest.mark.parametrize(
    "message",
    [
        AttitudeQuaternion(0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        AttitudeQuaternion(0, math.nan, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        LocalPositionNed(0, math.inf, 0.0, 0.0, 0.0, 0.0, 0.0),
        VfrHud(math.nan, 0.0, 0, 0, 500.0, 0.0),
        VfrHud(-1.0, 0.0, 0, 0, 500.0, 0.0),
        VfrHud(25.0, 0.0, 0, 0, 1e9, 0.0),
    ],
)
def test_what_cannot_be_true_is_not_heard(message):
    talk = Conversation(engage=False)
    talk.hear(heartbeat())
    kept = [m for m in state(5000) if type(m) is not type(message)]
    assert not setpoints(talk.hear(*kept, message._replace(**time_of(message)), *kept))


def time_of(message):
    return {"time_boot_ms": 5000} if "time_boot_ms" in message._fields else {}
