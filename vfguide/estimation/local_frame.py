"""From the autopilot's own local frame to the frame of the plan."""

from typing import NamedTuple

from vfguide.aircraft.state import FlightState
from vfguide.geometry.atmosphere import isa_density, true_airspeed
from vfguide.geometry.compiled import compiled
from vfguide.geometry.geodesy import R_level, geodetic_to_ned, tangent_plane
from vfguide.geometry.projection import geodetic_of
from vfguide.geometry.rows import replacing
from vfguide.geometry.so3 import exp, from_quaternion
from vfguide.geometry.units import G0
from vfguide.geometry.vector import Mat3, Vec3, add, matmul, matvec, scale

Quaternion = tuple[float, float, float, float]
STEEPEST = 0.5
"""Cosine of the bank beyond which a turn is not predicted to become tighter."""


class Measurement(NamedTuple):
    """What an autopilot told."""

    time: float
    """Of the attitude [s]."""
    origin: Vec3
    """Of the autopilot's local frame: latitude, longitude [rad] and altitude [m]."""
    p_l: Vec3
    """Position in the local frame [m], down from its origin's altitude."""
    v_l: Vec3
    """Velocity, north-east-down at the vehicle [m/s]."""
    ahead: float
    """The attitude is this much newer than the position [s]."""
    q_lb: Quaternion
    """Attitude w, x, y, z, body to north-east-down at the vehicle."""
    calibrated: float
    """Calibrated airspeed [m/s]; no number: not told."""
    altitude: float
    """Above mean sea level [m], for the density of the air."""
    wind_l: Vec3
    """Wind toward, north-east-down at the vehicle [m/s]; no numbers: not told."""
    omega_b: Vec3
    """Body rates [rad/s]."""
    lead: float
    """The state is wanted so much later than the attitude [s]."""
    projection: int
    """The `Projection` of the local frame."""


MeasurementTuple = tuple[
    float, Vec3, Vec3, Vec3, float, Quaternion, float, float, Vec3, Vec3, float, int
]
"""A `Measurement` without its names, as it crosses into compiled code."""
_at_attitude = replacing(Measurement, "lead")


@compiled
def place_state(m: Measurement, origin: Vec3) -> FlightState:
    """The state in the tangent plane at `origin`: latitude, longitude [rad], altitude [m]."""
    v_then, R_lb = extrapolated(m.v_l, from_quaternion(m.q_lb), m.omega_b, m.lead)
    p = add(m.p_l, add(scale(m.ahead + 0.5 * m.lead, m.v_l), scale(0.5 * m.lead, v_then)))
    lat, lon = geodetic_of(m.projection, m.origin[0], m.origin[1], p[0], p[1])
    plane = tangent_plane(origin[0], origin[1], origin[2])
    R_nl = R_level(plane, lat, lon)
    return FlightState(
        m.time,
        geodetic_to_ned(plane, lat, lon, m.origin[2] - p[2]),
        matvec(R_nl, v_then),
        matmul(R_nl, R_lb),
        true_airspeed(m.calibrated, isa_density(m.altitude)),
        matvec(R_nl, m.wind_l),
    )


@compiled
def place_measured(m: Measurement, origin: Vec3) -> FlightState:
    """The same at the time of the attitude: nothing is predicted."""
    return place_state(_at_attitude(m, 0.0), origin)


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
