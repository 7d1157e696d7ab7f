"""What the software autopilot believes of its aircraft, in the frames it reports in."""

from typing import NamedTuple

from vfguide.geometry.atmosphere import calibrated_airspeed, isa_density
from vfguide.geometry.projection import project
from vfguide.geometry.vector import Vec3
from vfguide.sim.truth import Truth

WIND_SMOOTHING = 5.0
"""Time constant of the wind estimate [s]."""


class Estimate(NamedTuple):
    """One aircraft at one instant, SI units, angles in radians."""

    time: float
    """Since the autopilot started [s]."""
    latitude: float
    longitude: float
    altitude: float
    """[m]; AMSL and ellipsoid are the same here."""
    p_l: Vec3
    """Position in the local frame [m]."""
    v_n: Vec3
    """Velocity over ground, NED [m/s]."""
    euler: Vec3
    """Roll, pitch, yaw [rad]."""
    omega_b: Vec3
    """Body rates [rad/s]."""
    calibrated_airspeed: float
    true_airspeed: float
    """[m/s]"""
    wind_n: Vec3
    """Wind, the direction it blows toward, NED [m/s]."""


class Origin(NamedTuple):
    """Origin of an autopilot's local frame: where it started."""

    latitude: float
    longitude: float
    """[rad]"""
    altitude: float
    """[m]"""


class Estimator:
    """Turns the truth into what an autopilot would report.

    Position, velocity, attitude, rates and airspeed are exact here; the wind is the true one
    behind a low-pass filter that begins settled.
    """

    def __init__(self, first: Truth) -> None:
        self.origin = Origin(first.latitude, first.longitude, first.altitude)
        self._wind_n = first.wind_n
        self._time = first.time

    def update(self, truth: Truth) -> Estimate:
        """The estimate at the time of `truth`."""
        origin = self.origin
        blend = min((truth.time - self._time) / WIND_SMOOTHING, 1.0)
        self._time = truth.time
        n, e, d = self._wind_n
        north, east, down = truth.wind_n
        self._wind_n = (
            n + blend * (north - n),
            e + blend * (east - e),
            d + blend * (down - d),
        )
        x, y = project(origin.latitude, origin.longitude, truth.latitude, truth.longitude)
        return Estimate(
            truth.time,
            truth.latitude,
            truth.longitude,
            truth.altitude,
            (x, y, origin.altitude - truth.altitude),
            truth.v_n,
            (truth.roll, truth.pitch, truth.yaw),
            truth.omega_b,
            calibrated_airspeed(truth.airspeed, isa_density(truth.altitude)),
            truth.airspeed,
            self._wind_n,
        )
