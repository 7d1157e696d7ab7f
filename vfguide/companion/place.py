"""From the autopilot's own local frame to the frame of the plan."""

from vfguide.flight.state import FlightState
from vfguide.geometry.atmosphere import isa_density, true_airspeed
from vfguide.geometry.compiled import compiled
from vfguide.geometry.geodesy import R_level, geodetic_to_ned, tangent_plane
from vfguide.geometry.projection import reproject
from vfguide.geometry.so3 import from_quaternion
from vfguide.geometry.vector import Vec3, add, matmul, matvec, scale

Heard = tuple[float, Vec3, Vec3, Vec3, float, tuple[float, float, float, float], float, float, Vec3]
"""What an autopilot said, see `place_state`."""


@compiled
def place_state(heard: Heard, origin: Vec3) -> FlightState:
    """The state in the tangent plane at `origin`: latitude, longitude [rad], altitude [m].

    What was heard, in this order:
        time: of the attitude [s].
        local: origin of the autopilot's projection (PX4's, on a sphere), as `origin`.
        p_l: position in the local frame [m], down from its origin's altitude.
        v_l: velocity, north-east-down at the vehicle [m/s].
        ahead: the attitude is this much newer than the position [s].
        q_lb: attitude w, x, y, z, body to north-east-down at the vehicle.
        calibrated: airspeed [m/s].
        altitude: above mean sea level [m], for the density of the air.
        wind_l: wind toward, north-east-down at the vehicle [m/s].
    """
    time, local, p_l, v_l, ahead, q_lb, calibrated, altitude, wind_l = heard
    p = add(p_l, scale(ahead, v_l))
    lat, lon = reproject(local[0], local[1], p[0], p[1])
    plane = tangent_plane(origin[0], origin[1], origin[2])
    R_nl = R_level(plane, lat, lon)
    return FlightState(
        time,
        geodetic_to_ned(plane, lat, lon, local[2] - p[2]),
        matvec(R_nl, v_l),
        matmul(R_nl, from_quaternion(q_lb)),
        true_airspeed(calibrated, isa_density(altitude)),
        matvec(R_nl, wind_l),
    )
