"""Wind filter: wind and airspeed from ground velocity, attitude, thrust and airspeed sensor.

It is an extended Kalman filter on the wind triangle: ground velocity = wind + V d, where d is the
direction of flight through the air (`flight_model`). Along d, wind and airspeed are not observable
apart; they are in a turn, and between turns by the airspeed sensor, or by the model of thrust and
drag.
The sensor's bias is a state of the filter, as its scale factor is in Cho et al.

Correlated errors, of sideslip in gusts and of velocity, are modelled as white noise of equal
information.

Beard and McLain, Small Unmanned Aircraft, 2012: the wind triangle (chapter 2) and the extended
Kalman filter with one measurement at a time (chapter 8).
Cho, Kim, Lee and Kee, Wind estimation and airspeed calibration using a UAV with a single-antenna
GPS receiver and pitot tube, IEEE Transactions on Aerospace and Electronic Systems 47 (1), 2011.
"""

import math

import numpy as np

from vfguide.aircraft.flight_model import ModelledFlight
from vfguide.estimation.air_state import (
    ACCELERATION_BIAS,
    AIRSPEED,
    EAST,
    NORTH,
    SENSOR_BIAS,
    STATES,
    YAW,
    Covariance,
    StateVector,
    WindEstimate,
)
from vfguide.geometry.se2 import unrotated
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Vec3
from vfguide.geometry.velocity import azimuth_of, horizontal_norm
from vfguide.kernels.compiled import compiled

PROCESS_NOISE = (0.3, 0.3, 0.4, (0.25 * DEG) ** 2, 1e-4, 1e-4)
"""Growth of the variances of the state vector [units^2/s]; chosen: gusts change wind and airspeed,
the other entries hardly change."""
INITIAL_SIGMA = (20.0, 20.0, 2.5, 3.0 * DEG, 1.0, 0.15)
"""Standard deviations of the state vector before the first measurement [units of the entries];
chosen: the wind is so uncertain that airspeed and ground velocity determine it."""
INITIAL_TIME = 0.1
"""Time that the first ground velocity counts for [s]; chosen, since the noise is given per
second."""
ALONG_NOISE = 0.8
"""Error of the wind triangle along the direction of flight that counts as white over a second
[m/s]; chosen."""
ACROSS_NOISE = 1.3
"""Error of the wind triangle across the direction of flight that counts as white over a second
[m/s]; chosen larger, for sideslip."""
SENSOR_NOISE = 0.5
"""Error of the airspeed sensor that counts as white over SENSOR_NOISE_TIME [m/s]; chosen."""
SENSOR_NOISE_TIME = 0.1
"""Time over which the error of the airspeed sensor counts as white [s]: the interval of its
messages."""
WIND_NOISE = 1.0
"""Error of the autopilot's wind that counts as white over WIND_NOISE_TIME [m/s]; chosen."""
WIND_NOISE_TIME = 5.0
"""Time over which the error of the autopilot's wind counts as white [s]; chosen."""
LEAST_LEVEL = 0.1
"""Least horizontal part of the direction of flight, a unit vector, with which the wind triangle is
solved, as a ratio; chosen, no flight is planned so steep."""
MODEL_MEMORY = 5.0
"""Time constant with which the airspeed of the model follows the estimate [s]; chosen, so that
errors of the model do not accumulate."""

Vec6 = tuple[float, float, float, float, float, float]
"""A number for each entry of the state vector."""
Observation = Vec6
"""A row of the observation matrix: how a measurement changes with each entry of the state vector,
in its unit over theirs."""


@compiled
def first_estimate(v_n: Vec3, airspeed: float, d_n: Vec3) -> WindEstimate:
    """The estimate from one measurement of the ground velocity.

    Args:
        v_n: velocity over ground, NED [m/s].
        airspeed: a guess of the true airspeed [m/s].
        d_n: direction of flight through the air, NED, a unit vector.
    """
    x: StateVector = np.zeros(STATES)
    P: Covariance = np.zeros((STATES, STATES))
    x[NORTH] = v_n[0] - airspeed * d_n[0]
    x[EAST] = v_n[1] - airspeed * d_n[1]
    x[AIRSPEED] = airspeed
    for k in range(STATES):
        P[k, k] = INITIAL_SIGMA[k] ** 2
    first = WindEstimate(x, P)
    fuse_ground_velocity(first, v_n, d_n, INITIAL_TIME)
    return first


@compiled
def copied(estimate: WindEstimate) -> WindEstimate:
    """The estimate in arrays of its own."""
    x, P = np.empty(STATES), np.empty((STATES, STATES))
    for i in range(STATES):
        x[i] = estimate.x[i]
        for j in range(STATES):
            P[i, j] = estimate.P[i, j]
    return WindEstimate(x, P)


@compiled
def time_update(estimate: WindEstimate, flight: ModelledFlight, dt: float) -> WindEstimate:
    """The estimate `dt` [s] later: x = f(x), P = F P F^T + Q.

    F is the identity but for the row of the airspeed. The measurements of this step are fused
    into the arrays of the result, in place.
    """
    x, P = copied(estimate)
    x[AIRSPEED] += dt * (flight.acceleration + x[ACCELERATION_BIAS])
    keep = 1.0 + dt * flight.slope
    for k in range(STATES):
        P[AIRSPEED, k] = keep * P[AIRSPEED, k] + dt * P[ACCELERATION_BIAS, k]
    for k in range(STATES):
        P[k, AIRSPEED] = keep * P[k, AIRSPEED] + dt * P[k, ACCELERATION_BIAS]
    for k in range(STATES):
        P[k, k] += PROCESS_NOISE[k] * dt
    return WindEstimate(x, P)


@compiled
def measurement_update(
    estimate: WindEstimate, h: Observation, innovation: float, variance: float
) -> None:
    """Fuse one measurement into the estimate, in place: x += K innovation, P -= K h P.

    The gain is K = P h / (h P h + variance).

    Args:
        estimate: estimate of this step.
        h: the measurement's derivative with respect to the state vector.
        innovation: what was measured less what was expected, in the measurement's unit.
        variance: variance of the measurement's error, in that unit squared.
    """
    x, P, Ph = estimate.x, estimate.P, product(estimate.P, h)
    total = variance
    for k in range(STATES):
        total += h[k] * Ph[k]
    for i in range(STATES):
        x[i] += Ph[i] * innovation / total
        for j in range(STATES):
            P[i, j] -= Ph[i] * Ph[j] / total


@compiled
def product(P: Covariance, h: Observation) -> Vec6:
    """P h: the covariance of the estimates with what is measured."""
    return (
        weighted(P[0], h),
        weighted(P[1], h),
        weighted(P[2], h),
        weighted(P[3], h),
        weighted(P[4], h),
        weighted(P[5], h),
    )


@compiled
def weighted(values: StateVector, h: Observation) -> float:
    """The sum of the values, each times its weight."""
    total = 0.0
    for k in range(STATES):
        total += values[k] * h[k]
    return total


@compiled
def fuse_ground_velocity(estimate: WindEstimate, v_n: Vec3, d_n: Vec3, dt: float) -> None:
    """Wind, airspeed and azimuth from the ground velocity, along and across the flight.

    Args:
        estimate: estimate of this step, changed in place.
        v_n: velocity over ground, NED [m/s].
        d_n: direction of flight through the air, NED, by the attitude.
        dt: time since the last ground velocity [s].
    """
    x = estimate.x
    level = max(horizontal_norm(d_n), LEAST_LEVEL)
    azimuth = azimuth_of(d_n) + x[YAW]
    c, s = math.cos(azimuth), math.sin(azimuth)
    north, east = v_n[0] - x[NORTH], v_n[1] - x[EAST]
    speed = level * x[AIRSPEED]
    along, across = unrotated(north, east, c, s)
    h_across, h_along = (-s, c, 0.0, speed, 0.0, 0.0), (c, s, level, 0.0, 0.0, 0.0)
    measurement_update(estimate, h_across, across, ACROSS_NOISE * ACROSS_NOISE / dt)
    measurement_update(estimate, h_along, along - speed, ALONG_NOISE * ALONG_NOISE / dt)


@compiled
def fuse_airspeed(estimate: WindEstimate, measured: float, dt: float) -> None:
    """Airspeed and bias of its sensor from what it `measured` [m/s], `dt` [s] after the last.

    The estimate is changed in place.
    """
    h = (0.0, 0.0, 1.0, 0.0, 1.0, 0.0)
    innovation = measured - estimate.x[AIRSPEED] - estimate.x[SENSOR_BIAS]
    measurement_update(
        estimate, h, innovation, SENSOR_NOISE * SENSOR_NOISE * SENSOR_NOISE_TIME / dt
    )


@compiled
def fuse_wind(estimate: WindEstimate, wind_n: Vec3, dt: float) -> None:
    """Wind from the autopilot's own estimate, NED [m/s], `dt` [s] after the last.

    The estimate is changed in place.
    """
    variance = WIND_NOISE * WIND_NOISE * WIND_NOISE_TIME / dt
    north, east = (1.0, 0.0, 0.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0, 0.0, 0.0)
    measurement_update(estimate, north, wind_n[0] - estimate.x[NORTH], variance)
    measurement_update(estimate, east, wind_n[1] - estimate.x[EAST], variance)


@compiled
def model_airspeed(
    airspeed: float, estimate: WindEstimate, flight: ModelledFlight, dt: float
) -> float:
    """The airspeed [m/s] that pitch and thrust alone ask for, by which the sensor is judged.

    It follows the estimate with MODEL_MEMORY, so that errors of the model do not accumulate.

    Args:
        airspeed: its value at the step before [m/s].
        estimate: estimate of the step before.
        flight: flight by the model, at the airspeed of the estimate.
        dt: time since the step before [s].
    """
    expected, bias = estimate.x[AIRSPEED], estimate.x[ACCELERATION_BIAS]
    acceleration = flight.acceleration + flight.slope * (airspeed - expected) + bias
    return airspeed + dt * (acceleration + (expected - airspeed) / MODEL_MEMORY)
