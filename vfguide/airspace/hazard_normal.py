"""The direction away from a hazard."""

from vfguide.airspace.hazards import Hazards, hazard_distance
from vfguide.geometry.vector import Vec3, add, norm, scale, sub
from vfguide.kernels.compiled import compiled

HALF_STEP = 0.5
"""Half the distance over which the distance from a hazard is differenced [m]; chosen, so that the
edges of a body are round by as much."""


@compiled
def outward_normal(hazards: Hazards, i: int, p_n: Vec3, t: float) -> Vec3:
    """Gradient of the distance from hazard `i` as a unit vector, NED; zero where there is none.

    Args:
        hazards: the known hazards.
        i: number of the hazard.
        p_n: position, NED [m].
        t: time on the clock of the obstacles [s].
    """
    gradient = (
        difference(hazards, i, p_n, (HALF_STEP, 0.0, 0.0), t),
        difference(hazards, i, p_n, (0.0, HALF_STEP, 0.0), t),
        difference(hazards, i, p_n, (0.0, 0.0, HALF_STEP), t),
    )
    size = norm(gradient)
    return scale(1.0 / size, gradient) if size > 0.0 else gradient


@compiled
def difference(hazards: Hazards, i: int, p_n: Vec3, step_n: Vec3, t: float) -> float:
    """Change of the distance from hazard `i` over twice a step, NED [m], about a position."""
    after = hazard_distance(hazards, i, add(p_n, step_n), t)
    return after - hazard_distance(hazards, i, sub(p_n, step_n), t)
