"""Point-mass model of the guided aircraft, commanded by bank and path angle, with lags.

The bank follows its command with a first-order lag and a largest roll rate, the path angle with a
first-order lag; the airspeed is constant, and the azimuth turns at g tan(bank) / V (Beard and
McLain, Small Unmanned Aircraft, 2012, chapter 9: the kinematic guidance models).
"""

import math
from typing import NamedTuple

from vfguide.aircraft.envelope import usable_bank
from vfguide.aircraft.path_limits import descent_at_airspeed
from vfguide.aircraft.performance import Gains, Performance
from vfguide.geometry.units import G0
from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled

RATE_LAG = 0.08
"""Time constant of the body rates behind their setpoints [s], the roll response for which the
default gains are made."""
ROLL_SHARE = 0.8
"""Share of the largest roll rate that a roll of the guided aircraft reaches; chosen below 1, so
that predicted turns are no quicker than flown ones."""
PATH_LAG = 0.03
"""Time constant of the path angle over the airspeed [s^2/m], chosen: 0.75 s at 25 m/s."""


class PointMass(NamedTuple):
    """An aircraft moving through the air."""

    p_n: Vec3
    """Position, NED [m]."""
    azimuth: float
    """Azimuth of the air velocity [rad]."""
    bank: float
    """Bank, right wing down positive [rad]."""
    gamma: float
    """Path angle through the air, up positive [rad]."""
    airspeed: float
    """True airspeed [m/s]."""


class Dynamics(NamedTuple):
    """What limits and delays the motion."""

    bank_max: float
    """Largest bank [rad]."""
    climb_max: float
    """Steepest path angle of a climb [rad], positive."""
    descent_max: float
    """Steepest path angle of a descent [rad], positive."""
    roll_rate: float
    """Fastest change of the bank [rad/s]."""
    bank_lag: float
    """Time constant of the bank [s]."""
    path_lag: float
    """Time constant of the path angle [s]."""


@compiled
def dynamics(aircraft: Performance, gains: Gains) -> Dynamics:
    """Limits and lags of an aircraft under the flight law, at the airspeed to fly."""
    return Dynamics(
        usable_bank(aircraft, gains, gains.airspeed),
        aircraft.climb_max,
        descent_at_airspeed(aircraft, 0.0),
        ROLL_SHARE * aircraft.rate_max[0],
        1.0 / gains.k_w + RATE_LAG + gains.response_lag,
        PATH_LAG * gains.airspeed + gains.response_lag,
    )


@compiled
def advance(
    motion: PointMass, bank: float, gamma: float, wind_n: Vec3, limits: Dynamics, dt: float
) -> PointMass:
    """The point mass `dt` [s] later, or earlier, under a commanded bank and path angle [rad].

    Bank and path angle are exact. The turn is integrated by Simpson's rule, the position with the
    direction in the middle of the step. `wind_n` blows toward, NED [m/s].
    """
    half = lagged(motion.bank, bank, limits.bank_lag, limits.roll_rate, 0.5 * dt)
    after = lagged(half, bank, limits.bank_lag, limits.roll_rate, 0.5 * dt)
    fall = math.exp(-0.5 * dt / limits.path_lag)
    climb = gamma + fall * (motion.gamma - gamma)
    first, middle, last = math.tan(motion.bank), math.tan(half), math.tan(after)
    turn = G0 * dt / motion.airspeed
    along = motion.azimuth + turn * (5.0 * first + 8.0 * middle - last) / 24.0
    flat = dt * motion.airspeed * math.cos(climb)
    p_n = (
        motion.p_n[0] + flat * math.cos(along) + dt * wind_n[0],
        motion.p_n[1] + flat * math.sin(along) + dt * wind_n[1],
        motion.p_n[2] - dt * motion.airspeed * math.sin(climb) + dt * wind_n[2],
    )
    azimuth = motion.azimuth + turn * (first + 4.0 * middle + last) / 6.0
    return PointMass(p_n, azimuth, after, gamma + fall * (climb - gamma), motion.airspeed)


@compiled
def lagged(value: float, wanted: float, lag: float, rate: float, dt: float) -> float:
    """Solution `dt` [s] later, or earlier, of x' = (wanted - x) / lag with |x'| <= `rate`."""
    error, reach = value - wanted, rate * lag
    if abs(error) > reach:
        limited = (abs(error) - reach) / rate
        if limited >= dt:
            return value - math.copysign(rate, error) * dt
        error, dt = math.copysign(reach, error), dt - limited
    return wanted + error * math.exp(-dt / lag)
