"""An autopilot as the companion knows it: a record of all that differs from one make to another.

All other messages between the two are the same for every autopilot that speaks MAVLink.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

from vfguide.earth.projection import Projection
from vfguide.link.enums import MavAutopilot, MavType


class Stream(NamedTuple):
    """A message that guidance needs."""

    msgid: int
    """Its id."""
    fastest: float = math.inf
    """Largest rate that the companion asks for [Hz]."""


@dataclass(frozen=True)
class Autopilot:
    """One make of autopilot."""

    make: MavAutopilot
    """The make, as in HEARTBEAT.autopilot."""
    kinds: tuple[MavType, ...]
    """Kinds of vehicles that it is this record for, as in HEARTBEAT.type."""
    modes: type[IntEnum]
    """Flight modes: the value is HEARTBEAT.custom_mode, the name is what the operator reads."""
    follow_mode: IntEnum
    """The mode in which the autopilot follows setpoints."""
    hold_mode: IntEnum
    """The mode in which the companion leaves the autopilot: it circles by itself."""
    mode_parameters: Callable[[int], tuple[float, ...]]
    """Parameters of MAV_CMD_DO_SET_MODE that ask for a mode; the argument is the mode."""
    loss_time: int
    """Time without a setpoint after which it flies by its own failsafe [us], unless its parameters
    say else."""
    offer: int
    """Time for which setpoints are sent before the companion asks for the follow mode [us]."""
    type_mask: int
    """Type mask of SET_ATTITUDE_TARGET: flags of the parts of a setpoint that are ignored. A
    setpoint has body rates, thrust, and the attitude to which the body rates lead."""
    projection: Projection
    """Projection of the earth in which its LOCAL_POSITION_NED is."""
    streams: tuple[Stream, ...]
    """Messages that the companion asks for, in the order of asking."""

    def mode_name(self, custom_mode: int) -> str:
        """The name of a mode in notes to the operator."""
        known = custom_mode in set(self.modes)
        return self.modes(custom_mode).name if known else f"mode {custom_mode}"
