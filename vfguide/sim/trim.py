"""Trim: the steady straight flight of a JSBSim model, by least squares on its accelerations."""

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from vfguide.geometry.units import DEG
from vfguide.sim.bench import Bench
from vfguide.sim.condition import FlightCondition
from vfguide.sim.signals import Controls

_WEIGHTS = np.array([1.0, 1.0, 1.0, 5.0, 5.0, 5.0])
"""By these, 1 m/s^2 and 0.2 rad/s^2 count alike."""
_RESIDUAL_MAX = 1e-4
"""Largest weighted acceleration that still is a trim: 1e-5 g."""

# The unknowns: alpha, bank, aileron, elevator, rudder, throttle.
_GUESS = np.array([3.0 * DEG, 0.0, 0.0, 0.0, 0.0, 0.5])
_LOWEST = np.array([-20.0 * DEG, -30.0 * DEG, -1.0, -1.0, -1.0, 0.0])
_HIGHEST = np.array([30.0 * DEG, 30.0 * DEG, 1.0, 1.0, 1.0, 1.0])
_SCALE = np.array([0.05, 0.02, 0.05, 0.1, 0.05, 0.2])


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

    def residual(unknowns: NDArray[np.float64]) -> NDArray[np.float64]:
        return _WEIGHTS * bench.accelerations(_condition(airspeed, climb, unknowns))

    solution = least_squares(
        residual,
        _GUESS,
        bounds=(_LOWEST, _HIGHEST),
        x_scale=_SCALE,
        diff_step=1e-4,
        xtol=1e-12,
        ftol=1e-14,
        gtol=1e-14,
    )
    worst = float(np.max(np.abs(solution.fun)))
    if not worst < _RESIDUAL_MAX:
        raise TrimError(
            f"{bench.model.name}: no steady flight at {airspeed:.1f} m/s, climbing "
            f"{climb / DEG:.1f} deg; at best {worst:.2g} m/s^2 remain"
        )
    return _condition(airspeed, climb, solution.x)


def _condition(airspeed: float, climb: float, unknowns: NDArray[np.float64]) -> FlightCondition:
    alpha, bank, aileron, elevator, rudder, throttle = map(float, unknowns)
    controls = Controls(aileron, elevator, rudder, throttle)
    return FlightCondition(airspeed, alpha, bank=bank, climb=climb, controls=controls)
