"""What goes into a link comes out, late and in order."""

import pytest

from vfguide.link.delay_line import DelayLine


@pytest.mark.parametrize("delay", [0, 1, 20_000, 2_000_000])
def test_nothing_arrives_early_or_twice(delay):
    line = DelayLine(delay)
    line.send(1000, [b"a", b"b"])
    line.send(1001, [b"c"])
    assert line.arrived(1000 + delay - 1) == b""
    assert line.arrived(1000 + delay) == b"ab"
    assert line.arrived(1000 + delay) == b""
    assert line.arrived(5_000_000) == b"c"


def test_what_arrives_together_keeps_its_order():
    line = DelayLine(7)
    for now, frame in enumerate((b"a", b"b", b"c")):
        line.send(now, [frame])
    assert line.arrived(100) == b"abc"
