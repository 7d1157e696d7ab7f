"""What the software autopilot measures with: sizes of its errors, and what fails when."""

import math
from enum import Enum
from typing import NamedTuple

from vfguide.earth.pressure_altitude import PRESSURE_0
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
    """Error of the velocity on each axis [m/s]."""
    attitude: float
    """Drift of roll and of pitch [rad]."""
    attitude_bias: float
    """Constant part of roll and of pitch [rad]."""
    yaw: float
    """Drift of yaw [rad]."""
    yaw_bias: float
    """Constant part of yaw [rad]."""
    rate: float
    """White noise of a body rate from one step of the plant to the next [rad/s]."""
    rate_bias: float
    """Constant part of a body rate [rad/s]."""
    airspeed: float
    """White noise of the airspeed from one look of the autopilot to the next [m/s]."""
    airspeed_bias: float
    """Constant part of the airspeed [m/s]."""
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
    """Time after the start [s]."""
    position: Vec3
    """Jump of its estimate of the position, NED [m]."""
    origin: Vec3
    """Move of the origin of its local frame, NED [m]."""


class Instruments(NamedTuple):
    """What one autopilot measures with; the defaults are exact and never fail."""

    errors: Errors | None = None
    """Sizes of the errors; None: it knows its state exactly."""
    seed: int = 0
    """Seed of the errors of its estimate."""
    rate_seed: int = 0
    """Seed of the errors of its body rates."""
    airspeed_fails: float = math.inf
    """Time after the start at which the airspeed sensor fails [s]; 0: there is none."""
    airspeed_fault: AirspeedFault = AirspeedFault.MISSING
    """What the sensor makes the autopilot tell from then on."""
    tells_wind: bool = True
    """Whether it sends WIND_COV."""
    resets: tuple[Reset, ...] = ()
    """Jumps of what it believes, in the order of time."""
    undulation: float = 0.0
    """Height of mean sea level above the ellipsoid [m]."""
    qnh: float = PRESSURE_0
    """Pressure of the air at mean sea level, as altimeters are set [Pa]."""
    tells_pressure: bool = True
    """Whether it sends SCALED_PRESSURE to who asks for it."""


EXACT = Instruments()
"""Instruments without errors and failures."""
