"""The flight law for a body without weight, that flies where its x axis points.

An aeroplane turns because its lift is tilted, so that its attitude follows from the turn. Here it
is the other way round: the body points its x axis into the direction that the flight law wants,
and is banked as the aeroplane would be.
"""

import math

import numpy as np

from vfguide.field.rate_law import rate_law
from vfguide.flight.guidance import plan_flight, reference_rate
from vfguide.flight.memory import Memory, Target
from vfguide.flight.performance import Law, unpacked
from vfguide.flight.state import FlightState
from vfguide.geometry.compiled import compiled
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.vector import Vec3


@compiled
def guide_body(state: FlightState, target: Target, law: Law, memory: Memory) -> tuple[Vec3, Memory]:
    """Body rates [rad/s], not limited yet, towards R_na = Rz(azimuth) Ry(path angle) Rx(bank).

    Lemma 4 with the reference's own rate, as for an aeroplane. `law` is what `packed` gives.
    """
    aircraft, gains = unpacked(law)
    wish, m = plan_flight(state, target, aircraft, gains, memory, np.zeros(0), math.inf)
    R_na = from_euler(wish.bank, wish.gamma, wish.azimuth)
    omega_a = (0.0, 0.0, 0.0)
    if memory.time >= 0.0:
        dt = max(state.time - memory.time, 1e-3)
        omega_a = reference_rate(memory, R_na, gains.smoothing, dt)
    after = Memory(
        state.time, m.leg, m.slope, m.turning, R_na, omega_a, m.thrust_integral, m.alpha_bias
    )
    return rate_law(state.R_nb, R_na, omega_a, gains.k_w), after
