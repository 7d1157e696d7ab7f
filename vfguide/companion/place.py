"""From the autopilot's own local frame to the frame of the plan."""

from vfguide.flight.state import FlightState
from vfguide.geometry.atmosphere import isa_density, true_airspeed
from vfguide.geometry.compiled import compiled
from vfguide.geometry.geodesy import R_level, geodetic_to_ned, tangent_plane
from vfguide.geometry.projection import reproject
from vfguide.geometry.so3 import exp, from_quaternion
from vfguide.geometry.units import G0
from vfguide.geometry.vector import Mat3, Vec3, add, matmul, matvec, scale

Quaternion = tuple[float, float, float, float]
Heard = tuple[float, Vec3, Vec3, Vec3, float, Quaternion, float, float, Vec3, Vec3, float]
"""What an autopilot said, see `place_state`."""
STEEPEST = 0.5
"""Cosine of the bank beyond which a turn is not predicted to become tighter."""


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
        omega_b: body rates [rad/s].
        lead: the state is wanted so much later than the attitude [s].
    """
    time, local, p_l, v_l, ahead, q_lb, calibrated, altitude, wind_l, omega_b, lead = heard
    v_then, R_lb = extrapolated(v_l, from_quaternion(q_lb), omega_b, lead)
    p = add(p_l, add(scale(ahead + 0.5 * lead, v_l), scale(0.5 * lead, v_then)))
    lat, lon = reproject(local[0], local[1], p[0], p[1])
    plane = tangent_plane(origin[0], origin[1], origin[2])
    R_nl = R_level(plane, lat, lon)
    return FlightState(
        time,
        geodetic_to_ned(plane, lat, lon, local[2] - p[2]),
        matvec(R_nl, v_then),
        matmul(R_nl, R_lb),
        true_airspeed(calibrated, isa_density(altitude)),
        matvec(R_nl, wind_l),
    )


@compiled
def place_told(heard: Heard, origin: Vec3) -> FlightState:
    """The same at the time of the attitude: nothing is predicted."""
    return place_state((*heard[:10], 0.0), origin)


@compiled
def extrapolated(v_n: Vec3, R_nb: Mat3, omega_b: Vec3, lead: float) -> tuple[Vec3, Mat3]:
    """Velocity [m/s] and attitude `lead` [s] later.

    The body rates [rad/s] stay, and the lift carries the weight: it turns the velocity to where
    the bank, half way, leans.
    """
    half = matmul(R_nb, exp(scale(0.5 * lead, omega_b)))
    down = max(half[2][2], STEEPEST)
    lean = scale(-G0 * lead / down, (half[0][2], half[1][2], 0.0))
    return add(v_n, lean), matmul(R_nb, exp(scale(lead, omega_b)))
