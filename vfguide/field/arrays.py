"""The paper's fields at many points: functions over the last axis, from the scalar formulas.

Positions (..., 3) [m] and velocities (..., 3) [m/s] are in the goal frame and broadcast against
each other; one point is an array of shape (3,). For a goal p_d, R_d elsewhere, F~ =
`navigation_fields((p - p_d) @ R_d) @ R_d.T`.
"""

from vfguide.field import navigation
from vfguide.field.attitude import frame, frame_fields, frame_rate
from vfguide.geometry.vector import ZERO, Matrix, Vector, vec3
from vfguide.kernels.over_points import over_points


@over_points("(n)->(n)")
def navigation_fields(p: Vector, F: Vector) -> None:
    """F of each point, (..., 3): eq_VF_xyz_compo."""
    F[0], F[1], F[2] = navigation.navigation_field(vec3(p))


@over_points("(n)->(n)")
def normal_fields(p: Vector, G: Vector) -> None:
    """G of each point, (..., 3): Lemma 1, eq_VF_G_xyz_comp."""
    G[0], G[1], G[2] = navigation.normal_field(vec3(p))


@over_points("(n)->(n)")
def binormal_fields(p: Vector, H: Vector) -> None:
    """H = G x F of each point, (..., 3): eq_VF_H_xyz_comp, corrected."""
    H[0], H[1], H[2] = navigation.binormal_field(vec3(p))


@over_points("(n)->(n,n)")
def attitudes(p: Vector, R_ga: Matrix) -> None:
    """R_a of each point, (..., 3, 3): eq_auxi_atti_matrix, defined everywhere."""
    R_ga[0], R_ga[1], R_ga[2] = frame(frame_fields(vec3(p), ZERO))


@over_points("(n),(n)->(n)")
def attitude_rates(p: Vector, v: Vector, Omega_a: Vector) -> None:
    """Omega_a of each moving point, (..., 3): body rates of R_a [rad/s], Lemma 2."""
    Omega_a[0], Omega_a[1], Omega_a[2] = frame_rate(frame_fields(vec3(p), vec3(v)))
