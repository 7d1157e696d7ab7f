"""PX4 on a fixed wing: its flight modes, and the parts of a setpoint that it follows.

Sources: px4_custom_mode.h and MavlinkReceiver::handle_message_set_attitude_target of PX4 1.17.
"""

from enum import IntEnum

from vfguide.autopilots.autopilot import Autopilot, Stream
from vfguide.earth.projection import Projection
from vfguide.link.enums import AttitudeTypeMask, MavAutopilot, MavType, ModeFlag
from vfguide.link.messages import AttitudeQuaternion, LocalPositionNed, VfrHud, WindCov

SUB_MODE = 24
"""Bit at which the sub mode starts in HEARTBEAT.custom_mode (PX4's px4_custom_mode.h)."""
MAIN_MODE = 16
"""Bit at which the main mode starts in HEARTBEAT.custom_mode (PX4's px4_custom_mode.h)."""


class Px4Mode(IntEnum):
    """Flight modes of PX4: custom_mode = main << 16 | sub << 24."""

    MANUAL = 1 << MAIN_MODE
    ALTCTL = 2 << MAIN_MODE
    POSCTL = 3 << MAIN_MODE
    TAKEOFF = 4 << MAIN_MODE | 2 << SUB_MODE
    HOLD = 4 << MAIN_MODE | 3 << SUB_MODE
    MISSION = 4 << MAIN_MODE | 4 << SUB_MODE
    RETURN = 4 << MAIN_MODE | 5 << SUB_MODE
    LAND = 4 << MAIN_MODE | 6 << SUB_MODE
    ACRO = 5 << MAIN_MODE
    OFFBOARD = 6 << MAIN_MODE
    STABILIZED = 7 << MAIN_MODE


def main_and_sub(mode: int) -> tuple[int, int]:
    """The two numbers of a mode that MAV_CMD_DO_SET_MODE takes as param2 and param3."""
    return mode >> MAIN_MODE & 0xFF, mode >> SUB_MODE & 0xFF


def mode_parameters(mode: int) -> tuple[float, ...]:
    """Parameters of MAV_CMD_DO_SET_MODE: the flag of custom modes, main mode, sub mode."""
    return (ModeFlag.CUSTOM_MODE_ENABLED, *main_and_sub(mode))


PX4 = Autopilot(
    make=MavAutopilot.PX4,
    kinds=(MavType.FIXED_WING,),
    modes=Px4Mode,
    follow_mode=Px4Mode.OFFBOARD,
    hold_mode=Px4Mode.HOLD,
    mode_parameters=mode_parameters,
    loss_time=1_000_000,  # the default of COM_OF_LOSS_T
    offer=200_000,  # chosen; PX4 refuses OFFBOARD until setpoints arrive
    type_mask=int(AttitudeTypeMask.ATTITUDE_IGNORE),
    projection=Projection.AZIMUTHAL_EQUIDISTANT,
    streams=(
        Stream(LocalPositionNed.MSGID),
        Stream(VfrHud.MSGID, 10.0),
        Stream(WindCov.MSGID, 5.0),
        Stream(AttitudeQuaternion.MSGID),
    ),
)
"""PX4 follows body rates and thrust in OFFBOARD, and nothing below the companion limits them."""
