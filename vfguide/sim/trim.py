"""Trim: the steady straight flight of a JSBSim model, by least squares on its accelerations."""

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np
from scipy.optimize import least_squares

from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Matrix, Vector
from vfguide.kernels.rows import row_of, table_of
from vfguide.sim.bench import Bench
from vfguide.sim.condition import FlightCondition
from vfguide.sim.readings import Accelerations
from vfguide.sim.signals import Controls


class Unknowns(NamedTuple):
    """The unknowns of a trim."""

    alpha: float
    """Angle of attack [rad]."""
    bank: float
    """Roll angle [rad]."""
    aileron: float
    """Aileron, -1 to 1."""
    elevator: float
    """Elevator, -1 to 1."""
    rudder: float
    """Rudder, -1 to 1."""
    throttle: float
    """Throttle, 0 to 1."""


_WEIGHTS = np.ravel(Accelerations((1.0, 1.0, 1.0), (5.0, 5.0, 5.0)))
"""By these, 1 m/s^2 and 0.2 rad/s^2 count alike."""
_RESIDUAL_MAX = 1e-4
"""Largest weighted acceleration that still is a trim: 1e-5 g."""
_GUESSES = table_of(
    Unknowns,
    [
        Unknowns(3.0 * DEG, 0.0, 0.0, 0.0, 0.0, throttle=0.5),
        Unknowns(0.0, 0.0, 0.0, 0.0, 0.0, throttle=0.8),
        Unknowns(8.0 * DEG, 0.0, 0.0, elevator=-0.2, rudder=0.0, throttle=0.7),
    ],
)
"""Tried one after the other: middle, fast and slow flight."""
_LOWEST = row_of(Unknowns(-20.0 * DEG, -30.0 * DEG, -1.0, -1.0, -1.0, 0.0))
_HIGHEST = row_of(Unknowns(30.0 * DEG, 30.0 * DEG, 1.0, 1.0, 1.0, 1.0))
_SCALE = row_of(Unknowns(0.05, 0.02, 0.05, 0.1, 0.05, 0.2))
_STEPS = 1e-3 * _SCALE
"""Of the differences: JSBSim's rounding errors drown the answers to much smaller ones."""
_MOST_STEPS = 40
"""A trim takes ten; one that is not there would take hundreds."""


class TrimError(Exception):
    """The aeroplane cannot fly steadily as asked."""


def trim(bench: Bench, airspeed: float, climb: float = 0.0) -> FlightCondition:
    """Steady straight flight without sideslip, of no acceleration at all.

    Args:
        bench: the model at the altitude of the flight.
        airspeed: true airspeed [m/s].
        climb: angle of the path above the horizon [rad].

    Raises:
        TrimError: thrust or surfaces do not suffice.
    """

    def residual(unknowns: Vector) -> Vector:
        condition = _condition(airspeed, climb, unknowns)
        return _WEIGHTS * np.ravel(bench.accelerations(condition))

    worst = np.inf
    for guess in _GUESSES:
        unknowns, remaining = _solve(residual, guess)
        if remaining < _RESIDUAL_MAX:
            return _condition(airspeed, climb, unknowns)
        worst = min(worst, remaining)
    raise TrimError(
        f"{bench.model.name}: no steady flight at {airspeed:.1f} m/s, climbing "
        f"{climb / DEG:.1f} deg; at best {worst:.2g} m/s^2 remain"
    )


def _solve(residual: Callable[[Vector], Vector], guess: Vector) -> tuple[Vector, float]:
    """The unknowns of least residual from one guess, and the largest of the six that remains."""
    solution = least_squares(
        residual,
        guess,
        partial(_slopes, residual),  # pyright: ignore[reportArgumentType], scipy takes functions
        bounds=(_LOWEST, _HIGHEST),
        x_scale=_SCALE,
        xtol=1e-12,
        ftol=1e-14,
        gtol=1e-14,
        max_nfev=_MOST_STEPS,
    )
    return solution.x, float(np.max(np.abs(solution.fun)))


def _slopes(residual: Callable[[Vector], Vector], unknowns: Vector) -> Matrix:
    """Derivatives of the residual by the unknowns, from differences into the bounds; (6, 6)."""
    middle = residual(unknowns)
    steps = np.where(unknowns + _STEPS <= _HIGHEST, _STEPS, -_STEPS)
    rows = [
        (residual(unknowns + moved) - middle) / step
        for moved, step in zip(np.diag(steps), steps, strict=True)
    ]
    return np.column_stack(rows)


def _condition(airspeed: float, climb: float, unknowns: Vector) -> FlightCondition:
    found = Unknowns(*map(float, unknowns))
    controls = Controls(found.aileron, found.elevator, found.rudder, found.throttle)
    return FlightCondition(airspeed, found.alpha, bank=found.bank, climb=climb, controls=controls)
