"""What passes between the simulated aeroplane and the inner loop of its autopilot.

At every time step these cross into compiled code and back as plain tuples, since records cost
a microsecond each. `without_names` takes the names off, `Inner(*numbers)` puts them on again.
"""

from typing import NamedTuple, cast


class Inner(NamedTuple):
    """What the inner loop measures, gusts included."""

    p: float
    q: float
    r: float
    """Body rates [rad/s]."""
    alpha: float
    beta: float
    """Angles of attack and sideslip [rad]."""
    airspeed: float
    """True airspeed [m/s]."""
    density: float
    """Air density [kg/m^3]."""


InnerTuple = tuple[float, float, float, float, float, float, float]
"""`Inner`, or the same seven numbers without names."""

Surfaces = tuple[float, float, float]
"""Aileron, elevator, rudder, -1 to 1; what a sign does is the model's own affair."""

ControlTuple = tuple[float, float, float, float]
"""`Controls`, or the same four numbers without names."""


class Controls(NamedTuple):
    """Commands to servos and motor, as JSBSim takes them."""

    aileron: float = 0.0
    elevator: float = 0.0
    rudder: float = 0.0
    """Surfaces, -1 to 1."""
    throttle: float = 0.0
    """0 to 1."""


def without_names(inner: Inner) -> InnerTuple:
    """The same numbers as a plain tuple."""
    return cast("InnerTuple", (*inner,))
