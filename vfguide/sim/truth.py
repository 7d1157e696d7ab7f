"""The true state of a simulated vehicle, which no companion sees."""

from typing import NamedTuple

from vfguide.geometry.vector import Vec3


class Truth(NamedTuple):
    """One vehicle at one instant, SI units, angles in radians."""

    time: float
    """Simulated time since the start of the run [s]."""
    latitude: float
    """Geodetic latitude [rad]."""
    longitude: float
    """Longitude [rad]."""
    altitude: float
    """Altitude above mean sea level [m]."""
    v_n: Vec3
    """Velocity over ground, north-east-down at the vehicle [m/s]."""
    roll: float
    """Roll of the body FRD against north-east-down at the vehicle, Euler angles z-y-x [rad]."""
    pitch: float
    """Pitch [rad]."""
    yaw: float
    """Yaw [rad]."""
    omega_b: Vec3
    """Body rates [rad/s]."""
    airspeed: float
    """True airspeed, gusts included [m/s]."""
    alpha: float
    """Angle of attack, gusts included [rad]."""
    beta: float
    """Sideslip, gusts included [rad]."""
    wind_n: Vec3
    """Wind with gusts, the direction it blows toward, NED [m/s]."""
    force_b: Vec3
    """Specific force at the centre of gravity, body FRD [m/s^2]; level flight (0, 0, -g)."""
    density: float
    """Air density [kg/m^3]."""
    height_above_ground: float
    """Height of the centre of gravity above the ground [m]."""
