"""What passes between the simulated aeroplane and the inner loop of its autopilot.

Plain tuples: at every time step they cross into compiled code, where records cost a
microsecond each.
"""

from typing import NamedTuple

Inner = tuple[float, float, float, float, float, float, float]
"""What the inner loop measures, gusts included: body rates p, q, r [rad/s], angles of attack and
sideslip [rad], true airspeed [m/s], air density [kg/m^3]."""

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
