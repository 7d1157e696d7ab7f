"""What is believed of the air from one step to the next: wind and airspeed with their uncertainty.

The estimate of a Kalman filter, the watch over the airspeed sensor, and the vertical wind; each
with what it needs to remember of the step before.
"""

import math
from typing import Annotated, NamedTuple

import numpy as np

from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import Shape
from vfguide.geometry.vector import Matrix, Vec3, Vector

NORTH = 0
"""Place in the state vector of the wind toward north [m/s]."""
EAST = 1
"""Place in the state vector of the wind toward east [m/s]."""
AIRSPEED = 2
"""Place in the state vector of the true airspeed [m/s]."""
YAW = 3
"""Place in the state vector of how much the attitude's azimuth is too small [rad]."""
SENSOR_BIAS = 4
"""Place in the state vector of how much the airspeed sensor reads too high [m/s]."""
ACCELERATION_BIAS = 5
"""Place in the state vector of the acceleration along the flight that the model of thrust and drag
does not know of [m/s^2]."""
STATES = 6
"""Length of the state vector."""

StateVector = Annotated[Vector, Shape(STATES)]
"""The estimates, (6,), at the places above."""
Covariance = Annotated[Matrix, Shape(STATES, STATES)]
"""Of their errors, (6, 6)."""


class WindEstimate(NamedTuple):
    """State of the Kalman filter of the wind triangle.

    Within a step the filter works in place; what a step leaves is not changed by the next one.
    """

    x: StateVector
    P: Covariance


class SensorWatch(NamedTuple):
    """How good the airspeed sensor is."""

    model_airspeed: float
    """True airspeed that pitch and thrust alone ask for: what the sensor is judged by [m/s]."""
    measured: float
    """What the sensor read when it last moved [m/s]."""
    stuck_time: float
    """For how long it has read about that [s]."""
    fault_time: float
    """For how long it has been implausible; negative: plausible [s]."""
    trusted: bool
    """Whether it is flown on."""


class VerticalWind(NamedTuple):
    """The vertical wind, and the measurements of the last step."""

    rise: float
    """How fast the air rises [m/s]."""
    v_n: Vec3
    """Measured velocity over ground, NED [m/s]."""
    alpha: float
    """The angle of attack that it would be in air that does not rise [rad]."""


class AirState(NamedTuple):
    """What is believed of the air after a step."""

    time: float
    """Of the step [s]; negative before the first."""
    estimate: WindEstimate
    """Wind, airspeed and what makes them uncertain."""
    v_n: Vec3
    """Velocity over ground that was flown on at the step, NED [m/s]."""
    side_force: float
    """Specific force to the right across the fuselage, smoothed [m/s^2]."""
    sensor: SensorWatch
    vertical: VerticalWind


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
    zero = (0.0, 0.0, 0.0)
    estimate = WindEstimate(np.zeros(STATES), np.zeros((STATES, STATES)))
    sensor = SensorWatch(0.0, 0.0, 0.0, 0.0, False)
    return AirState(-1.0, estimate, zero, 0.0, sensor, VerticalWind(0.0, zero, 0.0))


@compiled
def sigma(estimate: WindEstimate, state: int) -> float:
    """Standard deviation of the estimate at one place of the state vector."""
    return math.sqrt(max(estimate.P[state, state], 0.0))


@compiled
def report_air(air: AirState) -> AirReport:
    """The estimate in names."""
    estimate = air.estimate
    return AirReport(
        estimate.x[NORTH],
        estimate.x[EAST],
        max(sigma(estimate, NORTH), sigma(estimate, EAST)),
        estimate.x[AIRSPEED],
        sigma(estimate, AIRSPEED),
        air.sensor.trusted,
    )


def without_model_error(air: AirState) -> AirState:
    """What is believed of the air by an aircraft of which no error is known yet."""
    x = air.estimate.x.copy()
    x[ACCELERATION_BIAS] = 0.0
    sensor = air.sensor._replace(model_airspeed=float(x[AIRSPEED]))
    return air._replace(estimate=air.estimate._replace(x=x), sensor=sensor)
