"""Errors of measurements: white noise, drifts and constant parts, all from seeds of their own."""

import math
from collections.abc import Iterator
from itertools import islice
from typing import NamedTuple

from vfguide.geometry.vector import Vec3
from vfguide.sim.autopilot.instruments import Errors
from vfguide.sim.normals import normals
from vfguide.sim.signals import InnerTuple

VELOCITY_TIME = 1.0
"""Time constant of the errors of velocity [s]; chosen as that of a filter that blends GNSS and
inertial measurements."""
ATTITUDE_TIME = 30.0
"""Time constant of the drift of the attitude [s]; chosen."""
WIND_TIME = 30.0
"""Time constant of the drift of the wind estimate [s]; chosen."""


class Bias(NamedTuple):
    """Constant parts of the errors."""

    roll: float
    """Constant error of roll [rad]."""
    pitch: float
    """Constant error of pitch [rad]."""
    yaw: float
    """Constant error of yaw [rad]."""
    airspeed: float
    """Constant error of the airspeed [m/s]."""


class Errs(NamedTuple):
    """Errors at one instant: told minus true."""

    p_n: Vec3
    """Error of the position, NED [m]."""
    v_n: Vec3
    """Error of the velocity over ground, NED [m/s]."""
    euler: Vec3
    """Errors of roll, pitch and yaw [rad]."""
    airspeed: float
    """Error of the true airspeed [m/s]."""
    wind_n: Vec3
    """Error of the wind, NED [m/s]."""


class Drift:
    """First-order Gauss-Markov process: x' = x exp(-dt/T) + sigma sqrt(1 - exp(-2 dt/T)) N(0, 1).

    It begins settled, so that its standard deviation is sigma at all times.
    """

    def __init__(self, source: Iterator[float], sigma: float, time: float) -> None:
        """A process with standard deviation `sigma` and the time constant `time` [s]."""
        self.value = sigma * next(source)
        """Present value, in the unit of `sigma`."""
        self._source, self._sigma, self._time = source, sigma, time

    def step(self, dt: float) -> float:
        """Its value `dt` [s] later."""
        kept = math.exp(-dt / self._time)
        self.value *= kept
        self.value += self._sigma * math.sqrt(1.0 - kept * kept) * next(self._source)
        return self.value


class StateNoise:
    """Errors of what an autopilot believes, but for the body rates."""

    def __init__(self, errors: Errors, seed: int) -> None:
        self._errors = errors
        self._source = normals(seed)
        e = errors
        sigmas = Bias(e.attitude_bias, e.attitude_bias, e.yaw_bias, e.airspeed_bias)
        self._bias = Bias(*(sigma * next(self._source) for sigma in sigmas))
        drift = e.drift
        kinds = (
            *((e.position, drift), (e.position, drift), (e.height, drift)),
            *((e.velocity, VELOCITY_TIME),) * 3,
            *((e.attitude, ATTITUDE_TIME), (e.attitude, ATTITUDE_TIME), (e.yaw, ATTITUDE_TIME)),
            *((e.wind, WIND_TIME),) * 2,
        )
        self._drifts = [Drift(self._source, sigma, time) for sigma, time in kinds]

    def step(self, dt: float) -> Errs:
        """The errors `dt` [s] later."""
        n, e, d, vn, ve, vd, roll, pitch, yaw, wn, we = (drift.step(dt) for drift in self._drifts)
        bias = self._bias
        return Errs(
            (n, e, d),
            (vn, ve, vd),
            (roll + bias.roll, pitch + bias.pitch, yaw + bias.yaw),
            self._errors.airspeed * next(self._source) + bias.airspeed,
            (wn, we, 0.0),
        )


class RateNoise:
    """Errors of the measured body rates, at every step of the plant."""

    def __init__(self, errors: Errors, seed: int) -> None:
        self._source = normals(seed)
        self._sigma = errors.rate
        p, q, r = islice(self._source, 3)
        bias = errors.rate_bias
        self.last: Vec3 = (bias * p, bias * q, bias * r)
        """Errors of p, q, r that were added last [rad/s]."""
        self._bias = self.last

    def measure(self, inner: InnerTuple, airspeed_error: float) -> InnerTuple:
        """What the inner loop gets to see; the airspeed is off by `airspeed_error` [m/s]."""
        p, q, r, alpha, beta, airspeed, density = inner
        sigma, source, bias = self._sigma, self._source, self._bias
        last = (
            bias[0] + sigma * next(source),
            bias[1] + sigma * next(source),
            bias[2] + sigma * next(source),
        )
        self.last = last
        measured = airspeed + airspeed_error
        return (p + last[0], q + last[1], r + last[2], alpha, beta, measured, density)
