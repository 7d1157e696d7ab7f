"""The comparison of recorded setpoints with those of the same inputs now."""

import pytest

from vfguide.link.codec import Encoder, Parser
from vfguide.link.messages import SetAttitudeTarget
from vfguide.replay.compare import Timed, first_difference

LEVEL = (1.0, 0.0, 0.0, 0.0)


def setpoint(thrust, seq=0):
    encoder = Encoder(1, 195)
    encoder.seq = seq
    message = SetAttitudeTarget(20, 1, 1, 0x80, LEVEL, 0.1, 0.2, 0.3, thrust)
    (frame,) = Parser().feed(encoder.encode(message))
    return frame


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
