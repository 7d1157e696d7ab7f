"""The commands of the software autopilot: what it does on COMMAND_LONG and COMMAND_INT."""

from collections.abc import Callable

from vfguide.autopilots.px4 import MAIN_MODE, SUB_MODE, Px4Mode
from vfguide.link.enums import MavCmd, MavResult, ProtocolCapability
from vfguide.link.messages import (
    AutopilotVersion,
    AvailableModes,
    CommandInt,
    CommandLong,
    HomePosition,
    Message,
    MessageInterval,
)
from vfguide.sim.autopilot.autopilot import Autopilot
from vfguide.sim.autopilot.flight_mode import ASKED_BY, Event
from vfguide.sim.autopilot.mavlink_channel import MavlinkChannel
from vfguide.sim.autopilot.telemetry import MAKERS

CAPABILITIES = (
    ProtocolCapability.MAVLINK2
    | ProtocolCapability.SET_ATTITUDE_TARGET
    | ProtocolCapability.COMMAND_INT
    | ProtocolCapability.PARAM_ENCODE_BYTEWISE
)
"""Flags of the capabilities in AUTOPILOT_VERSION."""
FLIGHT_SW_VERSION = 1 << 24 | 17 << 16 | 255
"""Number of the PX4 release whose behaviour this is, 1.17.0 official, as in AUTOPILOT_VERSION."""

CommandReply = tuple[MavResult, list[Message]]
"""The result to acknowledge, and the messages to send after it."""


def set_mode(
    autopilot: Autopilot, _: MavlinkChannel, command: CommandLong | CommandInt
) -> CommandReply:
    """DO_SET_MODE with PX4's main and sub mode; DENIED where it cannot be asked for."""
    if not (is_number(command.param2) and is_number(command.param3)):
        return MavResult.DENIED, []
    mode = int(command.param2) << MAIN_MODE | int(command.param3) << SUB_MODE
    event = ASKED_BY.get(Px4Mode(mode)) if mode in set(Px4Mode) else None
    if event is None:
        return MavResult.DENIED, []
    return change_mode(autopilot, event), []


def change_mode(autopilot: Autopilot, event: Event) -> MavResult:
    """Change to a mode, and the result; OFFBOARD is accepted only while setpoints arrive."""
    if event is Event.OFFBOARD_ASKED and not autopilot.has_stream:
        return MavResult.TEMPORARILY_REJECTED
    autopilot.happen(event)
    return MavResult.ACCEPTED


def return_to_launch(autopilot: Autopilot, *_: object) -> CommandReply:
    """NAV_RETURN_TO_LAUNCH: fly back to where it started."""
    return change_mode(autopilot, Event.RETURN_ASKED), []


def loiter(autopilot: Autopilot, *_: object) -> CommandReply:
    """NAV_LOITER_UNLIM: hold here."""
    return change_mode(autopilot, Event.HOLD_ASKED), []


def arm_or_disarm(
    _: Autopilot, __: MavlinkChannel, command: CommandLong | CommandInt
) -> CommandReply:
    """COMPONENT_ARM_DISARM: the aircraft is armed already, and does not disarm in the air."""
    return (MavResult.ACCEPTED if command.param1 == 1.0 else MavResult.DENIED), []


def set_message_interval(
    autopilot: Autopilot, port: MavlinkChannel, command: CommandLong | CommandInt
) -> CommandReply:
    """SET_MESSAGE_INTERVAL [us] of a message that can be streamed, of others UNSUPPORTED."""
    if not (is_number(command.param1) and is_number(command.param2)):
        return MavResult.DENIED, []
    if int(command.param1) not in MAKERS:
        return MavResult.UNSUPPORTED, []
    port.set_interval(autopilot.now, int(command.param1), int(command.param2))
    return MavResult.ACCEPTED, []


def get_message_interval(
    _: Autopilot, port: MavlinkChannel, command: CommandLong | CommandInt
) -> CommandReply:
    """GET_MESSAGE_INTERVAL: MESSAGE_INTERVAL of a message that can be streamed."""
    if not is_number(command.param1) or int(command.param1) not in MAKERS:
        return MavResult.UNSUPPORTED, []
    msgid = int(command.param1)
    return MavResult.ACCEPTED, [MessageInterval(msgid, port.interval(msgid))]


def request_message(
    autopilot: Autopilot, _: MavlinkChannel, command: CommandLong | CommandInt
) -> CommandReply:
    """REQUEST_MESSAGE: the message that was asked for, UNSUPPORTED if it is none of ours."""
    wanted = int(command.param1) if is_number(command.param1) else -1
    if wanted == AutopilotVersion.MSGID:
        return MavResult.ACCEPTED, [version(autopilot)]
    if wanted == AvailableModes.MSGID:
        return MavResult.ACCEPTED, available_modes(int(command.param2))
    if wanted not in MAKERS:
        return MavResult.UNSUPPORTED, []
    return MavResult.ACCEPTED, [MAKERS[wanted](autopilot.report())]


def get_home(autopilot: Autopilot, *_: object) -> CommandReply:
    """GET_HOME_POSITION: HOME_POSITION."""
    return MavResult.ACCEPTED, [MAKERS[HomePosition.MSGID](autopilot.report())]


def request_version(autopilot: Autopilot, *_: object) -> CommandReply:
    """REQUEST_AUTOPILOT_CAPABILITIES: AUTOPILOT_VERSION."""
    return MavResult.ACCEPTED, [version(autopilot)]


COMMANDS: dict[
    int, Callable[[Autopilot, MavlinkChannel, CommandLong | CommandInt], CommandReply]
] = {
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
"""The handler of each command, by its number."""


def is_number(value: float) -> bool:
    """Whether a parameter of a command can be an integer."""
    return abs(value) < 2**31  # false for nan too


def version(autopilot: Autopilot) -> AutopilotVersion:
    """AUTOPILOT_VERSION; the unique id is the system id."""
    none = (0, 0, 0, 0, 0, 0, 0, 0)
    return AutopilotVersion(
        CAPABILITIES, FLIGHT_SW_VERSION, 0, 0, 0, none, none, none, 0, 0, autopilot.sysid
    )


def available_modes(index: int) -> list[Message]:
    """AVAILABLE_MODES of one index from 1, or of all with index 0."""
    modes = list(ASKED_BY)
    return [
        AvailableModes(len(modes), i, 0, mode, 0, mode.name.capitalize())
        for i, mode in enumerate(modes, start=1)
        if index in (0, i)
    ]
