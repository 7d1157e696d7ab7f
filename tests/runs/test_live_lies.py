"""`vfguide sim` and `vfguide fly` in real time, with a proxy between them that alters frames."""

import math
import signal
import time
from contextlib import ExitStack
from dataclasses import dataclass

import pytest
from altered import Alter
from programs import GroundStation, Program, free_vehicles, simulation
from proxy import Proxy
from test_lies import lie, wind, yaw

from vfguide.autopilots.px4 import Px4Mode, main_and_sub
from vfguide.geometry.units import DEG
from vfguide.link.codec import decode
from vfguide.link.enums import MavAutopilot, MavCmd, MavState, MavType
from vfguide.link.messages import (
    CommandLong,
    GpsGlobalOrigin,
    Heartbeat,
    HilStateQuaternion,
    SetAttitudeTarget,
    SystemTime,
    Timesync,
)
from vfguide.link.tlog import TlogReader

pytestmark = pytest.mark.slow

SCENARIO = """\
name = "short"
[[vehicle]]
id = {sysid}
position_m = [-350, -150, -120]
[[vehicle.goal]]
position_m = [0, 0, -125]
heading_deg = 50
tolerance_m = 2
tolerance_deg = 5
"""
WEEK = 7 * 86_400 * 1_000_000
SECONDS = 20.0
"""Time for which each pair is watched after the stalls, real time [s]."""


def answers_to_others(_, message):
    """Every answer to a TIMESYNC comes a second time, to a question asked 1.6 s ago."""
    if isinstance(message, Timesync):
        return [message, message._replace(ts1=message.ts1 - 1_600_000_000)]
    return [message]


def rollover(_, message):
    """The counter of the autopilot rolls over 10 s after the first message."""
    if "time_boot_ms" in message._fields:
        return [message._replace(time_boot_ms=(message.time_boot_ms - 10_000) % 2**32)]
    return [message]


def strangers(_, message):
    """Each heartbeat is followed by those of an ArduPlane and of a router with its address."""
    if not isinstance(message, Heartbeat):
        return [message]
    kinds = (
        (MavType.FIXED_WING, MavAutopilot.ARDUPILOTMEGA),
        (MavType.QUADROTOR, MavAutopilot.PX4),
        (MavType.GCS, MavAutopilot.INVALID),
    )
    return [message, *(Heartbeat(*kind, 0, 10, MavState.ACTIVE) for kind in kinds)]


def date(t, message):
    """The date is a week off from 6 s on."""
    if isinstance(message, SystemTime) and t > 6.0:
        return [message._replace(time_unix_usec=message.time_unix_usec + WEEK)]
    return [message]


elsewhere = lie(
    GpsGlobalOrigin, lambda m: m._replace(longitude=m.longitude + 10_000_000), -1.0, 999.0
)


def as_it_is(_, message):
    return [message]


LIES: dict[str, Alter] = {
    "answers to others": answers_to_others,
    "rollover": rollover,
    "strangers": strangers,
    "date": date,
    "elsewhere": elsewhere,
    "yaw": yaw(60.0, 6.0, 14.0),
    "wind": wind(-12.0, 9.0, 6.0),
    "short stall": as_it_is,
    "long stall": as_it_is,
    "choice in a stall": as_it_is,
}
STALLS = {"short stall": 0.75, "long stall": 1.6}
"""Times for which the companion is stopped in flight [s], by the names of the pairs."""
FAILSAFE = 2.2
"""Time of a stall after which the failsafe has acted and the socket is full [s]."""


@dataclass(frozen=True)
class Live:
    """What was seen of one pair."""

    told: str
    said: list
    truth: list

    def said_of(self, kind):
        return [m for m in self.said if isinstance(m, kind)]

    @property
    def bank(self):
        """Greatest bank [deg]."""
        return max(bank_of(m.attitude_quaternion) for m in self.truth) / DEG

    @property
    def lost(self):
        """Height lost below the start [m]."""
        return 1e-3 * (self.truth[0].alt - min(m.alt for m in self.truth))


def bank_of(q):
    w, x, y, z = q
    return abs(math.atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y)))


def messages(log, sysid, compid=None):
    frames = (frame for _, frame in TlogReader.open(log))
    return [
        decode(frame) for frame in frames if frame.sysid == sysid and compid in (None, frame.compid)
    ]


@pytest.fixture(scope="module")
def flown(tmp_path_factory):
    """All pairs at once, for they wait for most of the time."""
    lives, pairs = {}, {}
    with ExitStack() as stack:
        for (name, alter), sysid in zip(LIES.items(), free_vehicles(len(LIES)), strict=True):
            folder = tmp_path_factory.mktemp(name.replace(" ", "-"))
            path = folder / "short.toml"
            path.write_text(SCENARIO.format(sysid=sysid))
            proxy = stack.enter_context(Proxy(sysid, alter))
            fly = Program(
                *("fly", path, "--vehicle", sysid, "--connect", proxy.url),
                *("--engage", "--log", folder / "fly"),
                cwd=folder,
            )
            pairs[name] = (folder, sysid, stack.enter_context(fly))
        for _, _, fly in pairs.values():
            fly.says("Ctrl-C hands over")
        sims = [
            stack.enter_context(simulation(folder / "short.toml", "--log", folder / "sim"))
            for folder, _, _ in pairs.values()
        ]
        for _, _, fly in pairs.values():
            fly.says("the autopilot is found", within=60.0)
        time.sleep(6.0)
        for name, seconds in STALLS.items():
            _, sysid, fly = pairs[name]
            fly.says("flying to goal 1")
            fly.send(signal.SIGSTOP)
            time.sleep(seconds)
            fly.send(signal.SIGCONT)
        _, sysid, fly = pairs["choice in a stall"]
        with GroundStation(sysid) as ground:
            fly.send(signal.SIGSTOP)
            time.sleep(FAILSAFE)
            ground.set_mode(Px4Mode.RETURN)
            time.sleep(0.3)
            fly.send(signal.SIGCONT)
        time.sleep(4.0)
        _, sysid, fly = pairs["long stall"]
        with GroundStation(sysid) as ground:
            ground.set_mode(Px4Mode.OFFBOARD)
        time.sleep(SECONDS)
        for program in (*(fly for _, _, fly in pairs.values()), *sims):
            program.send(signal.SIGINT)
            assert program.status() == 0
        for name, (folder, sysid, fly) in pairs.items():
            lives[name] = Live(
                fly.text,
                messages(folder / "fly" / f"vehicle-{sysid}.tlog", sysid, 195),
                [
                    m
                    for m in messages(folder / "sim" / "truth.tlog", sysid)
                    if isinstance(m, HilStateQuaternion)
                ],
            )
    return lives


@pytest.mark.parametrize(
    "name", [name for name in LIES if name not in ("elsewhere", "choice in a stall")]
)
def test_the_goal_is_reached_in_spite_of_it(flown, name):
    live = flown[name]
    assert "goal 1 reached" in live.told
    assert "goal 1 missed" not in live.told
    assert live.bank <= 55.0
    assert live.lost <= 50.0


@pytest.mark.parametrize(
    ("name", "note"),
    [
        ("strangers", "is not its autopilot's: ignored"),
        ("date", "the autopilot's date has leapt by +604800 s"),
        ("elsewhere", "km from the nearest goal"),
        ("yaw", "the yaw told by the autopilot contradicts the rest"),
        ("wind", "the wind told by the autopilot contradicts the rest"),
    ],
)
def test_it_is_told(flown, name, note):
    assert note in flown[name].told.replace("\n", " ")


@pytest.mark.parametrize("name", ["answers to others", "rollover"])
def test_what_is_no_fault_of_the_vehicles_is_not_told(flown, name):
    assert "no setpoints" not in flown[name].told
    assert "leapt" not in flown[name].told


def test_a_vehicle_elsewhere_gets_neither_setpoint_nor_mode(flown):
    live = flown["elsewhere"]
    assert not live.said_of(SetAttitudeTarget)
    assert not any(m.command == MavCmd.DO_SET_MODE for m in live.said_of(CommandLong))
    assert live.lost <= 5.0


def test_a_short_stall_is_told_and_flown_through(flown):
    told = flown["short stall"].told
    assert "the companion stood still for 0." in told
    assert "no more setpoints" not in told
    assert "released" not in told


def test_after_a_long_stall_it_is_silent_until_the_operator_chooses_again(flown):
    told = flown["long stall"].told
    assert "the companion stood still for 1." in told
    assert "no more setpoints for now" in told
    assert told.count("the autopilot follows") == 2
    assert "released" not in told


def test_a_mode_that_was_chosen_while_it_stood_still_is_left_alone(flown):
    """What waited says that the failsafe holds, and that it would follow again."""
    live = flown["choice in a stall"]
    asked = [m for m in live.said_of(CommandLong) if m.command == MavCmd.DO_SET_MODE]
    assert [main_and_sub(Px4Mode.OFFBOARD)] == [(m.param2, m.param3) for m in asked]
    assert "the companion stood still for 2." in live.told
    assert "setpoints go out again, waiting for the operator to choose OFFBOARD" in live.told
    assert "ended: the autopilot flies RETURN" in live.told
    assert "leapt" not in live.told
    assert "released" not in live.told
