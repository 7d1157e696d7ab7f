"""The signals between the simulated aeroplane and the inner loop of its autopilot.

At every time step they cross into compiled code and back as plain tuples, since records cost
a microsecond each. `without_names` makes a tuple of a record, `Inner(*numbers)` a record of it.
"""

from typing import NamedTuple, cast


class Inner(NamedTuple):
    """The measurements of the inner loop, gusts included."""

    p: float
    """Body rate about x, roll [rad/s]."""
    q: float
    """Body rate about y, pitch [rad/s]."""
    r: float
    """Body rate about z, yaw [rad/s]."""
    alpha: float
    """Angle of attack [rad]."""
    beta: float
    """Angle of sideslip [rad]."""
    airspeed: float
    """True airspeed [m/s]."""
    density: float
    """Air density [kg/m^3]."""


InnerTuple = tuple[float, float, float, float, float, float, float]
"""`Inner`, or the same seven numbers without names."""

Surfaces = tuple[float, float, float]
"""Aileron, elevator and rudder, -1 to 1; the effect of a sign depends on the model."""

ControlTuple = tuple[float, float, float, float]
"""`Controls`, or the same four numbers without names."""


class Controls(NamedTuple):
    """Commands to servos and motor, as JSBSim takes them."""

    aileron: float = 0.0
    """Aileron, -1 to 1."""
    elevator: float = 0.0
    """Elevator, -1 to 1."""
    rudder: float = 0.0
    """Rudder, -1 to 1."""
    throttle: float = 0.0
    """Throttle, 0 to 1."""


def without_names(inner: Inner) -> InnerTuple:
    """The numbers of a record as a plain tuple."""
    return cast("InnerTuple", (*inner,))
