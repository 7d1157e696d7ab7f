"""Throttle for a thrust: the inverse of motor and propeller, looked up in a table.

The thrust setpoint of an autopilot runs from 0, no thrust, to 1, all thrust at cruise, and is
linear in newtons. At a given throttle and airspeed, thrust is taken to grow with density.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Matrix, Series
from vfguide.sim.bench import Bench
from vfguide.sim.condition import FlightCondition
from vfguide.sim.signals import Controls

Throttles = Matrix
"""Throttle over airspeed (rows) and thrust setpoint (columns, 0 to SETPOINT_MAX)."""
AxesTuple = tuple[float, float, float]
"""`Axes`, or the same three numbers without names."""

SETPOINT_MAX = 1.25
"""Largest thrust setpoint in the table, as a share of the full thrust; chosen above 1, because thin
air asks for more."""
_SETPOINTS = np.linspace(0.0, SETPOINT_MAX, 41)
_THROTTLES = np.linspace(0.0, 1.0, 26)
_AIRSPEEDS = np.linspace(0.4, 1.6, 13)
"""Airspeeds of the rows, as multiples of the cruise airspeed."""


class Axes(NamedTuple):
    """The airspeeds and the density at which a table of throttles was measured."""

    first_airspeed: float
    """True airspeed of the first row [m/s]."""
    airspeed_step: float
    """True airspeed between two rows [m/s]."""
    density: float
    """Air density [kg/m^3]."""

    @property
    def numbers(self) -> AxesTuple:
        """The same three numbers without names."""
        return (self.first_airspeed, self.airspeed_step, self.density)


@dataclass(frozen=True)
class ThrustMap:
    """The table of throttles of one airframe for `throttle_for`."""

    throttles: Throttles
    """Throttles over airspeed and thrust setpoint, 0 to 1, beyond 1 where thrust is lacking."""
    axes: Axes
    """Airspeeds and density of the table."""
    full_thrust: float
    """Thrust at setpoint 1, in the density of the table [N]."""


def thrust_map(bench: Bench, cruise: FlightCondition) -> ThrustMap:
    """Measure the thrust of the model on `bench` from 0.4 to 1.6 times the cruise airspeed."""
    airspeeds: Series = cruise.airspeed * _AIRSPEEDS
    full_thrust = _thrust(bench, cruise, cruise.airspeed, 1.0)
    rows = [_throttles(bench, cruise, float(airspeed), full_thrust) for airspeed in airspeeds]
    axes = Axes(float(airspeeds[0]), float(airspeeds[1] - airspeeds[0]), bench.density)
    return ThrustMap(np.array(rows), axes, full_thrust)


def _throttles(
    bench: Bench, cruise: FlightCondition, airspeed: float, full_thrust: float
) -> Throttles:
    """Throttle at each setpoint, at one airspeed.

    It goes on in a straight line beyond 1, where the throttle ends, so that interpolation between
    the rows is right up to there.
    """
    thrusts = [_thrust(bench, cruise, airspeed, float(throttle)) for throttle in _THROTTLES]
    rising: Series = np.maximum.accumulate(thrusts)
    beyond = rising[-1] + (rising[-1] - rising[-2]) * (_THROTTLES.size - 1)
    return np.interp(full_thrust * _SETPOINTS, [*rising, beyond], [*_THROTTLES, 2.0])


def _thrust(bench: Bench, cruise: FlightCondition, airspeed: float, throttle: float) -> float:
    controls = Controls(throttle=throttle)
    return bench.thrust(FlightCondition(airspeed, alpha=cruise.alpha, controls=controls))


@compiled
def throttle_for(
    throttles: Throttles, axes: Axes, thrust: float, airspeed: float, density: float
) -> float:
    """Throttle, 0 to 1, that gives the thrust setpoint at this airspeed [m/s] and density.

    It is interpolated bilinearly in the table of a ThrustMap, and constant beyond its ends. The
    density is in kg/m^3.
    """
    rows, columns = throttles.shape
    i, u = _cell((airspeed - axes.first_airspeed) / axes.airspeed_step, rows)
    setpoint = min(max(thrust, 0.0), 1.0) * axes.density / density
    j, v = _cell(setpoint * (columns - 1) / SETPOINT_MAX, columns)
    slower = (1.0 - v) * throttles[i, j] + v * throttles[i, j + 1]
    faster = (1.0 - v) * throttles[i + 1, j] + v * throttles[i + 1, j + 1]
    return min((1.0 - u) * slower + u * faster, 1.0)


@compiled
def _cell(position: float, size: int) -> tuple[int, float]:
    """Cell of a grid of `size` points that contains `position`, and the position in it, 0 to 1."""
    position = min(max(position, 0.0), size - 1.0)
    cell = min(int(position), size - 2)
    return cell, position - cell
