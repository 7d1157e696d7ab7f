"""The companion behind bytes: whom it hears, what it records, what junk does to it."""

from random import Random

import pytest
from conversations import SECOND, START, heartbeat, plan, setpoints, state

from vfguide.autopilots.engagement import Phase
from vfguide.autopilots.px4 import Px4Mode
from vfguide.companion.companion import Companion
from vfguide.companion.session import Session
from vfguide.link.codec import Encoder, Parser, decode
from vfguide.link.enums import AttitudeTypeMask, MavComponent, MavType
from vfguide.link.messages import CommandLong, Heartbeat, SetAttitudeTarget, Timesync

TICK = 20_000
ANSWER = Timesync(1, 1000 * START)
"""To the first question, which is asked when the first heartbeat is heard."""


class Recorded:
    """A session, and what it recorded."""

    def __init__(self, sysid=1, engage=False):
        self.record = []
        self.session = Session(Companion(sysid, plan(), engage=engage), self.keep)

    def keep(self, now, frames):
        self.record += [(now, raw) for raw in frames]


def frames_of(encoder, seconds=1.0):
    """(time, bytes) of a second of an autopilot's messages, first heartbeat and first answer."""
    frames = [(START, encoder.encode(first)) for first in (heartbeat(), ANSWER)]
    for tick in range(round(seconds * SECOND / TICK)):
        frames += [
            (START + tick * TICK, encoder.encode(message)) for message in state(5000 + 20 * tick)
        ]
    return frames


def flown(session, frames):
    return [answer for now, data in frames for answer in session.receive(now, data)]


def decoded(raw_frames):
    return [decode(frame) for raw in raw_frames for frame in Parser().feed(raw)]


def test_it_speaks_as_component_195_of_the_vehicles_system_and_numbers_its_frames():
    out = flown(Recorded(sysid=9).session, frames_of(Encoder(9, 1)))
    frames = [frame for raw in out for frame in Parser().feed(raw)]
    assert {(frame.sysid, frame.compid) for frame in frames} == {(9, 195)}
    assert [frame.seq for frame in frames] == [k % 256 for k in range(len(frames))]


def test_its_heartbeat_is_that_of_an_onboard_controller_once_a_second():
    session = Recorded().session
    beats = [
        (now, message)
        for now in range(START, START + 10 * SECOND, TICK)
        for message in decoded(session.poll(now))
        if isinstance(message, Heartbeat)
    ]
    assert [now for now, _ in beats] == [START + k * SECOND for k in range(10)]
    assert all(beat.type == MavType.ONBOARD_CONTROLLER for _, beat in beats)


def test_setpoints_are_body_rates_and_thrust_for_the_autopilot_at_its_own_time():
    out = decoded(flown(Recorded(sysid=9).session, frames_of(Encoder(9, 1))))
    sent = setpoints(out)
    assert [each.time_boot_ms for each in sent] == [5000 + 20 * k for k in range(50)]
    for each in sent:
        assert (each.target_system, each.target_component) == (9, 1)
        assert each.type_mask == AttitudeTypeMask.ATTITUDE_IGNORE == 0x80
        assert 0.0 <= each.thrust <= 1.0


def test_the_rate_is_that_of_the_plan_however_fast_attitudes_come():
    session, encoder = Recorded().session, Encoder(1, 1)
    session.receive(START, encoder.encode(heartbeat()) + encoder.encode(ANSWER))
    sent = 0
    for ms in range(0, 2000, 5):
        for message in state(5000 + ms):
            answers = session.receive(START + 1000 * ms, encoder.encode(message))
            sent += len(setpoints(decoded(answers)))
    assert sent == pytest.approx(2.0 * plan().rate, abs=1)


@pytest.mark.parametrize(
    ("sysid", "compid"),
    [(2, 1), (255, 190), (1, 195), (1, 100), (1, MavComponent.PATHPLANNER), (7, 7)],
)
def test_nobody_but_the_vehicles_autopilot_is_heard_or_recorded(sysid, compid):
    heard = Recorded()
    assert not flown(heard.session, frames_of(Encoder(sysid, compid)))
    assert heard.session.companion.phase is Phase.SEARCHING
    assert not heard.record


def test_somebody_else_in_between_changes_nothing():
    other, ours = Encoder(2, 1), frames_of(Encoder(1, 1))
    mixed = []
    for now, data in ours:
        mixed += [(now, data), (now, other.encode(heartbeat(Px4Mode.OFFBOARD)))]
    assert flown(Recorded().session, mixed) == flown(Recorded().session, ours)


@pytest.mark.parametrize("seed", range(5))
def test_junk_and_cuts_anywhere_cost_nothing_that_is_whole(seed):
    """Bytes of no frame between the frames, and the stream cut at random places."""
    rng, ours = Random(seed), frames_of(Encoder(1, 1), 0.4)
    clean, dirty = Recorded(), Recorded()
    stream = b"".join(
        data + bytes(rng.randrange(0xFD) for _ in range(rng.randrange(20))) for _, data in ours
    )
    flown(clean.session, [(START, data) for _, data in ours])
    while stream:
        cut = rng.randrange(1, 60)
        dirty.session.receive(START, stream[:cut])
        stream = stream[cut:]
    assert [raw for _, raw in dirty.record] == [raw for _, raw in clean.record]


@pytest.mark.parametrize("seed", range(5))
def test_bytes_at_random_are_harmless(seed):
    rng = Random(seed)
    heard = Recorded()
    for _ in range(200):
        assert not heard.session.receive(START, rng.randbytes(rng.randrange(300)))
    assert not heard.record


def test_a_frame_that_was_changed_on_the_way_is_not_heard():
    heard = Recorded()
    raw = bytearray(Encoder(1, 1).encode(heartbeat()))
    raw[12] ^= 0x10
    assert not heard.session.receive(START, bytes(raw))
    assert heard.session.companion.phase is Phase.SEARCHING


def test_the_record_holds_what_came_and_what_went_in_the_order_of_decoding():
    heard, ours = Recorded(engage=True), frames_of(Encoder(1, 1))
    answers = []
    for now, data in ours:
        before = len(heard.record)
        out = heard.session.receive(now, data)
        assert [raw for _, raw in heard.record[before:]] == [data, *out]
        assert {time for time, _ in heard.record[before:]} == {now}
        answers += out
    assert any(isinstance(message, SetAttitudeTarget) for message in decoded(answers))
    assert any(isinstance(message, CommandLong) for message in decoded(answers))


def test_what_is_due_without_anything_received_is_recorded_too():
    heard = Recorded()
    out = heard.session.poll(START)
    assert out
    assert heard.record == [(START, raw) for raw in out]


def test_the_record_of_a_fault_has_the_frames_up_to_the_one_that_brought_it_about(monkeypatch):
    ours, heard, unbroken = frames_of(Encoder(1, 1), 0.1), Recorded(), Recorded()
    flown(heard.session, ours[:5])
    flown(unbroken.session, ours[:5])
    before, companion = len(heard.record), heard.session.companion
    _, harmless = ours[5]
    unbroken.session.receive(START, harmless)
    receive, left = companion.receive, [1]

    def break_down(now, message):
        if not left:
            raise ZeroDivisionError
        left.pop()
        return receive(now, message)

    monkeypatch.setattr(companion, "receive", break_down)
    with pytest.raises(ZeroDivisionError):
        heard.session.receive(START, b"".join(data for _, data in ours[5:8]))
    _, broke_it = ours[6]
    assert heard.record[before:] == [*unbroken.record[before:], (START, broke_it)]


def test_two_frames_in_one_datagram_are_answered_one_after_the_other():
    ours = frames_of(Encoder(1, 1), 0.1)
    apart, together = Recorded(), Recorded()
    answers = flown(apart.session, [(START, data) for _, data in ours])
    assert together.session.receive(START, b"".join(data for _, data in ours)) == answers
    assert together.record == apart.record
