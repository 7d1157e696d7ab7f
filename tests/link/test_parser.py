import itertools
import struct
from random import Random

import pytest
from fastcrc.crc16 import mcrf4xx
from hypothesis import given
from hypothesis import strategies as st
from link_samples import any_record, magic_rich, pymavlink_message, pymavlink_sender, unknown_frame
from pymavlink.dialects.v20 import all as dialect

from vfguide.link.codec import Encoder, Parser
from vfguide.link.messages import Attitude, Heartbeat, SetAttitudeTarget

ATTITUDE = Encoder(1, 1).encode(Attitude(1, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6))
HEARTBEAT = Encoder(7, 195).encode(Heartbeat(18, 8, 0, 0, 4))
SETPOINT = Encoder(1, 195).encode(
    SetAttitudeTarget(1000, 1, 1, 0x80, (1.0, 0.0, 0.0, 0.0), 0.1, -0.2, 0.3, 0.5)
)
FLUSH = bytes(300)
"""Longer than any frame: whatever a false start waits for."""


@st.composite
def true_frames(draw):
    """A frame of any record: MAVLink 1 or 2, signed or not."""
    message = pymavlink_message(draw(any_record))
    sender = pymavlink_sender(draw(st.integers(1, 255)), draw(st.integers(1, 255)))
    sender.seq = draw(st.integers(0, 255))
    if draw(st.booleans()):
        sender.signing.secret_key = bytes(32)
        sender.signing.sign_outgoing = True
    elif message.id < 256 and draw(st.booleans()):
        return message.pack(sender, force_mavlink1=True)
    return message.pack(sender)


junk = magic_rich | st.binary(max_size=60) | st.binary(max_size=40).map(unknown_frame)
streams = st.lists(junk | true_frames(), max_size=8).map(b"".join)


def cut(data, places):
    ends = sorted({place % (len(data) + 1) for place in places} | {0, len(data)})
    return [data[a:b] for a, b in itertools.pairwise(ends)]


def result(pieces):
    parser = Parser()
    frames = [frame for piece in pieces for frame in parser.feed(piece)]
    return frames, parser.counters


@given(st.lists(st.tuples(junk, true_frames()), max_size=5), st.lists(st.integers(0, 2000)))
def test_no_junk_and_no_cut_costs_a_frame(pairs, places):
    stream = b"".join(noise + frame for noise, frame in pairs) + FLUSH
    frames, _ = result(cut(stream, places))
    assert [frame.raw for frame in frames] == [frame for _, frame in pairs]


@given(streams, st.lists(st.integers(0, 2000)))
def test_the_cuts_change_neither_frames_nor_counts(stream, places):
    whole = result([stream])
    assert result(cut(stream, places)) == whole
    assert result([stream[i : i + 1] for i in range(len(stream))]) == whole


def true_by_pymavlink(raw):
    """The judgement of pymavlink on one whole frame."""
    receiver = dialect.MAVLink(None)
    (message,) = receiver.parse_buffer(raw)
    return message.get_msgId() == (
        raw[5] if raw[0] == 0xFE else int.from_bytes(raw[7:10], "little")
    )


@given(magic_rich | st.binary(max_size=2000) | streams)
def test_whatever_comes_nothing_raises_and_no_frame_is_invented(data):
    frames, _ = result([data])
    at = 0
    for frame in frames:
        assert true_by_pymavlink(frame.raw)
        at = data.index(frame.raw, at) + len(frame.raw)


def test_a_megabyte_of_noise():
    data = Random(1).randbytes(1_000_000)
    frames, counters = result(cut(data, range(0, len(data), 1400)))
    assert all(true_by_pymavlink(frame.raw) for frame in frames)
    assert counters.junk_bytes > 500_000
    assert len(frames) < 10


@pytest.mark.parametrize("data", [bytearray(ATTITUDE), memoryview(ATTITUDE)])
def test_any_kind_of_bytes_will_do(data):
    (frame,) = Parser().feed(data)
    assert frame.raw == ATTITUDE
    assert type(frame.raw) is bytes


def test_junk_is_counted():
    _, counters = result([b"abc", ATTITUDE, b"de", HEARTBEAT, b"f"])
    assert (counters.frames, counters.junk_bytes) == (2, 6)
    assert (counters.bad_crc, counters.unknown) == (0, 0)


@pytest.mark.parametrize("place", range(len(SETPOINT)))
def test_one_wrong_byte_costs_one_frame(place):
    for error in range(1, 256):
        damaged = bytearray(SETPOINT)
        damaged[place] ^= error
        frames, counters = result([damaged, ATTITUDE, HEARTBEAT, FLUSH])
        assert [frame.raw for frame in frames] == [ATTITUDE, HEARTBEAT]
        assert counters.junk_bytes + counters.unknown > 0


def test_a_wrong_checksum_is_counted_once():
    damaged = SETPOINT[:-1] + bytes((SETPOINT[-1] ^ 1,))
    _, counters = result([damaged, ATTITUDE])
    assert (counters.bad_crc, counters.frames, counters.junk_bytes) == (1, 1, len(damaged))


@pytest.mark.parametrize("length", range(len(SETPOINT)))
def test_a_frame_cut_short_costs_no_other(length):
    frames, _ = result([SETPOINT[:length], ATTITUDE, HEARTBEAT, FLUSH])
    assert [frame.raw for frame in frames] == [ATTITUDE, HEARTBEAT]


@pytest.mark.parametrize("length", range(len(SETPOINT)))
def test_nothing_comes_before_the_last_byte(length):
    parser = Parser()
    assert parser.feed(SETPOINT[:length]) == []
    (frame,) = parser.feed(SETPOINT[length:])
    assert frame.raw == SETPOINT


@pytest.mark.parametrize("payload", [b"", b"plain", b"\xfd" * 9, bytes(range(256))[:255]])
def test_unknown_messages_are_counted_and_passed_over(payload):
    frames, counters = result([ATTITUDE, unknown_frame(payload), HEARTBEAT, FLUSH])
    assert [frame.raw for frame in frames] == [ATTITUDE, HEARTBEAT]
    assert (counters.unknown, counters.bad_crc) == (1, 0)
    assert counters.junk_bytes == len(FLUSH)


def test_frames_swallowed_by_a_false_unknown_frame_come_out():
    frames, _ = result(
        [unknown_frame(b"")[:-2].replace(b"\xfd\0", b"\xfd\xff", 1), ATTITUDE * 3, FLUSH]
    )
    assert [frame.raw for frame in frames] == [ATTITUDE] * 3


def test_frames_with_flags_that_nobody_knows_are_none():
    body = bytearray(ATTITUDE[1:-2])
    body[1] = 0x02
    raw = b"\xfd" + body + struct.pack("<H", mcrf4xx(bytes(body) + bytes((39,))))
    frames, counters = result([raw, HEARTBEAT])
    assert [frame.raw for frame in frames] == [HEARTBEAT]
    assert counters.junk_bytes == len(raw)


def test_the_third_byte_of_the_message_id_counts():
    body = bytearray(ATTITUDE[1:-2])
    body[8] = 1
    raw = b"\xfd" + body + struct.pack("<H", mcrf4xx(bytes(body) + bytes((39,))))
    frames, counters = result([raw, HEARTBEAT])
    assert [frame.raw for frame in frames] == [HEARTBEAT]
    assert counters.unknown == 1


def test_junk_behind_a_true_frame_is_junk_whatever_claimed_it():
    false = struct.pack("<10B", 0xFD, 255, 0, 0, 0, 1, 1, 0xF0, 0xFF, 0xFF)
    _, counters = result([false, ATTITUDE, bytes(300)])
    assert (counters.frames, counters.junk_bytes) == (1, 300)


def heartbeats(numbers, compid=1):
    encoder = Encoder(1, compid)
    for number in numbers:
        encoder.seq = number
        yield encoder.encode(Heartbeat(1, 12, 0, 0, 4))


@pytest.mark.parametrize(
    ("numbers", "lost"),
    [
        ([5], {}),
        ([254, 255, 0, 1], {}),
        ([5, 7, 8, 12], {(1, 1): 4}),
        ([250, 2], {(1, 1): 7}),
        ([5, 5, 6], {}),  # came twice
        ([5, 7, 6, 8], {(1, 1): 1}),  # came late
    ],
)
def test_missing_frames_show_by_their_numbers(numbers, lost):
    assert result(heartbeats(numbers))[1].lost == lost


def test_every_sender_has_its_own_numbers():
    mixed = zip(heartbeats([1, 2, 3]), heartbeats([100, 101, 103], compid=195), strict=True)
    assert result(itertools.chain(*mixed))[1].lost == {(1, 195): 1}


def test_frames_of_every_message_of_the_dialect_are_known():
    sender = pymavlink_sender()
    for message in dialect.mavlink_map.values():
        payload = bytes(range(1, message.unpacker.size + 1))
        raw = message._pack(
            dialect.MAVLink_message(message.id, ""), sender, message.crc_extra, payload
        )
        (frame,) = Parser().feed(raw)
        assert (frame.msgid, frame.payload, frame.raw) == (message.id, payload, raw)
