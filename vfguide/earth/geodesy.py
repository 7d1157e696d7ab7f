"""WGS-84: geodetic coordinates, the earth-centred frame and tangent planes.

Frames: `e` earth-centred earth-fixed, `n` north-east-down of a tangent plane, `l` north-east-down
at the vehicle. Latitude and longitude are in radians, altitude in metres above the ellipsoid. Where
all altitudes are above mean sea level instead, positions in a tangent plane are the same but for
their scale, undulation / earth radius: 16 mm a km at the most.
"""

import math
from typing import NamedTuple

from vfguide.geometry.vector import Mat3, Vec3, add, matmul, matvec, sub, transpose
from vfguide.kernels.compiled import compiled

SEMI_MAJOR = 6_378_137.0
"""Semi-major axis of the WGS-84 ellipsoid [m] (NIMA TR8350.2)."""
FLATTENING = 1.0 / 298.257223563
"""Flattening of the WGS-84 ellipsoid, the ratio (a - b) / a (NIMA TR8350.2)."""
SEMI_MINOR = SEMI_MAJOR * (1.0 - FLATTENING)
"""Semi-minor axis of the WGS-84 ellipsoid [m]."""
ECCENTRICITY_2 = FLATTENING * (2.0 - FLATTENING)
"""Square of the first eccentricity of the WGS-84 ellipsoid, dimensionless."""
SECOND_ECCENTRICITY_2 = ECCENTRICITY_2 / (1.0 - ECCENTRICITY_2)
"""Square of the second eccentricity of the WGS-84 ellipsoid, dimensionless."""


class TangentPlane(NamedTuple):
    """The north-east-down frame that touches the level surface through its origin."""

    lat: float
    """Geodetic latitude of the origin [rad]."""
    lon: float
    """Longitude of the origin [rad]."""
    alt: float
    """Height of the origin above the ellipsoid [m]."""
    p_e: Vec3
    """The origin, earth-centred [m]."""
    R_en: Mat3
    """From the plane's north-east-down to the earth-centred frame."""


@compiled
def geodetic_to_ecef(lat: float, lon: float, alt: float) -> Vec3:
    """Earth-centred earth-fixed position [m]."""
    prime_vertical = SEMI_MAJOR / math.sqrt(1.0 - ECCENTRICITY_2 * math.sin(lat) ** 2)
    axial = (prime_vertical + alt) * math.cos(lat)
    polar = (prime_vertical * (1.0 - ECCENTRICITY_2) + alt) * math.sin(lat)
    return (axial * math.cos(lon), axial * math.sin(lon), polar)


@compiled
def ecef_to_geodetic(p_e: Vec3) -> Vec3:
    """Latitude [rad], longitude [rad] in (-pi, pi] and altitude [m].

    Bowring's iteration on the reduced latitude: two rounds settle below rounding, a few
    1e-9 m, from 50 km under the ellipsoid to 10,000 km above it.
    """
    x, y, z = p_e
    axial = math.hypot(x, y)
    lat = math.atan2(z, axial * (1.0 - ECCENTRICITY_2))
    for _ in range(2):
        reduced = math.atan2((1.0 - FLATTENING) * math.sin(lat), math.cos(lat))
        lat = math.atan2(
            z + SECOND_ECCENTRICITY_2 * SEMI_MINOR * math.sin(reduced) ** 3,
            axial - ECCENTRICITY_2 * SEMI_MAJOR * math.cos(reduced) ** 3,
        )
    s = math.sin(lat)
    alt = axial * math.cos(lat) + z * s - SEMI_MAJOR * math.sqrt(1.0 - ECCENTRICITY_2 * s * s)
    return (lat, math.atan2(y, x), alt)


@compiled
def R_en(lat: float, lon: float) -> Mat3:
    """From north-east-down at (lat, lon) to the earth-centred frame; columns north, east, down."""
    s, c = math.sin(lat), math.cos(lat)
    sl, cl = math.sin(lon), math.cos(lon)
    return ((-s * cl, -sl, -c * cl), (-s * sl, cl, -c * sl), (c, 0.0, -s))


@compiled
def tangent_plane(lat: float, lon: float, alt: float) -> TangentPlane:
    """The tangent plane with its origin at lat [rad], lon [rad], alt [m]."""
    return TangentPlane(lat, lon, alt, geodetic_to_ecef(lat, lon, alt), R_en(lat, lon))


@compiled
def geodetic_to_ned(plane: TangentPlane, lat: float, lon: float, alt: float) -> Vec3:
    """Position p_n in the plane's north-east-down frame [m]."""
    return matvec(transpose(plane.R_en), sub(geodetic_to_ecef(lat, lon, alt), plane.p_e))


@compiled
def ned_to_geodetic(plane: TangentPlane, p_n: Vec3) -> Vec3:
    """Latitude [rad], longitude [rad] and altitude [m] of `p_n`, the inverse of the above."""
    return ecef_to_geodetic(add(plane.p_e, matvec(plane.R_en, p_n)))


@compiled
def R_level(plane: TangentPlane, lat: float, lon: float) -> Mat3:
    """R_nl: from north-east-down at (lat, lon) to the plane's north-east-down.

    A velocity or an attitude that an autopilot reports is north-east-down where the vehicle
    is; 1 km from the origin the two differ by about 0.01 degree.
    """
    return matmul(transpose(plane.R_en), R_en(lat, lon))


@compiled
def place_in_plane(
    origin: Vec3, lat: float, lon: float, alt: float, v_l: Vec3
) -> tuple[Vec3, Vec3]:
    """Position p_n [m] and velocity v_n [m/s] of a vehicle at (lat, lon, alt).

    They are in the tangent plane at `origin` (lat, lon, alt), made anew here: a tuple crosses
    into compiled code faster than a TangentPlane. `v_l` is north-east-down at the vehicle.
    """
    plane = tangent_plane(origin[0], origin[1], origin[2])
    return geodetic_to_ned(plane, lat, lon, alt), matvec(R_level(plane, lat, lon), v_l)
