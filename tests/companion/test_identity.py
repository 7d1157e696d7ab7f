"""Who speaks is known before anything is sent; whoever else speaks changes nothing."""

import pytest
from conversations import SECOND, TICK, Conversation, heartbeat, setpoints, state

from vfguide.autopilots.engagement import Phase
from vfguide.autopilots.px4 import Px4Mode
from vfguide.link.enums import MavAutopilot, MavState, MavType
from vfguide.link.messages import Heartbeat

pytestmark = pytest.mark.slow

OFFBOARD, HOLD = Px4Mode.OFFBOARD, Px4Mode.HOLD
STRANGERS = [
    (MavType.FIXED_WING, MavAutopilot.ARDUPILOTMEGA, 3),
    (MavType.FIXED_WING, MavAutopilot.GENERIC, 3),
    (MavType.FIXED_WING, 17, 3),
    (MavType.FIXED_WING, 255, 3),
    (MavType.QUADROTOR, MavAutopilot.PX4, 3),
    (MavType.HELICOPTER, MavAutopilot.PX4, 3),
    (MavType.VTOL_QUADROTOR, MavAutopilot.PX4, 3),
    (10, MavAutopilot.PX4, 3),
    (200, MavAutopilot.PX4, 3),
    (MavType.FIXED_WING, MavAutopilot.PX4, 1),
]
NOBODY = [
    (MavType.GCS, MavAutopilot.INVALID, 3),
    (MavType.FIXED_WING, MavAutopilot.INVALID, 3),
    (MavType.ONBOARD_CONTROLLER, MavAutopilot.INVALID, 3),
]


def beat(who, mode=HOLD):
    kind, make, version = who
    return Heartbeat(kind, make, 0, mode, MavState.ACTIVE, version)


def hear_for(talk, seconds, *beats, flying=True):
    """So many seconds with these heartbeats once a second."""
    out = []
    for tick in range(round(seconds * SECOND / TICK)):
        talk.now += TICK
        talk.boot_ms += TICK // 1000
        if tick % 50 == 0:
            out += talk.hear(*beats)
        if flying:
            out += talk.hear(*state(talk.boot_ms, 0.025 * talk.boot_ms))
        out += talk.poll()
    return out


@pytest.mark.parametrize("who", STRANGERS + NOBODY)
@pytest.mark.parametrize("mode", [HOLD, OFFBOARD, 0, 10])
def test_a_stranger_gets_nothing_but_our_heartbeat_and_one_sentence_is_told(who, mode):
    talk = Conversation()
    said = hear_for(talk, 5.0, beat(who, mode))
    assert len(said) == 5
    assert all(isinstance(m, Heartbeat) for m in said)
    assert talk.companion.phase is Phase.SEARCHING
    (told,) = talk.told
    assert "nothing is sent" in told if who in STRANGERS else "ignored" in told


@pytest.mark.parametrize("who", STRANGERS + NOBODY)
@pytest.mark.parametrize("mode", [HOLD, OFFBOARD, 0])
def test_a_heartbeat_that_cannot_be_the_vehicles_changes_nothing(who, mode):
    alone, disturbed = Conversation(), Conversation()
    for talk, others in ((alone, []), (disturbed, [beat(who, mode)])):
        hear_for(talk, 1.0, *others, heartbeat(HOLD))
        hear_for(talk, 3.0, heartbeat(OFFBOARD), *others)
        assert talk.companion.phase is Phase.FLYING
    assert disturbed.said == alone.said
    assert len(disturbed.told) <= len(alone.told) + 2
    assert "released" not in "".join(disturbed.told)


@pytest.mark.parametrize("who", STRANGERS + NOBODY)
def test_it_does_not_keep_the_link_either(who):
    talk = Conversation()
    talk.fly(1.0)
    talk.fly(1.0, OFFBOARD)
    said = hear_for(talk, 4.0, beat(who, OFFBOARD), flying=False)
    assert talk.companion.phase is Phase.INTERRUPTED
    assert len(setpoints(said)) == 1  # the one that ends a roll


def test_the_operator_is_not_flooded():
    talk = Conversation()
    for make in range(100, 200):
        talk.hear(beat((MavType.FIXED_WING, make, 3)))
    assert len(talk.told) <= 5
