import errno
import math
import os
import resource
import struct
from collections import Counter
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from link_samples import any_record, unknown_frame
from pymavlink import mavutil
from pymavlink.dialects.v20 import all as dialect

from vfguide.link.codec import Encoder
from vfguide.link.messages import Attitude, Heartbeat
from vfguide.link.tlog import LAST_TIME, TlogError, TlogReader, UsableTimes
from vfguide.link.tlog_writer import TlogWriter

RECORDED = sorted((Path(__file__).parents[3] / "shared" / "logs").glob("*.tlog"))

START_US = 1_767_225_600_000_000
"""2026-01-01."""


def attitudes(count):
    encoder = Encoder(1, 1)
    return [
        (START_US + 20_000 * i, encoder.encode(Attitude(20 * i, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6)))
        for i in range(count)
    ]


def as_bytes(records):
    return b"".join(struct.pack(">Q", time_us) + raw for time_us, raw in records)


def read(data):
    return [(time_us, frame.raw) for time_us, frame in TlogReader(data)]


@given(st.lists(st.tuples(st.integers(0, 2**64 - 1), any_record)), st.integers(1, 300))
def test_what_is_written_is_read(tmp_path_factory, pairs, buffer_bytes):
    path = tmp_path_factory.mktemp("log") / "flight.tlog"
    encoder = Encoder(1, 195)
    records = [(time_us, encoder.encode(message)) for time_us, message in pairs]
    write_all(path, records, buffer_bytes)
    assert path.read_bytes() == as_bytes(records)
    reader = TlogReader.open(path)
    assert [(time_us, frame.raw) for time_us, frame in reader] == records
    assert (reader.frames, reader.unknown, reader.junk_bytes) == (len(records), 0, 0)


@given(
    st.lists(st.tuples(st.integers(0, 2**64 - 1), st.lists(any_record, min_size=1, max_size=5))),
    st.integers(1, 300),
)
def test_frames_of_one_time_are_written_as_one_after_the_other(
    tmp_path_factory, batches, buffer_bytes
):
    path, encoder = tmp_path_factory.mktemp("log") / "flight.tlog", Encoder(1, 195)
    timed = [(time, [encoder.encode(each) for each in messages]) for time, messages in batches]
    with TlogWriter(path, buffer_bytes) as log:
        for time_us, frames in timed:
            log.write_all(time_us, frames)
    assert path.read_bytes() == as_bytes((time, raw) for time, frames in timed for raw in frames)


def test_pymavlink_reads_what_is_written(tmp_path):
    path = tmp_path / "flight.tlog"
    records = attitudes(100)
    with TlogWriter(path) as log:
        for record in records:
            log.write(*record)
    assert [round(1e6 * time) for time, _, _ in pymavlink_log(path)] == [t for t, _ in records]


def pymavlink_log(path):
    log = mavutil.mavlogfile(str(path))
    messages = []
    while (message := log.recv_msg()) is not None:
        messages.append((message._timestamp, message.get_type(), message.get_seq()))
    log.close()
    return messages


def test_a_log_can_be_read_twice():
    reader = TlogReader(as_bytes(attitudes(3)))
    assert list(reader) == list(reader)
    assert reader.frames == 3


def test_a_log_cut_off_anywhere_gives_its_whole_records():
    records = attitudes(3)
    data, size = as_bytes(records), len(as_bytes(records[:1]))
    for length in range(len(data) + 1):
        reader = TlogReader(data[:length])
        assert [(t, f.raw) for t, f in reader] == records[: length // size]
        assert reader.junk_bytes == length % size


@pytest.mark.parametrize("noise", [b"x", b"\xfd", b"\xfe\xfd\xfd\x01", bytes(30), b"\xfd" * 400])
def test_junk_anywhere_costs_at_most_the_record_that_it_hits(noise):
    records = attitudes(4)
    data, size = as_bytes(records), len(as_bytes(records[:1]))
    for place in range(len(data) + 1):
        got = read(data[:place] + noise + data[place:])
        raws = [raw for _, raw in got]
        spared = [raw for i, (_, raw) in enumerate(records) if i != place // size]
        assert [raw for raw in raws if raw in spared] == spared
        if place % size <= 8:  # in a time or between two records: no frame is hit
            assert raws == [raw for _, raw in records]
        assert all(abs(time_us - START_US) < 1_000_000 for time_us, _ in got[1:])


@pytest.mark.parametrize("missing", range(1, 60))
def test_bytes_missing_anywhere_cost_no_record_behind(missing):
    records = attitudes(6)
    data, size = as_bytes(records), len(as_bytes(records[:1]))
    for place in range(size, 2 * size):
        behind = records[math.ceil((place + missing) / size) :]
        got = read(data[:place] + data[place + missing :])
        assert got[0] == records[0]
        assert got[-len(behind) :] == behind


def test_a_second_frame_without_time_has_that_of_the_first():
    (first, second, third) = attitudes(3)
    data = as_bytes([first]) + second[1] + as_bytes([third])
    assert read(data) == [first, (first[0], second[1]), third]


def test_unknown_messages_are_counted_and_left_out():
    first, second = attitudes(2)
    strange = (START_US, unknown_frame(first[1] + b"\xfd\xfd"))
    reader = TlogReader(as_bytes([strange, first, strange, strange, second, strange]))
    assert [(t, f.raw) for t, f in reader] == [first, second]
    assert (reader.unknown, reader.junk_bytes) == (4, 0)


@given(st.binary(max_size=500))
def test_noise_does_not_raise(data):
    reader = TlogReader(data)
    assert sum(len(frame.raw) for _, frame in reader) + reader.junk_bytes <= len(data)


@pytest.mark.skipif(not RECORDED, reason="the recorded logs are not beside the project")
@pytest.mark.parametrize("path", RECORDED, ids=lambda path: path.name)
def test_recorded_logs_are_read_as_pymavlink_reads_them(path):
    expected = [record for record in pymavlink_log(path) if record[1] != "BAD_DATA"]
    got = [
        (time_us * 1e-6, dialect.mavlink_map[frame.msgid].msgname, frame.seq)
        for time_us, frame in TlogReader.open(path)
    ]
    assert Counter(name for _, name, _ in got) == Counter(name for _, name, _ in expected)
    assert got == expected


def test_nothing_reaches_the_file_in_parts(tmp_path):
    path = tmp_path / "flight.tlog"
    records = attitudes(50)
    size = len(as_bytes(records[:1]))
    with TlogWriter(path, buffer_bytes=200) as log:
        for record in records:
            log.write(*record)
            assert path.stat().st_size % size == 0
        log.flush()
        assert path.read_bytes() == as_bytes(records)


def write_all(path, records, buffer_bytes):
    with TlogWriter(path, buffer_bytes) as log:
        for record in records:
            log.write(*record)


def write_batches(path, time_us, batches, buffer_bytes):
    with TlogWriter(path, buffer_bytes) as log:
        for frames in batches:
            log.write_all(time_us, frames)


def interrupted_once(monkeypatch):
    """The next write to a file stops half way with Ctrl-C."""
    whole = os.pwrite

    def pwrite(fd, data, place):
        monkeypatch.setattr(os, "pwrite", whole)
        whole(fd, data[: len(data) // 2 + 3], place)
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "pwrite", pwrite)


def test_ctrl_c_in_the_middle_of_a_write_loses_nothing(tmp_path, monkeypatch):
    path = tmp_path / "flight.tlog"
    records = attitudes(9)
    with TlogWriter(path) as log:
        for record in records:
            log.write(*record)
        interrupted_once(monkeypatch)
        with pytest.raises(KeyboardInterrupt):
            log.flush()
    assert path.read_bytes() == as_bytes(records)


@pytest.fixture(params=[960, 1000])  # 20 records, and a part of one more
def disk_bytes(request):
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (request.param, hard))
    yield request.param
    resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


@pytest.mark.parametrize("buffer_bytes", [1, 100, 1 << 16])
def test_a_full_disk_keeps_whole_records_and_says_so(tmp_path, disk_bytes, buffer_bytes):
    path = tmp_path / "flight.tlog"
    records = attitudes(50)
    size = len(as_bytes(records[:1]))
    with pytest.raises(TlogError, match=r"flight\.tlog: File too large"):
        write_all(path, records, buffer_bytes)
    assert path.read_bytes() == as_bytes(records[: disk_bytes // size])


@pytest.mark.parametrize("buffer_bytes", [1, 100, 1 << 16])
@pytest.mark.parametrize("together", [2, 3, 50])
def test_a_full_disk_keeps_whole_records_of_those_written_together(
    tmp_path, disk_bytes, buffer_bytes, together
):
    path, records = tmp_path / "flight.tlog", attitudes(50)
    size, time_us = len(as_bytes(records[:1])), records[0][0]
    raws = [raw for _, raw in records]
    batches = [raws[begin : begin + together] for begin in range(0, 50, together)]
    with pytest.raises(TlogError):
        write_batches(path, time_us, batches, buffer_bytes)
    kept = [(time_us, raw) for raw in raws[: disk_bytes // size]]
    assert path.read_bytes() == as_bytes(kept)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="the system has no /dev/full")
def test_no_space_is_named():
    with (
        pytest.raises(TlogError, match="/dev/full: No space left"),
        TlogWriter(Path("/dev/full")) as log,
    ):
        log.write(*attitudes(1)[0])


def test_a_log_goes_on_after_the_disk_had_no_space(tmp_path, monkeypatch):
    path = tmp_path / "flight.tlog"
    first, lost, last = attitudes(3)
    whole = os.pwrite

    def full(fd, data, place):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with TlogWriter(path, buffer_bytes=1) as log:
        log.write(*first)
        monkeypatch.setattr(os, "pwrite", full)
        with pytest.raises(TlogError):
            log.write(*lost)
        monkeypatch.setattr(os, "pwrite", whole)
        log.write(*last)
    assert read(path.read_bytes()) == [first, last]


def test_a_place_that_cannot_be_written_is_named(tmp_path):
    with pytest.raises(TlogError, match=r"absent/flight\.tlog: No such file"):
        TlogWriter(tmp_path / "absent" / "flight.tlog")


def test_a_file_that_cannot_be_read_is_named(tmp_path):
    with pytest.raises(TlogError, match=r"absent\.tlog: No such file"):
        TlogReader.open(tmp_path / "absent.tlog")


@pytest.mark.parametrize("time_us", [-1, 2**64, 1.5])
def test_a_time_that_is_none_is_refused(tmp_path, time_us):
    path = tmp_path / "flight.tlog"
    with TlogWriter(path) as log, pytest.raises(ValueError, match="microseconds"):
        log.write(time_us, Encoder(1, 1).encode(Heartbeat(1, 12, 0, 0, 4)))
    assert path.read_bytes() == b""


def test_closing_twice_does_no_harm(tmp_path):
    log = TlogWriter(tmp_path / "flight.tlog")
    log.close()
    log.close()


def test_a_time_that_cannot_be_is_that_of_the_frame_before():
    raw = Encoder(1, 1).encode(Heartbeat(1, 12, 0, 0, 4))
    times = (5, LAST_TIME + 1, 2**64 - 1, 7, LAST_TIME)
    reader = TlogReader(as_bytes([(time_us, raw) for time_us in times]))
    usable = UsableTimes(reader)
    assert [time_us for time_us, _ in usable] == [5, 5, 5, 7, LAST_TIME]
    assert usable.wrong == 2


def test_damage_is_known_by_place_and_size():
    raw = Encoder(1, 1).encode(Heartbeat(1, 12, 0, 0, 4))
    whole = as_bytes([(1, raw)])
    reader = TlogReader(whole + bytes(30) + whole + whole[:9])
    assert len(list(reader)) == 2
    assert [(each.at, each.bytes) for each in reader.damage] == [
        (len(whole), 30),
        (2 * len(whole) + 30, 9),
    ]
