"""What is believed of the air: wind and airspeed with their uncertainty, as one array.

A Kalman filter's estimate and covariance, and what the watch over the airspeed sensor remembers.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.geometry.compiled import compiled

NORTH, EAST, AIRSPEED, YAW, SENSOR, PUSH = 0, 1, 2, 3, 4, 5
"""What is estimated: wind toward north and east [m/s], true airspeed [m/s], how much the attitude's
azimuth is too small [rad], how much the airspeed sensor tells too much [m/s], and the acceleration
along the path that the model of thrust and drag does not know of [m/s^2]."""
STATES = 6

TIME = 0
"""Of the last step [s]; negative before the first."""
X = 1
"""First of the STATES estimates."""
P = X + STATES
"""First of STATES x STATES covariances, row by row."""
THRUST = P + STATES * STATES
"""Thrust setpoint of the last step, 0 to 1."""
BEFORE = THRUST + 1
"""First of three: velocity over ground at the last step, NED [m/s]."""
SIDE = BEFORE + 3
"""Specific force to the right across the fuselage, smoothed [m/s^2]."""
MODEL = SIDE + 1
"""Airspeed that pitch and thrust alone ask for [m/s]."""
TOLD = MODEL + 1
"""What the sensor told when it last moved [m/s]."""
SAME = TOLD + 1
"""For how long it has told about that [s]."""
DOUBT = SAME + 1
"""For how long it has been implausible, negative: plausible [s]."""
TRUST = DOUBT + 1
"""1: the sensor is flown on; 0: it is not."""
RISE = TRUST + 1
"""How fast the air rises [m/s]."""
TOLD_BEFORE = RISE + 1
"""First of four: velocity over ground at the last step as it was told, NED [m/s], and the angle of
attack that it would be in air that does not rise [rad]."""
AIR_NUMBERS = TOLD_BEFORE + 4

AirState = NDArray[np.float64]
"""(AIR_NUMBERS,), the numbers at the places above."""


class AirReport(NamedTuple):
    """The estimate in names: for displays, logs and tests."""

    wind_north: float
    wind_east: float
    """Toward [m/s]."""
    wind_sigma: float
    """The larger standard deviation of the two [m/s]."""
    airspeed: float
    airspeed_sigma: float
    """True airspeed [m/s]."""
    trusts_sensor: bool
    """Whether the airspeed sensor is flown on."""


@compiled
def fresh_air() -> AirState:
    """Nothing is known of the air yet."""
    air = np.zeros(AIR_NUMBERS)
    air[TIME] = -1.0
    return air


@compiled
def sigma(air: AirState, state: int) -> float:
    """Standard deviation of one estimate."""
    return math.sqrt(max(air[P + state * (STATES + 1)], 0.0))


@compiled
def trusts_sensor(air: AirState) -> bool:
    """Whether the airspeed sensor is flown on."""
    return air[TRUST] != 0.0


@compiled
def report_air(air: AirState) -> AirReport:
    """The estimate in names."""
    return AirReport(
        air[X + NORTH],
        air[X + EAST],
        max(sigma(air, NORTH), sigma(air, EAST)),
        air[X + AIRSPEED],
        sigma(air, AIRSPEED),
        air[TRUST] != 0.0,
    )
