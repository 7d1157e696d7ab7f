"""What the guidance must know of an aircraft, and the gains it flies with."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.geometry.compiled import compiled
from vfguide.geometry.units import G0


class Performance(NamedTuple):
    """Limits and trim of one aircraft, SI units and radians."""

    airspeed_min: float
    """Slowest true airspeed of level flight [m/s]."""
    airspeed_cruise: float
    """True airspeed at which the trim values below hold [m/s]."""
    airspeed_max: float
    """Fastest true airspeed [m/s]."""
    bank_max: float
    """Largest bank the guidance asks for [rad]."""
    load_max: float
    load_min: float
    """Load factors n = lift / weight the guidance asks for."""
    climb_max: float
    descent_max: float
    """Steepest air-relative path angles, both positive [rad]."""
    rate_max: tuple[float, float, float]
    """Largest body rates p, q, r [rad/s]."""
    alpha_zero: float
    alpha_load: float
    """alpha = alpha_zero + alpha_load * n / V^2 [rad], [rad m^2/s^2], the latter above 0."""
    thrust_trim: float
    """Thrust setpoint of level flight at cruise, 0 to 1."""
    thrust_per_climb: float
    """Weight / full thrust: setpoint for each unit of sin(gamma) + acceleration / g."""
    thrust_per_load: float
    """Setpoint for each unit of n^2 - 1: the induced drag of a turn."""
    thrust_per_airspeed: float
    """Setpoint for each m/s of airspeed missing [s/m]."""
    thrust_integral: float
    """Setpoint for each m/s of airspeed missing during 1 s [1/m]."""


class Gains(NamedTuple):
    """Gains of the guidance; the defaults are measured for a rate-controlled aircraft."""

    airspeed: float
    """True airspeed to fly [m/s]."""
    k_w: float = 3.5
    """Attitude gain of Lemma 4 [1/s]."""
    k_lateral: float = 1.2
    """Turn rate per azimuth error of the air velocity [1/s]."""
    k_elevation: float = 0.5
    """Extra elevation per error of the path angle."""
    k_alpha: float = 0.2
    """Learning rate of the angle of attack from the error of the path angle [1/s]."""
    bank_max: float = 0.8727
    """Largest bank asked for [rad]."""
    turn_margin: float = 1.15
    """Radius of the goal circles over the smallest that the bank allows in this wind."""
    core: float = 0.4
    """Radius of the line core of the field, in turn radii of still air."""
    final: float = 0.6
    """Length of the straight end of the approach, in turn radii: field and circles lead to its
    beginning, so that the course has settled when the goal is passed."""
    smoothing: float = 0.08
    """Time constant of the reference attitude's angular velocity [s]."""
    sluggish: float = 0.0
    """How much longer the roll rate takes for 63 % of a step than the 0.08 s for which these
    defaults are made [s]: the course is planned for half of it ahead, and turns become wider by
    half the way that is flown meanwhile."""


@compiled
def turn_length(airspeed: float) -> float:
    """V^2 / g [m]: the radius of a turn at 45 degrees of bank, to which distances are scaled.

    63.7 m for the Aerosonde at 25 m/s, with which the multiples of it were measured.
    """
    return airspeed * airspeed / G0


Law = NDArray[np.float64]
"""Performance and gains as one array, (29,): compiled code that is called from Python checks every
field of a record at every call, an array at once."""
AIRSPEED_GAIN = 18
BANK_GAIN = 23
"""Places of the airspeed to fly and of the largest bank in a Law."""


def packed(aircraft: Performance, gains: Gains) -> Law:
    """Both as one array."""
    return np.hstack([*aircraft, *gains])


@compiled
def with_gains(law: Law, gains: Gains) -> Law:
    """The law with the airspeed and the largest bank of other gains."""
    other = law.copy()
    other[AIRSPEED_GAIN], other[BANK_GAIN] = gains.airspeed, gains.bank_max
    return other


@compiled
def unpacked(a: Law) -> tuple[Performance, Gains]:
    """What `packed` packed."""
    speeds = (a[0], a[1], a[2])
    limits = (a[3], a[4], a[5], a[6], a[7], (a[8], a[9], a[10]))
    lift = (a[11], a[12])
    thrust = (a[13], a[14], a[15], a[16], a[17])
    gains = (a[18], a[19], a[20], a[21], a[22], a[23], a[24], a[25], a[26], a[27], a[28])
    return Performance(*(speeds + limits + lift + thrust)), Gains(*gains)
