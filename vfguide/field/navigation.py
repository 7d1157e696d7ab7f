"""The paper's navigation field F and the fields G and H that go with it, in the goal frame.

The goal is the origin, its direction e_x. Positions are in metres; F, G and H are not
normalised and grow with the second, third and fifth power of the distance. Each rate is the
exact time derivative seen by a point at `p_g` that moves with `v_g`.
"""

from vfguide.geometry.vector import Vec3, dot
from vfguide.kernels.compiled import compiled


@compiled
def navigation_field(p_g: Vec3) -> Vec3:
    """F, the N-VF: Theorem 1, eq_VF_xyz_compo. |F| = |p|^2."""
    x, y, z = p_g
    return (x * x - y * y - z * z, 2.0 * x * y, 2.0 * x * z)


@compiled
def navigation_field_rate(p_g: Vec3, v_g: Vec3) -> Vec3:
    """dF/dt, the chain rule on eq_VF_xyz_compo."""
    x, y, z = p_g
    dx, dy, dz = v_g
    return (
        2.0 * (x * dx - y * dy - z * dz),
        2.0 * (dx * y + x * dy),
        2.0 * (dx * z + x * dz),
    )


@compiled
def normal_field(p_g: Vec3) -> Vec3:
    """G, the outward normal of F's circles: Lemma 1 (lem_VF_G), eq_VF_G_xyz_comp.

    |G| = r |p|^2 with r the distance from the x-axis: G vanishes on the whole axis.
    """
    x, y, z = p_g
    r2 = y * y + z * z
    k = r2 - x * x
    return (2.0 * x * r2, y * k, z * k)


@compiled
def normal_field_rate(p_g: Vec3, v_g: Vec3) -> Vec3:
    """dG/dt, the chain rule on eq_VF_G_xyz_comp."""
    x, y, z = p_g
    dx, dy, dz = v_g
    r2, dr2 = y * y + z * z, 2.0 * (y * dy + z * dz)
    k, dk = r2 - x * x, dr2 - 2.0 * x * dx
    return (2.0 * (dx * r2 + x * dr2), dy * k + y * dk, dz * k + z * dk)


@compiled
def binormal_field(p_g: Vec3) -> Vec3:
    """H = G x F, the normal of the plane of F's circle: eq_VF_H_xyz_comp, corrected.

    The print has the factor (x^2 + y^2 + z^2) to the first power; G x F has it squared.
    """
    _, y, z = p_g
    k = dot(p_g, p_g) ** 2
    return (0.0, -z * k, y * k)
