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
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.flight.performance import Performance
from vfguide.flight.response import airspeed_gains
from vfguide.geometry.compiled import compiled
from vfguide.geometry.units import DEG, G0

Array = NDArray[np.float64]

WINDOW = 1.0
"""Lift and thrust are compared in means over this time [s]."""
TIMES = np.geomspace(0.01, 2.0, 107)
"""Response times that are tried, 5 % apart [s]."""
SETTLED = 1.5
"""So much of the beginning does not count [s]: responses to what came before are in it."""
WORTH = 0.2
"""A slope or a time is worth something with a standard error of less than this part of it."""
TRIM_WORTH = 0.1
"""The same of the thrust setpoint of level flight."""
LOAD_WORTH = 0.05
"""The same of the setpoint for the load factor, which is small where drag is."""
LAG_WORTH = 0.5
"""The same of the response time of thrust, as part of it."""
ALPHA_WORTH = 1.0 * DEG
"""The same of the angle of attack at cruise [rad]."""
ALPHA_UNKNOWN = 1.0 * DEG
"""Error of the angle of attack that is not seen in flight [rad]."""
VARIED = 0.2
"""n / V^2 has to change by this part of it, or a flight shows no slope over it."""
FOLLOWED = 0.8
"""A response is one if this part of the roll rate's variance follows the setpoint."""
ENOUGH = 20
"""With fewer samples, or means, nothing is looked for."""
MOST_ALPHA, MOST_WEIGHT = 20.0 * DEG, 20.0
"""Beyond these angle of attack of zero lift [rad] and weight over full thrust nothing is taken for
an aircraft."""
STEEPEST = 60.0 * DEG
"""Banks beyond this count as this."""
THRUST = (
    ("thrust", "trim"),
    ("thrust", "per_climb"),
    ("thrust", "per_load"),
    ("response", "thrust_s"),
)
"""Places of what is found of it in an aircraft file."""


class Samples(NamedTuple):
    """A flight, at N instants in the order of time."""

    time: Array
    """(N,) of the attitude [s]."""
    R_nb: Array
    """(N, 3, 3) attitude, body FRD to NED."""
    v_n: Array
    """(N, 3) velocity over ground [m/s]."""
    airspeed: Array
    """(N,) true airspeed [m/s]."""
    roll_rate: Array
    """(N,) [rad/s]."""
    roll_rate_asked: Array
    """(N,) setpoint that answers this state [rad/s]."""
    thrust: Array
    """(N,) the same of the thrust, 0 to 1."""
    delay: Array
    """(N,) so long after the attitude the setpoint begins to act [s]."""


class Finding(NamedTuple):
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


class Identified(NamedTuple):
    """An aircraft as a flight shows it."""

    aircraft: Performance
    roll_time: float
    """63 % of a step of the roll rate [s]."""
    findings: tuple[Finding, ...]


class Fit(NamedTuple):
    """Least squares y = A x."""

    x: Array
    """(n,)."""
    covariance: Array
    """(n, n)."""
    squares: float
    """Sum of what is left, squared."""
    variance: float
    """Of one sample of it, as if all were independent."""

    def sigma(self, *weights: float) -> float:
        """Standard error of a sum of the estimates, so weighted."""
        w = np.array(weights)
        return math.sqrt(max(0.0, float(w @ self.covariance @ w)))


def identify(samples: Samples, before: Performance, roll_time: float) -> Identified:
    """The aircraft of a flight.

    Args:
        samples: of it, with turns, climbs and changes of airspeed; those that have something that
            is no number do not count.
        before: what is known of it; what the flight does not show well is taken from there.
        roll_time: the same of its roll response [s].
    """
    flown = sound(samples)
    roll = find_roll(flown)
    aircraft, lift = with_lift(before, flown)
    alpha_sigma = 0.0 if lift[0].used else ALPHA_UNKNOWN
    aircraft, thrust = with_thrust(aircraft, flown, alpha_sigma)
    return Identified(aircraft, roll.value if roll.used else roll_time, (*lift, *thrust, roll))


def sound(samples: Samples) -> Samples:
    """The samples that can be reckoned with: of numbers alone but for the airspeed, in order."""
    told = samples._replace(airspeed=samples.time)
    numbers = [np.isfinite(its).all(axis=tuple(range(1, its.ndim))) for its in told]
    good: NDArray[np.bool_] = np.logical_and.reduce(numbers)
    time = np.where(good, samples.time, -math.inf)
    good[1:] &= time[1:] > np.maximum.accumulate(time)[:-1]
    return Samples(*(its[good] for its in samples))


def find_roll(samples: Samples) -> Finding:
    """63 % of a step of the roll rate [s], the link's delay apart."""
    late = samples.time > samples.time[:1] + SETTLED
    rate = samples.roll_rate[late]
    if len(rate) < ENOUGH:
        return unseen("response", "roll_s")

    def fit_for(roll_time: float) -> Fit:
        asked = first_order(samples.time, samples.roll_rate_asked, samples.delay, roll_time)
        return fitted(columns(asked[late]), rate)

    roll_time, sigma, fit = best_time(fit_for)
    follows = fit.squares < (1.0 - FOLLOWED) * float(np.sum((rate - np.mean(rate)) ** 2))
    return Finding("response", "roll_s", roll_time, sigma, follows and sigma < WORTH * roll_time)


def with_lift(before: Performance, samples: Samples) -> tuple[Performance, tuple[Finding, ...]]:
    """The aircraft with its lift, if that is seen.

    A gust changes the load factor and not the angle told of it, or the reverse. The bank asks for
    load whatever the gusts do: it stands in for the load factor where the fit looks for what
    belongs together (instrumental variables).
    """
    keys, means = ("alpha_zero_deg", "alpha_load_deg_m2ps2"), means_of(samples)
    if len(means.load) < ENOUGH:
        return before, tuple(unseen("lift", key) for key in keys)
    loaded = means.load / means.airspeed**2
    fit = fitted(columns(loaded), means.alpha, columns(means.banked / means.airspeed**2))
    sigma_alpha, sigma_load = fit.sigma(1.0, float(np.mean(loaded))), fit.sigma(0.0, 1.0)
    zero, load = fit.x.tolist()
    varied = float(np.ptp(loaded)) > VARIED * abs(float(np.mean(loaded)))
    used = varied and abs(zero) < MOST_ALPHA
    used = used and sigma_load < WORTH * load and sigma_alpha < ALPHA_WORTH
    aircraft = before._replace(alpha_zero=zero, alpha_load=load) if used else before
    found = zip(keys, fit.x / DEG, (fit.sigma(1.0, 0.0) / DEG, sigma_load / DEG), strict=True)
    return aircraft, tuple(Finding("lift", key, float(x), s, used) for key, x, s in found)


def with_thrust(
    before: Performance, samples: Samples, alpha_sigma: float
) -> tuple[Performance, tuple[Finding, ...]]:
    """The aircraft with trim, slopes and gains of the thrust, if they are seen.

    The force along the flight is that along the fuselage, turned by the angle of attack of the
    load, which is known to `alpha_sigma` [rad]: a gust that the velocity does not show yet changes
    both.
    """
    means = means_of(samples)
    if len(means.load) < ENOUGH:
        return before, tuple(unseen(*its) for its in THRUST)
    alpha = before.alpha_zero + before.alpha_load * means.load / means.airspeed**2
    force = means.along * np.cos(alpha) - means.load * np.sin(alpha)
    faster, induced = means.airspeed - before.airspeed_cruise, means.load**2 - 1.0

    def fit_for(thrust_time: float) -> Fit:
        thrust = first_order(samples.time, samples.thrust, samples.delay, thrust_time)
        return fitted(columns(mean(samples, halfway(thrust)), faster, induced), force)

    thrust_time, sigma_time, fit = best_time(fit_for)
    drag, per_thrust, _, drag_of_load = fit.x.tolist()
    if not per_thrust > 0.0:
        return before, tuple(unseen(*its) for its in THRUST)
    # What makes the force nothing at cruise with n = 1, and the slopes over force and n^2.
    trim, per_climb, per_load = -drag / per_thrust, 1.0 / per_thrust, -drag_of_load / per_thrust
    sigma_trim = math.hypot(fit.sigma(1.0, trim, 0.0, 0.0), alpha_sigma) / per_thrust
    sigma_climb = fit.sigma(0.0, 1.0, 0.0, 0.0) / per_thrust**2
    sigma_load = fit.sigma(0.0, per_load, 0.0, 1.0) / per_thrust
    sound = 0.0 <= trim <= 1.0 and per_climb <= MOST_WEIGHT and per_load <= 1.0
    used = sound and sigma_trim < TRIM_WORTH and sigma_climb < WORTH * per_climb
    loads, lags = used and sigma_load < LOAD_WORTH, used and sigma_time < LAG_WORTH * thrust_time
    scale = per_climb / before.thrust_per_climb
    gains = (before.thrust_per_airspeed * scale, before.thrust_integral * scale)
    if lags:
        gains = airspeed_gains(per_climb, thrust_time)
    aircraft = before._replace(
        thrust_trim=trim,
        thrust_per_climb=per_climb,
        thrust_per_load=max(0.0, per_load) if loads else before.thrust_per_load,
        thrust_per_airspeed=gains[0],
        thrust_integral=gains[1],
    )
    values = (trim, per_climb, per_load, thrust_time)
    sigmas = (sigma_trim, sigma_climb, sigma_load, sigma_time)
    found = zip(THRUST, values, sigmas, (used, used, loads, lags), strict=True)
    findings = tuple(Finding(*place, value, sigma, its) for place, value, sigma, its in found)
    return aircraft if used else before, findings


def unseen(table: str, key: str) -> Finding:
    """A number that is not seen at all."""
    return Finding(table, key, math.nan, math.nan, False)


class Means(NamedTuple):
    """A flight in means over WINDOW, (M,) each."""

    airspeed: Array
    """True airspeed [m/s]."""
    alpha: Array
    """Angle of attack in level air [rad]."""
    load: Array
    """Load factor."""
    banked: Array
    """The load factor that the bank asks for in a level turn."""
    along: Array
    """Specific force along the fuselage, over g."""


def means_of(samples: Samples) -> Means:
    """The means, of the times at which the airspeed is told."""
    told = Samples(*(its[np.isfinite(samples.airspeed)] for its in samples))
    if len(told.time) < ENOUGH:
        return Means(*np.zeros((5, 0)))
    v_n, R_nb = halfway(told.v_n) - wind_of(told), halfway(told.R_nb)
    u, _, w = np.einsum("nij,ni->jn", R_nb, v_n)
    force_n = np.diff(told.v_n, axis=0) / np.diff(told.time)[:, None] - np.array([0.0, 0.0, G0])
    along, _, down = np.einsum("nij,ni->jn", R_nb, force_n) / G0
    bank = np.arctan2(R_nb[:, 2, 1], R_nb[:, 2, 2])
    banked = 1.0 / np.maximum(math.cos(STEEPEST), np.cos(bank))
    flown = (halfway(told.airspeed), np.arctan2(w, u), -down, banked, along)
    return Means(*(mean(told, its) for its in flown))


def wind_of(samples: Samples) -> Array:
    """The mean wind, NED [m/s]: with it velocity over ground and airspeed fit on all courses.

    V^2 = |v - w|^2, linear in w but for |w|^2. That is left free, and takes what the airspeed
    sensor tells too much.
    """
    level = samples.v_n[:, :2]
    excess = samples.airspeed**2 - np.einsum("ni,ni->n", samples.v_n, samples.v_n)
    _, north, east = fitted(columns(*(-2.0 * level.T)), excess).x.tolist()
    return np.array([north, east, 0.0])


def best_time(fit_for: Callable[[float], Fit]) -> tuple[float, float, Fit]:
    """The response time [s] that leaves least, its standard error, and the fit with it."""
    fits = [fit_for(float(time)) for time in TIMES]
    best = int(np.argmin([fit.squares for fit in fits]))
    time, fit = float(TIMES[best]), fits[best]
    if not 0 < best < len(TIMES) - 1:
        return time, math.inf, fit
    # The parabola through three sums, over the logarithm of the time.
    before, least, after = (fits[best + k].squares for k in (-1, 0, 1))
    step, bend = math.log(TIMES[1] / TIMES[0]), before - 2.0 * least + after
    if not bend > 0.0:
        return time, math.inf, fit
    time *= math.exp(0.5 * (before - after) / bend * step)
    return time, time * step * math.sqrt(2.0 * fit.variance / bend), fit


def fitted(A: Array, y: Array, instruments: Array | None = None) -> Fit:
    """Least squares, or what the instruments make of y = A x: all (N, n), `y` (N,)."""
    Z = A if instruments is None else instruments
    inverse = np.linalg.pinv(Z.T @ A)
    x = inverse @ (Z.T @ y)
    left = y - A @ x
    squares = float(left @ left)
    variance = squares / max(1, len(y) - len(x)) * persistence(left)
    return Fit(x, variance * (inverse @ (Z.T @ Z) @ inverse.T), squares, variance)


def persistence(left: Array) -> float:
    """How many samples in a row tell the same: 1 and twice the sum of the autocorrelations."""
    power = float(left @ left)
    total = 1.0
    for lag in range(1, len(left) // 2):
        together = float(left[lag:] @ left[:-lag])
        if not together > 0.05 * power:
            break
        total += 2.0 * together / power
    return total


def columns(*regressors: Array) -> Array:
    """A constant and the regressors, side by side."""
    return np.column_stack((np.ones_like(regressors[0]), *regressors))


def halfway(values: Array) -> Array:
    """Between the samples."""
    return 0.5 * (values[1:] + values[:-1])


def mean(samples: Samples, values: Array) -> Array:
    """Means over WINDOW after WINDOW of what was between the samples; hardly filled ones apart."""
    window = ((halfway(samples.time) - samples.time[0]) / WINDOW).astype(int)
    number = np.bincount(window)
    return (np.bincount(window, values) / np.maximum(number, 1))[number > 0.5 * np.max(number)]


@compiled
def first_order(time: Array, asked: Array, delay: Array, response_time: float) -> Array:
    """What follows setpoints with a lag of first order, at the times of the samples, (N,).

    Args:
        time: (N,) of the samples [s].
        asked: (N,) setpoints, each held from `delay` after its sample until the next one acts.
        delay: (N,) [s].
        response_time: 63 % of a step [s].
    """
    follows = np.empty(len(time))
    now, acts, value = time[0], 0, asked[0]
    for k in range(len(time)):
        while acts + 1 < len(time) and time[acts + 1] + delay[acts + 1] <= time[k]:
            then = time[acts + 1] + delay[acts + 1]
            value += (asked[acts] - value) * -math.expm1(-max(0.0, then - now) / response_time)
            now, acts = max(now, then), acts + 1
        value += (asked[acts] - value) * -math.expm1(-max(0.0, time[k] - now) / response_time)
        now = max(now, time[k])
        follows[k] = value
    return follows
