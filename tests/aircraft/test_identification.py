"""What an aircraft is like, from flights that are made up with known numbers."""

import itertools
import math

import numpy as np
import pytest
from aeroplanes import AEROSONDE
from hypothesis import given, settings
from hypothesis import strategies as st

from vfguide.aircraft.coordinated_turn import attitude_for_lift
from vfguide.aircraft.gain_scheduling import STEP_DELAY
from vfguide.aircraft.identification import identify
from vfguide.aircraft.least_squares import first_order
from vfguide.aircraft.parameter_estimate import ParameterEstimate
from vfguide.aircraft.samples import Sample, Samples, samples_of, sound
from vfguide.geometry.units import DEG, G0

pytestmark = pytest.mark.slow

DT = 0.02
SLOPE = 0.02
"""Thrust setpoint for each m/s of airspeed in level flight."""
TRUE = {
    "alpha_zero_deg": -2.0,
    "alpha_load_deg_m2ps2": 3000.0,
    "trim": 0.4,
    "per_climb": 2.5,
    "per_load": 0.1,
    "thrust_s": 0.3,
    "roll_s": 0.15,
}


def smooth(time, *pieces):
    """Values that go from one piece (from when, value) to the next within a second."""
    values = np.full_like(time, pieces[0][1])
    for (_, before), (when, after) in itertools.pairwise(pieces):
        values += (after - before) * 0.5 * (1.0 + np.tanh(3.0 * (time - when)))
    return values


def direction(azimuth, elevation):
    """Unit vectors, NED."""
    c = np.cos(elevation)
    return np.stack((c * np.cos(azimuth), c * np.sin(azimuth), -np.sin(elevation)), axis=1)


def flight(wind=(3.0, -2.0, 0.0), delay=0.04, lively=1.0, gusts=0.0, density=1.225):
    """Samples of a flight with the numbers of TRUE; `lively` 0: straight on.

    The path is the same whatever the gusts up and down [m/s]: attitude and thrust make up for them.
    In thin air it takes more of the thrust.
    """
    time = np.arange(0.0, 80.0, DT)
    equivalent = 25.0 + lively * smooth(time, (0, 0.0), (45, 4.0), (55, -4.0), (65, 0.0))
    speed = equivalent * math.sqrt(1.225 / density)
    gamma = lively * smooth(time, (0, 0.0), (4, 0.1), (11, -0.1), (18, 0.0))
    bank = lively * smooth(time, (0, 0.0), (24, 0.5), (40, 0.0), (66, -0.5), (78, 0.0))
    azimuth = np.cumsum(G0 * np.tan(bank) / speed) * DT
    flown_n = speed[:, None] * direction(azimuth, gamma)
    force = np.gradient(flown_n, DT, axis=0) - np.array([0.0, 0.0, G0])
    rng = np.random.default_rng(3)
    gust = gusts * np.convolve(rng.normal(0.0, 1.0, len(time)), np.ones(150) / 12.2, "same")
    through = gamma - gust / speed
    d = direction(azimuth, through)
    along = np.einsum("ni,ni->n", force, d) / G0
    load = np.sqrt(np.einsum("ni,ni->n", force, force) / G0**2 - along**2)
    alpha = DEG * (TRUE["alpha_zero_deg"] + TRUE["alpha_load_deg_m2ps2"] * load / equivalent**2)
    # The pull is across the flight in the banked plane: where the coordinated bank has it.
    R_nb = [attitude_for_lift(*its) for its in zip(azimuth, through, bank, alpha, strict=True)]
    thrust = (
        TRUE["trim"]
        + TRUE["per_climb"] * along
        + TRUE["per_load"] * (load**2 - 1.0)
        + SLOPE * (equivalent - 25.0)
    ) * (1.225 / density)
    late = round(delay / DT)
    asked = thrust + TRUE["thrust_s"] * np.gradient(thrust, DT)
    roll_asked = lively * np.repeat(np.random.default_rng(5).uniform(-1.0, 1.0, 80), 50)
    delays = np.full_like(time, delay)
    return Samples(
        time,
        np.array(R_nb),
        flown_n + np.array(wind),
        speed,
        np.full_like(time, density),
        first_order(time, roll_asked, delays, TRUE["roll_s"] - STEP_DELAY),
        roll_asked,
        np.append(asked[late:], np.full(late, asked[-1])),
        delays,
    )


def test_the_instants_of_a_flight_are_its_columns():
    R_nb = ((1.0, 2.0, 3.0), (4.0, 5.0, 6.0), (7.0, 8.0, 9.0))
    first = Sample(1.0, R_nb, (4.0, 5.0, 6.0), 25.0, 1.1, 0.1, 0.2, 0.3, 0.4)
    samples = samples_of([first, first._replace(time=2.0, delay=0.5)])
    assert list(samples.time) == [1.0, 2.0]
    assert samples.R_nb[1].tolist() == [list(row) for row in first.R_nb]
    assert samples.v_n[1].tolist() == [4.0, 5.0, 6.0]
    assert [values[0] for values in samples[3:]] == [25.0, 1.1, 0.1, 0.2, 0.3, 0.4]
    assert list(samples.delay) == [0.4, 0.5]


def found_in(samples, before=AEROSONDE):
    found = identify(samples, before, 0.3)
    return found, {its.key: its for its in found.estimates}


def assert_all_found(estimates):
    assert all(its.used for its in estimates.values())
    for key, true in TRUE.items():
        # A setpoint is held for DT: the response to it seems so much faster or slower.
        most = 0.06 * abs(true) + (DT if key.endswith("_s") else 0.0)
        assert estimates[key].value == pytest.approx(true, abs=most), key


@pytest.mark.parametrize("wind", [(0.0, 0.0, 0.0), (3.0, -2.0, 0.0), (-9.0, 8.0, 0.0)])
def test_the_numbers_of_a_flight_are_found(wind):
    found, estimates = found_in(flight(wind))
    assert_all_found(estimates)
    its = found.aircraft
    assert (its.thrust_trim, its.thrust_per_climb, its.thrust_per_load) == tuple(
        estimates[key].value for key in ("trim", "per_climb", "per_load")
    )
    assert its.alpha_zero == pytest.approx(DEG * estimates["alpha_zero_deg"].value)
    assert its.alpha_load == pytest.approx(DEG * estimates["alpha_load_deg_m2ps2"].value)
    assert its.thrust_per_airspeed == pytest.approx(0.8 * its.thrust_per_climb / G0, rel=1e-3)
    assert found.roll_time == estimates["roll_s"].value
    untouched = ("airspeed_min", "airspeed_max", "bank_max", "load_max", "climb_max", "rate_max")
    assert all(getattr(its, name) == getattr(AEROSONDE, name) for name in untouched)


@pytest.mark.parametrize("density", [0.66, 0.9, 1.3])
def test_they_are_those_of_sea_level_in_any_air(density):
    _, low = found_in(flight())
    _, high = found_in(flight(density=density))
    for key, its in high.items():
        assert its.used
        assert its.value == pytest.approx(low[key].value, rel=0.03), key


def noisy(samples, seed, velocity=0.1, attitude=0.3 * DEG, airspeed=0.3, roll_rate=0.3 * DEG):
    """The samples as sensors with white noise tell them."""
    rng, n = np.random.default_rng(seed), len(samples.time)
    about = rng.normal(0.0, attitude, (n, 3))
    skew = np.zeros((n, 3, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        skew[:, i, j], skew[:, j, i] = -about[:, k], about[:, k]
    return samples._replace(
        R_nb=samples.R_nb @ (np.eye(3) + skew),
        v_n=samples.v_n + rng.normal(0.0, velocity, (n, 3)),
        airspeed=samples.airspeed + rng.normal(0.0, airspeed, n),
        roll_rate=samples.roll_rate + rng.normal(0.0, roll_rate, n),
    )


def test_standard_errors_are_honest():
    """Beyond the error of the models themselves, which flights without noise have."""
    exact, noisy_flights = flight(), [noisy(flight(), seed) for seed in range(20)]
    _, clean = found_in(exact)
    for key in TRUE:
        finds = [found_in(samples)[1][key] for samples in noisy_flights]
        off = [abs(its.value - clean[key].value) / its.sigma for its in finds]
        assert 0.25 < np.sqrt(np.mean(np.square(off))) < 2.5, (key, off)
        assert max(off) < 5.0, key
        assert all(its.used for its in finds), key


def test_straight_flight_shows_nothing():
    """Noise alone must not be taken for an aircraft."""
    for seed in range(10):
        found, estimates = found_in(noisy(flight(lively=0.0), seed))
        assert not any(its.used for its in estimates.values()), estimates
        assert (found.aircraft, found.roll_time) == (AEROSONDE, 0.3)


def test_gusts_make_the_lift_unsure_and_leave_the_thrust():
    found, estimates = found_in(flight(gusts=2.0))
    assert not estimates["alpha_load_deg_m2ps2"].used
    assert found.aircraft.alpha_load == AEROSONDE.alpha_load
    assert estimates["per_climb"].used
    assert estimates["per_climb"].value == pytest.approx(TRUE["per_climb"], rel=0.1)


def test_without_an_airspeed_sensor_the_roll_response_alone_is_found():
    samples = flight()
    found, estimates = found_in(samples._replace(airspeed=np.full_like(samples.time, math.nan)))
    assert [key for key, its in estimates.items() if its.used] == ["roll_s"]
    assert found.aircraft == AEROSONDE


@pytest.mark.parametrize("gap", [(0.0, 0.6), (0.0, 1.5), (30.0, 33.0), (78.5, 80.0), (40.3, 40.9)])
def test_a_gap_in_the_airspeed_costs_no_more_than_itself(gap):
    samples = flight()
    lost = (samples.time >= gap[0]) & (samples.time < gap[1])
    found, estimates = found_in(
        samples._replace(airspeed=np.where(lost, math.nan, samples.airspeed))
    )
    assert_all_found(estimates)
    assert found.aircraft.thrust_trim == estimates["trim"].value


def test_an_airspeed_that_stands_still_shows_neither_lift_nor_thrust():
    """Its column is the constant's: what cannot be told apart is not known to any accuracy."""
    samples = flight()
    found, estimates = found_in(samples._replace(airspeed=np.full_like(samples.time, 27.0)))
    assert [key for key, its in estimates.items() if its.used] == ["roll_s"]
    assert found.aircraft == AEROSONDE


def test_what_is_flown_by_is_what_a_file_can_say():
    found, estimates = found_in(flight())
    its = found.aircraft
    numbers = (its.thrust_per_airspeed, its.thrust_integral, *(f.value for f in estimates.values()))
    assert all(value == float(f"{value:.4g}") for value in numbers)
    assert its.alpha_zero == math.radians(estimates["alpha_zero_deg"].value)
    assert its.alpha_load == math.radians(estimates["alpha_load_deg_m2ps2"].value)


def test_samples_that_are_no_numbers_do_not_count():
    samples = flight()
    _, before = found_in(samples)
    v_n, R_nb, time = samples.v_n.copy(), samples.R_nb.copy(), samples.time.copy()
    v_n[700], R_nb[1500, 1, 1], time[2100], time[2500] = math.nan, math.inf, math.nan, 3.0
    spoilt = samples._replace(v_n=v_n, R_nb=R_nb, time=time)
    assert len(sound(spoilt).time) == len(time) - 4
    _, estimates = found_in(spoilt)
    for key, its in estimates.items():
        assert its.value == pytest.approx(before[key].value, rel=0.02, abs=0.01), key


@given(st.integers(0, 900), st.integers(0, 2**32 - 1))
@settings(max_examples=30, deadline=None)
def test_anything_goes_in_and_no_exception_comes_out(n, seed):
    rng = np.random.default_rng(seed)

    def wild(*shape):
        values = rng.normal(0.0, 10.0 ** rng.integers(-3, 6), shape)
        values[rng.uniform(size=shape) < 0.05] = rng.choice([math.nan, math.inf, 0.0])
        return values

    time = np.cumsum(np.abs(wild(n))) if seed % 2 else 0.1 * np.arange(n)
    air = (wild(n), rng.uniform(0.1, 1.5, n))  # the density is our own
    samples = Samples(time, wild(n, 3, 3), wild(n, 3), *air, *(wild(n) for _ in range(4)))
    found, estimates = found_in(samples)
    if n < 20:
        assert not any(its.used for its in estimates.values())
        assert found.aircraft == AEROSONDE
    assert all(math.isfinite(x) for x in found.aircraft if isinstance(x, float))


def test_a_roll_rate_that_does_not_follow_is_no_response():
    samples = flight()
    rates = np.random.default_rng(2).normal(0.0, 0.5, len(samples.time))
    found, estimates = found_in(samples._replace(roll_rate=rates))
    assert not estimates["roll_s"].used
    assert found.roll_time == 0.3


@pytest.mark.parametrize(
    ("value", "sigma", "text"),
    [
        (0.29573, 0.0013, "x 0.296 +- 0.001"),
        (3675.8, 13.3, "x 3676 +- 13"),
        (11168.0, 137.0, "x 11168 +- 137"),
        (-2.4983, 0.022, "x -2.50 +- 0.02"),
        (0.5, 0.0, "x 0.5"),
        (math.nan, math.nan, "x nan"),
    ],
)
def test_a_finding_is_told_with_the_digits_that_it_has(value, sigma, text):
    assert str(ParameterEstimate("a", "x", value, sigma, True)) == text
