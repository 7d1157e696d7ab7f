"""From the autopilot's own local frame to the frame of the plan."""

from typing import NamedTuple, cast

from vfguide.aircraft.state import FlightState
from vfguide.earth.atmosphere import true_airspeed
from vfguide.earth.geodesy import R_level, TangentPlane, geodetic_to_ned, tangent_plane
from vfguide.earth.projection import geodetic_of
from vfguide.geometry.so3 import IDENTITY, exp, from_quaternion
from vfguide.geometry.units import G0
from vfguide.geometry.vector import Mat3, Vec3, add, matmul, matvec, norm, scale
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import replacing

Quaternion = tuple[float, float, float, float]
LEAST_BANK_COSINE = 0.5
"""Least cosine of the bank with which the turn is predicted, 60 degrees; chosen, since the load
factor of a level turn grows without bound."""


FARTHEST_LEVEL = 1e6
"""Distance from the plan above which the vehicle's level plane is taken to be the plan's [m];
chosen. No flight is begun so far away: it is a glitch, which must not tilt the attitude."""


class Measurement(NamedTuple):
    """One measurement of an autopilot, in its own local frame."""

    time: float
    """Time of the attitude [s]."""
    origin: Vec3
    """Origin of the autopilot's local frame: latitude, longitude [rad] and altitude [m]."""
    p_l: Vec3
    """Position in the local frame [m], down from its origin's altitude."""
    v_l: Vec3
    """Velocity, north-east-down at the vehicle [m/s]."""
    ahead: float
    """Time of the attitude less that of the position [s]."""
    q_lb: Quaternion
    """Attitude w, x, y, z, body to north-east-down at the vehicle."""
    calibrated: float
    """Calibrated airspeed [m/s]; not a number where it is not measured."""
    altitude: float
    """Altitude above mean sea level [m]."""
    density: float
    """Density of the air [kg/m^3]."""
    wind_l: Vec3
    """Wind, blowing toward, NED at the vehicle [m/s]; not numbers where it is not measured."""
    omega_b: Vec3
    """Body rates [rad/s]."""
    lead: float
    """Time after the attitude for which the state is predicted [s]."""
    projection: int
    """The `Projection` of the local frame."""


MeasurementTuple = tuple[
    float, Vec3, Vec3, Vec3, float, Quaternion, float, float, float, Vec3, Vec3, float, int
]
"""A `Measurement` without its names, as it crosses into compiled code."""
_at_attitude = replacing(Measurement, "lead")


def without_names(m: Measurement) -> MeasurementTuple:
    """A measurement as it crosses into compiled code."""
    return cast("MeasurementTuple", (*m,))


@compiled
def place_state(m: Measurement, origin: Vec3) -> FlightState:
    """The state in the tangent plane at `origin`: latitude, longitude [rad], altitude [m]."""
    return place_in(m, tangent_plane(origin[0], origin[1], origin[2]))


@compiled
def place_in(m: Measurement, plane: TangentPlane) -> FlightState:
    """The state in a tangent plane."""
    v_then, R_lb = extrapolated(m.v_l, from_quaternion(m.q_lb), m.omega_b, m.lead)
    p = add(m.p_l, add(scale(m.ahead + 0.5 * m.lead, m.v_l), scale(0.5 * m.lead, v_then)))
    lat, lon = geodetic_of(m.projection, m.origin[0], m.origin[1], p[0], p[1])
    p_n = geodetic_to_ned(plane, lat, lon, m.origin[2] - p[2])
    R_nl = R_level(plane, lat, lon) if norm(p_n) < FARTHEST_LEVEL else IDENTITY
    return FlightState(
        m.time,
        p_n,
        matvec(R_nl, v_then),
        matmul(R_nl, R_lb),
        true_airspeed(m.calibrated, m.density),
        matvec(R_nl, m.wind_l),
    )


@compiled
def place_measured(m: Measurement, origin: Vec3) -> FlightState:
    """The state in the tangent plane at `origin` at the time of the attitude, not predicted."""
    return measured_in(m, tangent_plane(origin[0], origin[1], origin[2]))


@compiled
def measured_in(m: Measurement, plane: TangentPlane) -> FlightState:
    """The state in a tangent plane at the time of the attitude, not predicted."""
    return place_in(_at_attitude(m, 0.0), plane)


@compiled
def measured_position(measured: MeasurementTuple, origin: Vec3) -> Vec3:
    """The position p_n of `place_measured` in the tangent plane at `origin` [m]."""
    return place_measured(Measurement(*measured), origin).p_n


@compiled
def distance_from(measured: MeasurementTuple, place: Vec3) -> float:
    """Horizontal distance of a place from the measured position [m].

    The place is latitude, longitude [rad] and altitude [m].
    """
    lat, lon, alt = place
    m = Measurement(*measured)
    own_lat, own_lon = geodetic_of(m.projection, m.origin[0], m.origin[1], m.p_l[0], m.p_l[1])
    return norm(geodetic_to_ned(tangent_plane(own_lat, own_lon, alt), lat, lon, alt))


@compiled
def extrapolated(v_n: Vec3, R_nb: Mat3, omega_b: Vec3, lead: float) -> tuple[Vec3, Mat3]:
    """Velocity [m/s] and attitude `lead` [s] later.

    The body rates [rad/s] are constant, and the lift carries the weight: it turns the velocity at
    the bank in the middle of that time.
    """
    half = matmul(R_nb, exp(scale(0.5 * lead, omega_b)))
    down = max(half[2][2], LEAST_BANK_COSINE)
    lean = scale(-G0 * lead / down, (half[0][2], half[1][2], 0.0))
    return add(v_n, lean), matmul(R_nb, exp(scale(lead, omega_b)))
