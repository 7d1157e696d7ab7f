"""Flights over a link that delivers late: every message is late, the replay knows nothing of it."""

import pytest
from commands import vfguide
from flights import scenario_file

from vfguide.link.codec import decode
from vfguide.link.messages import AttitudeQuaternion, CommandAck, CommandLong
from vfguide.link.tlog import TlogReader

pytestmark = pytest.mark.slow

DOWN, BACK = 100, 60
"""[ms]."""
LATE = ("--set", f"link.delay_ms={DOWN}", "--set", f"link.delay_back_ms={BACK}")


@pytest.fixture(scope="module")
def flown(tmp_path_factory):
    folder = tmp_path_factory.mktemp("late")
    done = vfguide("run", scenario_file(folder), "--out", "run", "--no-report", *LATE, cwd=folder)
    assert done.returncode == 0, done.stderr + done.stdout
    return folder / "run"


@pytest.fixture(scope="module")
def messages(flown):
    """What the companion received and sent, with the times [ms since the start]."""
    frames = [(time, decode(frame)) for time, frame in TlogReader.open(flown / "vehicle-7.tlog")]
    return [(time / 1000 - 1_767_225_600_000, message) for time, message in frames]


def test_the_companion_hears_late(messages):
    heard = [(time, its) for time, its in messages if isinstance(its, AttitudeQuaternion)]
    assert len(heard) > 500
    assert {time - its.time_boot_ms for time, its in heard} == {DOWN}


def test_an_answer_takes_both_ways(messages):
    asked = next(time for time, its in messages if isinstance(its, CommandLong))
    answered = next(time for time, its in messages if isinstance(its, CommandAck))
    assert answered - asked == DOWN + BACK


def test_replay_is_identical(flown):
    done = vfguide("replay", "vehicle-7.tlog", cwd=flown)
    assert done.returncode == 0, done.stderr + done.stdout
    assert "identical" in done.stdout
