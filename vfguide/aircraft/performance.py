"""Performance of an aircraft as the guidance knows it, and the gains of the guidance."""

from typing import NamedTuple

from vfguide.geometry.units import G0
from vfguide.kernels.compiled import compiled


class Performance(NamedTuple):
    """Limits and trim of one aircraft in air of one density, SI units and radians.

    An aircraft file holds at sea-level density, where equivalent airspeeds are true ones; from it
    `vfguide.aircraft.air_density` makes the aircraft in other air.
    """

    airspeed_min: float
    """Slowest true airspeed of level flight [m/s]."""
    airspeed_cruise: float
    """True airspeed at which the trim values below hold [m/s]."""
    airspeed_max: float
    """Fastest true airspeed [m/s]."""
    bank_max: float
    """Largest bank of the aircraft file [rad]; guidance takes that of its `Gains`."""
    load_max: float
    """Largest load factor n = lift / weight the guidance asks for."""
    load_min: float
    """Least load factor the guidance asks for."""
    climb_max: float
    """Steepest path angle of a climb through the air [rad], positive."""
    descent_max: float
    """Steepest path angle of a descent through the air [rad], positive."""
    rate_max: tuple[float, float, float]
    """Largest body rates p, q, r [rad/s]."""
    alpha_zero: float
    """Angle of attack of zero lift [rad]: alpha = alpha_zero + alpha_load n / V^2."""
    alpha_load: float
    """Slope of the angle of attack over n / V^2 [rad m^2/s^2], positive."""
    thrust_trim: float
    """Thrust setpoint of level flight at cruise, 0 to 1."""
    thrust_per_climb: float
    """Weight / full thrust: setpoint for each unit of sin(gamma) + acceleration / g.

    Full thrust is that at the cruise airspeed of sea level, in this air."""
    thrust_per_load: float
    """Setpoint for each unit of n^2 - 1: the induced drag of a turn."""
    thrust_per_airspeed: float
    """Setpoint for each m/s of airspeed missing [s/m]."""
    thrust_integral: float
    """Setpoint for each m/s of airspeed missing during 1 s [1/m]."""
    thrust_fade: float = 0.0
    """Share of the full thrust that is lost with each m/s of true airspeed above the cruise
    airspeed of sea level [s/m]."""


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
    final_approach: float = 0.6
    """Length of the straight end of the approach, in turn radii: field and circles lead to its
    beginning, so that the course has settled when the goal is passed."""
    smoothing: float = 0.08
    """Time constant of the reference attitude's angular velocity [s]."""
    response_lag: float = 0.0
    """Roll response time beyond the 0.08 s for which these defaults are made [s]: the course is
    planned for half of it ahead, and turns are wider by half the length that is flown in it."""


@compiled
def turn_length(airspeed: float) -> float:
    """V^2 / g [m]: the radius of a turn at 45 degrees of bank, to which distances are scaled.

    63.7 m for the Aerosonde at 25 m/s, with which the multiples of it were measured.
    """
    return airspeed * airspeed / G0


@compiled
def nonzero_airspeed(airspeed: float, aircraft: Performance) -> float:
    """True airspeed [m/s] to divide by: at least half of the slowest, whatever is measured."""
    return max(airspeed, 0.5 * aircraft.airspeed_min)


@compiled
def alpha_of_load(load: float, speed: float, aircraft: Performance) -> float:
    """Angle of attack [rad] of a load factor n at a true airspeed V [m/s].

    alpha = alpha_zero + alpha_load n / V^2.
    """
    return aircraft.alpha_zero + aircraft.alpha_load * load / (speed * speed)


@compiled
def load_of_alpha(alpha: float, speed: float, aircraft: Performance) -> float:
    """Load factor n at an angle of attack [rad] and a true airspeed V [m/s].

    n = (alpha - alpha_zero) V^2 / alpha_load, the inverse of `alpha_of_load`.
    """
    return (alpha - aircraft.alpha_zero) * speed * speed / aircraft.alpha_load
