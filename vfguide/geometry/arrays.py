"""Attitudes over arrays: the scalar formulas on the last axes."""

from vfguide.geometry.so3 import to_euler
from vfguide.geometry.vector import Matrix, Vector, mat3
from vfguide.kernels.over_points import over_points


@over_points("(n,n)->(n)")
def euler_angles(R_nb: Matrix, angles: Vector) -> None:
    """Roll, pitch and yaw [rad], (..., 3), of attitudes (..., 3, 3)."""
    angles[0], angles[1], angles[2] = to_euler(mat3(R_nb))
