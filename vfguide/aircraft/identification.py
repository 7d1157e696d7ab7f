"""What an aircraft is like, from a flight: lift, thrust and roll response.

Least squares on what the autopilot told and what it was asked for. The models are those that the
flight law flies by:

    angle of attack = alpha_zero + alpha_load n / V^2
    thrust setpoint = trim + per_climb f + per_load (n^2 - 1) + its slope over the airspeed
    roll rate       = the setpoint of the roll rate, 63 % of a step after roll_time

where n is the load factor, V the true airspeed and f the specific force along the flight over g:
sin(path angle) + acceleration / g. The air counts as level and the wind as steady: gusts are noise,
which the standard errors show.
"""

import math
from typing import NamedTuple

import numpy as np

from vfguide.aircraft.gain_scheduling import BEGIN, airspeed_gains
from vfguide.aircraft.least_squares import Array, best_time, first_order, fitted, with_constant
from vfguide.aircraft.performance import Performance
from vfguide.aircraft.samples import Means, Samples, halfway, mean, means_of, sound, with_airspeed
from vfguide.geometry.units import DEG

SETTLED = 1.5
"""So much of the beginning does not count for the roll response [s]: it is to what came before."""
ENOUGH = 20
"""With fewer samples, or means, nothing is looked for."""
LARGEST_RELATIVE_SIGMA = 0.2
"""A slope or a time is used with a standard error of less than this part of it."""
TRIM_WORTH = 0.1
"""The thrust setpoint of level flight is used with a standard error of less than this, of 1."""
LOAD_WORTH = 0.05
"""The thrust setpoint for each unit of n^2 is used with a standard error of less than this, not
with one in proportion to it: it is small where drag is."""
LAG_WORTH = 0.5
"""The response time of thrust is used with a standard error of less than this part of it."""
SLOW_ENGINE = 1.0
"""An engine whose response time is not seen is taken for so slow [s]."""
ALPHA_WORTH = 1.0 * DEG
"""The lift is used with a standard error of the angle of attack at cruise of less than this
[rad]."""
ALPHA_UNKNOWN = 1.0 * DEG
"""Standard error of the angle of attack of an aircraft file, if it is not seen in flight [rad]."""
VARIED = 0.2
"""n / V^2 has to change by this part of it, or a flight shows no slope over it."""
FOLLOWED = 0.5
"""A response is one if this part of the roll rate's variance follows the setpoint."""
MOST_ALPHA = 20.0
"""An aircraft file takes no larger angle of attack of zero lift [deg]."""
MOST_LOAD = 1e5
"""An aircraft file takes no larger slope of the angle of attack over n / V^2 [deg m^2/s^2]."""
MOST_WEIGHT = 20.0
"""An aircraft file takes no larger weight over full thrust, without unit."""


class ParameterEstimate(NamedTuple):
    """A number that was looked for."""

    table: str
    key: str
    """Where an aircraft file has it."""
    value: float
    sigma: float
    """What was found and its standard error, in the unit of the file; no number: nothing was."""
    used: bool
    """Whether it is flown by; else what was known before is."""

    def __str__(self) -> str:
        """Key, value and standard error, as in "trim 0.296 +- 0.001"."""
        if not (math.isfinite(self.sigma) and self.sigma > 0.0):
            return f"{self.key} {self.value:.4g}"
        digits = max(0, -math.floor(math.log10(self.sigma)))
        return f"{self.key} {self.value:.{digits}f} +- {self.sigma:.{digits}f}"


class LiftEstimates(NamedTuple):
    """What was looked for of the lift."""

    alpha_zero: ParameterEstimate
    """Angle of attack of zero lift [deg]."""
    alpha_load: ParameterEstimate
    """Its slope over n / V^2 [deg m^2/s^2]."""


class ThrustEstimates(NamedTuple):
    """What was looked for of the thrust."""

    trim: ParameterEstimate
    """Setpoint of level flight at cruise."""
    per_climb: ParameterEstimate
    per_load: ParameterEstimate
    """Its slopes over f and n^2."""
    response_time: ParameterEstimate
    """63 % of a step of the thrust [s]."""


class Identified(NamedTuple):
    """An aircraft as a flight shows it."""

    aircraft: Performance
    roll_time: float
    """63 % of a step of the roll rate [s]."""
    estimates: tuple[ParameterEstimate, ...]


def identify(samples: Samples, before: Performance, roll_time: float) -> Identified:
    """The aircraft of a flight.

    Args:
        samples: of it, with turns, climbs and changes of airspeed; those that have something that
            is no number do not count.
        before: what is known of it; what the flight does not show well is taken from there.
        roll_time: the same of its roll response [s].
    """
    flown = sound(samples)
    told = with_airspeed(flown)
    with np.errstate(all="ignore"):  # what comes of it is no number and not used
        roll = find_roll(flown)
        means = means_of(told) if len(told.time) >= ENOUGH else Means(*np.zeros((5, 0)))
        lift = find_lift(means)
        aircraft = with_lift(before, lift)
        thrust = find_thrust(aircraft, flown, means, 0.0 if lift.alpha_zero.used else ALPHA_UNKNOWN)
        aircraft = with_thrust(aircraft, thrust)
    return Identified(aircraft, roll.value if roll.used else roll_time, (*lift, *thrust, roll))


def find_roll(samples: Samples) -> ParameterEstimate:
    """63 % of a step of the roll rate [s], the link's delay apart."""
    late = samples.time > samples.time[:1] + SETTLED
    rate = samples.roll_rate[late]
    if len(rate) < ENOUGH:
        return unseen("response", "roll_s")

    def regressors(lag: float) -> Array:
        asked = first_order(samples.time, samples.roll_rate_asked, samples.delay, lag)
        return with_constant(asked[late])

    lag, sigma, fit = best_time(regressors, rate)
    follows = fit.squares < (1.0 - FOLLOWED) * float(np.sum((rate - np.mean(rate)) ** 2))
    return found(
        "response", "roll_s", BEGIN + lag, sigma, follows and sigma < LARGEST_RELATIVE_SIGMA * lag
    )


def find_lift(means: Means) -> LiftEstimates:
    """Angle of attack of zero lift, and its slope over n / V^2.

    A gust changes the load factor and not the angle told of it, or the reverse. The bank asks for
    load whatever the gusts do: it stands in for the load factor where the fit looks for what
    belongs together (instrumental variables).
    """
    zero_key, load_key = "alpha_zero_deg", "alpha_load_deg_m2ps2"
    if len(means.load) < ENOUGH:
        return LiftEstimates(unseen("lift", zero_key), unseen("lift", load_key))
    loaded = means.load / means.airspeed**2
    instruments = with_constant(means.banked / means.airspeed**2)
    fit = fitted(with_constant(loaded), means.alpha / DEG, instruments)
    zero, load = fit.x.tolist()
    sigma_alpha, sigma_load = fit.sigma(1.0, float(np.mean(loaded))), fit.sigma(0.0, 1.0)
    varied = float(np.ptp(loaded)) > VARIED * abs(float(np.mean(loaded)))
    used = varied and abs(zero) < MOST_ALPHA and 0.0 < load < MOST_LOAD
    used = used and sigma_load < LARGEST_RELATIVE_SIGMA * load and sigma_alpha < ALPHA_WORTH / DEG
    return LiftEstimates(
        found("lift", zero_key, zero, fit.sigma(1.0, 0.0), used),
        found("lift", load_key, load, sigma_load, used),
    )


def find_thrust(
    aircraft: Performance, samples: Samples, means: Means, alpha_sigma: float
) -> ThrustEstimates:
    """Thrust setpoint of level flight, its slopes over f and n^2, and its response time [s].

    The force along the flight is that along the fuselage, turned by the angle of attack of the
    load, which is known to `alpha_sigma` [rad]: a gust that the velocity does not show yet changes
    both.
    """
    nothing = ThrustEstimates(
        unseen("thrust", "trim"),
        unseen("thrust", "per_climb"),
        unseen("thrust", "per_load"),
        unseen("response", "thrust_s"),
    )
    if len(means.load) < ENOUGH:
        return nothing
    alpha = aircraft.alpha_zero + aircraft.alpha_load * means.load / means.airspeed**2
    force = means.along * np.cos(alpha) - means.load * np.sin(alpha)
    faster, induced = means.airspeed - aircraft.airspeed_cruise, means.load**2 - 1.0
    told, known = with_airspeed(samples), np.isfinite(samples.airspeed)

    def regressors(lag: float) -> Array:
        thrust = first_order(samples.time, samples.thrust, samples.delay, lag)
        return with_constant(mean(told, halfway(thrust[known])), faster, induced)

    lag, sigma_lag, fit = best_time(regressors, force)
    drag, per_thrust, _, drag_of_load = fit.x.tolist()
    if not per_thrust > 0.0:
        return nothing
    # What makes the force nothing at cruise with n = 1, and the slopes over force and n^2.
    trim, per_climb, per_load = -drag / per_thrust, 1.0 / per_thrust, -drag_of_load / per_thrust
    sigma_trim = math.hypot(fit.sigma(1.0, trim, 0.0, 0.0), alpha_sigma) / per_thrust
    sigma_climb = fit.sigma(0.0, 1.0, 0.0, 0.0) / per_thrust**2
    sigma_load = fit.sigma(0.0, per_load, 0.0, 1.0) / per_thrust
    used = 0.0 < trim < 1.0 and sigma_trim < TRIM_WORTH
    used = used and per_climb < MOST_WEIGHT and sigma_climb < LARGEST_RELATIVE_SIGMA * per_climb
    loads = used and per_load < 1.0 and sigma_load < LOAD_WORTH
    return ThrustEstimates(
        found("thrust", "trim", trim, sigma_trim, used),
        found("thrust", "per_climb", per_climb, sigma_climb, used),
        found("thrust", "per_load", max(0.0, per_load), sigma_load, loads),
        found("response", "thrust_s", lag, sigma_lag, used and sigma_lag < LAG_WORTH * lag),
    )


def with_lift(before: Performance, lift: LiftEstimates) -> Performance:
    """The aircraft with the lift that was found."""
    zero, load = lift
    if not zero.used:
        return before
    return before._replace(alpha_zero=math.radians(zero.value), alpha_load=math.radians(load.value))


def with_thrust(before: Performance, thrust: ThrustEstimates) -> Performance:
    """The aircraft with the thrust that was found, and the gains of the airspeed that suit it."""
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


def found(table: str, key: str, value: float, sigma: float, used: bool) -> ParameterEstimate:
    """A number as an aircraft file writes it: what is flown by is what is written."""
    return ParameterEstimate(table, key, written(value), sigma, used)


def unseen(table: str, key: str) -> ParameterEstimate:
    """A number that is not seen at all."""
    return ParameterEstimate(table, key, math.nan, math.nan, False)


def written(value: float) -> float:
    """With four digits."""
    return float(f"{value:.4g}")
