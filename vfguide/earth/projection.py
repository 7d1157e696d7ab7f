"""The local frames of autopilots: projections of the earth about an origin.

LOCAL_POSITION_NED is in such a frame, not in a tangent plane of the ellipsoid. PX4's is an
azimuthal-equidistant projection of the sphere: 1 km east of an origin at 46.8 degrees the two
differ by 3 m.
"""

import math
from enum import IntEnum

from vfguide.geometry.angles import wrap
from vfguide.kernels.compiled import compiled

EARTH_RADIUS = 6_371_000.0
"""Radius of the spherical earth of PX4's map projection [m] (CONSTANTS_RADIUS_OF_EARTH)."""


class Projection(IntEnum):
    """Kinds of local frames."""

    AZIMUTHAL_EQUIDISTANT = 0
    """Of the sphere, as PX4's: `reproject`."""


@compiled
def project(origin_lat: float, origin_lon: float, lat: float, lon: float) -> tuple[float, float]:
    """North and east [m] of a point; all arguments in radians.

    PX4's MapProjection::project: x = k (cos lat0 sin lat - sin lat0 cos lat cos dlon) R,
    y = k cos lat sin dlon R, k = c / sin c, c the angle between the two. The antipode, which
    has no image, comes out at the origin.
    """
    s0, c0 = math.sin(origin_lat), math.cos(origin_lat)
    s, c = math.sin(lat), math.cos(lat)
    cos_dlon = math.cos(lon - origin_lon)
    north = c0 * s - s0 * c * cos_dlon
    east = c * math.sin(lon - origin_lon)
    sine = math.hypot(north, east)
    if sine == 0.0:
        return (0.0, 0.0)
    k = math.atan2(sine, s0 * s + c0 * c * cos_dlon) / sine * EARTH_RADIUS
    return (k * north, k * east)


@compiled
def reproject(origin_lat: float, origin_lon: float, x: float, y: float) -> tuple[float, float]:
    """Latitude and longitude in [-pi, pi) [rad] of the point x north, y east [m] of the origin.

    PX4's MapProjection::reproject, with the arc sine written as an arc tangent, which is
    exact at the poles too.
    """
    c = math.hypot(x, y) / EARTH_RADIUS
    k = math.sin(c) / (c * EARTH_RADIUS) if c > 0.0 else 0.0
    up, north, east = math.cos(c), k * x, k * y
    s0, c0 = math.sin(origin_lat), math.cos(origin_lat)
    axial = up * c0 - north * s0
    lat = math.atan2(up * s0 + north * c0, math.hypot(axial, east))
    return (lat, wrap(origin_lon + math.atan2(east, axial)))


@compiled
def geodetic_of(
    projection: int, origin_lat: float, origin_lon: float, x: float, y: float
) -> tuple[float, float]:
    """Latitude and longitude in [-pi, pi) [rad] of the point x north, y east [m] of the origin.

    `projection` is a `Projection`; no numbers come out for any other number.
    """
    if projection == Projection.AZIMUTHAL_EQUIDISTANT:
        return reproject(origin_lat, origin_lon, x, y)
    return (math.nan, math.nan)
