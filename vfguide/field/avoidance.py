"""The paper's avoidance field F_OA (F_CA) and the regular form of the field G that goes with it.

An obstacle and a robot with priority are the same to the law: a transition chi and a normal n.
All vectors are in one frame, that of the field in free space; each has its exact rate.
"""

from typing import NamedTuple

from vfguide.geometry import dual, vector
from vfguide.geometry.dual import Dual, Dual3
from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled

COLLINEAR = 1e-9
"""Largest sine of the angle between n and F at which the two count as collinear, chosen well above
rounding; the paper compares with zero (tau_Upsilon_2_case2)."""


class FreeField(NamedTuple):
    """The fields in free space at a moving point, with their time derivatives."""

    F: Dual3
    """The navigation field (Theorem 1), not normalised."""
    G: Dual3
    """The field orthogonal to it (Lemma 1), not normalised; zero on the goal's axis."""
    aside: Vec3
    """Constant unit vector, orthogonal to F wherever G is zero."""


class Barrier(NamedTuple):
    """An obstacle, or a robot to give way to."""

    chi: Dual
    """0 where the field has to be tangential, 1 where the barrier has no effect."""
    n: Dual3
    """Outward normal, the gradient of the level (n_Upsilon, n_Psi), not normalised."""


class Deflection(NamedTuple):
    """What barriers do to the field: the product and the sums of eq_F_OA_multi_obs."""

    chi: Dual
    """Product of all chi_i."""
    tangents: Dual3
    """Sum of (1 - chi_i) tau_b_i."""
    normals: Dual3
    """Sum of (1 - chi_i) (n_i . G) n_i."""
    facing: Dual
    """Sum of 1 - chi_i over the barriers whose n is collinear with F."""
    stretch: float
    """Sum of (1 - chi_i) |n_i|^2."""


@compiled
def no_deflection() -> Deflection:
    """The deflection in free space: chi is 1 and all sums are 0."""
    zero = dual.zero3()
    return Deflection(dual.rest(1.0), zero, zero, dual.rest(0.0), 0.0)


@compiled
def deflect(by: Deflection, free: FreeField, barrier: Barrier) -> Deflection:
    """The deflection with one more barrier: a factor and a term of eq_F_OA_multi_obs, eq_F_CA_i."""
    if barrier.chi.value == 1.0:
        return by
    n, share = barrier.n, dual.complement(barrier.chi)
    chi = dual.times(by.chi, barrier.chi)
    stretch = by.stretch + share.value * vector.dot(n.value, n.value)
    if collinear(n.value, free.F.value):
        tangents = dual.add(by.tangents, dual.scale(share, facing_tangent(free)))
        return Deflection(chi, tangents, by.normals, dual.plus(by.facing, share), stretch)
    tangents = dual.add(by.tangents, dual.scale(share, tangent(n, free.F)))
    along_n = dual.scale(dual.times(share, dual.dot(n, free.G)), n)
    return Deflection(chi, tangents, dual.add(by.normals, along_n), by.facing, stretch)


@compiled
def collinear(n: Vec3, F: Vec3) -> bool:
    """Whether n and F are collinear: |n x F| <= COLLINEAR |n| |F|."""
    product = vector.norm(vector.cross(n, F))
    return product <= COLLINEAR * vector.norm(n) * vector.norm(F)


@compiled
def tangent(n: Dual3, F: Dual3) -> Dual3:
    """tau_b = tau_a x n with tau_a = n x F: tau_Upsilon_1, tau_Upsilon_2_case1, eq_tau_psi_b."""
    return dual.cross(dual.cross(n, F), n)


@compiled
def facing_tangent(free: FreeField) -> Dual3:
    """tau_b where n and F are collinear: G (tau_Upsilon_2_case2).

    Where G vanishes too, straight ahead on the goal's axis, the print leaves F_OA zero on the
    surface. There it is |F| times the constant unit vector `aside`.
    """
    if vector.norm(free.G.value) > 0.0 or vector.norm(free.F.value) == 0.0:
        return free.G
    return dual.scale(dual.norm(free.F), Dual3(free.aside, (0.0, 0.0, 0.0)))


@compiled
def avoidance_field(free: FreeField, by: Deflection) -> Dual3:
    """F_OA = (prod chi_i) F + sum (1 - chi_i) tau_b_i: eq_F_ob, eq_F_OA_multi_obs, eq_F_CA_i."""
    return dual.add(dual.scale(by.chi, free.F), by.tangents)


@compiled
def avoidance_normal(free: FreeField, by: Deflection) -> Dual3:
    """G', the regular form of G_OA (Lemma 5, eq_G_OA), before it is made orthogonal to F_OA.

    G' = (prod chi_i) G + sum (1 - chi_i) (n_i . G) n_i: for one obstacle the printed G_OA times
    the denominator of mu, without its poles. Where n is collinear with F,
    G' = chi |F|^2 G - (1 - chi) |G|^2 F.
    """
    G = dual.add(dual.scale(by.chi, free.G), by.normals)
    if by.facing.value == 0.0:
        return G
    against = dual.times(by.facing, dual.dot(free.G, free.G))
    return dual.sub(dual.scale(dual.dot(free.F, free.F), G), dual.scale(against, free.F))
