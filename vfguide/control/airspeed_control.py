"""Thrust: what the climb, the turn and the airspeed take."""

import math

from vfguide.aircraft.performance import Performance
from vfguide.geometry.compiled import compiled


@compiled
def thrust_for(
    aircraft: Performance, error: float, gamma: float, load: float, integral: float
) -> float:
    """Thrust setpoint, not limited.

    Args:
        aircraft: its trim and slopes.
        error: airspeed missing [m/s].
        gamma: wanted path angle through the air [rad].
        load: load factor flown.
        integral: of the airspeed error, in setpoint.
    """
    return (
        aircraft.thrust_trim
        + aircraft.thrust_per_climb * math.sin(gamma)
        + aircraft.thrust_per_load * (load * load - 1.0)
        + aircraft.thrust_per_airspeed * error
        + integral
    )


@compiled
def integrate_error(
    aircraft: Performance, error: float, thrust: float, integral: float, dt: float
) -> float:
    """Next value of the integral; it rests while the thrust is at a limit."""
    if thrust <= 0.0 or thrust >= 1.0:
        return integral
    return max(-0.3, min(0.3, integral + aircraft.thrust_integral * error * dt))
