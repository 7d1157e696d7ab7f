"""Geodesy and attitudes over arrays: functions on the last axes, from the scalar formulas."""

from vfguide.geometry.geodesy import geodetic_to_ned, tangent_plane
from vfguide.geometry.over_points import over_points
from vfguide.geometry.so3 import to_euler
from vfguide.geometry.vector import Matrix, Vector, mat3, vec3


@over_points("(n),(n)->(n)")
def geodetic_to_neds(origin: Vector, points: Vector, p_n: Vector) -> None:
    """Positions north-east-down [m], (..., 3), of points on the tangent plane at `origin`.

    Both arguments are latitude [rad], longitude [rad], altitude [m] along the last axis.
    """
    plane = tangent_plane(*vec3(origin))
    p_n[0], p_n[1], p_n[2] = geodetic_to_ned(plane, *vec3(points))


@over_points("(n,n)->(n)")
def euler_angles(R_nb: Matrix, angles: Vector) -> None:
    """Roll, pitch and yaw [rad], (..., 3), of attitudes (..., 3, 3)."""
    angles[0], angles[1], angles[2] = to_euler(mat3(R_nb))
