"""The rate loop of the software autopilot: body rates to surfaces, by inverting the airframe.

The airframe is a record of coefficients: the angular acceleration about each axis is

    rho V^2 (zero + alpha, beta terms),  rho V (p, q, r terms),  and p q, p r, q r, p^2 - r^2 terms,

plus rho V^2 times the control effectiveness, which is stored inverted, a surface for each axis.
The coefficients so do not depend on the air: static moments and controls grow with dynamic
pressure, damping with rho V, gyroscopic terms with neither.
"""

from typing import NamedTuple

from vfguide.geometry.vector import Vec3, dot, sub
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Row, reader
from vfguide.sim.signals import Inner, Surfaces


class Axis(NamedTuple):
    """Angular acceleration about one body axis with the surfaces at zero, and its surface."""

    zero: float
    """Angular acceleration at no angle and no rate, by rho V^2 [m/kg]."""
    alpha: float
    """Derivative of that by the angle of attack [m/(kg rad)]."""
    beta: float
    """Derivative of that by the angle of sideslip [m/(kg rad)]."""
    damping: Vec3
    """Derivatives of the angular acceleration by the body rates p, q, r, by rho V [m^2/kg]."""
    pq: float
    """Gyroscopic coefficient of p q [1]."""
    pr: float
    """Gyroscopic coefficient of p r [1]."""
    qr: float
    """Gyroscopic coefficient of q r [1]."""
    pp_rr: float
    """Gyroscopic coefficient of p^2 - r^2 [1]."""
    surface: Vec3
    """Its surface for an angular acceleration about x, y, z, by 1 / (rho V^2) [kg/m]."""


class Rates(NamedTuple):
    """The coefficients of all three axes."""

    roll: Axis
    """About x, with the aileron."""
    pitch: Axis
    """About y, with the elevator."""
    yaw: Axis
    """About z, with the rudder."""


RateTable = Row
"""The row of `Rates`, since an array crosses into compiled code in less time than a record."""
read_rates = reader(Rates)


class Air(NamedTuple):
    """The air flow that acts on the airframe."""

    pressure: float
    """rho V^2 [kg/(m s^2)]."""
    momentum: float
    """rho V [kg/(m^2 s)]."""
    alpha: float
    """Angle of attack [rad]."""
    beta: float
    """Angle of sideslip [rad]."""


LOWEST_AIRSPEED = 10.0
"""Least airspeed with which the gains are scheduled [m/s]; chosen, so that they stay finite."""
PROPORTIONAL: Vec3 = (12.0, 9.0, 6.0)
"""Bandwidths about the three axes [1/s]; chosen, the servos leave room for about 20."""
INTEGRAL: Vec3 = (20.0, 30.0, 8.0)
"""Gains of the integrals of the rate errors about the three axes [1/s^2]; chosen."""
INTEGRAL_MAX = 6.0
"""Largest angular acceleration that the integrals command [rad/s^2]; chosen."""


@compiled
def rate_loop(
    table: RateTable, inner: Inner, omega_b: Vec3, memory: Vec3, dt: float
) -> tuple[Surfaces, Vec3]:
    """Surfaces that bring the body rates to `omega_b`, and the memory of the next step.

    The commanded angular acceleration is proportional plus integral in the rate errors. The
    airframe is inverted for it with the static terms at the measured angles and the damping at
    the commanded rates, a feed-forward that needs no error.

    Args:
        table: the airframe, the row of `Rates`.
        inner: measurements of the loop.
        omega_b: setpoint of the body rates [rad/s].
        memory: integrals [rad/s^2], zero at first.
        dt: time step [s].
    """
    roll, pitch, yaw = read_rates(table)
    airspeed = max(inner.airspeed, LOWEST_AIRSPEED)
    pressure, momentum = inner.density * airspeed * airspeed, inner.density * airspeed
    air = Air(pressure, momentum, inner.alpha, inner.beta)
    measured_b = (inner.p, inner.q, inner.r)
    error = sub(omega_b, measured_b)
    lack = (
        PROPORTIONAL[0] * error[0] + memory[0] - _uncontrolled(roll, air, omega_b, measured_b),
        PROPORTIONAL[1] * error[1] + memory[1] - _uncontrolled(pitch, air, omega_b, measured_b),
        PROPORTIONAL[2] * error[2] + memory[2] - _uncontrolled(yaw, air, omega_b, measured_b),
    )
    aileron = dot(roll.surface, lack) / pressure
    elevator = dot(pitch.surface, lack) / pressure
    rudder = dot(yaw.surface, lack) / pressure
    growth = (
        _growth(INTEGRAL[0] * error[0], aileron, roll.surface[0]),
        _growth(INTEGRAL[1] * error[1], elevator, pitch.surface[1]),
        _growth(INTEGRAL[2] * error[2], rudder, yaw.surface[2]),
    )
    memory = (
        _clip(memory[0] + growth[0] * dt, INTEGRAL_MAX),
        _clip(memory[1] + growth[1] * dt, INTEGRAL_MAX),
        _clip(memory[2] + growth[2] * dt, INTEGRAL_MAX),
    )
    return (_clip(aileron, 1.0), _clip(elevator, 1.0), _clip(rudder, 1.0)), memory


@compiled
def _uncontrolled(axis: Axis, air: Air, damped_b: Vec3, omega_b: Vec3) -> float:
    """Angular acceleration about an axis with the surfaces at zero [rad/s^2].

    The damping is that of the body rates `damped_b`, the rest of `omega_b` [rad/s].
    """
    p, q, r = omega_b
    static = axis.zero + axis.alpha * air.alpha + axis.beta * air.beta
    damping = dot(axis.damping, damped_b)
    gyroscopic = axis.pq * p * q + axis.pr * p * r + axis.qr * q * r
    gyroscopic += axis.pp_rr * (p * p - r * r)
    return air.pressure * static + air.momentum * damping + gyroscopic


@compiled
def _growth(growth: float, surface: float, effect: float) -> float:
    """Growth of an integral; zero while the surface is at its stop and would move beyond it."""
    if abs(surface) > 1.0 and growth * effect * surface > 0.0:
        return 0.0
    return growth


@compiled
def _clip(value: float, limit: float) -> float:
    return min(max(value, -limit), limit)
