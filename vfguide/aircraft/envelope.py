"""Turning envelope: the bank that the wing carries, and the turn radius at an airspeed and wind.

A level turn at bank phi has the load factor 1 / cos phi and the radius V^2 / (g tan phi).
"""

import math

from vfguide.aircraft.performance import Gains, Performance
from vfguide.aircraft.state import FlightState
from vfguide.geometry.units import G0
from vfguide.geometry.velocity import horizontal_norm
from vfguide.kernels.compiled import compiled

SLOWEST_TURN = 2.5
"""Least time of a turn by one radian [s], measured with the EasyStar in calm air
(`tools/measure_poses.py`): in tighter turns it could not settle on the final approach."""
LEAST_RADIUS = 1e-3
"""Radius of a turn at no airspeed, or at one that is not a number [m]; chosen so that divisions
stay finite."""
LEAST_LOAD = 1.05
"""Load factor that is flown however slow the aircraft is, dimensionless: 18 degrees of bank;
chosen, so that it can still turn."""
FASTEST_SHARE = 0.95
"""Share of the fastest airspeed up to which the airspeed to fly is raised, without a sensor and in
the identification flight; chosen, gusts take the rest."""


@compiled
def usable_bank(aircraft: Performance, gains: Gains, airspeed: float) -> float:
    """Largest bank that is allowed and whose load factor the wing carries at `airspeed` [rad]."""
    load = min(aircraft.load_max, carried_load(aircraft, airspeed))
    return min(gains.bank_max, bank_of_turn(load))


@compiled
def bank_of_turn(load: float) -> float:
    """Bank of a level turn [rad] with a load factor of at least 1: 1 / cos phi = n."""
    return math.acos(1.0 / load)


@compiled
def carried_load(aircraft: Performance, airspeed: float) -> float:
    """Load factor that the wing carries at a true airspeed [m/s]: n = (V / V_min)^2."""
    return max(LEAST_LOAD, (airspeed / aircraft.airspeed_min) ** 2)


@compiled
def flyable_radius(state: FlightState, bank: float, gains: Gains) -> float:
    """Turn radius over ground at the commanded airspeed in this wind [m]."""
    return radius_in(horizontal_norm(state.wind_n), bank, gains)


@compiled
def radius_in(wind: float, bank: float, gains: Gains) -> float:
    """Turn radius [m] over ground at the commanded airspeed, in a wind [m/s], at a bank [rad]."""
    radius = turn_radius(gains.airspeed, wind, bank, gains.turn_margin)
    radius += 0.5 * (gains.airspeed + wind) * gains.response_lag
    return max(radius, SLOWEST_TURN * gains.airspeed)


@compiled
def turn_radius(airspeed: float, wind: float, bank: float, margin: float) -> float:
    """Radius over ground that the bank allows flying downwind [m], times `margin`; never zero.

    (V + wind)^2 / (g tan bank), with the true airspeed V and the wind [m/s] and the bank [rad].
    """
    radius = margin * (airspeed + wind) ** 2 / (G0 * math.tan(bank))
    return radius if radius > LEAST_RADIUS else LEAST_RADIUS
