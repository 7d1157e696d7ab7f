"""The parameters of the software autopilot: few, those that a companion looks at."""

import struct
from dataclasses import dataclass

from vfguide.link.enums import MavParamType
from vfguide.link.messages import ParamValue

HOLD_ACTION = 1
"""Value of NAV_RCL_ACT of PX4 for a hold."""
RETURN_ACTION = 2
"""Value of NAV_RCL_ACT of PX4 for a return."""


@dataclass
class Parameter:
    """One parameter and what it may be."""

    name: str
    """Name on MAVLink, as of PX4."""
    value: float
    """Present value, in the unit that PX4 gives it."""
    low: float
    """Least value that is taken."""
    high: float
    """Largest value that is taken."""
    integer: bool
    """Whether it is an integer."""


class Parameters:
    """All parameters, in the order of their index."""

    def __init__(self) -> None:
        known = (
            Parameter("COM_OBL_RC_ACT", 5, 5, 5, integer=True),
            Parameter("COM_OF_LOSS_T", 1.0, 0.0, 60.0, integer=False),
            Parameter("MAV_TYPE", 1, 1, 1, integer=True),
            Parameter("NAV_RCL_ACT", HOLD_ACTION, HOLD_ACTION, RETURN_ACTION, integer=True),
        )
        self._all = {parameter.name: parameter for parameter in known}

    def __getitem__(self, name: str) -> float:
        return self._all[name].value

    def set(self, name: str, wire_value: float) -> ParamValue | None:
        """Take a value as PARAM_SET has it; returns PARAM_VALUE with the value that holds.

        A value out of range is not taken. None: there is no such parameter.
        """
        parameter = self._all.get(name)
        if parameter is None:
            return None
        value = from_bytes(wire_value) if parameter.integer else wire_value
        if parameter.low <= value <= parameter.high:
            parameter.value = value
        return self.describe(name)

    def names(self) -> list[str]:
        """The names in the order of their index."""
        return list(self._all)

    def describe(self, name: str) -> ParamValue:
        """PARAM_VALUE of one parameter.

        Raises:
            KeyError: there is no such parameter.
        """
        parameter = self._all[name]
        kind = MavParamType.INT32 if parameter.integer else MavParamType.REAL32
        value = to_bytes(int(parameter.value)) if parameter.integer else parameter.value
        return ParamValue(name, value, kind, len(self._all), self.names().index(name))


def to_bytes(value: int) -> float:
    """The float that has the four bytes of an integer, as PX4 sends integers.

    Raises:
        struct.error: the integer needs more than 32 bits.
    """
    return float(struct.unpack("<f", struct.pack("<i", value))[0])


def from_bytes(value: float) -> int:
    """The integer whose four bytes a float of 32 bits has."""
    return int(struct.unpack("<i", struct.pack("<f", value))[0])
