"""Frames in datagrams: each is whole, and none of the next one's business."""

from hypothesis import given
from hypothesis import strategies as st
from link_samples import magic_rich

from vfguide.link.codec import Encoder, Parser
from vfguide.link.messages import Heartbeat

FRAME = Encoder(7, 195).encode(Heartbeat(18, 8, 0, 0, 4))
cut_frame = st.integers(0, len(FRAME) - 1).map(lambda size: FRAME[:size])
junk = magic_rich | cut_frame


@given(st.lists(st.tuples(junk, junk), max_size=6))
def test_every_frame_comes_with_its_own_datagram(pairs):
    parser = Parser()
    for before, behind in pairs:
        frames = parser.feed(before + FRAME + behind, whole=True)
        assert [frame.raw for frame in frames] == [FRAME]


@given(st.lists(junk, max_size=6))
def test_every_byte_of_no_frame_is_counted(datagrams):
    parser = Parser()
    for data in datagrams:
        parser.feed(data, whole=True)
    counters = parser.counters
    assert counters.frames == 0
    assert counters.junk_bytes <= sum(map(len, datagrams))
    if not counters.unknown:
        assert counters.junk_bytes == sum(map(len, datagrams))


def test_a_frame_over_two_datagrams_is_none():
    parser = Parser()
    assert parser.feed(FRAME[:10], whole=True) == []
    assert parser.feed(FRAME[10:], whole=True) == []
    assert parser.counters.junk_bytes == len(FRAME)
