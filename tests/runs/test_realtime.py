"""`vfguide sim` as a process over UDP, in real time."""

import signal
import socket
import statistics
import time

import pytest
from conversations_with_autopilot import UPDATE, Dialogue, new_vehicle, setpoint
from programs import (
    GroundStation,
    Program,
    free_vehicles,
    ground_port,
    offboard_port,
    ports_of,
    simulation,
)

from vfguide.autopilots.px4 import Px4Mode
from vfguide.cli.main import main
from vfguide.geometry.units import MS
from vfguide.link.codec import Encoder, Parser, decode
from vfguide.link.enums import AttitudeTypeMask, MavCmd
from vfguide.link.messages import (
    AttitudeTarget,
    CommandLong,
    CurrentMode,
    GlobalPositionInt,
    Heartbeat,
    ParamSet,
    SetAttitudeTarget,
    SystemTime,
)
from vfguide.link.tlog import TlogReader
from vfguide.preflight.load import load_scenario
from vfguide.runs.vehicle_setup import start_us
from vfguide.sim.fdm import ModelError
from vfguide.sim.realtime import RealtimeFlight, Station
from vfguide.sim.udp import PortTakenError, bound_socket, ground_numbers, offboard_numbers

pytestmark = pytest.mark.slow

HEAD = 'name = "stay"\nduration_s = 1.0\n'
VEHICLE = """
[[vehicle]]
id = {sysid}
position_m = [0, {east}, -150]
[[vehicle.goal]]
position_m = [500, 0, -150]
heading_deg = 0
"""
READY = "flying at"


@pytest.fixture
def sysid():
    (free,) = free_vehicles()
    return free


def write(folder, *ids):
    path = folder / "stay.toml"
    vehicles = (VEHICLE.format(sysid=sysid, east=300 * k) for k, sysid in enumerate(ids))
    path.write_text(HEAD + "".join(vehicles))
    return path


@pytest.mark.parametrize(
    ("sysid", "offboard", "ground"),
    [
        (1, (14580, 14540), (18570, 14550)),
        (10, (14589, 14549), (18579, 14550)),
        (11, (14590, 15550), (18580, 14550)),
        (250, (14829, 15789), (18819, 14550)),
    ],
)
def test_ports_are_numbered_as_px4_numbers_them(sysid, offboard, ground):
    assert offboard_numbers(sysid) == offboard
    assert ground_numbers(sysid) == ground


def test_no_two_vehicles_share_a_port():
    numbers = [f(sysid) for f in (offboard_numbers, ground_numbers) for sysid in range(1, 251)]
    own = [number.own for number in numbers]
    peers = [offboard_numbers(sysid).peer for sysid in range(1, 251)]
    assert len({*own, *peers, 14550}) == len(own) + len(peers) + 1


def test_two_vehicles_fly_by_the_clock_beyond_the_duration_until_they_are_ended(tmp_path):
    first, second = free_vehicles(2)
    path = write(tmp_path, first, second)
    with simulation(path, "--log", tmp_path / "truth") as sim:
        sim.says(READY)
        with GroundStation(first) as one, GroundStation(second) as other:
            one.listen(4.0)
            other.listen(0.1)
            sim.send(signal.SIGTERM)
            assert sim.status() == 0
        companion, offboard, ground = ports_of(second)
        assert f"vehicle {second}: companion {offboard} -> {companion}" in sim.text
        assert f"ground station {ground} -> 14550" in sim.text
        assert "ended after" in sim.text
    assert other.of(GlobalPositionInt)
    heard = [(at, m) for at, m in one.heard if isinstance(m, GlobalPositionInt)]
    assert len(heard) >= 39
    drift = [at - MS * m.time_boot_ms for at, m in heard]
    assert statistics.median(drift[-10:]) - statistics.median(drift[:10]) == pytest.approx(
        0.0, abs=0.02
    )
    times = [time_us for time_us, frame in TlogReader.open(tmp_path / "truth" / "truth.tlog")]
    assert {t - start_us(load_scenario(path).scenario) for t in times[:2]} == {20_000}


def test_with_speed_the_clock_and_the_date_of_the_simulation_run_together(tmp_path, sysid):
    with simulation(write(tmp_path, sysid), "--speed", 5) as sim:
        sim.says(READY)
        with GroundStation(sysid) as ground:
            ground.listen(2.0)
        sim.send(signal.SIGINT)
        assert sim.status() == 0
    dates = [(at, m) for at, m in ground.heard if isinstance(m, SystemTime)]
    (first_at, first), (last_at, last) = dates[0], dates[-1]
    boot = MS * (last.time_boot_ms - first.time_boot_ms)
    assert boot == pytest.approx(5.0 * (last_at - first_at), rel=0.05)
    assert 1e-6 * (last.time_unix_usec - first.time_unix_usec) == pytest.approx(boot, abs=0.01)


class Companion:
    """A peer on the offboard channel, bound to a port of its own choice."""

    def __init__(self, sysid):
        self.sysid = sysid
        self.encoder, self.parser = Encoder(sysid, 195), Parser()
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.connect(("127.0.0.1", offboard_port(sysid)))
        self.socket.settimeout(2.0)

    def send(self, message):
        self.socket.send(self.encoder.encode(message))

    def command(self, number, *parameters):
        p = (*parameters, *(0.0,) * (7 - len(parameters)))
        self.send(CommandLong(self.sysid, 1, number, 0, *p))

    def set_rates(self, p):
        mask = AttitudeTypeMask.ATTITUDE_IGNORE
        attitude = (1.0, 0.0, 0.0, 0.0)
        self.send(SetAttitudeTarget(0, self.sysid, 1, mask, attitude, p, 0.0, 0.0, 0.4))

    def wait_for(self, kind, fits=lambda _: True):
        end = time.monotonic() + 3.0
        while time.monotonic() < end:
            for frame in self.parser.feed(self.socket.recv(65_535)):
                message = decode(frame)
                if isinstance(message, kind) and fits(message):
                    return message
        raise AssertionError(f"no {kind.NAME}")


def test_a_setpoint_is_applied_on_arrival(tmp_path, sysid):
    """From the setpoint's sending to the answer that tells it, both ways and all processes."""
    with simulation(write(tmp_path, sysid)) as sim:
        sim.says(READY)
        peer = Companion(sysid)
        with peer.socket:
            for _ in range(10):
                peer.set_rates(0.0)
                time.sleep(0.02)
            peer.command(MavCmd.DO_SET_MODE, 1.0, 6.0, 0.0)
            peer.wait_for(CurrentMode, lambda m: m.custom_mode == Px4Mode.OFFBOARD)
            delays = []
            for number in range(100):
                rate = 0.001 * (1 + number)
                sent = time.perf_counter()
                peer.set_rates(rate)
                peer.command(MavCmd.REQUEST_MESSAGE, AttitudeTarget.MSGID)
                peer.wait_for(AttitudeTarget, lambda m, r=rate: abs(m.body_roll_rate - r) < 1e-6)
                delays.append(time.perf_counter() - sent)
                time.sleep(0.003)
    quickest, median, _ = statistics.quantiles(delays, n=4)
    print(f"median {1e3 * median:.2f} ms, worst {1e3 * max(delays):.2f} ms")
    assert quickest < 0.002


def test_answers_go_to_who_spoke_last_and_junk_is_nobody(tmp_path, sysid):
    with simulation(write(tmp_path, sysid)) as sim:
        sim.says(READY)
        with GroundStation(sysid) as first, GroundStation(sysid) as second:
            second.listen(0.5)
            assert second.of(GlobalPositionInt)
            first.listen(0.2)
            before = len(first.heard)
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
                stranger.sendto(b"\xfd no frame at all", ("127.0.0.1", ground_port(sysid)))
                second.listen(1.1)
                first.listen(0.1)
                assert second.of(Heartbeat)
                assert len(first.heard) == before
            first.greet()
            first.listen(0.5)
            assert len(first.heard) > before


def test_a_port_in_use_is_told_in_one_line(tmp_path, sysid):
    with (
        bound_socket(ground_port(sysid)),
        Program("sim", write(tmp_path, sysid), cwd=tmp_path) as sim,
    ):
        assert sim.status(within=240.0) == 2
        assert len(sim.lines) == 1
        assert f"vehicle {sysid}" in sim.text
        assert str(ground_port(sysid)) in sim.text


def test_a_port_cannot_be_had_twice(sysid):
    port = offboard_port(sysid)
    with bound_socket(port), pytest.raises(PortTakenError, match=str(port)):
        bound_socket(port)


@pytest.mark.parametrize("speed", ["0", "-1", "nan", "fast"])
def test_a_speed_that_makes_no_sense_is_refused(monkeypatch, capsys, speed):
    monkeypatch.setattr("sys.argv", ["vfguide", "sim", "first-flight", "--speed", speed])
    with pytest.raises(SystemExit) as ended:
        main()
    assert ended.value.code == 2
    assert "--speed" in capsys.readouterr().err


def flight(vehicle, speed, warnings):
    return RealtimeFlight([Station(vehicle, [])], speed, UPDATE, lambda _: None, warnings.append)


def test_a_vehicle_that_hits_the_ground_ends_and_with_the_last_one_the_flight():
    vehicle, warnings = new_vehicle(), []
    talk = Dialogue(vehicle)
    talk.send(ParamSet(1, 1, "COM_OF_LOSS_T", 60.0, 9))
    talk.fly(0.1, setpoint())
    talk.set_mode(Px4Mode.OFFBOARD)
    talk.send(setpoint(q=-0.3))
    flight(vehicle, 500.0, warnings).run(lambda: False)
    assert warnings[-1].startswith("vehicle 1 ends after")
    assert warnings[-1].endswith("it has hit the ground")
    assert vehicle.truth.height_above_ground <= 0.0


def test_a_machine_that_is_too_slow_is_told_once_and_the_flight_goes_on():
    vehicle, warnings, turns = new_vehicle(), [], iter(range(200))
    too_fast = flight(vehicle, 1e6, warnings)
    time.sleep(0.2)
    too_fast.run(lambda: next(turns) == 199)
    (warning,) = warnings
    assert "too slow or too busy" in warning
    assert too_fast.sim_s == pytest.approx(199 * UPDATE * 0.005)


def test_a_model_that_fails_ends_its_vehicle_alone(monkeypatch):
    vehicle, warnings = new_vehicle(), []

    def fail(steps):
        raise ModelError("the wing came off")

    monkeypatch.setattr(vehicle, "fly", fail)
    flight(vehicle, 1.0, warnings).run(lambda: False)
    assert "the wing came off" in warnings[0]
