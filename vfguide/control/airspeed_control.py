"""Airspeed control: thrust by feed-forward of climb and turn, and PI feedback of the airspeed.

It is no total-energy control: path angle and airspeed are controlled apart.
"""

import math

from vfguide.aircraft.performance import Performance
from vfguide.kernels.compiled import compiled

FEEDBACK_THRUST_MAX = 0.3
"""Largest thrust setpoint that the integral of the airspeed error adds or takes, a share of full
thrust; chosen, so that an error of the trim is made up for and a long error winds up no further."""


@compiled
def thrust_for(
    aircraft: Performance, error: float, gamma: float, load: float, integral: float
) -> float:
    """Thrust setpoint, not limited: trim + climb + induced drag of the turn + feedback.

    Args:
        aircraft: its trim and slopes.
        error: airspeed to fly less true airspeed [m/s].
        gamma: wanted path angle through the air [rad].
        load: load factor that is flown.
        integral: integral of the airspeed error, as thrust setpoint.
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
    """The integral `dt` [s] later, as thrust setpoint; held while the `thrust` is at a limit.

    `error` is the airspeed to fly less the true airspeed [m/s], `integral` the present value.
    """
    if thrust <= 0.0 or thrust >= 1.0:
        return integral
    return max(
        -FEEDBACK_THRUST_MAX,
        min(FEEDBACK_THRUST_MAX, integral + aircraft.thrust_integral * error * dt),
    )
