"""Geodesy over arrays: the scalar formulas on the last axes."""

from vfguide.earth.geodesy import geodetic_to_ned, tangent_plane
from vfguide.geometry.vector import Vector, vec3
from vfguide.kernels.over_points import over_points


@over_points("(n),(n)->(n)")
def geodetic_to_neds(origin: Vector, points: Vector, p_n: Vector) -> None:
    """Positions north-east-down [m], (..., 3), of points on the tangent plane at `origin`.

    Both arguments are latitude [rad], longitude [rad], altitude [m] along the last axis.
    """
    plane = tangent_plane(*vec3(origin))
    p_n[0], p_n[1], p_n[2] = geodetic_to_ned(plane, *vec3(points))
