"""The comparison of recorded setpoints with those of the same inputs now."""

import pytest

from vfguide.link.codec import Encoder, Parser
from vfguide.link.messages import SetAttitudeTarget
from vfguide.link.tlog import TlogReader
from vfguide.replay.compare import Comparison, Replay, Timed, companions_in, first_difference
from vfguide.runs.lockstep import fly_scenario
from vfguide.scenario.load import load_scenario
from vfguide.scenario.plans import plan_of

SECONDS = 4
LEVEL = (1.0, 0.0, 0.0, 0.0)


@pytest.fixture(scope="module")
def flown(tmp_path_factory):
    """The first seconds of the first flight: what it was, and the log of its companion."""
    folder = tmp_path_factory.mktemp("flown")
    loaded = load_scenario("first-flight", [f"duration_s={SECONDS}"])
    fly_scenario(loaded, folder)
    return loaded, list(TlogReader.open(folder / "vehicle-1.tlog"))


def replayed(loaded, log) -> Comparison:
    plan = plan_of(loaded, loaded.scenario.vehicles[0])
    return Replay(1, plan, lambda *_: None).compare(log)


def setpoint(thrust, seq=0):
    encoder = Encoder(1, 195)
    encoder.seq = seq
    message = SetAttitudeTarget(20, 1, 1, 0x80, LEVEL, 0.1, 0.2, 0.3, thrust)
    (frame,) = Parser().feed(encoder.encode(message))
    return frame


def test_the_same_inputs_give_the_same_setpoints(flown):
    found = replayed(*flown)
    assert found.difference is None
    assert found.recorded == found.replayed > 40 * SECONDS


def test_a_setpoint_that_is_not_in_the_log_is_missed(flown):
    loaded, log = flown
    sent = [index for index, (_, frame) in enumerate(log) if frame.msgid == SetAttitudeTarget.MSGID]
    found = replayed(loaded, [timed for index, timed in enumerate(log) if index != sent[-1]])
    assert found.difference is not None
    assert found.difference.number == len(sent) - 1
    assert found.difference.what == "the log has no such setpoint, the replay has"


def test_the_vehicle_whose_companion_speaks_is_found(flown):
    assert companions_in(flown[1]) == [1]


@pytest.mark.parametrize(
    ("old", "new", "what"),
    [
        (Timed(5, setpoint(0.5)), Timed(5, setpoint(0.75)), "thrust: recorded 0.5, now 0.75"),
        (Timed(5, setpoint(0.5)), Timed(6, setpoint(0.5)), "time of sending: recorded 5, now 6 us"),
        (Timed(5, setpoint(0.5)), None, "the replay has no such setpoint, the log has"),
    ],
)
def test_the_first_difference_is_named(old, new, what):
    same = [Timed(1, setpoint(0.5)), Timed(2, setpoint(0.25))]
    found = first_difference([*same, old], [*same, *([] if new is None else [new])])
    assert found is not None
    assert (found.number, found.time, found.what) == (2, 5, what)


def test_the_numbers_of_frames_are_no_difference():
    old, new = (Timed(1, setpoint(0.5, seq=seq)) for seq in (3, 9))
    assert first_difference([old], [new]) is None
