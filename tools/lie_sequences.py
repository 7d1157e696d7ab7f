"""Sequences of lies about a point-mass aeroplane that the control loop flies to a pose in wind.

Roll, pitch and position stay true.
"""

import math
from typing import NamedTuple

import numpy as np
from rate_body import advance, level, load_factor

from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import read_vehicle
from vfguide.companion.setpoints import COAST_AFTER
from vfguide.control.coasting import coast
from vfguide.control.limits import limit_rates
from vfguide.earth.atmosphere import DENSITY_0
from vfguide.estimation.estimation import Inputs
from vfguide.geometry.so3 import bank_angle, exp, to_quaternion
from vfguide.geometry.vector import Mat3, Vec3, add, matmul, scale
from vfguide.guidance.laws import Law
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Row
from vfguide.loop.legs import Legs
from vfguide.loop.state import read_state, write_state
from vfguide.loop.step import step

UPDATE = 0.04
"""Time between two steps of guidance [s]; chosen."""
SUBSTEPS = 2
"""Number of steps of the aeroplane in that time; chosen."""
YAW, VELOCITY, WIND, AIRSPEED, RATE, NO_WIND, NO_AIRSPEED, OLD, SILENT, TWICE, LEAP = range(11)
NAMES = (
    *("yaw", "velocity", "wind", "airspeed", "rate", "no wind", "no airspeed"),
    *("old", "silent", "twice", "leap"),
)
HISTORY = 51
"""Number of updates that are remembered for old frames; chosen as 2 s."""


class Lie(NamedTuple):
    """One quantity that is reported wrong for some time."""

    kind: int
    begin: float
    """When it begins [s]."""
    end: float
    """When it ends [s]."""
    ramp: float
    """Time in which it grows from nothing [s]."""
    size: float
    """Size of the error, as a share of the largest, 0 to 1."""
    direction: float
    """Direction of the error [rad]."""


class Extremes(NamedTuple):
    """Extreme values of the truth in a sequence."""

    bank: float
    """Largest bank [rad]."""
    least_load: float
    most_load: float
    lost: float
    """Greatest depth below start and goal [m]."""
    silent_from: float
    """Time from which nothing was sent any more [s]; infinite: there is none."""
    is_finite: bool
    """Whether every setpoint was finite."""


@compiled
def random_lie(longest: float) -> Lie:
    """A random lie that begins and ends within a time [s]; uses numba's random numbers."""
    begin = np.random.uniform(0.0, longest) if np.random.random() < 0.8 else -1.0
    end = begin + np.random.uniform(0.1, 8.0) if np.random.random() < 0.5 else math.inf
    ramp = np.random.uniform(0.2, 5.0) if np.random.random() < 0.3 else 0.0
    size = math.exp(np.random.uniform(math.log(0.03), 0.0))
    direction = np.random.uniform(-math.pi, math.pi)
    return Lie(np.random.randint(0, 11), begin, end, ramp, size, direction)


@compiled
def told(state: FlightState, old: FlightState, lie: Lie, t: float) -> FlightState:
    """The state with one more lie in it, where it is on at the time `t` [s].

    `old` is the state at an earlier time.
    """
    if not lie.begin <= t < lie.end:
        return state
    share = lie.size * (min((t - lie.begin) / lie.ramp, 1.0) if lie.ramp > 0.0 else 1.0)
    along = (math.cos(lie.direction), math.sin(lie.direction), 0.0)
    time, p_n, v_n, R_nb, airspeed, wind_n = state
    if lie.kind == YAW:
        R_nb = matmul(exp((0.0, 0.0, math.copysign(math.pi * share, lie.direction))), R_nb)
    elif lie.kind == VELOCITY:
        v_n = add(v_n, add(scale(40.0 * share, along), (0.0, 0.0, 8.0 * share * along[0])))
    elif lie.kind == WIND:
        wind_n = add(wind_n, scale(40.0 * share, along))
    elif lie.kind == AIRSPEED:
        airspeed *= 1.0 + share * (1.5 if lie.direction > 0.0 else -1.0)
    elif lie.kind == NO_WIND:
        wind_n = (math.nan, math.nan, math.nan)
    elif lie.kind == NO_AIRSPEED:
        airspeed = math.nan
    elif lie.kind == OLD:
        v_n, wind_n = old.v_n, old.wind_n
    elif lie.kind == LEAP:
        time += 2.0 * share
    return FlightState(time, p_n, v_n, R_nb, airspeed, wind_n)


@compiled
def is_on(lies: tuple[Lie, Lie, Lie, Lie], kind: int, t: float) -> bool:
    """Whether a lie of a kind is on at a time [s]."""
    found = False
    for lie in lies:
        found |= lie.kind == kind and lie.begin <= t < min(lie.end, lie.begin + 1.0)
    return found


@compiled
def random_lies(seed: int) -> tuple[float, tuple[Lie, Lie, Lie, Lie]]:
    """The lies of a sequence, of which all but the first may be none, and its length [s]."""
    np.random.seed(seed)
    longest, number = np.random.uniform(2.0, 10.0), np.random.randint(1, 5)
    a, b = random_lie(longest), random_lie(longest)
    c, d = random_lie(longest), random_lie(longest)
    none = Lie(a.kind, math.inf, math.inf, 0.0, 0.0, 0.0)
    return longest, (
        a,
        b if number > 1 else none,
        c if number > 2 else none,
        d if number > 3 else none,
    )


@compiled
def rates_told(omega_b: Vec3, lies: tuple[Lie, Lie, Lie, Lie], t: float) -> Vec3:
    """Body rates as they are reported at a time `t` [s], with the lies about them [rad/s]."""
    for lie in lies:
        if lie.kind == RATE and lie.begin <= t < lie.end:
            wrong = (math.cos(lie.direction), math.sin(lie.direction), 0.0)
            omega_b = add(omega_b, scale(2.0 * lie.size, wrong))
    return omega_b


@compiled
def fly_sequence(
    seed: int, legs: Legs, law: Law, vehicle: Row, fresh: Row, down: float
) -> Extremes:
    """Fly one sequence.

    Args:
        seed: seed of its random numbers.
        legs: legs to a goal at the origin.
        law: the law of guidance.
        vehicle: row of the vehicle.
        fresh: row of the state of the loop before the first step.
        down: the goal's height, down of the origin [m].
    """
    of = read_vehicle(vehicle)
    longest, lies = random_lies(seed)
    toward, strength = np.random.uniform(-math.pi, math.pi), np.random.uniform(0.0, 0.45)
    speed = of.gains.airspeed
    wind_n = scale(strength * speed, (math.cos(toward), math.sin(toward), 0.0))
    place = (np.random.uniform(-600.0, 600.0), np.random.uniform(-600.0, 600.0), down)
    body = level(place, np.random.uniform(-math.pi, math.pi), speed, of.aircraft)
    warm = np.random.uniform(0.3, 4.0)
    row, wanted_b = fresh, (0.0, 0.0, 0.0)
    kept = [FlightState(0.0, body.p_n, body.air_n, body.R_nb, speed, wind_n)]
    bank, least, most, lost, finite = 0.0, 1.0, 1.0, 0.0, True
    silent, heard, flown = math.inf, math.inf, ((1.0, 0.0, 0.0, 0.0), wanted_b)
    while body.time < warm + longest and silent == math.inf:
        t = body.time - warm
        v_n = add(body.air_n, wind_n)
        state = FlightState(body.time, body.p_n, v_n, body.R_nb, speed, wind_n)
        kept.append(state)
        if len(kept) > HISTORY:
            kept.pop(0)
        if not is_on(lies, SILENT, t):
            for _ in range(2 if is_on(lies, TWICE, t) else 1):
                said = state
                for lie in lies:
                    age = int(lie.size * len(kept))
                    said = told(said, kept[max(len(kept) - 1 - age, 0)], lie, t)
                omega_b = rates_told(body.omega_b, lies, t)
                inputs = Inputs(said, said, omega_b, False, 0.0, DENSITY_0)
                setpoint, left, _ = step(inputs, read_state(row), legs, None, law, of)
                row = np.empty(len(fresh))
                write_state(left, row)
                wanted_b = setpoint.omega_b
                finite = finite and math.isfinite(sum(wanted_b) + setpoint.thrust)
                flown, heard = (to_quaternion(said.R_nb), wanted_b), body.time
                if left.estimation.consistency.attitude_doubt > 0.0:
                    silent = t
        elif body.time - heard > COAST_AFTER:
            age = body.time - heard
            q_nb, flown_b = flown
            omega_b, _ = coast(q_nb, flown_b, age, speed, of.gains.bank_max)
            wanted_b, heard = limit_rates(omega_b, of.aircraft.rate_max), math.inf
        for _ in range(SUBSTEPS):
            body = advance(body, wanted_b, wind_n, of.aircraft, UPDATE / SUBSTEPS)
            load = load_factor(body, of.aircraft)
            least, most = min(least, load), max(most, load)
            bank = max(bank, bank_of(body.R_nb))
            lost = max(lost, body.p_n[2] - down)
    return Extremes(bank, least, most, lost, silent, finite)


@compiled
def bank_of(R_nb: Mat3) -> float:
    """Bank, the angle of the right wing from the horizon about the nose [rad], not negative."""
    return abs(bank_angle(R_nb))


@compiled
def fly_sequences(
    first: int, number: int, legs: Legs, law: Law, vehicle: Row, fresh: Row, down: float
) -> list[Extremes]:
    """The extremes of `number` sequences, from seed `first` on; others as of `fly_sequence`."""
    return [fly_sequence(first + k, legs, law, vehicle, fresh, down) for k in range(number)]
