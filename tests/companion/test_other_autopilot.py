"""An autopilot of another make needs its record and its place in the table, and nothing else."""

from dataclasses import replace
from enum import IntEnum

import pytest
from conversations import Conversation, plan, setpoints, state

from vfguide.autopilots.autopilot import Stream
from vfguide.autopilots.engagement import Phase
from vfguide.autopilots.makes import BY_MAKE
from vfguide.autopilots.px4 import PX4, Px4Mode
from vfguide.companion.guided_flight import GuidedFlight
from vfguide.estimation.local_frame import Measurement
from vfguide.link.enums import AttitudeTypeMask, MavAutopilot, MavCmd, MavState, MavType
from vfguide.link.messages import AttitudeQuaternion, CommandLong, Heartbeat
from vfguide.loop.rows import step_measured

ATTITUDES = int(AttitudeTypeMask.BODY_ROLL_RATE_IGNORE | AttitudeTypeMask.BODY_YAW_RATE_IGNORE)


class PlaneMode(IntEnum):
    """Some of ArduPlane's."""

    AUTO = 10
    LOITER = 12
    GUIDED = 15


PLANE = replace(
    PX4,
    make=MavAutopilot.ARDUPILOTMEGA,
    modes=PlaneMode,
    follow_mode=PlaneMode.GUIDED,
    hold_mode=PlaneMode.LOITER,
    mode_parameters=lambda mode: (1, mode),
    offer=1_000_000,
    type_mask=ATTITUDES,
    streams=(Stream(AttitudeQuaternion.MSGID, 25.0),),
)


class PlaneConversation(Conversation):
    """The autopilot that is played is ArduPlane."""

    def beat(self, mode: int) -> list:
        kind = (MavType.FIXED_WING, MavAutopilot.ARDUPILOTMEGA)
        return self.hear(Heartbeat(*kind, 0, mode, MavState.ACTIVE))

    def fly_in(self, mode: int, seconds: float) -> list:
        said = []
        for _ in range(round(seconds)):
            said += self.beat(mode)
            said += self.fly(1.0, mode=None)
        return said


@pytest.fixture
def talk(monkeypatch):
    monkeypatch.setitem(BY_MAKE, PLANE.make, PLANE)
    return PlaneConversation()


def modes_asked(messages):
    """The parameters of every DO_SET_MODE."""
    return [
        (m.param1, m.param2, m.param3)
        for m in messages
        if isinstance(m, CommandLong) and m.command == MavCmd.DO_SET_MODE
    ]


def test_it_is_asked_for_its_own_mode_after_its_own_time(talk):
    first = talk.fly_in(PlaneMode.AUTO, 1.0)
    assert setpoints(first)
    assert not modes_asked(first)
    assert modes_asked(talk.fly_in(PlaneMode.AUTO, 1.0)) == [(1, PlaneMode.GUIDED, 0)]


def test_it_gets_setpoints_with_its_own_mask(talk):
    sent = setpoints(talk.fly_in(PlaneMode.AUTO, 1.0))
    assert {each.type_mask for each in sent} == {ATTITUDES}


def test_it_is_asked_for_its_own_streams(talk):
    said = talk.fly_in(PlaneMode.AUTO, 1.0)
    asked = [m for m in said if isinstance(m, CommandLong)]
    asked = [m for m in asked if m.command == MavCmd.SET_MESSAGE_INTERVAL]
    assert {(m.param1, m.param2) for m in asked} == {(AttitudeQuaternion.MSGID, 40_000.0)}


def test_it_is_followed_and_left_in_its_own_modes(talk):
    talk.fly_in(PlaneMode.AUTO, 2.0)
    talk.fly_in(PlaneMode.GUIDED, 1.0)
    assert talk.companion.phase is Phase.FLYING
    assert modes_asked(talk.stop()) == [(1, PlaneMode.LOITER, 0)]
    talk.beat(PlaneMode.LOITER)
    assert talk.companion.phase is Phase.ENDED


def test_the_operator_reads_the_names_of_its_modes(talk):
    talk.fly_in(PlaneMode.AUTO, 2.0)
    talk.fly_in(PlaneMode.GUIDED, 1.0)
    talk.stop()
    told = " ".join(talk.told)
    assert all(mode.name in told for mode in (PlaneMode.AUTO, PlaneMode.GUIDED, PlaneMode.LOITER))
    assert not any(mode.name in told for mode in (Px4Mode.OFFBOARD, Px4Mode.HOLD))


def test_its_local_frame_reaches_the_step(monkeypatch):
    """A number that stands for no projection shows that nothing else is put in its place."""
    monkeypatch.setitem(BY_MAKE, PLANE.make, replace(PLANE, projection=77))
    placed_by = []

    def step(measured, *others):
        placed_by.append(Measurement(*measured).projection)
        return step_measured(measured, *others)

    talk = PlaneConversation()
    talk.beat(PlaneMode.AUTO)
    talk.hear(*state(5000))
    GuidedFlight(plan(), step).guide(talk.companion._known, False, 0.0)
    assert placed_by == [77]
    assert not setpoints(talk.said)
