"""`vfguide sim` and `vfguide fly` together, as processes over UDP."""

import itertools
import math
import random
import signal
import socket
import threading
import time

import pytest
from programs import (
    GroundStation,
    companion,
    free_vehicles,
    legs_of,
    motion_told,
    ports_of,
    simulation,
    true_path,
)

from vfguide.autopilots.px4 import Px4Mode
from vfguide.cli.main import main
from vfguide.geometry.angles import wrap
from vfguide.geometry.units import DEG, MM, MS
from vfguide.geometry.vector import dot, sub
from vfguide.link.codec import Encoder, decode
from vfguide.link.enums import MavAutopilot, MavState, MavType
from vfguide.link.messages import (
    CurrentMode,
    GlobalPositionInt,
    Heartbeat,
    SetAttitudeTarget,
    Statustext,
)
from vfguide.link.tlog import TlogReader
from vfguide.preflight.load import load_scenario
from vfguide.scenario.resolve import place_of

pytestmark = pytest.mark.slow

SCENARIO = """\
name = "short"
[wind]
speed_mps = 4
from_deg = 300
[[vehicle]]
id = {sysid}
position_m = [-350, -150, -120]
[[vehicle.goal]]
position_m = [0, 0, -125]
heading_deg = 50
tolerance_m = 1
tolerance_deg = 2
"""
FLYING = "flying to goal 1"
BEHIND = 20.0
"""So far behind the goal the log of the truth has the pass [m]."""


@pytest.fixture
def sysid():
    (free,) = free_vehicles()
    return free


@pytest.fixture
def path(tmp_path, sysid):
    """The scenario's file."""
    file = tmp_path / "short.toml"
    file.write_text(SCENARIO.format(sysid=sysid))
    return file


def setpoints(log):
    """Times [us] of the setpoints in a companion's log."""
    frames = ((time_us, decode(frame)) for time_us, frame in TlogReader.open(log))
    return [time_us for time_us, message in frames if isinstance(message, SetAttitudeTarget)]


def goal_pass(path, sysid):
    truth = true_path(path, path.parent / "sim" / "truth.tlog", sysid)
    return legs_of(path, truth, sysid).best()[0]


def test_a_goal_is_reached_in_real_time_and_the_aircraft_handed_over(
    path, sysid, tmp_path, replays
):
    with companion(path, sysid, "--engage", "--log", tmp_path / "fly") as fly:
        fly.says("Ctrl-C hands over")
        with simulation(path, "--log", tmp_path / "sim") as sim:
            fly.says("goal 1 reached", within=60)
            with GroundStation(sysid) as ground:
                ground.listen(0.3)
                stopped = time.monotonic()
                fly.send(signal.SIGINT)
                ground.listen(2.0, says_hold)
                handed_over = time.monotonic()
                assert fly.status() == 0
                ground.listen(2.5)
            sim.send(signal.SIGINT)
            assert sim.status() == 0
    reached = goal_pass(path, sysid)
    assert reached.miss < 1.0
    assert reached.course_error < 2.0 * DEG

    assert "handing over" in fly.text
    assert handed_over - stopped < 0.5
    assert ground.of(Heartbeat)[-1].custom_mode == Px4Mode.HOLD
    assert all(beat.system_status == MavState.ACTIVE for beat in ground.of(Heartbeat))
    assert not any("Failsafe" in m.text for m in ground.of(Statustext))

    log = tmp_path / "fly" / f"vehicle-{sysid}.tlog"
    sent = setpoints(log)
    assert len(sent) / (1e-6 * (sent[-1] - sent[0])) == pytest.approx(50.0, abs=2.0)
    assert replays(log) == 0


@pytest.fixture
def replays(monkeypatch):
    """The exit status of the replay of a log: 0 if all its setpoints come out the same."""

    def replay(log):
        monkeypatch.setattr("sys.argv", ["vfguide", "replay", str(log)])
        with pytest.raises(SystemExit) as ended:
            main()
        return ended.value.code

    return replay


def test_bytes_of_anybody_do_not_disturb_the_flight(path, sysid, tmp_path):
    with companion(path, sysid, "--engage", "--log", tmp_path / "fly") as fly:
        fly.says("Ctrl-C hands over")
        with simulation(path, "--speed", 3, "--log", tmp_path / "sim") as sim:
            fly.says(FLYING, within=60)
            ports = ports_of(sysid)
            with Noise(ports, forgeries(sysid)):
                fly.says("goal 1 reached", within=60)
            with GroundStation(sysid) as ground:
                assert ground.listen(10.0, is_behind_goal(path)), "told before it was there"
            sim.send(signal.SIGTERM)
            assert sim.status() == 0
        assert "released" not in fly.text
        assert f"ignored as vehicle {sysid}" in fly.text
        fly.says("link lost", within=5.0)
        fly.send(signal.SIGTERM)
        assert fly.status() == 1  # nobody confirms a hold any more
        assert "ended without a link" in fly.text
    reached = goal_pass(path, sysid)
    assert reached.miss < 1.0
    assert reached.course_error < 2.0 * DEG


def is_behind_goal(path):
    """What tells whether a message of the autopilot is from BEHIND the goal."""
    loaded = load_scenario(path).scenario
    plane, goal = place_of(loaded.origin), loaded.vehicles[0].goals[0]
    ahead = (math.cos(goal.heading_deg * DEG), math.sin(goal.heading_deg * DEG), 0.0)

    def tells(message):
        if not isinstance(message, GlobalPositionInt):
            return False
        p_n, _ = motion_told(plane, message)
        return dot(sub(p_n, goal.position_m), ahead) > BEHIND

    return tells


def forgeries(sysid):
    """What a stranger sends to the companion: other systems, other components, and itself."""
    beat = Heartbeat(MavType.FIXED_WING, MavAutopilot.PX4, 0, Px4Mode.RETURN, MavState.ACTIVE)
    speakers = ((sysid, 195), (sysid, 100), (sysid + 1, 1), (sysid, 1))
    return [Encoder(*speaker).encode(beat) for speaker in speakers]


class Noise:
    """A thread that throws bytes at ports, and `frames` at the first of them."""

    def __init__(self, ports, frames):
        self.ports, self.frames = ports, frames
        self.stop = threading.Event()
        self.thread = threading.Thread(target=self.throw)

    def throw(self):
        rng = random.Random(1)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as thrower:
            while not self.stop.wait(0.002):
                for port in self.ports:
                    junk = rng.randbytes(rng.choice((0, 1, 7, 40, 300, 1400)))
                    head = rng.choice((b"", b"\xfd", b"\xfd\xff\x00", b"\xfe\x09", b"\xfd\x09\x01"))
                    thrower.sendto(head + junk, ("127.0.0.1", port))
                thrower.sendto(rng.choice(self.frames), ("127.0.0.1", self.ports[0]))

    def __enter__(self):
        self.thread.start()

    def __exit__(self, *_):
        self.stop.set()
        self.thread.join()


def test_the_autopilot_holds_by_itself_when_the_companion_dies(path, sysid, tmp_path):
    speed = 4.0
    with (
        companion(path, sysid, "--engage", "--log", tmp_path / "fly") as fly,
        simulation(path, "--speed", speed),
    ):
        fly.says(FLYING)
        time.sleep(4.0 / speed)
        with GroundStation(sysid) as ground:
            before = ground.listen(2.0, lambda m: isinstance(m, GlobalPositionInt))
            fly.send(signal.SIGKILL)
            killed = ground.listen(2.0, lambda m: isinstance(m, GlobalPositionInt))
            switch = ground.listen(2.0, says_hold)
            lost = ground.of(GlobalPositionInt)[-1]
            ground.listen(35.0 / speed)
        holding = [m for m in ground.of(GlobalPositionInt) if m.time_boot_ms >= lost.time_boot_ms]
    assert before is not None
    assert switch is not None
    assert 0.7 < MS * (lost.time_boot_ms - killed.time_boot_ms) < 2.0
    beats = ground.of(Heartbeat)
    assert (beats[-1].custom_mode, beats[-1].system_status) == (Px4Mode.HOLD, MavState.CRITICAL)
    assert "Failsafe" in ground.of(Statustext)[0].text
    assert MS * (holding[-1].time_boot_ms - holding[0].time_boot_ms) > 20.0
    assert all(abs(m.alt - lost.alt) * MM < 3.0 for m in holding)
    assert turned(holding) > 1.8 * math.pi


def says_hold(message):
    return isinstance(message, CurrentMode) and message.custom_mode == Px4Mode.HOLD


def turned(positions):
    """How far to the right the course has turned [rad]."""
    courses = [math.atan2(m.vy, m.vx) for m in positions]
    return sum(wrap(b - a) for a, b in itertools.pairwise(courses))


def test_the_operator_engages_and_always_wins(path, sysid, tmp_path):
    with (
        companion(path, sysid, "--log", tmp_path / "fly") as fly,
        simulation(path, "--speed", 2),
    ):
        fly.says("waiting for the operator to choose OFFBOARD")
        with GroundStation(sysid) as ground:
            ground.listen(1.0)
            assert {beat.custom_mode for beat in ground.of(Heartbeat)} == {Px4Mode.HOLD}
            ground.set_mode(Px4Mode.OFFBOARD)
            fly.says(FLYING, within=2.0)
            ground.listen(0.5)
            ground.set_mode(Px4Mode.RETURN)
            asked = time.time()
            fly.says("released: the mode was changed to RETURN", within=2.0)
            ground.heard.clear()
            ground.listen(2.5)
            assert fly.process.poll() is None
            fly.send(signal.SIGTERM)
            assert fly.status() == 0
            ground.listen(1.0)
    assert {beat.custom_mode for beat in ground.of(Heartbeat)} == {Px4Mode.RETURN}
    assert {beat.system_status for beat in ground.of(Heartbeat)} == {MavState.ACTIVE}
    assert setpoints(tmp_path / "fly" / f"vehicle-{sysid}.tlog")[-1] < 1e6 * (asked + 0.5)
