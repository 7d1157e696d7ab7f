"""The companion's step for a kinematic body: its own state in, body rates out, no messages."""

from vfguide.companion.legs import Legs, target_of
from vfguide.companion.route_memory import (
    PackedMemory,
    RouteMemory,
    packed_memory,
    unpacked_memory,
)
from vfguide.companion.step import note_passage, passage_since
from vfguide.flight.body_guidance import guide_body
from vfguide.flight.performance import Law, unpacked
from vfguide.flight.state import FlightState
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Matrix, Vec3, Vector, mat3, matvec
from vfguide.safety.limits import limit_rates


@compiled
def step_body(
    time: float, p: Vector, R: Matrix, legs: Legs, law: Law, memory: PackedMemory
) -> tuple[Vec3, PackedMemory]:
    """Body rates [rad/s] of a body that flies at the law's airspeed, and the next memory.

    Args:
        time: [s].
        p: position (3,), NED [m].
        R: attitude (3, 3), body to NED.
        legs: of `leg_rows`.
        law: aircraft and gains, of `packed`.
        memory: of the step before.
    """
    aircraft, gains = unpacked(law)
    R_nb = mat3(R)
    v_n = matvec(R_nb, (gains.airspeed, 0.0, 0.0))
    state = FlightState(time, (p[0], p[1], p[2]), v_n, R_nb, gains.airspeed, (0.0, 0.0, 0.0))
    before = unpacked_memory(memory)
    route = note_passage(passage_since(before, state, legs), legs, before)
    omega_b, flight = guide_body(state, target_of(legs, route.goal), law, route.flight)
    kept = (route.jumps, route.stand, route.tries, route.progress)
    learned = (route.air, route.guard, route.detour)
    after = RouteMemory(route.goal, True, state.p_n, state.v_n, flight, *kept, *learned)
    return limit_rates(omega_b, aircraft.rate_max), packed_memory(after)
