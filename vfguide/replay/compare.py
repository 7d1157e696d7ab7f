"""Recorded inputs through the same companion, its setpoints compared with the recorded ones."""

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
    """[us since 1970]."""
    frame: Frame


class Difference(NamedTuple):
    """The first setpoint that is not the recorded one."""

    number: int
    """Of the setpoint, from 0."""
    time: int
    """[us since 1970]."""
    what: str
    """The field and its two values, or which of the two is missing."""


class Comparison(NamedTuple):
    """What a replay found."""

    recorded: int
    """Setpoints in the log."""
    replayed: int
    """Setpoints that the companion made of the same inputs."""
    difference: Difference | None


class Replay:
    """One companion fed with a log."""

    def __init__(self, sysid: int, plan: Plan, record: Record, step: Step = step_measured) -> None:
        """A replay for one vehicle.

        Args:
            sysid: MAVLink system of the vehicle.
            plan: what its companion was asked to do.
            record: takes what the companion receives and sends now.
            step: of the control loop.
        """
        self._sysid = sysid
        self.companion = Companion(sysid, plan, engage=False, step=step)
        """The companion that is fed."""
        self._session = Session(self.companion, record)

    def compare(self, log: Iterable[tuple[int, Frame]]) -> Comparison:
        """Feed the whole log; setpoints are compared one by one, in their order."""
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
        """Whether the companion of the log sent a frame."""
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
    """The first field in which two setpoints differ."""
    before, after = decode(old), decode(new)
    if isinstance(before, SetAttitudeTarget) and isinstance(after, SetAttitudeTarget):
        for name, was, now in zip(before._fields, before, after, strict=True):
            if was != now:
                return f"{name}: recorded {was!r}, now {now!r}"
    return f"payload: recorded {old.payload.hex()}, now {new.payload.hex()}"


def companions_in(log: Iterable[tuple[int, Frame]]) -> list[int]:
    """Systems whose companion speaks in a log, ascending."""
    return sorted({frame.sysid for _, frame in log if frame.compid == MavComponent.PATHPLANNER})
