"""What the software autopilot believes of its aircraft, in the frames it reports in."""

import math
from typing import NamedTuple

from vfguide.earth.atmosphere import calibrated_airspeed, isa_density
from vfguide.earth.pressure_altitude import pressure_altitude
from vfguide.earth.projection import project, reproject
from vfguide.geometry.vector import Vec3, add, norm, sub
from vfguide.kernels.compiled import compiled
from vfguide.kernels.written_functions import maker
from vfguide.sim.autopilot.instruments import AirspeedFault, Instruments
from vfguide.sim.autopilot.noise import Errs, StateNoise
from vfguide.sim.truth import Truth

WIND_SMOOTHING = 5.0
"""Time constant of the autopilot's wind estimate [s]; chosen."""
NO_ERRORS = Errs((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, (0.0, 0.0, 0.0))
"""The errors of exact instruments, all zero."""


class Estimate(NamedTuple):
    """One aircraft at one instant, SI units, angles in radians."""

    time: float
    """Time since the autopilot started [s]."""
    latitude: float
    """Geodetic latitude [rad]."""
    longitude: float
    """Longitude [rad]."""
    altitude: float
    """Altitude above mean sea level [m]."""
    p_l: Vec3
    """Position in the local frame, NED from its origin [m]."""
    v_n: Vec3
    """Velocity over ground, NED [m/s]."""
    euler: Vec3
    """Roll, pitch, yaw of body FRD against NED, Euler angles z-y-x [rad]."""
    omega_b: Vec3
    """Body rates p, q, r, FRD [rad/s]."""
    calibrated_airspeed: float
    """Calibrated airspeed that is told [m/s]; not a number without a sensor."""
    true_airspeed: float
    """True airspeed that it flies on [m/s]: without a sensor, ground velocity less wind."""
    wind_n: Vec3
    """Wind, the direction it blows toward, NED [m/s]."""


_estimate = maker(Estimate)


class Origin(NamedTuple):
    """Origin of an autopilot's local frame: where it started, until it is reset."""

    latitude: float
    """Geodetic latitude [rad]."""
    longitude: float
    """Longitude [rad]."""
    altitude: float
    """Altitude above mean sea level [m]."""


@compiled
def on_instruments(
    origin_lat: float, origin_lon: float, lat: float, lon: float, airspeed: float, altitude: float
) -> Vec3:
    """North and east of the local origin [m], and the calibrated airspeed [m/s].

    Args:
        origin_lat: latitude of that origin [rad].
        origin_lon: its longitude [rad].
        lat: latitude of the aircraft [rad].
        lon: its longitude [rad].
        airspeed: its true airspeed [m/s].
        altitude: its altitude, which sets the density of the air [m].
    """
    x, y = project(origin_lat, origin_lon, lat, lon)
    return x, y, calibrated_airspeed(airspeed, isa_density(altitude))


class Estimator:
    """Turns the truth into what an autopilot would report.

    Without errors position, velocity, attitude, rates and airspeed are exact; the wind is the
    true one behind a low-pass filter that begins settled.
    """

    def __init__(self, first: Truth, instruments: Instruments) -> None:
        """An estimator that starts at the truth `first`."""
        self.origin = Origin(first.latitude, first.longitude, first.altitude)
        """Origin of the local frame; resets move it."""
        self.home = self.origin
        """Where the autopilot started."""
        self.error = NO_ERRORS
        """Told minus true, at the latest update; of the position without its resets."""
        self.undulation = instruments.undulation
        self._qnh_altitude = pressure_altitude(instruments.qnh)
        self._altitude = first.altitude
        """Height of mean sea level above the ellipsoid [m]."""
        self._instruments = instruments
        self._resets = list(instruments.resets)
        self._offset_n: Vec3 = (0.0, 0.0, 0.0)
        self._airspeed = first.airspeed
        errors = instruments.errors
        self._noise = None if errors is None else StateNoise(errors, instruments.seed)
        self._wind_n = first.wind_n
        self._time = first.time

    @property
    def pressure_altitude(self) -> float:
        """Height at which the standard atmosphere has the pressure of the air around it [m]."""
        return self._altitude + self._qnh_altitude

    def has_airspeed(self, time: float) -> bool:
        """Whether the airspeed sensor works at a `time` [s]."""
        return time < self._instruments.airspeed_fails

    def update(self, truth: Truth, rate_error: Vec3 = (0.0, 0.0, 0.0)) -> Estimate:
        """The estimate at the time of `truth`; `rate_error` is that of the body rates [rad/s]."""
        time, _, _, true_altitude, v_n, roll, pitch, yaw, omega_b, _, _, _, wind_n, *_ = truth
        dt = time - self._time
        self._time, self._altitude = time, true_altitude
        self._follow_wind(wind_n, min(dt / WIND_SMOOTHING, 1.0))
        self._reset(time)
        wind_n, euler = self._wind_n, (roll, pitch, yaw)
        if self._noise is not None:
            self.error = error = self._noise.step(dt)
            v_n, wind_n = add(v_n, error.v_n), add(wind_n, error.wind_n)
            euler, omega_b = add(euler, error.euler), add(omega_b, rate_error)
        origin = self.origin
        latitude, longitude, altitude = self._place(truth)
        sensed, own = self._airspeeds(truth, v_n, wind_n)
        x, y, calibrated = on_instruments(
            origin.latitude, origin.longitude, latitude, longitude, sensed, true_altitude
        )
        below = (x, y, origin.altitude - altitude)
        place = (latitude, longitude, altitude, below)
        return _estimate((time, *place, v_n, euler, omega_b, calibrated, own, wind_n))

    def _follow_wind(self, wind_n: Vec3, blend: float) -> None:
        n, e, d = self._wind_n
        north, east, down = wind_n
        self._wind_n = (
            n + blend * (north - n),
            e + blend * (east - e),
            d + blend * (down - d),
        )

    def _reset(self, time: float) -> None:
        """The jumps that are due."""
        while self._resets and self._resets[0].time <= time:
            reset = self._resets.pop(0)
            self._offset_n = add(self._offset_n, reset.position)
            north, east, down = reset.origin
            latitude, longitude, altitude = self.origin
            if any(reset.origin):
                self.origin = Origin(*reproject(latitude, longitude, north, east), altitude - down)

    def _place(self, truth: Truth) -> Vec3:
        """Latitude, longitude [rad] and altitude [m] where it believes to be."""
        if self._noise is None and not any(self._offset_n):
            return truth.latitude, truth.longitude, truth.altitude
        north, east, down = add(self.error.p_n, self._offset_n)
        place = reproject(truth.latitude, truth.longitude, north, east)
        return (*place, truth.altitude - down)

    def _airspeeds(self, truth: Truth, v_n: Vec3, wind_n: Vec3) -> tuple[float, float]:
        """True airspeeds [m/s]: what the sensor tells, and what the autopilot flies on."""
        if self.has_airspeed(truth.time):
            self._airspeed = max(truth.airspeed + self.error.airspeed, 0.0)
            return self._airspeed, self._airspeed
        by_fault = {
            AirspeedFault.MISSING: math.nan,
            AirspeedFault.FROZEN: self._airspeed,
            AirspeedFault.BLOCKED: 0.0,
        }
        return by_fault[self._instruments.airspeed_fault], norm(sub(v_n, wind_n))
