"""The airframe as the software autopilot knows it, measured on the JSBSim model itself."""

from dataclasses import dataclass, replace
from functools import cache
from typing import NamedTuple

import numpy as np

from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Mat3, Matrix, Vec3, Vector
from vfguide.kernels.rows import place, python_reader, row_of, width
from vfguide.sim.bench import Bench
from vfguide.sim.condition import FlightCondition, Model
from vfguide.sim.inner_loop.inner_loop import Tables
from vfguide.sim.inner_loop.rate_loop import Axis, RateTable
from vfguide.sim.inner_loop.thrust_map import ThrustMap, thrust_map
from vfguide.sim.signals import Controls
from vfguide.sim.trim import trim


class Variables(NamedTuple):
    """The variables on which the accelerations of an airframe in given air depend."""

    alpha: float
    """Angle of attack [rad]."""
    beta: float
    """Angle of sideslip [rad]."""
    omega_b: Vec3
    """Body rates [rad/s]."""
    surfaces: Vec3
    """Aileron, elevator, rudder, -1 to 1."""


_variables_of = python_reader(Variables)
_STEPS = row_of(Variables(1.0 * DEG, 1.0 * DEG, (5.0 * DEG, 5.0 * DEG, 5.0 * DEG), (0.1, 0.1, 0.1)))
"""Steps to each side for the differences."""
_CONDITION_MAX = 1e4
"""Condition number of the control effectiveness beyond which an axis is without control."""


class AirframeModelError(Exception):
    """The surfaces of a model do not move it about all three axes."""


@dataclass(frozen=True)
class Airframe:
    """A model as its autopilot knows it: measured tables, no coefficients of JSBSim."""

    rates: RateTable
    """The table of `rate_loop`."""
    thrust: ThrustMap
    """The table of `throttle_for`."""
    cruise: FlightCondition
    """Level trimmed flight, about which the airframe was measured."""
    cruise_thrust: float
    """Thrust setpoint of the cruise, 0 to 1."""

    @property
    def tables(self) -> Tables:
        """The tables of `inner_loop`."""
        return (self.rates, self.thrust.throttles, self.thrust.axes.numbers)


def identify(model: Model, airspeed: float, altitude: float = 0.0) -> Airframe:
    """Measure `model` about level flight at `airspeed` [m/s] and `altitude` [m].

    The same model, read from the same files, is measured once in a process.

    Raises:
        ModelError: the model is missing, unreadable or broken.
        TrimError: it cannot fly level so.
        AirframeModelError: its surfaces do not move it about all three axes.
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
        AirframeModelError: the control effectiveness is singular.
    """
    slopes = _slopes(bench, cruise, _variables(cruise))
    momentum = bench.density * cruise.airspeed
    pressure = momentum * cruise.airspeed
    effect = slopes[:, place(Variables, "surfaces")]
    parts = {
        "zero": -(slopes @ _variables(cruise)) / pressure,
        "alpha": slopes[:, place(Variables, "alpha")] / pressure,
        "beta": slopes[:, place(Variables, "beta")] / pressure,
        "damping": slopes[:, place(Variables, "omega_b")] / momentum,
        "surface": pressure * _inverse(effect, bench),
        **_gyroscopic(bench.inertia),
    }
    table = np.zeros((3, width(Axis)))
    for name, part in parts.items():
        table[:, place(Axis, name)] = part.reshape(3, -1)
    return table.ravel()


def _variables(condition: FlightCondition) -> Vector:
    """The row of `Variables` of a flight condition."""
    aileron, elevator, rudder, _ = condition.controls
    surfaces = (aileron, elevator, rudder)
    return row_of(Variables(condition.alpha, condition.beta, condition.omega_b, surfaces))


def _with_variables(condition: FlightCondition, row: Vector) -> FlightCondition:
    """A flight condition with the row of other `Variables`."""
    alpha, beta, omega_b, surfaces = _variables_of(row.tolist())
    controls = Controls(*surfaces, throttle=condition.controls.throttle)
    return replace(condition, alpha=alpha, beta=beta, omega_b=omega_b, controls=controls)


def _slopes(bench: Bench, cruise: FlightCondition, middle: Vector) -> Matrix:
    """Derivatives of (p', q', r') by the variables, (3, width), from central differences.

    A surface near its stop is moved up to the stop only.
    """

    def omega_dot(variables: Vector) -> Vector:
        return np.array(bench.accelerations(_with_variables(cruise, variables)).omega_dot_b)

    def slope(column: int) -> Vector:
        low, high = middle.copy(), middle.copy()
        low[column] = max(middle[column] - _STEPS[column], -1.0)
        high[column] = min(middle[column] + _STEPS[column], 1.0)
        return (omega_dot(high) - omega_dot(low)) / (high[column] - low[column])

    return np.column_stack([slope(column) for column in range(middle.size)])


def _gyroscopic(inertia_b: Mat3) -> dict[str, Vector]:
    """Coefficients of pq, pr, qr, p^2 - r^2 in (p', q', r') = -J^-1 (w x J w), (3,) each.

    The keys are fields of `Axis`. The equation is Beard and McLain's (3.17), for an airframe with a
    plane of symmetry.
    """
    J = np.array(inertia_b)

    def omega_dot(p: float, q: float, r: float) -> Vector:
        omega = np.array([p, q, r])
        return -np.linalg.solve(J, np.cross(omega, J @ omega))

    pp, qq, rr = omega_dot(1.0, 0.0, 0.0), omega_dot(0.0, 1.0, 0.0), omega_dot(0.0, 0.0, 1.0)
    return {
        "pq": omega_dot(1.0, 1.0, 0.0) - pp - qq,
        "pr": omega_dot(1.0, 0.0, 1.0) - pp - rr,
        "qr": omega_dot(0.0, 1.0, 1.0) - qq - rr,
        "pp_rr": pp,
    }


def _inverse(effect: Matrix, bench: Bench) -> Matrix:
    """Inverse of the control effectiveness: surfaces for angular accelerations, (3, 3)."""
    if np.linalg.cond(effect) > _CONDITION_MAX:
        name = bench.model.name
        raise AirframeModelError(f"{name}: its surfaces do not turn it about three axes")
    return np.asarray(np.linalg.inv(effect), dtype=np.float64)
