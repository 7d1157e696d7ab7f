"""The autopilot restarts in flight, or another one is heard after a lost link."""

import pytest
from conversations import SECOND, TICK, Conversation, flying, heartbeat, modes_asked, setpoints
from conversations import state as state_at
from hypothesis import given, settings
from hypothesis import strategies as st

from vfguide.autopilots.engagement import Phase
from vfguide.autopilots.px4 import Px4Mode
from vfguide.link.enums import MavAutopilot, MavCmd, MavResult, MavState, MavType
from vfguide.link.messages import CommandAck, CommandLong, CurrentMode, GpsGlobalOrigin, Heartbeat

OFFBOARD, HOLD, MANUAL = Px4Mode.OFFBOARD, Px4Mode.HOLD, Px4Mode.MANUAL
DISARMED = [MavState.UNINIT, MavState.BOOT, MavState.CALIBRATING, MavState.STANDBY]


def beat(mode, status):
    return Heartbeat(MavType.FIXED_WING, MavAutopilot.PX4, 0, mode, status)


def after(talk: Conversation, seconds, boot_ms, mode, status, *, says=heartbeat, north=0.0):
    """Nothing for so long, then 3 s of an autopilot whose counter is `boot_ms` at first."""
    said = talk.fly(seconds, mode=None, flying=False)
    for tick in range(round(3 * SECOND / TICK)):
        talk.now += TICK
        if tick % 50 == 0:
            told = CurrentMode(0, mode, mode) if says is CurrentMode else beat(mode, status)
            said += talk.hear(told)
        said += talk.hear(*state_at(boot_ms + 20 * tick, north + 0.5 * tick)[1:])
        said += talk.poll()
    return said


@settings(max_examples=8)
@given(
    st.floats(3.2, 9.0), st.integers(0, 2000), st.sampled_from([HOLD, MANUAL]),
    st.sampled_from(DISARMED),
)  # fmt: skip
def test_a_restart_releases_nobody_and_asks_for_no_mode(seconds, boot_ms, mode, status):
    talk = flying(engage=False)
    talk.boot_ms += 100_000
    talk.fly(1.0, OFFBOARD)
    said = after(talk, seconds, boot_ms, mode, status)
    assert talk.companion.phase in (Phase.YIELDING, Phase.OFFERING)
    assert "released" not in "".join(talk.told)
    assert not modes_asked(said)
    assert sum("restart" in note for note in talk.told) == 1


@settings(max_examples=8)
@given(
    st.floats(3.2, 9.0), st.integers(20_000, 10**9), st.sampled_from([HOLD, OFFBOARD]),
    st.sampled_from([heartbeat, CurrentMode]),
)  # fmt: skip
def test_another_autopilot_after_a_lost_link_is_not_guided_and_releases_nobody(
    seconds, boot_ms, mode, says
):
    """It may speak from another address by then, with the same numbers."""
    talk = flying()
    said = after(talk, seconds, 10**6 + boot_ms, mode, MavState.ACTIVE, says=says, north=900.0)
    assert talk.companion.phase is not Phase.RELEASED
    assert talk.companion.phase is not Phase.FLYING
    assert OFFBOARD not in modes_asked(said)
    assert HOLD not in modes_asked(said)


def test_the_origin_and_the_streams_are_asked_for_anew():
    talk = flying()
    for _ in range(40):
        asked = [m for m in talk.fly(0.1, OFFBOARD) if isinstance(m, CommandLong)]
        talk.hear(*(CommandAck(m.command, MavResult.ACCEPTED) for m in asked))
    assert not [m for m in talk.fly(1.0, OFFBOARD) if isinstance(m, CommandLong)]
    said = after(talk, 5.0, 0, OFFBOARD, MavState.ACTIVE)
    asked = {(m.command, m.param1) for m in said if isinstance(m, CommandLong)}
    assert (MavCmd.REQUEST_MESSAGE, GpsGlobalOrigin.MSGID) in asked
    assert len(setpoints(said)) == 1  # the one that ends a roll


@pytest.mark.parametrize("status", DISARMED)
def test_an_autopilot_that_was_never_armed_may_be_tried_on_the_ground(status):
    talk = Conversation(engage=False)
    for mode in (HOLD, OFFBOARD, OFFBOARD, OFFBOARD):
        talk.hear(beat(mode, status))
        talk.fly(1.0, mode=None)
    assert talk.companion.phase is Phase.FLYING


def test_a_short_silence_of_the_same_autopilot_is_none_of_this():
    talk = flying()
    talk.fly(4.0, mode=None, flying=False)
    assert talk.companion.phase is Phase.INTERRUPTED
    talk.fly(3.0, OFFBOARD)
    assert talk.companion.phase is Phase.FLYING
