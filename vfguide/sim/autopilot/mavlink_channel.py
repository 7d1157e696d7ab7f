"""One MAVLink channel of the software autopilot: its numbering and its streams."""

from vfguide.geometry.units import SECOND
from vfguide.link.codec import Encoder, Frame, Parser
from vfguide.link.enums import MavComponent, MavType
from vfguide.link.messages import (
    AttitudeQuaternion,
    AttitudeTarget,
    CurrentMode,
    ExtendedSysState,
    GlobalPositionInt,
    GpsRawInt,
    Heartbeat,
    HomePosition,
    LocalPositionNed,
    Message,
    MissionCurrent,
    SysStatus,
    SystemTime,
    VfrHud,
    WindCov,
)

ONBOARD: dict[int, float] = {
    Heartbeat.MSGID: 1.0,
    SysStatus.MSGID: 1.0,
    SystemTime.MSGID: 1.0,
    ExtendedSysState.MSGID: 1.0,
    CurrentMode.MSGID: 0.5,
    HomePosition.MSGID: 0.5,
    GpsRawInt.MSGID: 5.0,
    AttitudeTarget.MSGID: 10.0,
    GlobalPositionInt.MSGID: 10.0,
    WindCov.MSGID: 10.0,
    VfrHud.MSGID: 10.0,
    LocalPositionNed.MSGID: 30.0,
    AttitudeQuaternion.MSGID: 50.0,
}
"""Rates of the messages to a companion that come without asking [Hz]. The attitude is last:
guidance on its arrival then has all others of the same instant."""
GROUND: dict[int, float] = {
    Heartbeat.MSGID: 1.0,
    SysStatus.MSGID: 1.0,
    SystemTime.MSGID: 1.0,
    ExtendedSysState.MSGID: 1.0,
    CurrentMode.MSGID: 0.5,
    MissionCurrent.MSGID: 0.5,
    HomePosition.MSGID: 0.5,
    GpsRawInt.MSGID: 1.0,
    WindCov.MSGID: 1.0,
    VfrHud.MSGID: 4.0,
    LocalPositionNed.MSGID: 4.0,
    GlobalPositionInt.MSGID: 10.0,
    AttitudeQuaternion.MSGID: 10.0,
}
"""Rates of the messages to a ground station that come without asking [Hz]."""


class MavlinkChannel:
    """One channel. All times are dates [us since 1970]."""

    def __init__(self, sysid: int, rates: dict[int, float], now: int) -> None:
        """A channel of system `sysid` with these streams [Hz], all due at `now`."""
        self.parser = Parser()
        self.has_ground_station = False
        """PX4 sends STATUSTEXT only where a ground station was heard."""
        self.encode = Encoder(sysid, MavComponent.AUTOPILOT1).encode
        """Makes the frame of a message on this channel."""
        self._default = {msgid: round(SECOND / rate) for msgid, rate in rates.items()}
        self._interval = dict(self._default)
        self._due = dict.fromkeys(self._default, now)
        self._queue: list[tuple[int, Message]] = []

    def queue(self, at: int, message: Message) -> None:
        """Have a message sent at a time, or as soon as the streams are sent after it."""
        self._queue.append((at, message))

    def take_queue(self, now: int) -> list[Message]:
        """The queued messages whose time has come."""
        if not self._queue:
            return []
        ready = [message for at, message in self._queue if at <= now]
        self._queue = [(at, message) for at, message in self._queue if at > now]
        return ready

    def due(self, now: int) -> list[int]:
        """The messages to send now, by their ids, in the order of the table.

        What was missed is left out; the others keep their beat.
        """
        ready = [msgid for msgid, due in self._due.items() if due <= now]
        for msgid in ready:
            interval, due = self._interval[msgid], self._due[msgid]
            self._due[msgid] = due + interval * (1 + (now - due) // interval)
        return ready

    def set_interval(self, now: int, msgid: int, interval: int) -> None:
        """Change the interval of a stream [us] at a time: -1 ends it, 0 is its default."""
        interval = self._default.get(msgid, -1) if interval == 0 else interval
        if interval < 0:
            self._interval.pop(msgid, None)
            self._due.pop(msgid, None)
        elif self._interval.get(msgid) != interval:
            self._interval[msgid] = interval
            self._due[msgid] = now

    def interval(self, msgid: int) -> int:
        """The interval of a stream [us], -1 if there is none."""
        return self._interval.get(msgid, -1)

    def hear(self, frame: Frame, message: Message) -> None:
        """Note who is on this channel."""
        ground = isinstance(message, Heartbeat) and message.type == MavType.GCS
        if ground and frame.compid != MavComponent.AUTOPILOT1:
            self.has_ground_station = True
