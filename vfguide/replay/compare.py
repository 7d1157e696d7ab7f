"""Replay of a log: recorded inputs are fed to a companion, and its setpoints are compared."""

from collections.abc import Iterable, Iterator
from itertools import zip_longest
from typing import NamedTuple

from vfguide.companion.companion import Companion
from vfguide.companion.guided_flight import Step
from vfguide.companion.plan import Plan
from vfguide.companion.session import Record, Session
from vfguide.link.codec import Frame, Parser, decode
from vfguide.link.enums import MavComponent
from vfguide.link.messages import SetAttitudeTarget
from vfguide.loop.rows import step_measured


class Timed(NamedTuple):
    """A frame and its time."""

    time: int
    """Time of sending [us since 1970]."""
    frame: Frame


class Difference(NamedTuple):
    """The first setpoint in which a replay differs from the log."""

    number: int
    """Number of the setpoint, from 0."""
    time: int
    """Time of sending [us since 1970]."""
    what: str
    """What differs, in words: a field with both values, or which setpoint is missing."""


class Comparison(NamedTuple):
    """What a replay found."""

    recorded: int
    """Number of setpoints in the log."""
    replayed: int
    """Number of setpoints that the companion made of the same inputs."""
    difference: Difference | None
    """The first difference; None: the setpoints are identical."""


class Replay:
    """One companion that is fed with a log."""

    def __init__(self, sysid: int, plan: Plan, record: Record, step: Step = step_measured) -> None:
        """A replay for one vehicle.

        Args:
            sysid: MAVLink system of the vehicle.
            plan: the plan of its companion.
            record: takes what the companion receives and sends in the replay.
            step: the step of the control loop.
        """
        self._sysid = sysid
        self.companion = Companion(sysid, plan, engage=False, step=step)
        """The companion that is fed."""
        self._session = Session(self.companion, record)

    def compare(self, log: Iterable[tuple[int, Frame]]) -> Comparison:
        """Feed the log, frames with their times [us since 1970], and compare setpoints in order."""
        recorded: list[Timed] = []
        replayed: list[Timed] = []
        for time, frame in log:
            if self._is_own(frame):
                replayed += setpoints_of(time, self._session.recall(time, frame))
                if frame.msgid == SetAttitudeTarget.MSGID:
                    recorded.append(Timed(time, frame))
            elif frame.compid == MavComponent.AUTOPILOT1:
                replayed += setpoints_of(time, self._session.receive(time, frame.raw))
        return Comparison(len(recorded), len(replayed), first_difference(recorded, replayed))

    def _is_own(self, frame: Frame) -> bool:
        """Whether the companion of this vehicle sent a frame."""
        return frame.sysid == self._sysid and frame.compid == MavComponent.PATHPLANNER


def setpoints_of(time: int, sent: Iterable[bytes]) -> Iterator[Timed]:
    """The setpoints among frames that go out at a `time` [us since 1970]."""
    for raw in sent:
        for frame in Parser().feed(raw):
            if frame.msgid == SetAttitudeTarget.MSGID:
                yield Timed(time, frame)


def first_difference(recorded: list[Timed], replayed: list[Timed]) -> Difference | None:
    """The first setpoint whose bytes differ, the time of sending included."""
    for index, (old, new) in enumerate(zip_longest(recorded, replayed)):
        if old is None:
            return Difference(index, new.time, "the log has no such setpoint, the replay has")
        if new is None:
            return Difference(index, old.time, "the replay has no such setpoint, the log has")
        if old.frame.payload != new.frame.payload:
            return Difference(index, old.time, field_difference(old.frame, new.frame))
        if old.time != new.time:
            what = f"time of sending: recorded {old.time}, now {new.time} us"
            return Difference(index, old.time, what)
    return None


def field_difference(old: Frame, new: Frame) -> str:
    """The first field in which two setpoints differ, with both values, in words."""
    before, after = decode(old), decode(new)
    if isinstance(before, SetAttitudeTarget) and isinstance(after, SetAttitudeTarget):
        for name, was, now in zip(before._fields, before, after, strict=True):
            if was != now:
                return f"{name}: recorded {was!r}, now {now!r}"
    return f"payload: recorded {old.payload.hex()}, now {new.payload.hex()}"


def companions_in(log: Iterable[tuple[int, Frame]]) -> list[int]:
    """MAVLink systems whose companion speaks in a log, ascending."""
    return sorted({frame.sysid for _, frame in log if frame.compid == MavComponent.PATHPLANNER})
