"""Throttle for a thrust: the inverse of motor and propeller, looked up in a table.

The thrust setpoint of an autopilot runs from 0, no thrust, to 1, all thrust at cruise, and is
linear in newtons. At a given throttle and airspeed, thrust is taken to grow with density, so that
a setpoint stands for less thrust in thin air: an autopilot does not know what its motor gives.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from vfguide.geometry.vector import Matrix, Series
from vfguide.kernels.compiled import compiled
from vfguide.sim.bench import Bench
from vfguide.sim.condition import FlightCondition
from vfguide.sim.signals import Controls

Throttles = Matrix
"""Throttle over airspeed (rows) and thrust setpoint (columns, 0 to 1)."""
AxesTuple = tuple[float, float]
"""`Axes`, or the same two numbers without names."""

_SETPOINTS = np.linspace(0.0, 1.0, 33)
_THROTTLES = np.linspace(0.0, 1.0, 26)
_AIRSPEEDS = np.linspace(0.4, 1.6, 13)
"""Airspeeds of the rows, as multiples of the cruise airspeed."""


class Axes(NamedTuple):
    """The airspeeds at which a table of throttles was measured."""

    first_airspeed: float
    """True airspeed of the first row [m/s]."""
    airspeed_step: float
    """True airspeed between two rows [m/s]."""

    @property
    def numbers(self) -> AxesTuple:
        """The same two numbers without names."""
        return (self.first_airspeed, self.airspeed_step)


@dataclass(frozen=True)
class ThrustMap:
    """The table of throttles of one airframe for `throttle_for`."""

    throttles: Throttles
    """Throttles over airspeed and thrust setpoint; beyond 1 where thrust is lacking."""
    axes: Axes
    """Airspeeds of the table."""
    full_thrust: float
    """Thrust at setpoint 1 and cruise, in the air of the table [N]."""


def thrust_map(bench: Bench, cruise: FlightCondition) -> ThrustMap:
    """Measure the thrust of the model on `bench` from 0.4 to 1.6 times the cruise airspeed."""
    airspeeds: Series = cruise.airspeed * _AIRSPEEDS
    full_thrust = _thrust(bench, cruise, cruise.airspeed, 1.0)
    rows = [_throttles(bench, cruise, float(airspeed), full_thrust) for airspeed in airspeeds]
    axes = Axes(float(airspeeds[0]), float(airspeeds[1] - airspeeds[0]))
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
def throttle_for(throttles: Throttles, axes: Axes, thrust: float, airspeed: float) -> float:
    """Throttle, 0 to 1, that gives the thrust setpoint at this true airspeed [m/s].

    It is interpolated bilinearly in the table of a ThrustMap, and constant beyond its ends.
    """
    rows, columns = throttles.shape
    i, u = _cell((airspeed - axes.first_airspeed) / axes.airspeed_step, rows)
    setpoint = min(max(thrust, 0.0), 1.0)
    j, v = _cell(setpoint * (columns - 1), columns)
    slower = (1.0 - v) * throttles[i, j] + v * throttles[i, j + 1]
    faster = (1.0 - v) * throttles[i + 1, j] + v * throttles[i + 1, j + 1]
    return min((1.0 - u) * slower + u * faster, 1.0)


@compiled
def _cell(position: float, size: int) -> tuple[int, float]:
    """Cell of a grid of `size` points that contains `position`, and the position in it, 0 to 1."""
    position = min(max(position, 0.0), size - 1.0)
    cell = min(int(position), size - 2)
    return cell, position - cell
