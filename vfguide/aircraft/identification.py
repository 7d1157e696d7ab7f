"""Identification of an aircraft from a flight: lift, thrust and roll response.

Least squares on what was measured and what was commanded (R. V. Jategaonkar, Flight Vehicle System
Identification, 2006: the equation-error method). The models are those of the flight law:

    angle of attack = alpha_zero + alpha_load n / V_e^2
    thrust at sea level = trim + per_climb f + per_load (n^2 - 1) + slope (V_e - cruise)
    roll rate       = its setpoint with a first-order lag, 63 % of a step after roll_time

where n is the load factor, V_e the equivalent airspeed, and f the specific force along the
direction of flight over g: sin(path angle) + acceleration / g. The thrust at sea level is the
setpoint times the ratio of the density to that at sea level. The air is taken to move level and the
wind to be steady: gusts are noise, which the standard errors show.
"""

import math
from typing import NamedTuple

import numpy as np

from vfguide.aircraft.gain_scheduling import STEP_DELAY, airspeed_gains
from vfguide.aircraft.least_squares import Array, best_time, first_order, fitted, with_constant
from vfguide.aircraft.parameter_estimate import (
    LiftEstimates,
    ParameterEstimate,
    ThrustEstimates,
    found,
    unseen,
    written,
)
from vfguide.aircraft.performance import Performance
from vfguide.aircraft.samples import Means, Samples, halfway, mean, means_of, sound, with_airspeed
from vfguide.earth.atmosphere import DENSITY_0
from vfguide.geometry.units import DEG

SETTLED = 1.5
"""Time at the start of a flight that is left out of the roll response [s], because the aircraft
still answers earlier setpoints; chosen."""
MIN_SAMPLES = 20
"""Least number of samples, or of means, from which something is estimated; chosen."""
LARGEST_RELATIVE_SIGMA = 0.2
"""Largest ratio of the standard error of a slope or a time to its value at which it is still used;
chosen."""
TRIM_SIGMA = 0.1
"""Largest standard error of the thrust setpoint of level flight at which it is still used, as a
share of full thrust; chosen."""
LOAD_SIGMA = 0.05
"""Largest standard error of the thrust setpoint per unit of n^2 at which it is still used, as a
share of full thrust; chosen, and not a ratio to the value, which is small where the drag is."""
LAG_SIGMA = 0.5
"""Largest ratio of the standard error of the response time of thrust to its value at which it is
still used; chosen."""
SLOW_ENGINE = 1.0
"""Response time that is assumed of an engine whose own the flight does not show [s]; chosen on the
slow side, which makes the gains small."""
ALPHA_SIGMA = 1.0 * DEG
"""Largest standard error of the mean angle of attack at which the lift is still used [rad];
chosen."""
ALPHA_UNKNOWN = 1.0 * DEG
"""Standard error that the angle of attack of the aircraft file is assumed to have where the flight
does not show a better one [rad]; chosen."""
MIN_LOAD_RANGE = 0.2
"""Least range of n / V^2 as a share of its mean with which a slope over it is estimated; chosen."""
MIN_FOLLOWED = 0.5
"""Least share of the variance of the roll rate that follows the setpoint in a usable response;
chosen."""
MAX_ALPHA_ZERO = 20.0
"""Largest angle of attack of zero lift that an aircraft file accepts, see
`vfguide.files.aircraft_file` [deg]."""
MAX_ALPHA_LOAD = 1e5
"""Largest slope of the angle of attack over n / V^2 that an aircraft file accepts [deg m^2/s^2]."""
MAX_PER_CLIMB = 20.0
"""Largest ratio of the weight to the full thrust that an aircraft file accepts."""


class Identified(NamedTuple):
    """An aircraft as a flight shows it."""

    aircraft: Performance
    roll_time: float
    """Time to 63 % of a step of the roll rate [s]."""
    estimates: tuple[ParameterEstimate, ...]
    """All estimates, used or not."""


def identify(samples: Samples, before: Performance, roll_time: float) -> Identified:
    """The aircraft that a flight shows.

    Args:
        samples: the flight, with turns, climbs and changes of airspeed; samples with values that
            are not finite are ignored.
        before: what is known of the aircraft; it stays where the flight does not show better.
        roll_time: roll response time known before [s]; it stays likewise.
    """
    flown = sound(samples)
    sensed = with_airspeed(flown)
    with np.errstate(all="ignore"):  # the results are not numbers then, and not used
        roll = find_roll(flown)
        means = means_of(sensed) if len(sensed.time) >= MIN_SAMPLES else Means(*np.zeros((5, 0)))
        lift = find_lift(means)
        aircraft = with_lift(before, lift)
        thrust = find_thrust(aircraft, flown, means, 0.0 if lift.alpha_zero.used else ALPHA_UNKNOWN)
        aircraft = with_thrust(aircraft, thrust)
    return Identified(aircraft, roll.value if roll.used else roll_time, (*lift, *thrust, roll))


def find_roll(samples: Samples) -> ParameterEstimate:
    """Roll response time [s]: 63 % of a step of the roll rate, without the delay of the link."""
    late = samples.time > samples.time[:1] + SETTLED
    rate = samples.roll_rate[late]
    if len(rate) < MIN_SAMPLES:
        return unseen("response", "roll_s")

    def regressors(lag: float) -> Array:
        asked = first_order(samples.time, samples.roll_rate_asked, samples.delay, lag)
        return with_constant(asked[late])

    lag, sigma, fit = best_time(regressors, rate)
    follows = fit.squares < (1.0 - MIN_FOLLOWED) * float(np.sum((rate - np.mean(rate)) ** 2))
    return found(
        "response",
        "roll_s",
        STEP_DELAY + lag,
        sigma,
        follows and sigma < LARGEST_RELATIVE_SIGMA * lag,
    )


def find_lift(means: Means) -> LiftEstimates:
    """Angle of attack of zero lift, and its slope over n / V^2.

    A gust changes the load factor but not the measured angle of attack, or the reverse. The bank is
    independent of gusts: it is the instrumental variable for the load factor.
    """
    zero_key, load_key = "alpha_zero_deg", "alpha_load_deg_m2ps2"
    if len(means.load) < MIN_SAMPLES:
        return LiftEstimates(unseen("lift", zero_key), unseen("lift", load_key))
    loaded = means.load / means.airspeed**2
    instruments = with_constant(means.banked / means.airspeed**2)
    fit = fitted(with_constant(loaded), means.alpha / DEG, instruments)
    zero, load = fit.x.tolist()
    sigma_alpha, sigma_load = fit.sigma(1.0, float(np.mean(loaded))), fit.sigma(0.0, 1.0)
    varied = float(np.ptp(loaded)) > MIN_LOAD_RANGE * abs(float(np.mean(loaded)))
    used = varied and abs(zero) < MAX_ALPHA_ZERO and 0.0 < load < MAX_ALPHA_LOAD
    used = used and sigma_load < LARGEST_RELATIVE_SIGMA * load and sigma_alpha < ALPHA_SIGMA / DEG
    return LiftEstimates(
        found("lift", zero_key, zero, fit.sigma(1.0, 0.0), used),
        found("lift", load_key, load, sigma_load, used),
    )


def find_thrust(
    aircraft: Performance, samples: Samples, means: Means, alpha_sigma: float
) -> ThrustEstimates:
    """Thrust setpoint of level flight, its slopes over f and n^2, and its response time [s].

    The force along the flight is that along the fuselage, turned by the angle of attack that
    belongs to the load factor, whose standard error is `alpha_sigma` [rad]. The measured angle of
    attack is not used: a gust that the velocity does not show yet changes it.
    """
    nothing = ThrustEstimates(
        unseen("thrust", "trim"),
        unseen("thrust", "per_climb"),
        unseen("thrust", "per_load"),
        unseen("response", "thrust_s"),
    )
    if len(means.load) < MIN_SAMPLES:
        return nothing
    alpha = aircraft.alpha_zero + aircraft.alpha_load * means.load / means.airspeed**2
    force = means.along * np.cos(alpha) - means.load * np.sin(alpha)
    faster, induced = means.airspeed - aircraft.airspeed_cruise, means.load**2 - 1.0
    sensed, known = with_airspeed(samples), np.isfinite(samples.airspeed)
    at_sea_level = samples.thrust * samples.density / DENSITY_0

    def regressors(lag: float) -> Array:
        thrust = first_order(samples.time, at_sea_level, samples.delay, lag)
        return with_constant(mean(sensed, halfway(thrust[known])), faster, induced)

    lag, sigma_lag, fit = best_time(regressors, force)
    drag, per_thrust, _, drag_of_load = fit.x.tolist()
    if not per_thrust > 0.0:
        return nothing
    # The setpoint of zero force at cruise with n = 1, and its slopes over force and n^2.
    trim, per_climb, per_load = -drag / per_thrust, 1.0 / per_thrust, -drag_of_load / per_thrust
    sigma_trim = math.hypot(fit.sigma(1.0, trim, 0.0, 0.0), alpha_sigma) / per_thrust
    sigma_climb = fit.sigma(0.0, 1.0, 0.0, 0.0) / per_thrust**2
    sigma_load = fit.sigma(0.0, per_load, 0.0, 1.0) / per_thrust
    used = 0.0 < trim < 1.0 and sigma_trim < TRIM_SIGMA
    used = used and per_climb < MAX_PER_CLIMB and sigma_climb < LARGEST_RELATIVE_SIGMA * per_climb
    loads = used and per_load < 1.0 and sigma_load < LOAD_SIGMA
    return ThrustEstimates(
        found("thrust", "trim", trim, sigma_trim, used),
        found("thrust", "per_climb", per_climb, sigma_climb, used),
        found("thrust", "per_load", max(0.0, per_load), sigma_load, loads),
        found("response", "thrust_s", lag, sigma_lag, used and sigma_lag < LAG_SIGMA * lag),
    )


def with_lift(before: Performance, lift: LiftEstimates) -> Performance:
    """The aircraft with the estimates of the lift, where they are used."""
    zero, load = lift
    if not zero.used:
        return before
    return before._replace(alpha_zero=math.radians(zero.value), alpha_load=math.radians(load.value))


def with_thrust(before: Performance, thrust: ThrustEstimates) -> Performance:
    """The aircraft with the estimates of the thrust that are used, and airspeed gains to suit."""
    trim, per_climb, per_load, lag = thrust
    if not trim.used:
        return before
    proportional, integral = airspeed_gains(per_climb.value, lag.value if lag.used else SLOW_ENGINE)
    return before._replace(
        thrust_trim=trim.value,
        thrust_per_climb=per_climb.value,
        thrust_per_load=per_load.value if per_load.used else before.thrust_per_load,
        thrust_per_airspeed=written(proportional),
        thrust_integral=written(integral),
    )
