"""The flight law as it may be used: no value outside the aircraft's limits leaves here."""

import math

from vfguide.flight.guidance import guide
from vfguide.flight.memory import Memory, Target, Wish
from vfguide.flight.performance import Law, Performance, unpacked
from vfguide.flight.state import FlightState, RateSetpoint
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3


@compiled
def guide_within_limits(
    state: FlightState, target: Target, law: Law, memory: Memory
) -> tuple[RateSetpoint, Memory, Wish]:
    """One step of the flight law, its setpoint limited; `law` is what `packed` gives."""
    aircraft, gains = unpacked(law)
    wanted, memory, wish = guide(state, target, aircraft, gains, memory)
    return limit_setpoint(wanted, aircraft), memory, wish


@compiled
def limit_setpoint(setpoint: RateSetpoint, aircraft: Performance) -> RateSetpoint:
    """The setpoint with body rates and thrust inside their limits, always finite.

    A value that is not a number becomes zero rate, or the thrust of level flight.
    """
    return RateSetpoint(
        limit_rates(setpoint.omega_b, aircraft.rate_max),
        limited(setpoint.thrust, 0.0, 1.0, aircraft.thrust_trim),
        setpoint.q_nb,
    )


@compiled
def limit_rates(omega: Vec3, most: Vec3) -> Vec3:
    """Each rate between minus and plus its limit [rad/s]."""
    return (
        limited(omega[0], -most[0], most[0], 0.0),
        limited(omega[1], -most[1], most[1], 0.0),
        limited(omega[2], -most[2], most[2], 0.0),
    )


@compiled
def limited(value: float, low: float, high: float, otherwise: float) -> float:
    """`value` between `low` and `high`; `otherwise` if it is not a number."""
    return otherwise if math.isnan(value) else max(low, min(high, value))
