"""Setpoint limits: no value outside the aircraft's limits leaves the control loop."""

import math

from vfguide.aircraft.state import RateSetpoint
from vfguide.aircraft.vehicle import Vehicle
from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled


@compiled
def apply(setpoint: RateSetpoint, vehicle: Vehicle) -> RateSetpoint:
    """The setpoint with body rates and thrust inside their limits, always finite.

    A value that is not a number becomes zero rate, or the thrust of level flight.
    """
    aircraft = vehicle.aircraft
    return RateSetpoint(
        limit_rates(setpoint.omega_b, aircraft.rate_max),
        limited(setpoint.thrust, 0.0, 1.0, aircraft.thrust_trim),
        setpoint.q_nb,
    )


@compiled
def limit_rates(omega: Vec3, most: Vec3) -> Vec3:
    """Each rate between minus and plus its limit [rad/s]."""
    return (
        limited(omega[0], -most[0], most[0], 0.0),
        limited(omega[1], -most[1], most[1], 0.0),
        limited(omega[2], -most[2], most[2], 0.0),
    )


@compiled
def limited(value: float, low: float, high: float, otherwise: float) -> float:
    """`value` between `low` and `high`; `otherwise` if it is not a number."""
    return otherwise if math.isnan(value) else max(low, min(high, value))
