"""Throttle for a thrust: the inverse of motor and propeller, looked up in a table.

The thrust setpoint of an autopilot runs from 0, no thrust, to 1, all thrust at cruise, and is
linear in newtons. At a given throttle and airspeed, thrust is taken to grow with density.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3
from vfguide.sim.bench import Bench
from vfguide.sim.condition import FlightCondition
from vfguide.sim.signals import Controls

Throttles = NDArray[np.float64]
"""Throttle over airspeed (rows) and thrust setpoint (columns, 0 to SETPOINT_MAX)."""

SETPOINT_MAX = 1.25
"""The table reaches beyond 1, because thin air asks for more."""
_SETPOINTS = np.linspace(0.0, SETPOINT_MAX, 41)
_THROTTLES = np.linspace(0.0, 1.0, 26)
_AIRSPEEDS = np.linspace(0.4, 1.6, 13)
"""As multiples of the cruise airspeed."""


@dataclass(frozen=True)
class ThrustMap:
    """What `throttle_for` needs of one airframe."""

    throttles: Throttles
    axes: Vec3
    """First airspeed and step of the rows [m/s]; air density of the table [kg/m^3]."""
    full_thrust: float
    """Thrust at setpoint 1, in the density of the table [N]."""


def thrust_map(bench: Bench, cruise: FlightCondition) -> ThrustMap:
    """Measure the thrust of the model on `bench` from 0.4 to 1.6 times the cruise airspeed."""
    airspeeds = cruise.airspeed * _AIRSPEEDS
    full_thrust = _thrust(bench, cruise, cruise.airspeed, 1.0)
    rows = [_throttles(bench, cruise, float(airspeed), full_thrust) for airspeed in airspeeds]
    step = float(airspeeds[1] - airspeeds[0])
    return ThrustMap(np.array(rows), (float(airspeeds[0]), step, bench.density), full_thrust)


def _throttles(
    bench: Bench, cruise: FlightCondition, airspeed: float, full_thrust: float
) -> Throttles:
    """Throttle at each setpoint, at one airspeed.

    It goes on in a straight line beyond 1, where the throttle ends, so that interpolation between
    the rows is right up to there.
    """
    thrusts = [_thrust(bench, cruise, airspeed, float(throttle)) for throttle in _THROTTLES]
    rising = np.maximum.accumulate(thrusts)
    beyond = rising[-1] + (rising[-1] - rising[-2]) * (_THROTTLES.size - 1)
    return np.interp(full_thrust * _SETPOINTS, [*rising, beyond], [*_THROTTLES, 2.0])


def _thrust(bench: Bench, cruise: FlightCondition, airspeed: float, throttle: float) -> float:
    controls = Controls(throttle=throttle)
    return bench.thrust(FlightCondition(airspeed, alpha=cruise.alpha, controls=controls))


@compiled
def throttle_for(
    throttles: Throttles, axes: Vec3, thrust: float, airspeed: float, density: float
) -> float:
    """Throttle, 0 to 1, that gives the thrust setpoint at this airspeed [m/s] and density.

    Bilinear in the table of a ThrustMap; beyond its ends the value at the end holds.
    """
    first_airspeed, airspeed_step, table_density = axes
    rows, columns = throttles.shape
    i, u = _cell((airspeed - first_airspeed) / airspeed_step, rows)
    setpoint = min(max(thrust, 0.0), 1.0) * table_density / density
    j, v = _cell(setpoint * (columns - 1) / SETPOINT_MAX, columns)
    slower = (1.0 - v) * throttles[i, j] + v * throttles[i, j + 1]
    faster = (1.0 - v) * throttles[i + 1, j] + v * throttles[i + 1, j + 1]
    return min((1.0 - u) * slower + u * faster, 1.0)


@compiled
def _cell(position: float, size: int) -> tuple[int, float]:
    """Cell of a grid of `size` points that holds `position`, and where in it, 0 to 1."""
    position = min(max(position, 0.0), size - 1.0)
    cell = min(int(position), size - 2)
    return cell, position - cell
