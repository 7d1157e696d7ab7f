"""What stands in the logs of a run, read by other people's software too."""

import math
from itertools import pairwise

import pytest
from flights import messages, scenario_file
from pymavlink import mavutil

from vfguide.link.messages import Heartbeat, HilStateQuaternion, SetAttitudeTarget
from vfguide.preflight.load import load_scenario
from vfguide.runs.lockstep import fly_scenario
from vfguide.runs.truth_log import TRUTH_COMPONENT

DURATION = 10.0


@pytest.fixture(scope="module")
def logs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("logs")
    fly_scenario(load_scenario(scenario_file(folder), [f"duration_s={DURATION}"]), folder)
    return folder


def test_setpoints_are_body_rates_at_50_hz_and_finite(logs):
    sent = [
        (time, frame, message)
        for time, frame, message in messages(logs / "vehicle-7.tlog")
        if isinstance(message, SetAttitudeTarget)
    ]
    assert {frame.compid for _, frame, _ in sent} == {195}
    assert {frame.sysid for _, frame, _ in sent} == {7}
    assert {message.type_mask for *_, message in sent} == {0x80}
    assert all(
        math.isfinite(value)
        for *_, m in sent
        for value in (*m.q, m.body_roll_rate, m.body_pitch_rate, m.body_yaw_rate, m.thrust)
    )
    times = [time for time, *_ in sent]
    assert {b - a for a, b in pairwise(times)} == {20_000}
    assert len(sent) >= 50 * (DURATION - 0.3)


def test_no_companion_sees_the_truth(logs):
    own = {type(message) for *_, message in messages(logs / "vehicle-7.tlog")}
    assert HilStateQuaternion not in own
    truth = [
        (time, frame)
        for time, frame, message in messages(logs / "flight.tlog")
        if isinstance(message, HilStateQuaternion)
    ]
    assert {frame.compid for _, frame in truth} == {TRUTH_COMPONENT}
    assert len(truth) == 50 * DURATION + 1
    assert truth[0][0] == 1_767_225_600_000_000  # 2026-01-01T00:00:00Z
    assert [frame.seq for _, frame in truth[:3]] == [0, 1, 2]


def test_the_companion_shows_itself_once_a_second(logs):
    beats = [
        (time, message)
        for time, frame, message in messages(logs / "vehicle-7.tlog")
        if frame.compid == 195 and isinstance(message, Heartbeat)
    ]
    assert abs(len(beats) - DURATION) <= 2
    assert {(m.type, m.autopilot) for _, m in beats} == {(18, 8)}


def test_pymavlink_reads_every_frame(logs):
    ours = messages(logs / "flight.tlog")
    theirs = mavutil.mavlogfile(str(logs / "flight.tlog"))
    names = []
    while (message := theirs.recv_msg()) is not None:
        names.append(message.get_type())
    theirs.close()
    assert "BAD_DATA" not in names
    assert len(names) == len(ours)
    assert names == [message.NAME for *_, message in ours]
