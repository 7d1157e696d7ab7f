"""What bank and which turns the aircraft flies, at an airspeed and in a wind."""

import math

from vfguide.aircraft.performance import Gains, Performance
from vfguide.aircraft.state import FlightState
from vfguide.geometry.compiled import compiled
from vfguide.geometry.units import G0

SLOWEST_TURN = 2.5
"""No turn is planned tighter than a radian in this time [s]: rolling into it and out of it takes
the same time for a small aircraft, which could turn faster."""
SMALLEST = 1e-3
"""Radius of turns without any speed, or with one that is no number [m]."""


@compiled
def usable_bank(aircraft: Performance, gains: Gains, airspeed: float) -> float:
    """Largest bank whose load factor the wing carries at this airspeed [rad]."""
    load = min(aircraft.load_max, max(1.05, (airspeed / aircraft.airspeed_min) ** 2))
    return min(gains.bank_max, math.acos(1.0 / load))


@compiled
def flyable_radius(state: FlightState, bank: float, gains: Gains) -> float:
    """Turn radius over ground at the commanded airspeed in this wind [m]."""
    return radius_in(math.hypot(state.wind_n[0], state.wind_n[1]), bank, gains)


@compiled
def radius_in(wind: float, bank: float, gains: Gains) -> float:
    """Turn radius [m] over ground at the commanded airspeed, in a wind [m/s], at a bank [rad]."""
    radius = turn_radius(gains.airspeed, wind, bank, gains.turn_margin)
    radius += 0.5 * (gains.airspeed + wind) * gains.response_lag
    return max(radius, SLOWEST_TURN * gains.airspeed)


@compiled
def turn_radius(airspeed: float, wind: float, bank: float, margin: float) -> float:
    """Radius over ground that the bank allows flying downwind [m], times `margin`; never zero."""
    radius = margin * (airspeed + wind) ** 2 / (G0 * math.tan(bank))
    return radius if radius > SMALLEST else SMALLEST
