import math
import re
import struct

import pytest
from fastcrc.crc16 import mcrf4xx
from hypothesis import given, settings
from hypothesis import strategies as st
from link_samples import (
    extensions,
    pymavlink_class,
    pymavlink_message,
    pymavlink_sender,
    records_of,
    same,
    values_of,
)
from pymavlink.dialects.v20 import all as dialect

from vfguide.link import layout
from vfguide.link.codec import EncodeError, Encoder, Parser, decode
from vfguide.link.dialect import WireField, wire_fields
from vfguide.link.layout import LAYOUTS
from vfguide.link.messages import (
    RECORDS,
    AttitudeQuaternion,
    AutopilotVersion,
    CommandAck,
    Heartbeat,
    MissionRequestList,
    ParamValue,
    SetAttitudeTarget,
    Statustext,
    SystemTime,
    VfrHud,
)

pytestmark = pytest.mark.slow

every_record = pytest.mark.parametrize("record", RECORDS, ids=lambda record: record.NAME)
bytes_1_to_255 = st.integers(1, 255)

HEARTBEAT = Heartbeat(18, 8, 0, 0, 4)
SETPOINT = SetAttitudeTarget(1000, 1, 1, 0x80, (1.0, 0.0, 0.0, 0.0), 0.1, -0.2, 0.3, 0.5)


def parsed(raw):
    parser = Parser()
    (frame,) = parser.feed(raw)
    assert parser.counters.junk_bytes == 0
    return frame


@every_record
def test_record_has_the_fields_of_the_message(record):
    message = pymavlink_class(record)
    assert message.msgname == record.NAME
    assert list(record._fields) == message.fieldnames


@every_record
def test_extensions_have_zeros_for_defaults(record):
    defaults = dict(record._field_defaults)
    if record is Heartbeat:
        assert defaults.pop("mavlink_version") == 3
    assert list(defaults) == extensions(record)
    for value in defaults.values():
        assert not any(value) if isinstance(value, tuple) else value == 0


@every_record
@settings(max_examples=20)
@given(st.data())
def test_bytes_are_those_of_pymavlink(record, data):
    message = data.draw(records_of(record))
    sysid, compid = data.draw(bytes_1_to_255), data.draw(bytes_1_to_255)
    encoder = Encoder(sysid, compid)
    encoder.seq = data.draw(st.integers(0, 255))
    sender = pymavlink_sender(sysid, compid, encoder.seq)
    assert encoder.encode(message) == pymavlink_message(message).pack(sender)


@every_record
@settings(max_examples=20)
@given(st.data())
def test_what_pymavlink_writes_is_read(record, data):
    message = data.draw(records_of(record))
    sysid, compid = data.draw(bytes_1_to_255), data.draw(bytes_1_to_255)
    raw = pymavlink_message(message).pack(pymavlink_sender(sysid, compid, seq=7))
    frame = parsed(raw)
    assert (frame.sysid, frame.compid, frame.seq) == (sysid, compid, 7)
    assert (frame.msgid, frame.raw, frame.version) == (record.MSGID, raw, 2)
    assert not frame.signed
    got = decode(frame)
    assert type(got) is record
    assert same(got, message)


@every_record
@settings(max_examples=20)
@given(st.data())
def test_pymavlink_reads_what_is_written(record, data):
    message = data.draw(records_of(record))
    (got,) = pymavlink_sender().parse_buffer(Encoder(3, 195).encode(message))
    assert got.get_type() == record.NAME
    assert (got.get_srcSystem(), got.get_srcComponent()) == (3, 195)
    assert same(values_of(got), list(message))


@every_record
@settings(max_examples=5)
@given(st.data())
def test_signed_frames_keep_their_signature(record, data):
    message = data.draw(records_of(record))
    sender = pymavlink_sender()
    sender.signing.secret_key = bytes(32)
    sender.signing.sign_outgoing = True
    raw = pymavlink_message(message).pack(sender)
    frame = parsed(raw)
    assert frame.signed
    assert frame.raw == raw
    assert same(decode(frame), message)


def base_length(record):
    """Bytes of the payload before the extensions, which stand at its end."""
    codes = re.findall(r"\d*[a-zA-Z]", pymavlink_class(record).unpacker.format)
    return struct.calcsize("<" + "".join(codes[: len(codes) - len(extensions(record))]))


def mavlink_1(record, payload):
    body = struct.pack("<5B", len(payload), 9, 1, 1, record.MSGID) + payload
    extra = bytes((pymavlink_class(record).crc_extra,))
    return b"\xfe" + body + struct.pack("<H", mcrf4xx(body + extra))


@pytest.mark.parametrize(
    "record", [r for r in RECORDS if r.MSGID < 256], ids=lambda record: record.NAME
)
@settings(max_examples=20)
@given(st.data())
def test_mavlink_1_is_read_and_extensions_are_zero(record, data):
    full = data.draw(records_of(record))
    message = full._replace(**{name: record._field_defaults[name] for name in extensions(record)})
    whole = pymavlink_message(message).pack(pymavlink_sender(seq=9), force_mavlink1=True)
    raw = mavlink_1(record, whole[6 : 6 + base_length(record)])
    assert raw == whole or extensions(record)
    frame = parsed(raw)
    assert (frame.version, frame.seq, frame.msgid, frame.raw) == (1, 9, record.MSGID, raw)
    assert same(decode(frame), message)


def test_zeros_at_the_end_are_cut_off_but_for_one_byte():
    assert parsed(Encoder(1, 1).encode(SystemTime(0, 0))).payload == b"\0"
    assert parsed(Encoder(1, 1).encode(SystemTime(5, 0))).payload == b"\x05"


def test_a_payload_longer_than_known_is_read_as_far_as_known():
    frame = parsed(Encoder(1, 1).encode(CommandAck(400, 0, 1, 2, 3, 4)))
    assert decode(frame._replace(payload=frame.payload + b"later")) == decode(frame)


def test_an_empty_payload_is_all_zeros():
    frame = parsed(Encoder(1, 1).encode(SystemTime(1, 2)))
    assert decode(frame._replace(payload=b"")) == SystemTime(0, 0)


def test_a_message_without_record_is_none():
    message = dialect.MAVLink_raw_imu_message(1, 2, 3, 4, 5, 6, 7, 8, 9, 10)
    assert decode(parsed(message.pack(pymavlink_sender()))) is None


def test_sequence_numbers_count_and_wrap():
    encoder = Encoder(1, 195)
    assert [parsed(encoder.encode(HEARTBEAT)).seq for _ in range(258)] == [*range(256), 0, 1]


def test_a_failed_message_takes_no_sequence_number():
    encoder = Encoder(1, 195)
    with pytest.raises(EncodeError):
        encoder.encode(HEARTBEAT._replace(type=-1))
    assert encoder.seq == 0


def test_text_goes_as_utf8_and_comes_back():
    message = Statustext(6, "Höhe 120 m, β ≤ 5°")
    assert decode(parsed(Encoder(1, 1).encode(message))) == message


def test_text_of_a_peer_ends_at_nul_and_need_not_be_utf8():
    frame = parsed(Encoder(1, 1).encode(Statustext(6, "a")))
    assert decode(frame._replace(payload=b"\x06ab\xff\0rest")) == Statustext(6, "ab\ufffd")


@pytest.mark.parametrize(
    ("message", "words"),
    [
        (HEARTBEAT._replace(type=256), ["HEARTBEAT.type", "256", "0 to 255"]),
        (HEARTBEAT._replace(custom_mode=-1), ["HEARTBEAT.custom_mode", "-1", "0 to 4294967295"]),
        (HEARTBEAT._replace(custom_mode=math.nan), ["HEARTBEAT.custom_mode", "nan", "integer"]),
        (HEARTBEAT._replace(type=1.5), ["HEARTBEAT.type", "1.5", "integer"]),
        (HEARTBEAT._replace(type=None), ["HEARTBEAT.type", "None", "integer"]),
        (VfrHud(1e39, 0.0, 0, 0, 0.0, 0.0), ["VFR_HUD.airspeed", "1e+39", "3.4e38"]),
        (VfrHud(0.0, 0.0, 40000, 0, 0.0, 0.0), ["VFR_HUD.heading", "-32768 to 32767"]),
        (SETPOINT._replace(thrust="full"), ["SET_ATTITUDE_TARGET.thrust", "'full'", "number"]),
        (SETPOINT._replace(q=(1.0, 0.0, 0.0)), ["SET_ATTITUDE_TARGET.q", "4 values"]),
        (SETPOINT._replace(q=(1.0,) * 5), ["SET_ATTITUDE_TARGET.q", "4 values"]),
        (SETPOINT._replace(q=1.0), ["SET_ATTITUDE_TARGET.q", "4 values"]),
        (
            AutopilotVersion(0, 0, 0, 0, 0, (0,) * 7, (0,) * 9, (0,) * 8, 0, 0, 0),
            ["AUTOPILOT_VERSION.flight_custom_version", "8 values"],
        ),
        (Statustext(6, "ä" * 26), ["STATUSTEXT.text", "50 bytes"]),
        (Statustext(6, "a\0b"), ["STATUSTEXT.text", "NUL"]),
        (Statustext(6, b"bytes"), ["STATUSTEXT.text", "text"]),
        (Statustext(6, "\ud800"), ["STATUSTEXT.text", "UTF-8"]),
        (ParamValue("P" * 17, 0.0, 9, 1, 0), ["PARAM_VALUE.param_id", "16 bytes"]),
        ((1, 2, 3), ["(1, 2, 3)", "records"]),
    ],
)
def test_what_the_wire_cannot_carry_is_refused_by_name(message, words):
    with pytest.raises(EncodeError) as caught:
        Encoder(1, 1).encode(message)
    for word in words:
        assert word in str(caught.value)


@pytest.mark.parametrize(("sysid", "compid"), [(0, 1), (256, 1), (1, 0), (1, 256), (-1, 1)])
def test_nobody_has_such_an_identity(sysid, compid):
    with pytest.raises(EncodeError, match="1 to 255"):
        Encoder(sysid, compid)


def test_infinity_and_nan_are_numbers():
    got = decode(
        parsed(Encoder(1, 1).encode(AttitudeQuaternion(1, *[math.nan] * 4, *[math.inf] * 3)))
    )
    assert math.isnan(got.q1)
    assert got.rollspeed == math.inf


def test_arrays_may_be_lists():
    assert Encoder(1, 1).encode(SETPOINT._replace(q=[1.0, 0.0, 0.0, 0.0])) == Encoder(1, 1).encode(
        SETPOINT
    )


def test_a_newer_dialect_may_have_more_extensions(monkeypatch):
    newer = [*wire_fields(SetAttitudeTarget.MSGID), WireField("thrust_body", "3f")]
    monkeypatch.setattr(layout, "wire_fields", lambda msgid: newer)
    there = LAYOUTS[SetAttitudeTarget].body(7, 1, 1, SETPOINT)
    assert layout.Layout(SetAttitudeTarget).body(7, 1, 1, SETPOINT) == there


def test_records_with_equal_values_are_told_apart_by_class():
    assert type(decode(parsed(Encoder(1, 1).encode(MissionRequestList(1, 1, 1))))) is (
        MissionRequestList
    )
