"""Turbulence of MIL-F-8785C, Flying Qualities of Piloted Airplanes, 1980, 3.7, in Dryden's form.

The air is a field of gusts that drifts with the mean wind and does not change otherwise. An
aircraft meets it along its path: what is left of a gust depends on the distance flown through the
air, not on time. With x, that distance over the scale length L, Dryden's spectra (3.7.1.2) and
their correlations are

    along the path   s^2 (2 L / pi) / (1 + (L W)^2)                      exp(-x)
    across it        s^2 (L / pi) (1 + 3 (L W)^2) / (1 + (L W)^2)^2      (1 - x/2) exp(-x)

at W radians a metre. The first is one first-order stage, the second two. Kept from step to step
are gusts over their standard deviation s, and the steps are exact: whatever their lengths and
airspeeds, the variance stays one. Horizontal gusts are kept north and east, for an aircraft that
turns does not turn the air; their stages act along and across the horizontal direction of flight,
at all heights.
"""

import math
from enum import Enum
from itertools import islice
from typing import NamedTuple

import numpy as np

from vfguide.geometry.units import FT, KT
from vfguide.geometry.vector import Vec3, norm
from vfguide.sim.normals import normals

LEAST_HEIGHT = 10.0 * FT
"""Least height above ground of the low-altitude forms [m] (MIL-F-8785C, figures 10 and 11)."""
LOW_ALTITUDE = 1000.0 * FT
"""Height above ground up to which the low-altitude forms hold [m] (MIL-F-8785C, 3.7.3)."""
MEDIUM_ALTITUDE = 2000.0 * FT
"""Height above ground from which the medium-altitude forms hold [m] (MIL-F-8785C, 3.7.2)."""
MEDIUM_LENGTH = 1750.0 * FT
"""Scale length of all components in the medium-altitude forms [m] (MIL-F-8785C, 3.7.2.1)."""
SLEAST_HEIGHT = 1.0
"""Airspeed with which an aircraft meets new air at least [m/s]; chosen, so that the air changes
round one that stands still in it."""
UNCHANGED = 1e-9
"""Ratio of distance to scale length below which nothing new is met; chosen above rounding."""


def in_feet(*values: float) -> tuple[float, ...]:
    """Numbers of the standard, which are feet or feet a second, in SI."""
    return tuple(FT * value for value in values)


CURVE_HEIGHTS = in_feet(500, 1750, 3750, 7500, 15e3, 25e3, 35e3, 45e3, 55e3, 65e3, 75e3, 80e3)
"""Heights at which the curves of the standard deviation are read [m] (MIL-F-8785C, figure 7)."""


class Intensity(NamedTuple):
    """How strong the gusts are, by height."""

    wind_at_20_ft: float
    """Mean wind 20 ft above ground, W20, which scales the low-altitude forms [m/s]."""
    curve: tuple[float, ...]
    """Standard deviations at `CURVE_HEIGHTS` of the medium-altitude forms [m/s]."""


class Turbulence(Enum):
    """Intensities of MIL-F-8785C: W20 of 3.7.3, and a curve of figure 7.

    The curves are those that light, moderate and severe turbulence have there: they are exceeded
    with probabilities of 10^-2, 10^-3 and 10^-5.
    """

    NONE = Intensity(0.0, in_feet(*12 * (0.0,)))
    LIGHT = Intensity(
        15.0 * KT,
        in_feet(6.6, 6.9, 7.4, 6.7, 4.6, 2.7, 0.4, 0.0, 0.0, 0.0, 0.0, 0.0),
    )
    MODERATE = Intensity(
        30.0 * KT,
        in_feet(8.6, 9.6, 10.6, 10.1, 8.0, 6.6, 5.0, 4.2, 2.7, 0.0, 0.0, 0.0),
    )
    SEVERE = Intensity(
        45.0 * KT,
        in_feet(15.6, 17.6, 23.0, 23.6, 22.1, 20.0, 16.0, 15.1, 12.1, 7.9, 6.2, 5.1),
    )


class Scales(NamedTuple):
    """Standard deviations and scale lengths at one height."""

    sigma: float
    """Standard deviation of both horizontal components, u and v [m/s]."""
    length: float
    """Scale length of both horizontal components [m]."""
    sigma_w: float
    """Standard deviation of the vertical component [m/s]."""
    length_w: float
    """Scale length of the vertical component [m]."""


def scales_at(turbulence: Turbulence, height: float) -> Scales:
    """Standard deviations and scale lengths at a height above ground [m].

    Between the low and the medium altitude they are linear in the height.
    """
    if height <= LOW_ALTITUDE:
        return low_altitude(turbulence, height)
    if height >= MEDIUM_ALTITUDE:
        return medium_altitude(turbulence, height)
    below = low_altitude(turbulence, LOW_ALTITUDE)
    above = medium_altitude(turbulence, MEDIUM_ALTITUDE)
    part = (height - LOW_ALTITUDE) / (MEDIUM_ALTITUDE - LOW_ALTITUDE)
    return Scales(*(low + part * (high - low) for low, high in zip(below, above, strict=True)))


def low_altitude(turbulence: Turbulence, height: float) -> Scales:
    """The forms near the ground, MIL-F-8785C, 3.7.3, figures 10 and 11; h in feet.

    sigma_w = 0.1 W20, sigma_u = sigma_v = sigma_w / (0.177 + 0.000823 h)^0.4,
    L_w = h, L_u = L_v = h / (0.177 + 0.000823 h)^1.2.
    """
    height = max(height, LEAST_HEIGHT)
    ratio = 0.177 + 0.000823 * height / FT
    sigma_w = 0.1 * turbulence.value.wind_at_20_ft
    return Scales(sigma_w / ratio**0.4, height / ratio**1.2, sigma_w, height)


def medium_altitude(turbulence: Turbulence, height: float) -> Scales:
    """The forms far above ground, the same in all directions; MIL-F-8785C, 3.7.2, figure 7."""
    sigma = float(np.interp(height, CURVE_HEIGHTS, turbulence.value.curve))
    return Scales(sigma, MEDIUM_LENGTH, sigma, MEDIUM_LENGTH)


class Noise(NamedTuple):
    """Independent standard normal numbers of one step."""

    along: float
    """Drives the gust along the path."""
    across: float
    """Drives the gust across the path, and its second stage."""
    second: float
    """Drives the second stage of the gust across the path."""
    down: float
    """Drives the vertical gust, and its second stage."""
    down_second: float
    """Drives the second stage of the vertical gust."""


class Stages(NamedTuple):
    """The two first-order stages of a gust across the path; of variance one and uncorrelated."""

    gust: float
    """Gust over its standard deviation."""
    second: float
    """What else has to be known of the air for the gusts to come."""


class Gusts(NamedTuple):
    """The gusts at one place over their standard deviations, and what is known of those to come."""

    north: float
    """Gust toward north."""
    east: float
    """Gust toward east."""
    second: float
    """Second stage of the gust across the path."""
    vertical: Stages
    """Stages of the gust downward."""


def along_path(gust: float, x: float, noise: float) -> float:
    """A gust along the path, x scale lengths on: y exp(-x) + sqrt(1 - exp(-2 x)) N(0, 1)."""
    return math.exp(-x) * gust + math.sqrt(-math.expm1(-2.0 * x)) * noise


def across_path(stages: Stages, x: float, noise: float, other: float) -> Stages:
    """A gust across the path, x scale lengths on.

    The transfer function (1 + sqrt(3) s) / (1 + s)^2 has two states. In the orthogonal ones
    whose first is the gust the transition is F = exp(-x) [[1 - x/2, k x], [-m x, 1 + x/2]] with
    k, m = 1 -+ sqrt(3)/2. The noise has the covariance I - F F^T, so that I remains I.
    """
    left, half = math.exp(-x), 0.5 * x
    to_gust, to_second = x - math.sqrt(3.0) * half, -x - math.sqrt(3.0) * half
    gust = left * ((1.0 - half) * stages.gust + to_gust * stages.second)
    second = left * (to_second * stages.gust + (1.0 + half) * stages.second)
    if x < UNCHANGED:
        return Stages(gust, second)
    squared = left * left
    lost = 1.0 - squared * ((1.0 - half) ** 2 + to_gust**2)
    shared = -squared * ((1.0 - half) * to_second + to_gust * (1.0 + half))
    second_lost = 1.0 - squared * (to_second**2 + (1.0 + half) ** 2)
    # The factor of Cholesky; what rounding makes of a remainder of order x^3 may be negative.
    common = math.sqrt(lost)
    rest = math.sqrt(max(second_lost - shared * shared / lost, 0.0))
    return Stages(gust + common * noise, second + shared / common * noise + rest * other)


def flown_on(gusts: Gusts, v_air_n: Vec3, dt: float, scales: Scales, noise: Noise) -> Gusts:
    """The gusts a time step later.

    Args:
        gusts: those before it.
        v_air_n: velocity through the mean wind, NED [m/s].
        dt: time step [s].
        scales: those of this height.
        noise: what is new in the air.
    """
    distance = max(norm(v_air_n), SLEAST_HEIGHT) * dt
    x, (ahead_n, ahead_e) = distance / scales.length, direction(v_air_n)
    u = along_path(ahead_n * gusts.north + ahead_e * gusts.east, x, noise.along)
    v_before = Stages(ahead_n * gusts.east - ahead_e * gusts.north, gusts.second)
    v, second = across_path(v_before, x, noise.across, noise.second)
    w = across_path(gusts.vertical, distance / scales.length_w, noise.down, noise.down_second)
    return Gusts(ahead_n * u - ahead_e * v, ahead_e * u + ahead_n * v, second, w)


def direction(v_n: Vec3) -> tuple[float, float]:
    """The horizontal direction of a velocity; north if it has none."""
    north, east, _ = v_n
    speed = math.hypot(north, east)
    return (north / speed, east / speed) if speed > 0.0 else (1.0, 0.0)


def velocity_of(gusts: Gusts, scales: Scales) -> Vec3:
    """Velocity of the air over the mean wind, the direction it moves toward, NED [m/s]."""
    sigma = scales.sigma
    return (sigma * gusts.north, sigma * gusts.east, scales.sigma_w * gusts.vertical.gust)


class GustyAir:
    """The air that one aircraft meets: equal seeds and equal flights meet equal gusts."""

    def __init__(self, turbulence: Turbulence, seed: int) -> None:
        """Air at its start; the gusts have their standard deviations from there on."""
        self._turbulence = turbulence
        self._source = normals(seed)
        north, east, second, down, down_second = islice(self._source, 5)
        self._gusts = Gusts(north, east, second, Stages(down, down_second))

    def gust_at(self, height: float) -> Vec3:
        """The gust of this instant at a height above ground [m], NED [m/s]."""
        return velocity_of(self._gusts, scales_at(self._turbulence, height))

    def fly(self, v_air_n: Vec3, height: float, dt: float) -> Vec3:
        """The gust [m/s] after `dt` [s] at a velocity through the mean wind [m/s], both NED."""
        scales = scales_at(self._turbulence, height)
        noise = Noise(*islice(self._source, 5))
        self._gusts = flown_on(self._gusts, v_air_n, dt, scales, noise)
        return velocity_of(self._gusts, scales)
