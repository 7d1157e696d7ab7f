"""The auxiliary attitude R_a = [F, H', G'] of the avoidance field, H' = G' x F, each normalised.

The regular G' of `avoidance` vanishes where G does, on the goal's axis, and where chi = 0 and
n . G = 0. There it is replaced by the first of three directions that is not along F: G, the goal's
z axis and the goal's y axis, made orthogonal to F. On the axis in free space this gives the
attitude of `vfguide.field.attitude`.
"""

from vfguide.field.attitude import FrameFields
from vfguide.field.avoidance import Deflection, FreeField, avoidance_field, avoidance_normal
from vfguide.field.goal_frame import GoalFrame
from vfguide.geometry import dual
from vfguide.geometry.dual import Dual3
from vfguide.geometry.vector import ZERO, Vec3, norm
from vfguide.kernels.compiled import compiled

VANISHED = 1e-12
"""Share of the length of its terms below which the part of G' orthogonal to F counts as zero;
chosen a thousand times above rounding."""
NOT_ALONG = 0.1
"""Least sine of the angle between F and the direction that replaces a vanished G', chosen so that
the direction stays well conditioned."""


@compiled
def avoidance_frame_fields(goal: GoalFrame, free: FreeField, by: Deflection) -> FrameFields:
    """F_OA and the G' orthogonal to it, with their rates: Lemma 5 (lem_G_OA_H_OA).

    Where F_OA is zero, at the goal, both rates are zero and G' is the goal's z axis.
    """
    F = avoidance_field(free, by)
    if norm(F.value) == 0.0:
        return FrameFields(F.value, ZERO, goal_axis(goal, 2), ZERO)
    G = orthogonal_part(avoidance_normal(free, by), F)
    if norm(G.value) > VANISHED * normal_bound(free, by):
        return FrameFields(F.value, F.rate, G.value, G.rate)
    substitute = substitute_normal(goal, free, F)
    return FrameFields(F.value, F.rate, substitute.value, substitute.rate)


@compiled
def orthogonal_part(a: Dual3, b: Dual3) -> Dual3:
    """The part of `a` orthogonal to `b`, which is not zero.

    It is computed twice: where it is small, rounding leaves an error along `b` the first time.
    """
    e = dual.unit(b)
    part = dual.sub(a, dual.scale(dual.dot(a, e), e))
    return dual.sub(part, dual.scale(dual.dot(part, e), e))


@compiled
def normal_bound(free: FreeField, by: Deflection) -> float:
    """Upper bound of |G'|: the sum of the greatest lengths that its terms can have."""
    F, G = norm(free.F.value), norm(free.G.value)
    bound = (by.chi.value + by.stretch) * G
    return bound if by.facing.value == 0.0 else F * F * bound + by.facing.value * G * G * F


@compiled
def substitute_normal(goal: GoalFrame, free: FreeField, F: Dual3) -> Dual3:
    """The unit vector orthogonal to F that replaces a G' that vanishes."""
    if norm(free.G.value) > 0.0:
        part = orthogonal_part(dual.unit(free.G), F)
        if norm(part.value) > NOT_ALONG:
            return dual.unit(part)
    part = orthogonal_part(Dual3(goal_axis(goal, 2), ZERO), F)
    if norm(part.value) <= NOT_ALONG:
        part = orthogonal_part(Dual3(goal_axis(goal, 1), ZERO), F)
    return dual.unit(part)


@compiled
def goal_axis(goal: GoalFrame, k: int) -> Vec3:
    """Axis x, y or z (0, 1, 2) of the goal frame in NED; y is level and points to the right."""
    R_ng = goal.R_ng
    return (R_ng[0][k], R_ng[1][k], R_ng[2][k])
