"""The log of a flight, replayed."""

import pytest

from vfguide.link.messages import SetAttitudeTarget
from vfguide.link.tlog import TlogReader
from vfguide.preflight.load import load_scenario
from vfguide.replay.compare import Comparison, Replay, companions_in
from vfguide.runs.lockstep import fly_scenario
from vfguide.scenario.plans import plan_of

SECONDS = 4


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
