"""What the software autopilot answers on MAVLink: commands, parameters, missions, time.

Every command is acknowledged to whoever sent it, if only with UNSUPPORTED: silence costs the
sender its retries.
"""

from collections.abc import Callable

from vfguide.autopilots.px4 import MAIN_MODE, SUB_MODE, Px4Mode
from vfguide.link.codec import Frame, decode
from vfguide.link.enums import MavCmd, MavComponent, MavMissionResult, MavResult, ProtocolCapability
from vfguide.link.messages import (
    AutopilotVersion,
    AvailableModes,
    CommandAck,
    CommandInt,
    CommandLong,
    HomePosition,
    Message,
    MessageInterval,
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
from vfguide.sim.autopilot.flight_mode import ASKED_BY, Event
from vfguide.sim.autopilot.mavlink_channel import MavlinkChannel
from vfguide.sim.autopilot.telemetry import MAKERS

NANOSECONDS = 1000
"""In one microsecond."""
CAPABILITIES = (
    ProtocolCapability.MAVLINK2
    | ProtocolCapability.SET_ATTITUDE_TARGET
    | ProtocolCapability.COMMAND_INT
    | ProtocolCapability.PARAM_ENCODE_BYTEWISE
)
VERSION = 1 << 24 | 17 << 16 | 255
"""The release of PX4 whose behaviour this is: 1.17.0, official."""
MODE_ACK_DELAY = 10_000
"""The second acknowledgement of a change of mode, the real one, comes this much later [us]."""
BY_NAME = -1
"""PARAM_REQUEST_READ with this index asks by name."""

Outcome = tuple[MavResult, list[Message]]


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
            return [Timesync(autopilot.now * NANOSECONDS, message.ts1)]
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


def set_mode(autopilot: Autopilot, _: MavlinkChannel, command: CommandLong | CommandInt) -> Outcome:
    """DO_SET_MODE with PX4's main and sub mode."""
    if not (is_number(command.param2) and is_number(command.param3)):
        return MavResult.DENIED, []
    mode = int(command.param2) << MAIN_MODE | int(command.param3) << SUB_MODE
    event = ASKED_BY.get(Px4Mode(mode)) if mode in set(Px4Mode) else None
    if event is None:
        return MavResult.DENIED, []
    return change_mode(autopilot, event), []


def change_mode(autopilot: Autopilot, event: Event) -> MavResult:
    """Take the mode; OFFBOARD only while setpoints arrive."""
    if event is Event.OFFBOARD_ASKED and not autopilot.has_stream:
        return MavResult.TEMPORARILY_REJECTED
    autopilot.happen(event)
    return MavResult.ACCEPTED


def return_to_launch(autopilot: Autopilot, *_: object) -> Outcome:
    """NAV_RETURN_TO_LAUNCH."""
    return change_mode(autopilot, Event.RETURN_ASKED), []


def loiter(autopilot: Autopilot, *_: object) -> Outcome:
    """NAV_LOITER_UNLIM: hold here."""
    return change_mode(autopilot, Event.HOLD_ASKED), []


def arm_or_disarm(_: Autopilot, __: MavlinkChannel, command: CommandLong | CommandInt) -> Outcome:
    """Armed it is already; in the air it does not disarm."""
    return (MavResult.ACCEPTED if command.param1 == 1.0 else MavResult.DENIED), []


def set_message_interval(
    autopilot: Autopilot, port: MavlinkChannel, command: CommandLong | CommandInt
) -> Outcome:
    """SET_MESSAGE_INTERVAL of a message that there is a stream of."""
    if not (is_number(command.param1) and is_number(command.param2)):
        return MavResult.DENIED, []
    if int(command.param1) not in MAKERS:
        return MavResult.UNSUPPORTED, []
    port.set_interval(autopilot.now, int(command.param1), int(command.param2))
    return MavResult.ACCEPTED, []


def get_message_interval(
    _: Autopilot, port: MavlinkChannel, command: CommandLong | CommandInt
) -> Outcome:
    """GET_MESSAGE_INTERVAL."""
    if not is_number(command.param1) or int(command.param1) not in MAKERS:
        return MavResult.UNSUPPORTED, []
    msgid = int(command.param1)
    return MavResult.ACCEPTED, [MessageInterval(msgid, port.interval(msgid))]


def request_message(
    autopilot: Autopilot, _: MavlinkChannel, command: CommandLong | CommandInt
) -> Outcome:
    """REQUEST_MESSAGE."""
    wanted = int(command.param1) if is_number(command.param1) else -1
    if wanted == AutopilotVersion.MSGID:
        return MavResult.ACCEPTED, [version(autopilot)]
    if wanted == AvailableModes.MSGID:
        return MavResult.ACCEPTED, available_modes(int(command.param2))
    if wanted not in MAKERS:
        return MavResult.UNSUPPORTED, []
    return MavResult.ACCEPTED, [MAKERS[wanted](autopilot.report())]


def get_home(autopilot: Autopilot, *_: object) -> Outcome:
    """GET_HOME_POSITION."""
    return MavResult.ACCEPTED, [MAKERS[HomePosition.MSGID](autopilot.report())]


def request_version(autopilot: Autopilot, *_: object) -> Outcome:
    """REQUEST_AUTOPILOT_CAPABILITIES."""
    return MavResult.ACCEPTED, [version(autopilot)]


COMMANDS: dict[int, Callable[[Autopilot, MavlinkChannel, CommandLong | CommandInt], Outcome]] = {
    MavCmd.DO_SET_MODE: set_mode,
    MavCmd.NAV_RETURN_TO_LAUNCH: return_to_launch,
    MavCmd.NAV_LOITER_UNLIM: loiter,
    MavCmd.COMPONENT_ARM_DISARM: arm_or_disarm,
    MavCmd.SET_MESSAGE_INTERVAL: set_message_interval,
    MavCmd.GET_MESSAGE_INTERVAL: get_message_interval,
    MavCmd.REQUEST_MESSAGE: request_message,
    MavCmd.GET_HOME_POSITION: get_home,
    MavCmd.REQUEST_AUTOPILOT_CAPABILITIES: request_version,
}
"""What the autopilot can be told to do."""


def is_number(value: float) -> bool:
    """Whether a parameter of a command can be an integer."""
    return abs(value) < 2**31  # false for nan too


def version(autopilot: Autopilot) -> AutopilotVersion:
    """AUTOPILOT_VERSION."""
    none = (0, 0, 0, 0, 0, 0, 0, 0)
    return AutopilotVersion(CAPABILITIES, VERSION, 0, 0, 0, none, none, none, 0, 0, autopilot.sysid)


def available_modes(index: int) -> list[Message]:
    """AVAILABLE_MODES of one index from 1, or of all with index 0."""
    modes = list(ASKED_BY)
    return [
        AvailableModes(len(modes), i, 0, mode, 0, mode.name.capitalize())
        for i, mode in enumerate(modes, start=1)
        if index in (0, i)
    ]


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
    if message.param_index == BY_NAME:
        return [parameters.describe(message.param_id)] if message.param_id in names else []
    known = 0 <= message.param_index < len(names)
    return [parameters.describe(names[message.param_index])] if known else []


def refuse_mission(frame: Frame, message: MissionCount | MissionClearAll) -> MissionAck:
    """There is nothing to clear, and no room for a mission."""
    cleared = isinstance(message, MissionClearAll)
    result = MavMissionResult.ACCEPTED if cleared else MavMissionResult.NO_SPACE
    return MissionAck(frame.sysid, frame.compid, result, message.mission_type)
