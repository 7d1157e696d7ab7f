"""State of the air estimate: wind and airspeed with their uncertainty.

It has the estimate of a Kalman filter, the watch over the airspeed sensor, and the vertical wind.
"""

import math
from typing import Annotated, NamedTuple

import numpy as np

from vfguide.geometry.vector import Matrix, Vec3, Vector
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Shape

NORTH = 0
"""Index in the state vector of the wind toward north [m/s]."""
EAST = 1
"""Index in the state vector of the wind toward east [m/s]."""
AIRSPEED = 2
"""Index in the state vector of the true airspeed [m/s]."""
YAW = 3
"""Index in the state vector of the true azimuth less that of the attitude [rad]."""
SENSOR_BIAS = 4
"""Index in the state vector of the bias of the airspeed sensor, positive where it reads too high
[m/s]."""
ACCELERATION_BIAS = 5
"""Index in the state vector of the acceleration along the flight that the model of thrust and drag
lacks [m/s^2]."""
STATES = 6
"""Number of entries of the state vector."""

StateVector = Annotated[Vector, Shape(STATES)]
"""The estimates, (6,), at the indices above."""
Covariance = Annotated[Matrix, Shape(STATES, STATES)]
"""Covariance of the errors of the estimates, (6, 6)."""


class WindEstimate(NamedTuple):
    """State of the Kalman filter of the wind triangle.

    Within a step the filter works in place; the next step works on a copy.
    """

    x: StateVector
    P: Covariance


class SensorWatch(NamedTuple):
    """State of the watch over the airspeed sensor."""

    model_airspeed: float
    """True airspeed that pitch and thrust alone ask for, by which the sensor is judged [m/s]."""
    measured: float
    """Measured airspeed at its last change [m/s]."""
    stuck_time: float
    """Time since that change [s]."""
    fault_time: float
    """Time for which it has been implausible, or minus the time for which it was plausible [s]."""
    trusted: bool
    """Whether it is used."""


class VerticalWind(NamedTuple):
    """The vertical wind, and the measurements of the last step."""

    rise: float
    """Vertical wind, up positive [m/s]."""
    v_n: Vec3
    """Measured velocity over ground, NED [m/s]."""
    alpha: float
    """Angle of attack in level air [rad]."""


class AirState(NamedTuple):
    """The estimate of the air after a step."""

    time: float
    """Time of the step [s]; negative before the first."""
    estimate: WindEstimate
    """Wind, airspeed and biases."""
    v_n: Vec3
    """Velocity over ground that was used at the step, NED [m/s]."""
    side_force: float
    """Specific force to the right across the fuselage, smoothed [m/s^2]."""
    sensor: SensorWatch
    vertical: VerticalWind


class AirReport(NamedTuple):
    """The estimate by names, for displays, logs and tests."""

    wind_north: float
    """Wind blowing to the north [m/s]."""
    wind_east: float
    """Wind blowing to the east [m/s]."""
    wind_sigma: float
    """The larger standard deviation of the two [m/s]."""
    airspeed: float
    """True airspeed [m/s]."""
    airspeed_sigma: float
    """Standard deviation of the true airspeed [m/s]."""
    trusts_sensor: bool
    """Whether the airspeed sensor is used."""


@compiled
def fresh_air() -> AirState:
    """The estimate of the air before the first step."""
    zero = (0.0, 0.0, 0.0)
    estimate = WindEstimate(np.zeros(STATES), np.zeros((STATES, STATES)))
    sensor = SensorWatch(0.0, 0.0, 0.0, 0.0, False)
    return AirState(-1.0, estimate, zero, 0.0, sensor, VerticalWind(0.0, zero, 0.0))


@compiled
def sigma(variance: float) -> float:
    """Standard deviation of a variance, zero where rounding made that negative."""
    return math.sqrt(max(variance, 0.0))


@compiled
def report_air(air: AirState) -> AirReport:
    """The estimate by names."""
    x, P = air.estimate
    return AirReport(
        x[NORTH],
        x[EAST],
        max(sigma(P[NORTH, NORTH]), sigma(P[EAST, EAST])),
        x[AIRSPEED],
        sigma(P[AIRSPEED, AIRSPEED]),
        air.sensor.trusted,
    )


def without_model_error(air: AirState) -> AirState:
    """The estimate of the air without the bias of the model of thrust and drag."""
    x = air.estimate.x.copy()
    x[ACCELERATION_BIAS] = 0.0
    sensor = air.sensor._replace(model_airspeed=float(x[AIRSPEED]))
    return air._replace(estimate=air.estimate._replace(x=x), sensor=sensor)
