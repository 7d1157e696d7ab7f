"""What the software autopilot measures with: sizes of its errors, and what fails when."""

import math
from enum import Enum
from typing import NamedTuple

from vfguide.geometry.vector import Vec3


class Errors(NamedTuple):
    """Standard deviations of what an autopilot reports, SI units and radians."""

    position: float
    """Drift of the horizontal position on each axis [m]."""
    height: float
    """Drift of the height [m]."""
    drift: float
    """Time constant of both drifts [s]."""
    velocity: float
    """On each axis [m/s]."""
    attitude: float
    """Drift of roll and of pitch [rad]."""
    attitude_bias: float
    """Constant part of roll and of pitch [rad]."""
    yaw: float
    yaw_bias: float
    """The same of yaw [rad]."""
    rate: float
    """White noise of a body rate from one step of the plant to the next [rad/s]."""
    rate_bias: float
    """Constant part of a body rate [rad/s]."""
    airspeed: float
    """White noise from one look of the autopilot to the next [m/s]."""
    airspeed_bias: float
    """Constant part [m/s]."""
    wind: float
    """Drift of the wind estimate on each axis [m/s]."""


class AirspeedFault(Enum):
    """What an airspeed sensor that has failed makes the autopilot tell."""

    MISSING = "missing"
    """Not a number, as PX4 does without a sensor that it trusts."""
    FROZEN = "frozen"
    """The last value for ever."""
    BLOCKED = "blocked"
    """Zero: nothing presses on the tube."""


class Reset(NamedTuple):
    """A jump of what the autopilot believes."""

    time: float
    """[s] after the start."""
    position: Vec3
    """By which its estimate of the position jumps, NED [m]."""
    origin: Vec3
    """By which the origin of its local frame moves, NED [m]."""


class Instruments(NamedTuple):
    """What one autopilot measures with; the defaults are exact and never fail."""

    errors: Errors | None = None
    """None: it knows its state exactly."""
    seed: int = 0
    """Of the errors of its estimate."""
    rate_seed: int = 0
    """Of the errors of its body rates."""
    airspeed_fails: float = math.inf
    """When the airspeed sensor fails [s]; 0: there is none."""
    airspeed_fault: AirspeedFault = AirspeedFault.MISSING
    tells_wind: bool = True
    """Whether it sends WIND_COV."""
    resets: tuple[Reset, ...] = ()
    """In the order of time."""


EXACT = Instruments()
"""Instruments without errors and failures."""
