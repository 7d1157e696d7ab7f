"""A recorded flight for identification: measurements, setpoints, and means of both."""

import math
from collections.abc import Iterable
from typing import NamedTuple, cast

import numpy as np

from vfguide.aircraft.flight_model import STEEPEST_BANK
from vfguide.aircraft.least_squares import Array, fitted, with_constant
from vfguide.earth.atmosphere import DENSITY_0
from vfguide.geometry.units import G0
from vfguide.geometry.vector import Mask, Mat3, Matrices, Series, Vec3, Vectors
from vfguide.kernels.rows import columns, table_of

WINDOW = 1.0
"""Time over which lift and thrust are averaged before they are compared [s]; chosen longer than
most gusts."""


class Sample(NamedTuple):
    """One instant of a flight, in the units of `Samples`."""

    time: float
    R_nb: Mat3
    v_n: Vec3
    airspeed: float
    density: float
    roll_rate: float
    roll_rate_asked: float
    thrust: float
    delay: float


class Samples(NamedTuple):
    """A flight, at N instants in the order of time: the columns of a table of `Sample`."""

    time: Series
    """(N,) times of the attitudes [s]."""
    R_nb: Matrices
    """(N, 3, 3) attitude, body FRD to NED."""
    v_n: Vectors
    """(N, 3) velocity over ground [m/s]."""
    airspeed: Series
    """(N,) true airspeed [m/s]; not a number where it was not measured, or not trusted."""
    density: Series
    """(N,) air density [kg/m^3]."""
    roll_rate: Series
    """(N,) roll rate p [rad/s]."""
    roll_rate_asked: Series
    """(N,) setpoint of the roll rate that answers this state [rad/s]."""
    thrust: Series
    """(N,) thrust setpoint that answers this state, 0 to 1."""
    delay: Series
    """(N,) time from the attitude until the setpoint acts [s]."""


class Means(NamedTuple):
    """A flight in means over WINDOW, (M,) each."""

    airspeed: Series
    """Equivalent airspeed [m/s]."""
    alpha: Series
    """Angle of attack in level air [rad]."""
    load: Series
    """Load factor."""
    banked: Series
    """The load factor that the bank asks for in a level turn."""
    along: Series
    """Specific force along the fuselage, over g."""


def samples_of(flown: Iterable[Sample]) -> Samples:
    """The samples of a flight as arrays."""
    return Samples(*cast("tuple[Array, ...]", columns(Sample, table_of(Sample, flown))))


def sound(samples: Samples) -> Samples:
    """The usable samples: finite except for the airspeed, in the order of time."""
    needed = samples._replace(airspeed=samples.time)
    numbers = [np.isfinite(values).all(axis=tuple(range(1, values.ndim))) for values in needed]
    good: Mask = np.logical_and.reduce(numbers)
    time: Series = np.where(good, samples.time, -math.inf)
    latest: Series = np.maximum.accumulate(time)
    good[1:] &= time[1:] > latest[:-1]
    return Samples(*(values[good] for values in samples))


def with_airspeed(samples: Samples) -> Samples:
    """The samples at which the airspeed is known."""
    known = np.isfinite(samples.airspeed)
    return Samples(*(values[known] for values in samples))


def means_of(samples: Samples) -> Means:
    """The means of samples whose airspeed is known, two at least."""
    v_n = halfway(samples.v_n) - wind_of(samples)
    R_nb: Matrices = halfway(samples.R_nb)
    u, _, w = np.einsum("nij,ni->jn", R_nb, v_n)
    dt = np.diff(samples.time)
    force_n = np.diff(samples.v_n, axis=0) / dt[:, None] - np.array([0.0, 0.0, G0])
    along, _, down = np.einsum("nij,ni->jn", R_nb, force_n) / G0
    bank = np.arctan2(R_nb[:, 2, 1], R_nb[:, 2, 2])
    banked = 1.0 / np.maximum(math.cos(STEEPEST_BANK), np.cos(bank))
    equivalent = samples.airspeed * np.sqrt(samples.density / DENSITY_0)
    flown = (halfway(equivalent), np.arctan2(w, u), -down, banked, along)
    return Means(*(mean(samples, values) for values in flown))


def wind_of(samples: Samples) -> Array:
    """The mean wind, NED [m/s], with which velocity over ground and airspeed fit on all courses.

    V^2 = |v - w|^2 is linear in w but for |w|^2, which is a free parameter and absorbs the bias of
    the airspeed sensor. On one course alone the wind is not a number.
    """
    level = samples.v_n[:, :2]
    excess = samples.airspeed**2 - np.einsum("ni,ni->n", samples.v_n, samples.v_n)
    _, north, east = fitted(with_constant(*(-2.0 * level.T)), excess).x.tolist()
    return np.array([north, east, 0.0])


def halfway(values: Vectors) -> Vectors:
    """Means of neighbouring samples, which are along the first axis."""
    return 0.5 * (values[1:] + values[:-1])


def mean(samples: Samples, values: Array) -> Array:
    """Means over successive windows of the values between the samples, without sparse windows.

    Steps over a gap are left out.
    """
    dt = np.diff(samples.time)
    steady = dt < 0.5 * WINDOW
    window = ((halfway(samples.time) - samples.time[0]) / WINDOW).astype(int)[steady]
    number = np.bincount(window)
    total = np.bincount(window, values[steady])
    return (total / np.maximum(number, 1))[number > 0.5 * np.max(number, initial=0)]
