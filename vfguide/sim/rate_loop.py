"""The rate loop of the software autopilot: body rates to surfaces, by inverting the airframe.

What the loop knows of the airframe is a table, three rows (p', q', r') by the columns named
below: the angular accelerations are its product with

    rho V^2 (1, alpha, beta),  rho V (p, q, r),  (p q, p r, q r, p^2 - r^2),

plus rho V^2 times the control effectiveness, of which the last three columns are the inverse.
So every term keeps its size in units of the air: static moments and controls grow with
dynamic pressure, damping with rho V, gyroscopic terms with neither.
"""

import numpy as np
from numpy.typing import NDArray

from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3
from vfguide.sim.signals import Inner, Surfaces

ONE, ALPHA, BETA = 0, 1, 2
P, Q, R = 3, 4, 5
PQ, PR, QR, PP_RR = 6, 7, 8, 9
INVERSE = 10
"""First of three columns: surfaces per angular acceleration, times rho V^2."""
COLUMNS = 13

RateTable = NDArray[np.float64]
"""Shape (3, COLUMNS)."""

LOWEST_AIRSPEED = 10.0
"""Below it the loop takes this, so that its gains stay finite [m/s]."""
PROPORTIONAL: Vec3 = (12.0, 9.0, 6.0)
"""Bandwidths about the three axes [1/s]; the servos leave room for about 20."""
INTEGRAL: Vec3 = (20.0, 30.0, 8.0)
"""[1/s^2]"""
INTEGRAL_MAX = 6.0
"""Largest angular acceleration the integrals may ask for [rad/s^2]."""


@compiled
def rate_loop(
    table: RateTable, inner: Inner, omega_b: Vec3, memory: Vec3, dt: float
) -> tuple[Surfaces, Vec3]:
    """Surfaces that bring the body rates to `omega_b`, and the memory of the next step.

    The angular acceleration wished for is proportional plus integral in the rate errors. The
    airframe is inverted for it with the static terms at the measured angles and the damping at
    the rates wished for, which need not wait for an error.

    Args:
        table: the airframe, see above.
        inner: what the loop measures.
        omega_b: setpoint of the body rates [rad/s].
        memory: integrals [rad/s^2], zero at first.
        dt: time step [s].
    """
    p, q, r, alpha, beta, airspeed, density = inner
    airspeed = max(airspeed, LOWEST_AIRSPEED)
    air = (density * airspeed * airspeed, density * airspeed, alpha, beta)
    error = (omega_b[0] - p, omega_b[1] - q, omega_b[2] - r)
    lack = (
        PROPORTIONAL[0] * error[0] + memory[0] - _uncontrolled(table, 0, air, omega_b, (p, q, r)),
        PROPORTIONAL[1] * error[1] + memory[1] - _uncontrolled(table, 1, air, omega_b, (p, q, r)),
        PROPORTIONAL[2] * error[2] + memory[2] - _uncontrolled(table, 2, air, omega_b, (p, q, r)),
    )
    aileron = _surface(table, 0, air[0], lack)
    elevator = _surface(table, 1, air[0], lack)
    rudder = _surface(table, 2, air[0], lack)
    growth = (
        _growth(INTEGRAL[0] * error[0], aileron, table[0, INVERSE]),
        _growth(INTEGRAL[1] * error[1], elevator, table[1, INVERSE + 1]),
        _growth(INTEGRAL[2] * error[2], rudder, table[2, INVERSE + 2]),
    )
    memory = (
        _clip(memory[0] + growth[0] * dt, INTEGRAL_MAX),
        _clip(memory[1] + growth[1] * dt, INTEGRAL_MAX),
        _clip(memory[2] + growth[2] * dt, INTEGRAL_MAX),
    )
    return (_clip(aileron, 1.0), _clip(elevator, 1.0), _clip(rudder, 1.0)), memory


@compiled
def _uncontrolled(
    table: RateTable,
    axis: int,
    air: tuple[float, float, float, float],
    damped_b: Vec3,
    omega_b: Vec3,
) -> float:
    """Angular acceleration about `axis` with the surfaces at zero [rad/s^2]."""
    row = table[axis]
    pressure, momentum, alpha, beta = air
    p, q, r = omega_b
    static = row[ONE] + row[ALPHA] * alpha + row[BETA] * beta
    damping = row[P] * damped_b[0] + row[Q] * damped_b[1] + row[R] * damped_b[2]
    gyroscopic = row[PQ] * p * q + row[PR] * p * r + row[QR] * q * r
    gyroscopic += row[PP_RR] * (p * p - r * r)
    return pressure * static + momentum * damping + gyroscopic


@compiled
def _surface(table: RateTable, axis: int, pressure: float, lack: Vec3) -> float:
    """Surface of `axis` that makes up for the lacking angular accelerations, unlimited."""
    row = table[axis]
    sum_ = row[INVERSE] * lack[0] + row[INVERSE + 1] * lack[1] + row[INVERSE + 2] * lack[2]
    return sum_ / pressure


@compiled
def _growth(growth: float, surface: float, effect: float) -> float:
    """Growth of an integral; none while the surface is at its stop and would only go further."""
    if abs(surface) > 1.0 and growth * effect * surface > 0.0:
        return 0.0
    return growth


@compiled
def _clip(value: float, limit: float) -> float:
    return min(max(value, -limit), limit)
