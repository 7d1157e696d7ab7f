"""What the software autopilot answers on MAVLink: commands, parameters, missions, time.

Every command is acknowledged to whoever sent it, if only with UNSUPPORTED: silence costs the
sender its retries.
"""

from vfguide.geometry.units import NS_PER_US
from vfguide.link.codec import Frame, decode
from vfguide.link.enums import MavCmd, MavComponent, MavMissionResult, MavResult
from vfguide.link.messages import (
    CommandAck,
    CommandInt,
    CommandLong,
    Message,
    MissionAck,
    MissionClearAll,
    MissionCount,
    MissionRequestList,
    ParamRequestList,
    ParamRequestRead,
    ParamSet,
    Ping,
    SetAttitudeTarget,
    Timesync,
)
from vfguide.sim.autopilot.autopilot import Autopilot
from vfguide.sim.autopilot.commands import COMMANDS
from vfguide.sim.autopilot.mavlink_channel import MavlinkChannel

MODE_ACK_DELAY = 10_000
"""Time after which a change of mode is acknowledged for the second time, with the real result [us];
chosen, as PX4 does."""
INDEX_BY_NAME = -1
"""Index of a PARAM_REQUEST_READ that asks for a parameter by its name."""


def receive(autopilot: Autopilot, port: MavlinkChannel, data: bytes) -> list[bytes]:
    """Takes a datagram that arrived on a port; returns the frames that answer it at once."""
    out: list[Message] = []
    for frame in port.parser.feed(data, whole=True):
        message = decode(frame)
        if message is not None and is_addressed(message, autopilot.sysid):
            port.hear(frame, message)
            out += answer(autopilot, port, frame, message)
    return [port.encode(message) for message in out]


def is_addressed(message: Message, sysid: int) -> bool:
    """Whether a message is for this autopilot or for all."""
    if isinstance(message, SetAttitudeTarget):
        return message.target_system in (0, sysid) and message.target_component in (0, 1)
    system = getattr(message, "target_system", 0)
    component = getattr(message, "target_component", 0)
    return system in (0, sysid) and component in (MavComponent.ALL, MavComponent.AUTOPILOT1)


def answer(  # noqa: PLR0911
    autopilot: Autopilot, port: MavlinkChannel, frame: Frame, message: Message
) -> list[Message]:
    """What to send back for one message."""
    match message:
        case SetAttitudeTarget():
            autopilot.take_setpoint(message)
            return []
        case CommandLong() | CommandInt():
            return answer_command(autopilot, port, frame, message)
        case ParamRequestList() | ParamRequestRead() | ParamSet():
            return answer_parameter(autopilot, message)
        case MissionRequestList():
            return [MissionCount(frame.sysid, frame.compid, 0, message.mission_type)]
        case MissionCount() | MissionClearAll():
            return [refuse_mission(frame, message)]
        case Timesync(tc1=0):
            return [Timesync(autopilot.now * NS_PER_US, message.ts1)]
        case Ping(target_system=0):
            return [message._replace(target_system=frame.sysid, target_component=frame.compid)]
        case _:
            return []


def answer_command(
    autopilot: Autopilot, port: MavlinkChannel, frame: Frame, command: CommandLong | CommandInt
) -> list[Message]:
    """Carry out a command and acknowledge it; a change of mode is acknowledged twice."""

    def ack(result: MavResult) -> CommandAck:
        return CommandAck(command.command, result, 0, 0, frame.sysid, frame.compid)

    perform = COMMANDS.get(command.command)
    result, messages = perform(autopilot, port, command) if perform else (MavResult.UNSUPPORTED, [])
    if command.command == MavCmd.DO_SET_MODE:
        port.queue(autopilot.now + MODE_ACK_DELAY, ack(result))
        return [ack(MavResult.ACCEPTED)]
    return [ack(result), *messages]


def answer_parameter(
    autopilot: Autopilot, message: ParamRequestList | ParamRequestRead | ParamSet
) -> list[Message]:
    """PARAM_VALUE of what was asked for, or set."""
    parameters = autopilot.parameters
    if isinstance(message, ParamRequestList):
        return [parameters.describe(name) for name in parameters.names()]
    if isinstance(message, ParamSet):
        echo = parameters.set(message.param_id, message.param_value)
        return [echo] if echo else []
    names = parameters.names()
    if message.param_index == INDEX_BY_NAME:
        return [parameters.describe(message.param_id)] if message.param_id in names else []
    known = 0 <= message.param_index < len(names)
    return [parameters.describe(names[message.param_index])] if known else []


def refuse_mission(frame: Frame, message: MissionCount | MissionClearAll) -> MissionAck:
    """There is nothing to clear, and no room for a mission."""
    cleared = isinstance(message, MissionClearAll)
    result = MavMissionResult.ACCEPTED if cleared else MavMissionResult.NO_SPACE
    return MissionAck(frame.sysid, frame.compid, result, message.mission_type)
