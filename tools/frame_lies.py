"""Random lies about the frames that an autopilot sends: values, order, time and identity.

Roll, pitch and position stay true. A lie is a function that takes each message with the time [s] at
which it is sent, and returns the messages that arrive in its place.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from operator import itemgetter
from typing import NamedTuple

import numpy as np
from altered import turned_about_vertical
from numpy.random import Generator

from vfguide.link.enums import MavAutopilot, MavType
from vfguide.link.messages import (
    AttitudeQuaternion,
    GlobalPositionInt,
    Heartbeat,
    LocalPositionNed,
    Message,
    SystemTime,
    Timesync,
    VfrHud,
    WindCov,
)

Lie = Callable[[float, Message], Sequence[Message]]
COUNTER_LIMIT = 1 << 32
"""Count at which a counter of milliseconds starts again at zero [ms]: it has 32 bits."""
UNTOLD = (WindCov, VfrHud, SystemTime, Timesync, GlobalPositionInt)
"""The kinds of message that a lie may keep back or delay: those without roll, pitch, position."""


@dataclass(frozen=True)
class While:
    """A lie that changes values for some time, and may grow."""

    begin: float
    """When it begins [s]."""
    end: float
    """When it ends [s]."""
    ramp: float
    """Time in which it grows from nothing [s]."""
    change: Callable[[Message, float], Sequence[Message]]
    """The messages in place of one, for the share 0 to 1 to which the lie has grown."""

    def __call__(self, t: float, message: Message) -> Sequence[Message]:
        """The messages that arrive at the time `t` [s]."""
        if not self.begin <= t < self.end:
            return [message]
        share = min((t - self.begin) / self.ramp, 1.0) if self.ramp > 0.0 else 1.0
        return self.change(message, share)


class Late:
    """A lie by which messages of some kinds arrive late, each by a random time."""

    def __init__(self, rng: Generator, kinds: tuple[type, ...], least: float, most: float):
        self._rng, self._kinds, self._delays = rng, kinds, (least, most)
        self._waiting = list[tuple[float, Message]]()

    def __call__(self, t: float, message: Message) -> Sequence[Message]:
        """The messages that arrive at the time `t` [s]: those whose time has come."""
        arrived = [] if isinstance(message, self._kinds) else [message]
        if not arrived:
            self._waiting.append((t + self._rng.uniform(*self._delays), message))
        self._waiting.sort(key=itemgetter(0))
        delayed = [each for at, each in self._waiting if at <= t]
        self._waiting = [(at, each) for at, each in self._waiting if at > t]
        return [*delayed, *arrived]


def yaw(angle: float) -> Callable[[Message, float], Sequence[Message]]:
    """A change that makes yaw wrong by an angle [rad]."""

    def change(m: Message, share: float) -> Sequence[Message]:
        if not isinstance(m, AttitudeQuaternion):
            return [m]
        q1, q2, q3, q4 = turned_about_vertical((m.q1, m.q2, m.q3, m.q4), share * angle)
        return [m._replace(q1=float(q1), q2=float(q2), q3=float(q3), q4=float(q4))]

    return change


def velocity(north: float, east: float, down: float) -> Callable[[Message, float], list[Message]]:
    """A change that makes ground velocity wrong by a vector, NED [m/s]."""

    def change(m: Message, share: float) -> list[Message]:
        n, e, d = share * north, share * east, share * down
        if isinstance(m, LocalPositionNed):
            return [m._replace(vx=m.vx + n, vy=m.vy + e, vz=m.vz + d)]
        if isinstance(m, GlobalPositionInt):
            cm = [int(100.0 * each) for each in (n, e, d)]
            return [m._replace(vx=m.vx + cm[0], vy=m.vy + cm[1], vz=m.vz + cm[2])]
        return [m]

    return change


def wind(north: float, east: float) -> Callable[[Message, float], list[Message]]:
    """A change that makes the wind wrong by a vector [m/s]."""

    def change(m: Message, share: float) -> list[Message]:
        if not isinstance(m, WindCov):
            return [m]
        return [m._replace(wind_x=m.wind_x + share * north, wind_y=m.wind_y + share * east)]

    return change


def airspeed(ratio: float) -> Callable[[Message, float], list[Message]]:
    """A change that multiplies the airspeed by a ratio."""

    def change(m: Message, share: float) -> list[Message]:
        if not isinstance(m, VfrHud):
            return [m]
        return [m._replace(airspeed=m.airspeed * (1.0 + share * (ratio - 1.0)))]

    return change


def body_rates(p: float, q: float, r: float) -> Callable[[Message, float], list[Message]]:
    """A change that makes body rates wrong by a vector, FRD [rad/s]."""

    def change(m: Message, share: float) -> list[Message]:
        if not isinstance(m, AttitudeQuaternion):
            return [m]
        p_n, q_n, r_n = m.rollspeed + share * p, m.pitchspeed + share * q, m.yawspeed + share * r
        return [m._replace(rollspeed=p_n, pitchspeed=q_n, yawspeed=r_n)]

    return change


def untold(kinds: tuple[type, ...]) -> Callable[[Message, float], list[Message]]:
    """A change by which messages of some kinds do not arrive."""
    return lambda m, _: [] if isinstance(m, kinds) else [m]


def lost(rng: Generator, share: float) -> Callable[[Message, float], list[Message]]:
    """A change by which a random share of all messages does not arrive."""
    return lambda m, _: [] if rng.random() < share else [m]


def repeated(times: int) -> Callable[[Message, float], list[Message]]:
    """A change by which each message arrives several times."""
    return lambda m, _: times * [m]


def counter(offset_ms: int) -> Callable[[Message, float], list[Message]]:
    """A change that makes the time since the autopilot's start wrong by an offset [ms]."""

    def change(m: Message, _: float) -> list[Message]:
        if not isinstance(m, AttitudeQuaternion | LocalPositionNed | GlobalPositionInt):
            return [m]
        return [m._replace(time_boot_ms=(m.time_boot_ms + offset_ms) % COUNTER_LIMIT)]

    return change


def date(offset_us: int) -> Callable[[Message, float], list[Message]]:
    """A change that makes the date wrong by an offset [us]."""

    def change(m: Message, _: float) -> list[Message]:
        if not isinstance(m, SystemTime):
            return [m]
        return [m._replace(time_unix_usec=max(0, m.time_unix_usec + offset_us))]

    return change


def answers(rng: Generator) -> Callable[[Message, float], list[Message]]:
    """A change that adds answers of TIMESYNC with random stamps."""

    def change(m: Message, _: float) -> list[Message]:
        if not isinstance(m, Timesync):
            return [m]
        stamp = m.ts1 + int(rng.integers(-(10**10), 10**10))
        return [m._replace(tc1=int(rng.integers(1, 10**15)), ts1=stamp), m]

    return change


def stranger(rng: Generator) -> Callable[[Message, float], list[Message]]:
    """A change that adds heartbeats of another sender with the autopilot's identity."""
    makes = (MavAutopilot.INVALID, MavAutopilot.GENERIC, MavAutopilot.ARDUPILOTMEGA)
    autopilot = int(makes[int(rng.integers(len(makes)))])
    kind = int((MavType.QUADROTOR, MavType.GCS, MavType.FIXED_WING)[int(rng.integers(3))])

    def change(m: Message, _: float) -> list[Message]:
        if not isinstance(m, Heartbeat):
            return [m]
        mode = int(rng.integers(0, 1 << 32))
        return [m, m._replace(type=kind, autopilot=autopilot, custom_mode=mode)]

    return change


Change = Callable[[Message, float], Sequence[Message]]
LEAST_SHARE = 0.03
"""Least size of a lie, as a share of the largest; chosen."""


class Size(NamedTuple):
    """How wrong a lie is."""

    share: float
    """Share of the largest size, from LEAST_SHARE to 1, distributed evenly in its logarithm."""
    sign: float
    """Minus or plus one."""
    north: float
    """North component of a random horizontal unit vector."""
    east: float
    """East component of the same."""


def over_decades(size: Size, least: float, most: float) -> float:
    """A number from `least` to `most`, whose logarithm is linear in that of the share."""
    return most * (most / least) ** (-math.log(size.share) / math.log(LEAST_SHARE))


CHANGES: dict[str, Callable[[Generator, Size], Change]] = {
    "yaw": lambda _, s: yaw(s.sign * math.pi * s.share),
    "velocity": lambda _, s: velocity(
        40.0 * s.share * s.north, 40.0 * s.share * s.east, 8.0 * s.share * s.sign
    ),
    "wind": lambda _, s: wind(40.0 * s.share * s.north, 40.0 * s.share * s.east),
    "airspeed": lambda _, s: airspeed(1.0 + s.share * (1.5 if s.sign > 0.0 else -1.0)),
    "body rates": lambda _, s: body_rates(
        2.0 * s.share * s.north, 2.0 * s.share * s.east, 2.0 * s.share * s.sign
    ),
    "untold": lambda rng, _: untold((UNTOLD[int(rng.integers(len(UNTOLD)))],)),
    "silence": lambda _, __: untold((object,)),
    "loss": lambda rng, s: lost(rng, 0.5 * s.share),
    "twice": lambda rng, _: repeated(int(rng.integers(2, 4))),
    "counter": lambda _, s: counter(int(s.sign * over_decades(s, 10.0, 4e9))),
    "date": lambda _, s: date(int(s.sign * over_decades(s, 1e5, 1e14))),
    "timesync": lambda rng, _: answers(rng),
    "stranger": lambda rng, _: stranger(rng),
}
"""The changes of values, by the names of the lies."""
NAMES = (*CHANGES, "late", "reordered")
"""The names of all lies."""


def draw_size(rng: Generator) -> Size:
    """A random size of a lie."""
    toward = rng.uniform(-math.pi, math.pi)
    share, sign = LEAST_SHARE ** rng.uniform(0.0, 1.0), float(rng.choice((-1.0, 1.0)))
    return Size(share, sign, math.cos(toward), math.sin(toward))


def draw_lie(rng: Generator, name: str, longest: float) -> Lie:
    """A named lie within a time [s]."""
    if name == "late":
        most = rng.uniform(0.1, 2.0)
        return Late(rng, (UNTOLD[int(rng.integers(len(UNTOLD)))],), 0.5 * most, most)
    if name == "reordered":
        return Late(rng, (object,), 0.0, rng.uniform(0.02, 0.2))
    begin = rng.uniform(0.0, longest) if rng.random() < 0.8 else -1.0
    end = begin + rng.uniform(0.1, 20.0) if rng.random() < 0.5 else math.inf
    if name == "silence":
        end = begin + rng.uniform(0.1, 1.0)
    ramp = rng.uniform(0.2, 20.0) if rng.random() < 0.3 else 0.0
    return While(begin, end, ramp, CHANGES[name](rng, draw_size(rng)))


def draw_lies(rng: Generator, longest: float) -> dict[str, Lie]:
    """One to four lies of different names within a time [s]."""
    names = rng.choice(NAMES, int(rng.integers(1, 5)), replace=False)
    return {str(name): draw_lie(rng, str(name), longest) for name in names}


def through(lies: Sequence[Lie], t: float, message: Message) -> Iterator[Message]:
    """The messages that arrive of one that passes several lies in turn at a time [s]."""
    told: Sequence[Message] = [message]
    for lie in lies:
        told = [each for m in told for each in lie(t, m)]
    yield from told


def seeded(seed: int, number: int) -> Generator:
    """The generator of the random numbers of flight `number`."""
    return np.random.default_rng(np.random.SeedSequence((seed, number)))
