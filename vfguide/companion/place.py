"""From the autopilot's own local frame to the frame of the plan."""

from typing import NamedTuple

from vfguide.flight.state import FlightState
from vfguide.geometry.atmosphere import isa_density, true_airspeed
from vfguide.geometry.compiled import compiled
from vfguide.geometry.geodesy import R_level, TangentPlane, geodetic_to_ned
from vfguide.geometry.projection import reproject
from vfguide.geometry.so3 import from_quaternion
from vfguide.geometry.vector import Vec3, add, matmul, matvec, scale


class Local(NamedTuple):
    """Origin of the autopilot's local frame."""

    lat: float
    lon: float
    """[rad]"""
    alt: float
    """[m], in the plan's own reference of height."""


@compiled
def place_state(
    frame: TangentPlane,
    local: Local,
    time: float,
    p_l: Vec3,
    v_l: Vec3,
    ahead: float,
    q_lb: tuple[float, float, float, float],
    calibrated: float,
    altitude: float,
    wind_l: Vec3,
) -> FlightState:
    """The state in the plane `frame`.

    Args:
        frame: tangent plane of the plan.
        local: origin of the autopilot's projection (PX4's, on a sphere).
        time: of the attitude [s].
        p_l: position in the local frame [m], down from the origin's altitude.
        v_l: velocity, north-east-down at the vehicle [m/s].
        ahead: the attitude is this much newer than the position [s].
        q_lb: attitude w, x, y, z, body to north-east-down at the vehicle.
        calibrated: airspeed [m/s].
        altitude: above mean sea level [m], for the density of the air.
        wind_l: wind toward, north-east-down at the vehicle [m/s].
    """
    p = add(p_l, scale(ahead, v_l))
    lat, lon = reproject(local.lat, local.lon, p[0], p[1])
    R_nl = R_level(frame, lat, lon)
    return FlightState(
        time,
        geodetic_to_ned(frame, lat, lon, local.alt - p[2]),
        matvec(R_nl, v_l),
        matmul(R_nl, from_quaternion(q_lb)),
        true_airspeed(calibrated, isa_density(altitude)),
        matvec(R_nl, wind_l),
    )
