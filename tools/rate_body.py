"""A point-mass aeroplane that follows body rates: lift follows the angle of attack."""

import math
from typing import NamedTuple

from vfguide.aircraft.performance import Performance
from vfguide.geometry.so3 import exp, from_euler
from vfguide.geometry.units import G0
from vfguide.geometry.vector import (
    Mat3,
    Vec3,
    add,
    dot,
    matmul,
    matvec,
    scale,
    sub,
    transpose,
    unit,
)
from vfguide.kernels.compiled import compiled

BODY_LAG = 0.08
"""Time constant of the body rates behind their setpoints [s]; chosen."""
SIDE_FORCE = 18.0
"""Lateral acceleration for each radian of sideslip [m/s^2]; chosen."""

LEAST_FORWARD = 0.5
"""Least component of the air velocity along the nose, as a ratio, with which thrust keeps the
airspeed; chosen, 60 degrees: beyond it the aeroplane is stalled."""


class Body(NamedTuple):
    """An aeroplane in flight."""

    time: float
    """Time since the start [s]."""
    p_n: Vec3
    """Position, NED [m]."""
    air_n: Vec3
    """Velocity through the air, NED [m/s]."""
    R_nb: Mat3
    """Attitude, body FRD to NED."""
    omega_b: Vec3
    """Body rates, FRD [rad/s]."""


@compiled
def load_factor(body: Body, aircraft: Performance) -> float:
    """Load factor: lift over weight, dimensionless."""
    u, _, w = matvec(transpose(body.R_nb), body.air_n)
    speed_2 = body.air_n[0] ** 2 + body.air_n[1] ** 2 + body.air_n[2] ** 2
    return (math.atan2(w, u) - aircraft.alpha_zero) * speed_2 / aircraft.alpha_load


@compiled
def advance(body: Body, wanted_b: Vec3, wind_n: Vec3, aircraft: Performance, dt: float) -> Body:
    """The aeroplane `dt` [s] later; thrust along its nose keeps its airspeed.

    Args:
        body: the aeroplane before.
        wanted_b: setpoint of its body rates, FRD [rad/s].
        wind_n: wind vector, NED [m/s].
        aircraft: the performance from which its lift is taken.
        dt: time step [s].
    """
    speed = math.sqrt(body.air_n[0] ** 2 + body.air_n[1] ** 2 + body.air_n[2] ** 2)
    lag = 1.0 - math.exp(-dt / BODY_LAG)
    omega = add(body.omega_b, scale(lag, sub(wanted_b, body.omega_b)))
    R_nb = matmul(body.R_nb, exp(scale(dt, omega)))
    u, v, w = matvec(transpose(R_nb), body.air_n)
    load = (math.atan2(w, u) - aircraft.alpha_zero) * speed**2 / aircraft.alpha_load
    force = matvec(R_nb, (0.0, -SIDE_FORCE * math.asin(v / speed), -load * G0))
    force = add(force, (0.0, 0.0, G0))
    nose = (R_nb[0][0], R_nb[1][0], R_nb[2][0])
    thrust = -dot(force, body.air_n) / max(u, LEAST_FORWARD * speed)
    turned = add(body.air_n, scale(dt, add(force, scale(thrust, nose))))
    air = scale(speed, unit(turned))
    p_n = add(body.p_n, scale(dt, add(scale(0.5, add(body.air_n, air)), wind_n)))
    return Body(body.time + dt, p_n, air, R_nb, omega)


@compiled
def level(p_n: Vec3, heading: float, airspeed: float, aircraft: Performance) -> Body:
    """Level flight at a position, NED [m], and an airspeed [m/s]; the heading is in radians."""
    alpha = aircraft.alpha_zero + aircraft.alpha_load / airspeed**2
    air = (airspeed * math.cos(heading), airspeed * math.sin(heading), 0.0)
    return Body(0.0, p_n, air, from_euler(0.0, alpha, heading), (0.0, 0.0, 0.0))
