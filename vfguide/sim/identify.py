"""What the software autopilot knows of its airframe, measured on the JSBSim model itself."""

from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from numpy.typing import NDArray

from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Mat3
from vfguide.sim import rate_loop
from vfguide.sim.bench import Bench
from vfguide.sim.condition import FlightCondition, Model
from vfguide.sim.inner_loop import Tables
from vfguide.sim.rate_loop import RateTable
from vfguide.sim.signals import Controls
from vfguide.sim.thrust_map import ThrustMap, thrust_map
from vfguide.sim.trim import trim

Vector = NDArray[np.float64]

_STEPS = np.array([1.0 * DEG, 1.0 * DEG, 5.0 * DEG, 5.0 * DEG, 5.0 * DEG, 0.1, 0.1, 0.1])
"""To each side, for the differences: alpha, beta, p, q, r, aileron, elevator, rudder."""
_CONDITION_MAX = 1e4
"""Condition number of the control effectiveness beyond which an axis is without control."""


class IdentifyError(Exception):
    """The surfaces of a model do not move it about all three axes."""


@dataclass(frozen=True)
class Airframe:
    """A model as its autopilot knows it."""

    rates: RateTable
    """For `rate_loop`."""
    thrust: ThrustMap
    cruise: FlightCondition
    """Level trimmed flight, about which the airframe was measured."""
    cruise_thrust: float
    """Thrust setpoint of the cruise, 0 to 1."""

    @property
    def tables(self) -> Tables:
        """For `inner_loop`."""
        return (self.rates, self.thrust.throttles, self.thrust.axes)


def identify(model: Model, airspeed: float, altitude: float = 0.0) -> Airframe:
    """Measure `model` about level flight at `airspeed` [m/s] and `altitude` [m].

    The same model, read from the same files, is measured once in a process.

    Raises:
        ModelError: the model is missing, unreadable or broken.
        TrimError: it cannot fly level so.
        IdentifyError: its surfaces do not move it about all three axes.
    """
    return _identified(model, model.fingerprint(), airspeed, altitude)


@cache
def _identified(model: Model, _: str, airspeed: float, altitude: float) -> Airframe:
    bench = Bench(model, altitude)
    cruise = trim(bench, airspeed)
    thrust = thrust_map(bench, cruise)
    cruise_thrust = bench.thrust(cruise) / thrust.full_thrust
    return Airframe(rate_table(bench, cruise), thrust, cruise, cruise_thrust)


def rate_table(bench: Bench, cruise: FlightCondition) -> RateTable:
    """The table of `rate_loop` for the model on `bench`, about `cruise`.

    Raises:
        IdentifyError: the control effectiveness is singular.
    """
    middle = _variables(cruise)
    slopes = _slopes(bench, cruise, middle)
    momentum = bench.density * cruise.airspeed
    pressure = momentum * cruise.airspeed
    static, damping, effect = slopes[:, :2] / pressure, slopes[:, 2:5] / momentum, slopes[:, 5:]
    table = np.zeros((3, rate_loop.COLUMNS))
    table[:, rate_loop.ONE] = -(slopes @ middle) / pressure
    table[:, rate_loop.ALPHA : rate_loop.P] = static
    table[:, rate_loop.P : rate_loop.PQ] = damping
    table[:, rate_loop.PQ : rate_loop.INVERSE] = _gyroscopic(bench.inertia)
    table[:, rate_loop.INVERSE :] = pressure * _inverse(effect, bench)
    return table


def _variables(condition: FlightCondition) -> Vector:
    """alpha, beta, p, q, r, aileron, elevator, rudder."""
    surfaces = condition.controls[:3]
    return np.array([condition.alpha, condition.beta, *condition.omega_b, *surfaces])


def _with_variables(condition: FlightCondition, variables: Vector) -> FlightCondition:
    alpha, beta, p, q, r, *surfaces = map(float, variables)
    controls = Controls(*surfaces, throttle=condition.controls.throttle)
    return replace(condition, alpha=alpha, beta=beta, omega_b=(p, q, r), controls=controls)


def _slopes(bench: Bench, cruise: FlightCondition, middle: Vector) -> Vector:
    """Derivatives of (p', q', r') by the eight variables, from differences of both sides; (3, 8).

    A surface near its stop is moved up to there only.
    """

    def omega_dot(variables: Vector) -> Vector:
        return bench.accelerations(_with_variables(cruise, variables))[3:]

    def slope(column: int) -> Vector:
        low, high = middle.copy(), middle.copy()
        low[column] = max(middle[column] - _STEPS[column], -1.0)
        high[column] = min(middle[column] + _STEPS[column], 1.0)
        return (omega_dot(high) - omega_dot(low)) / (high[column] - low[column])

    return np.column_stack([slope(column) for column in range(middle.size)])


def _gyroscopic(inertia_b: Mat3) -> Vector:
    """Coefficients of pq, pr, qr, p^2 - r^2 in (p', q', r') = -J^-1 (w x J w); (3, 4).

    Beard and McLain (3.17), for an airframe with a plane of symmetry.
    """
    J = np.array(inertia_b)

    def omega_dot(p: float, q: float, r: float) -> Vector:
        omega = np.array([p, q, r])
        return -np.linalg.solve(J, np.cross(omega, J @ omega))

    squares = [omega_dot(1.0, 0.0, 0.0), omega_dot(0.0, 1.0, 0.0), omega_dot(0.0, 0.0, 1.0)]
    products = [
        omega_dot(1.0, 1.0, 0.0) - squares[0] - squares[1],
        omega_dot(1.0, 0.0, 1.0) - squares[0] - squares[2],
        omega_dot(0.0, 1.0, 1.0) - squares[1] - squares[2],
    ]
    return np.column_stack([*products, squares[0]])


def _inverse(effect: Vector, bench: Bench) -> Vector:
    """Surfaces for angular accelerations, of how these answer to the surfaces."""
    if np.linalg.cond(effect) > _CONDITION_MAX:
        name = bench.model.name
        raise IdentifyError(f"{name}: its surfaces do not turn it about three axes")
    return np.asarray(np.linalg.inv(effect), dtype=np.float64)
