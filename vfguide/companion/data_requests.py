"""What is asked of an autopilot besides modes: its streams, its origin, its pressure."""

from vfguide.autopilots.autopilot import Autopilot
from vfguide.companion.requests import Requests, command
from vfguide.geometry.units import SECOND
from vfguide.link.enums import MavCmd
from vfguide.link.messages import CommandAck, CommandLong, GpsGlobalOrigin, ScaledPressure

ORIGIN_RETRY = SECOND
"""Time after which the origin of the local frame is asked for again [us]; chosen."""
PRESSURE_RATE = 1.0
"""Rate at which the pressure of the air is asked for [Hz]; chosen, since weather is slow."""


def request_origin(target: int) -> CommandLong:
    """The command that makes the autopilot send the origin of its local frame.

    Not every make does so by itself.
    """
    return command(target, MavCmd.REQUEST_MESSAGE, GpsGlobalOrigin.MSGID)


def request_pressure(target: int) -> CommandLong:
    """The command that makes the autopilot send the pressure of the air."""
    interval = round(SECOND / PRESSURE_RATE)
    return command(target, MavCmd.SET_MESSAGE_INTERVAL, ScaledPressure.MSGID, interval)


def requested_streams(target: int, autopilot: Autopilot, rate: float) -> list[CommandLong]:
    """The commands that make the autopilot send the messages that guidance needs.

    `rate` is that of guidance [Hz]; MAV_CMD_SET_MESSAGE_INTERVAL takes the interval in us.
    """
    intervals = (
        (stream.msgid, round(SECOND / min(rate, stream.fastest))) for stream in autopilot.streams
    )
    return [command(target, MavCmd.SET_MESSAGE_INTERVAL, *each) for each in intervals]


class DataRequests:
    """The requests for data to the autopilot of one vehicle."""

    def __init__(self, sysid: int) -> None:
        """Nothing was asked yet of the vehicle with a MAVLink system number."""
        self._sysid = sysid
        self._requests = Requests()
        self._origin_asked = 0
        self._pressure_asked = False

    def begin(self, now: int, autopilot: Autopilot, rate: float) -> None:
        """An autopilot was found at `now` [us]: ask for its streams at the `rate` of guidance [Hz].

        What was asked before is forgotten.
        """
        self._origin_asked = now - ORIGIN_RETRY
        self._requests, self._pressure_asked = Requests(), False
        self.ask_streams(autopilot, rate)

    def ask_streams(self, autopilot: Autopilot, rate: float) -> None:
        """Ask for the streams of an autopilot at the `rate` of guidance [Hz]."""
        self._requests.ask(requested_streams(self._sysid, autopilot, rate))

    def ask_origin(self) -> None:
        """Ask for the origin of the local frame."""
        self._requests.ask([request_origin(self._sysid)])

    def ask_origin_again(self, now: int) -> None:
        """Ask for the origin at `now` [us], unless that was done within ORIGIN_RETRY."""
        if now - self._origin_asked >= ORIGIN_RETRY:
            self._origin_asked = now
            self.ask_origin()

    def ask_pressure(self) -> None:
        """Ask for the pressure of the air, once of each autopilot."""
        if not self._pressure_asked:
            self._pressure_asked = True
            self._requests.ask([request_pressure(self._sysid)])

    def due(self, now: int) -> CommandLong | None:
        """The request to send at `now` [us], if it is time for one."""
        return self._requests.due(now)

    def answer(self, ack: CommandAck) -> str | None:
        """Note an answer; returns a complaint when the autopilot refuses for good."""
        return self._requests.answer(ack)
