"""What an autopilot is to the companion: a record of all that differs from one make to another.

The rest of what passes between the two is common to all that speak MAVLink.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

from vfguide.geometry.projection import Projection
from vfguide.link.enums import MavAutopilot


class Stream(NamedTuple):
    """A message that the companion flies on."""

    msgid: int
    fastest: float = math.inf
    """The companion asks for no more of them in a second [Hz]."""


@dataclass(frozen=True)
class Autopilot:
    """One make of autopilot."""

    make: MavAutopilot
    """What HEARTBEAT.autopilot says."""
    modes: type[IntEnum]
    """Flight modes: the value is HEARTBEAT.custom_mode, the name is what the operator reads."""
    follow_mode: IntEnum
    """The mode in which it follows setpoints."""
    hold_mode: IntEnum
    """The mode that the companion leaves it in: it circles by itself."""
    mode_parameters: Callable[[int], tuple[float, ...]]
    """Takes a mode; returns the parameters of MAV_CMD_DO_SET_MODE that ask for it."""
    offer: int
    """Setpoints go out for this long before the companion asks for the follow mode [us]."""
    type_mask: int
    """Of SET_ATTITUDE_TARGET: what of a setpoint it has to ignore. A setpoint has body rates,
    thrust, and the attitude that the body rates lead to."""
    projection: Projection
    """Between its LOCAL_POSITION_NED and the earth."""
    streams: tuple[Stream, ...]
    """What the companion asks it to send, in the order of asking."""

    def mode_name(self, custom_mode: int | None) -> str:
        """What the operator reads of a mode; None: it is not known."""
        if custom_mode is None:
            return "nothing known"
        known = custom_mode in set(self.modes)
        return self.modes(custom_mode).name if known else f"mode {custom_mode}"
