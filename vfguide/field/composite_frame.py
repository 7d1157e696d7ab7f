"""The auxiliary attitude R_a = [F, H', G'] of the avoidance field, H' = G' x F, each normalised.

The regular G' of `avoidance` vanishes where G does, on the goal's axis, and where chi = 0 and
n . G = 0. Its place is taken there by the direction of the first of G, the goal's z axis and the
goal's y axis that is not along F, made orthogonal to F. On the axis in free space this is the
attitude of `attitude`.
"""

from vfguide.field.attitude import FrameFields
from vfguide.field.avoidance import Deflection, FreeField, avoidance_field, avoidance_normal
from vfguide.field.goal_frame import GoalFrame
from vfguide.geometry import dual
from vfguide.geometry.compiled import compiled
from vfguide.geometry.dual import Dual3
from vfguide.geometry.vector import Vec3, norm

VANISHED = 1e-12
"""G' counts as zero where no more than this part of its terms is left and orthogonal to F."""
NOT_ALONG = 0.1
"""Least sine of the angle between F and the direction that takes the place of G'."""
STILL = (0.0, 0.0, 0.0)


@compiled
def avoidance_frame_fields(goal: GoalFrame, free: FreeField, by: Deflection) -> FrameFields:
    """F_OA and the G' orthogonal to it, with their rates: Lemma 5 (lem_G_OA_H_OA).

    Where F_OA is zero, at the goal, both stand still and G' is the goal's z axis.
    """
    F = avoidance_field(free, by)
    if norm(F.value) == 0.0:
        return FrameFields(F.value, STILL, goal_axis(goal, 2), STILL)
    G = orthogonal_part(avoidance_normal(free, by), F)
    if norm(G.value) > VANISHED * normal_bound(free, by):
        return FrameFields(F.value, F.rate, G.value, G.rate)
    substitute = substitute_normal(goal, free, F)
    return FrameFields(F.value, F.rate, substitute.value, substitute.rate)


@compiled
def orthogonal_part(a: Dual3, b: Dual3) -> Dual3:
    """The part of `a` orthogonal to `b`, which is not zero.

    Taken twice: where it is a small part of `a`, rounding leaves it askew the first time.
    """
    e = dual.unit(b)
    part = dual.sub(a, dual.scale(dual.dot(a, e), e))
    return dual.sub(part, dual.scale(dual.dot(part, e), e))


@compiled
def normal_bound(free: FreeField, by: Deflection) -> float:
    """Sum of the greatest lengths that the terms of G' can have."""
    F, G = norm(free.F.value), norm(free.G.value)
    bound = (by.chi.value + by.stretch) * G
    return bound if by.facing.value == 0.0 else F * F * bound + by.facing.value * G * G * F


@compiled
def substitute_normal(goal: GoalFrame, free: FreeField, F: Dual3) -> Dual3:
    """The unit vector orthogonal to F in the place of a G' that vanishes."""
    if norm(free.G.value) > 0.0:
        part = orthogonal_part(dual.unit(free.G), F)
        if norm(part.value) > NOT_ALONG:
            return dual.unit(part)
    part = orthogonal_part(Dual3(goal_axis(goal, 2), STILL), F)
    if norm(part.value) <= NOT_ALONG:
        part = orthogonal_part(Dual3(goal_axis(goal, 1), STILL), F)
    return dual.unit(part)


@compiled
def goal_axis(goal: GoalFrame, k: int) -> Vec3:
    """Axis x, y or z (0, 1, 2) of the goal frame in NED; y is level and points to the right."""
    R_ng = goal.R_ng
    return (R_ng[0][k], R_ng[1][k], R_ng[2][k])
