"""The loop of the daemon, with a clock and a link that the test holds."""

import socket

import pytest
from plans import FIRST_FLIGHT

from vfguide.annunciations.goal_notes import passage_note
from vfguide.autopilots.px4 import Px4Mode
from vfguide.companion.companion import Companion
from vfguide.companion.session import Session
from vfguide.daemon.clock import Clock
from vfguide.daemon.daemon import HOLD_TIMEOUT, Daemon, HandoverResult
from vfguide.daemon.flight_log import FLUSH_INTERVAL, FlightLog
from vfguide.daemon.warm_up import warm_up
from vfguide.estimation.local_frame import distance_from
from vfguide.link.codec import Encoder, Parser, decode
from vfguide.link.enums import MavAutopilot, MavCmd, MavState, MavType
from vfguide.link.messages import CommandLong, Heartbeat
from vfguide.link.tlog import TlogError, TlogReader
from vfguide.link.tlog_writer import TlogWriter

START = 1_767_225_600_000_000
ENCODER = Encoder(1, 1)


def heartbeat(mode):
    beat = Heartbeat(MavType.FIXED_WING, MavAutopilot.PX4, 0, mode, MavState.ACTIVE)
    return Parser().feed(ENCODER.encode(beat))


@pytest.fixture(scope="module")
def plan():
    return FIRST_FLIGHT


class HeldClock(Clock):
    """A clock that goes on a tenth of a second whenever it is read."""

    def __init__(self):
        self.time = START

    def now(self):
        self.time += 100_000
        return self.time


class HeldLink:
    """A link on which frames arrive as the script says, one list a call."""

    def __init__(self, script):
        self._own, self._other = socket.socketpair()
        self._other.send(b"always ready")
        self.script = iter(script)
        self.warnings = []
        self.sent = []

    def fileno(self):
        return self._own.fileno()

    def receive(self, now):
        return next(self.script, [])

    def send(self, raw):
        self.sent += [decode(frame) for frame in Parser().feed(raw)]

    def close(self):
        self._own.close()
        self._other.close()


@pytest.fixture
def fly(plan, tmp_path):
    links = []

    def run(script, stops):
        """The outcome, what was sent, what was said; `stops` is asked once a turn."""
        link, said, wishes = HeldLink(script), [], iter(stops)
        links.append(link)
        log = FlightLog(TlogWriter(tmp_path / "vehicle-1.tlog"))
        session = Session(Companion(1, plan, engage=True), log.write)
        daemon = Daemon(session, link, log, HeldClock(), said.append, said.append)
        outcome = daemon.run(lambda: next(wishes, 1))
        log.close()
        return outcome, link.sent, said

    yield run
    for link in links:
        link.close()


FLIES = [heartbeat(Px4Mode.HOLD), heartbeat(Px4Mode.OFFBOARD)]


def test_a_companion_that_never_flew_ends_at_once(fly):
    outcome, _, said = fly([heartbeat(Px4Mode.HOLD)], [0, 0, 1])
    assert outcome is HandoverResult.HANDED_OVER
    assert said[0].startswith("the autopilot is found, it flies HOLD")


def test_it_waits_until_the_autopilot_confirms(fly):
    script = [*FLIES, [], [], heartbeat(Px4Mode.OFFBOARD), [], heartbeat(Px4Mode.HOLD)]
    outcome, sent, said = fly(script, [0, 0, 0, 1])
    assert outcome is HandoverResult.HANDED_OVER
    asked = [m for m in sent if isinstance(m, CommandLong) and m.command == MavCmd.DO_SET_MODE]
    assert {(m.param2, m.param3) for m in asked} == {(4.0, 3.0)}
    assert said[-1] == "ended: the autopilot flies HOLD"


def test_its_patience_has_an_end(fly):
    script = [*FLIES, *[heartbeat(Px4Mode.OFFBOARD)] * 1000]
    outcome, sent, _ = fly(script, [0, 0, 0])
    assert outcome is HandoverResult.UNCONFIRMED
    assert len([m for m in sent if isinstance(m, Heartbeat)]) <= 2 + HOLD_TIMEOUT / 1e6


def test_a_link_that_is_lost_meanwhile_is_no_confirmation(fly):
    outcome, _, said = fly(FLIES, [0, 0, 0])
    assert outcome is HandoverResult.UNLINKED
    assert "without a link" in said[-1]


def test_the_second_wish_ends_at_once(fly):
    outcome, _, _ = fly([*FLIES, *[heartbeat(Px4Mode.OFFBOARD)] * 10], [0, 0, 0, 1, 2])
    assert outcome is HandoverResult.CUT_SHORT


def test_what_comes_after_the_end_is_neither_answered_nor_logged(fly, tmp_path):
    last = heartbeat(Px4Mode.HOLD) + heartbeat(Px4Mode.RETURN)
    fly([*FLIES, [], last], [0, 0, 0, 1])
    modes = [
        message.custom_mode
        for _, frame in TlogReader.open(tmp_path / "vehicle-1.tlog")
        if isinstance(message := decode(frame), Heartbeat) and frame.compid == 1
    ]
    assert modes == [Px4Mode.HOLD, Px4Mode.OFFBOARD, Px4Mode.HOLD]


def test_the_date_never_goes_back(monkeypatch):
    clock = Clock()
    first = clock.now()
    monkeypatch.setattr("time.time_ns", lambda: 0)
    assert clock.now() >= first > 1_700_000_000_000_000


def test_the_log_reaches_the_file_while_it_is_written(tmp_path):
    log = FlightLog(TlogWriter(tmp_path / "a.tlog"))
    (frame,) = heartbeat(Px4Mode.HOLD)
    log.write(START, [frame.raw])
    log.flush(START)
    log.write(START, [frame.raw])
    log.flush(START + FLUSH_INTERVAL - 1)
    assert (tmp_path / "a.tlog").stat().st_size == 8 + len(frame.raw)
    log.flush(START + FLUSH_INTERVAL)
    assert (tmp_path / "a.tlog").stat().st_size == 2 * (8 + len(frame.raw))
    log.close()


class FullDisk:
    """A log on a disk that is full."""

    def write_all(self, time_us, frames):
        self.flush()

    def flush(self):
        raise TlogError(__file__, OSError(28, "No space left on device"))

    close = flush


@pytest.mark.parametrize("action", ["write", "flush", "close"])
def test_a_full_disk_is_told_once_and_does_not_end_the_flight(action):
    log = FlightLog(FullDisk())
    for _ in range(3):
        {
            "write": lambda: log.write(0, [b""]),
            "flush": lambda: log.flush(FLUSH_INTERVAL),
            "close": log.close,
        }[action]()
    (warning,) = log.warnings
    assert "No space left" in warning


def test_a_warm_up_flies_past_a_goal(plan, monkeypatch):
    passed = []

    def spy(said, goals):
        passed.append(passage_note(said, goals))
        return passed[-1]

    monkeypatch.setattr("vfguide.companion.guided_flight.passage_note", spy)
    warm_up(plan)
    assert passed
    assert "goal 1 missed" in passed[0] or "goal 1 reached" in passed[0]


def test_a_warm_up_compares_the_places_that_an_autopilot_tells(plan, monkeypatch):
    compared = []

    def spy(measured, place):
        compared.append(distance_from(measured, place))
        return compared[-1]

    monkeypatch.setattr("vfguide.companion.place.distance_from", spy)
    warm_up(plan)
    assert compared
    assert max(compared) < 10.0
