"""The state of an aircraft, and the setpoint that is sent to its autopilot."""

from typing import NamedTuple

from vfguide.geometry.vector import Mat3, Vec3


class FlightState(NamedTuple):
    """One aircraft at one instant, all in SI units."""

    time: float
    """Time on the aircraft's own clock [s]."""
    p_n: Vec3
    """Position in the guidance frame, NED [m]."""
    v_n: Vec3
    """Velocity over ground, NED [m/s]."""
    R_nb: Mat3
    """Attitude, body FRD to NED."""
    airspeed: float
    """True airspeed [m/s]."""
    wind_n: Vec3
    """Wind, the direction it blows toward, NED [m/s]."""


class RateSetpoint(NamedTuple):
    """Body rates and thrust for a rate-controlled autopilot."""

    omega_b: Vec3
    """Body rates p, q, r [rad/s], FRD."""
    thrust: float
    """Thrust, 0 to 1."""
    q_nb: tuple[float, float, float, float]
    """The reference attitude as a quaternion w, x, y, z (FRD to NED), for the record."""
