"""How PX4 names its flight modes on MAVLink."""

from enum import IntEnum

SUB_MODE = 24
MAIN_MODE = 16
"""Bit positions of the sub and the main mode in HEARTBEAT.custom_mode."""


class Px4Mode(IntEnum):
    """custom_mode = main << 16 | sub << 24."""

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
