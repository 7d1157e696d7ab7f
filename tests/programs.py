"""`vfguide sim` and `vfguide fly` as processes over UDP, and a ground station to watch them."""

import itertools
import os
import random
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

from vfguide.autopilots.px4 import main_and_sub
from vfguide.earth.geodesy import place_in_plane
from vfguide.geometry.units import CM_S, DEG_E7, MM, US
from vfguide.geometry.vector import Vec3
from vfguide.link.codec import Encoder, Parser, decode
from vfguide.link.enums import MavAutopilot, MavCmd, MavState, MavType, ModeFlag
from vfguide.link.messages import CommandLong, GlobalPositionInt, Heartbeat, HilStateQuaternion
from vfguide.link.tlog import TlogReader
from vfguide.preflight.load import load_scenario
from vfguide.results.goal_passages import Legs, Sample
from vfguide.runs.vehicle_setup import start_us
from vfguide.scenario.resolve import place_of

COMPILING = 240.0
"""The first run after a change compiles everything [s]."""
VFGUIDE = (sys.executable, "-c", "from vfguide.cli.main import main; main()")


def offboard_port(sysid: int) -> int:
    return 14580 + sysid - 1


def companion_port(sysid: int) -> int:
    return 15540 + sysid - 1


def ground_port(sysid: int) -> int:
    return 18570 + sysid - 1


def free_vehicles(count: int = 1) -> list[int]:
    """System ids whose ports nobody uses: other tests may be running on this machine."""
    ids = random.SystemRandom().sample(range(101, 251), 150)
    free = (sysid for sysid in ids if all(map(is_free, ports_of(sysid))))
    return sorted(itertools.islice(free, count))


def ports_of(sysid: int) -> tuple[int, int, int]:
    return companion_port(sysid), offboard_port(sysid), ground_port(sysid)


def is_free(port: int) -> bool:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as tried:
        try:
            tried.bind(("127.0.0.1", port))
        except OSError:
            return False
    return True


class Program:
    """A running `vfguide`; ended, if need be, at the end of the `with`."""

    def __init__(self, *arguments: str | Path | int, cwd: Path) -> None:
        self.lines: list[str] = []
        command = [*VFGUIDE, *map(str, arguments)]
        self.process = subprocess.Popen(
            command,
            cwd=cwd,
            env={**os.environ, "COLUMNS": "200"},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        self._reader = threading.Thread(target=self._read)
        self._reader.start()

    def _read(self) -> None:
        self.lines.extend(line.rstrip("\n") for line in self.process.stdout)

    @property
    def text(self) -> str:
        return "\n".join(self.lines)

    def says(self, text: str, within: float = COMPILING) -> None:
        """Wait until it has printed `text`."""
        self.until(lambda: text in self.text, f"saying {text!r}", within)

    def writes(self, path: Path, within: float = COMPILING) -> None:
        """Wait until there is something in a file."""
        self.until(lambda: path.exists() and path.stat().st_size > 0, f"writing {path}", within)

    def until(self, condition: Callable[[], bool], what: str, within: float) -> None:
        """Wait, while it runs, until a condition holds."""
        end = time.monotonic() + within
        while not condition():
            assert self.process.poll() is None, f"ended without {what}:\n{self.text}"
            assert time.monotonic() < end, f"no {what} in {within} s:\n{self.text}"
            time.sleep(0.02)

    def send(self, number: int) -> None:
        self.process.send_signal(number)

    def status(self, within: float = 20.0) -> int:
        """Wait for its end."""
        status = self.process.wait(within)
        self._reader.join()
        return status

    def __enter__(self) -> "Program":
        return self

    def __exit__(self, *_: object) -> None:
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self._reader.join()
        self.process.stdout.close()


def simulation(scenario: Path, *options: str | Path | float) -> Program:
    return Program("sim", scenario, *options, cwd=scenario.parent)


def companion(scenario: Path, sysid: int, *options: str | Path) -> Program:
    url = f"udpin:127.0.0.1:{companion_port(sysid)}"
    return Program(
        "fly", scenario, "--vehicle", sysid, "--connect", url, *options, cwd=scenario.parent
    )


class GroundStation:
    """A socket that speaks to a vehicle's ground port, and so hears its streams."""

    def __init__(self, sysid: int) -> None:
        self.sysid = sysid
        self.heard: list[tuple[float, object]] = []
        self._encoder = Encoder(255, 190)
        self._parser = Parser()
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.connect(("127.0.0.1", ground_port(sysid)))
        self.greet()

    def greet(self) -> None:
        self.send(Heartbeat(MavType.GCS, MavAutopilot.INVALID, 0, 0, MavState.ACTIVE))

    def send(self, message) -> None:
        self._socket.send(self._encoder.encode(message))

    def set_mode(self, mode) -> None:
        main, sub = main_and_sub(mode)
        flags = ModeFlag.CUSTOM_MODE_ENABLED
        self.send(CommandLong(self.sysid, 1, MavCmd.DO_SET_MODE, 0, flags, main, sub, 0, 0, 0, 0))

    def listen(self, seconds: float, until=lambda _: False):
        """Hear for so long, or until a message is what is waited for: returns that one."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0.0:
            self._socket.settimeout(left)
            try:
                data = self._socket.recv(65_535)
            except (TimeoutError, ConnectionRefusedError):
                continue
            for frame in self._parser.feed(data, whole=True):
                message = decode(frame)
                self.heard.append((time.monotonic(), message))
                if message is not None and until(message):
                    return message
        return None

    def of(self, kind: type) -> list:
        """What was heard of one kind."""
        return [message for _, message in self.heard if isinstance(message, kind)]

    def __enter__(self) -> "GroundStation":
        return self

    def __exit__(self, *_: object) -> None:
        self._socket.close()


def true_path(scenario: Path, log: Path, sysid: int) -> list[Sample]:
    """The path of a vehicle in the scenario frame, from the log of the truth."""
    loaded = load_scenario(scenario).scenario
    plane, start = place_of(loaded.origin), start_us(loaded)
    path = []
    for time_us, frame in TlogReader.open(log):
        message = decode(frame)
        if frame.sysid == sysid and isinstance(message, HilStateQuaternion):
            path.append(Sample((time_us - start) * US, *motion_told(plane, message)))
    return path


def motion_told(origin: Vec3, message: HilStateQuaternion | GlobalPositionInt) -> tuple[Vec3, Vec3]:
    """Position [m] and velocity [m/s] that a message tells, NED in the frame with an `origin`."""
    v_n = (message.vx * CM_S, message.vy * CM_S, message.vz * CM_S)
    where = (message.lat * DEG_E7, message.lon * DEG_E7, message.alt * MM)
    return place_in_plane(origin, *where, v_n)


def legs_of(scenario: Path, path: list[Sample], sysid: int) -> Legs:
    """The path judged against the goals of the vehicle."""
    vehicles = load_scenario(scenario).scenario.vehicles
    legs = Legs(next(vehicle.goals for vehicle in vehicles if vehicle.id == sysid))
    for sample in path:
        legs.feed(sample)
    return legs
