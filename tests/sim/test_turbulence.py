"""The gusts against the formulas of MIL-F-8785C, whose numbers are written anew here, in feet."""

import math

import numpy as np
import pytest
from gust_samples import UNIT, flown
from hypothesis import given
from hypothesis import strategies as st

from vfguide.geometry.units import FT, KT
from vfguide.sim.turbulence import (
    LOW_ALTITUDE,
    MEDIUM_ALTITUDE,
    Gusts,
    GustyAir,
    Noise,
    Stages,
    Turbulence,
    across_path,
    along_path,
    flown_on,
    scales_at,
)

LEVELS = [Turbulence.LIGHT, Turbulence.MODERATE, Turbulence.SEVERE]
distances = st.floats(1e-8, 50.0)
speeds = st.floats(0.0, 80.0)
headings = st.floats(-math.pi, math.pi)
vectors = st.tuples(*3 * (st.floats(-80.0, 80.0),))
numbers = st.floats(-4.0, 4.0)


def transition(x: float) -> np.ndarray:
    """(2, 2): what each stage of a gust across the path becomes."""
    return np.array(
        [across_path(Stages(*stages), x, 0.0, 0.0) for stages in ((1.0, 0.0), (0.0, 1.0))]
    ).T


def input_matrix(x: float) -> np.ndarray:
    """(2, 2): what each of the noises makes."""
    return np.array(
        [across_path(Stages(0.0, 0.0), x, *noise) for noise in ((1.0, 0.0), (0.0, 1.0))]
    ).T


@pytest.mark.parametrize(
    ("level", "horizontal", "vertical"),
    [
        (Turbulence.LIGHT, 0.88, 0.77),
        (Turbulence.MODERATE, 1.76, 1.54),
        (Turbulence.SEVERE, 2.64, 2.31),
    ],
)
def test_standard_deviations_200_m_above_ground(level, horizontal, vertical):
    found = scales_at(level, 200.0)
    assert (found.sigma, found.sigma_w) == pytest.approx((horizontal, vertical), abs=0.01)


@pytest.mark.parametrize("height", [4.0, 20.0, 50.0, 150.0, 300.0])
@pytest.mark.parametrize("level", LEVELS)
def test_near_the_ground_the_wind_at_20_ft_scales_them(level, height):
    # Figures 10 and 11, for wind speeds of 15, 30 and 45 kt; h in feet.
    h, w20 = height / 0.3048, 15.0 * (1 + LEVELS.index(level)) * 1852.0 / 3600.0
    found, ratio = scales_at(level, height), 0.177 + 0.000823 * h
    assert found.sigma_w == pytest.approx(0.1 * w20)
    assert found.sigma == pytest.approx(0.1 * w20 / ratio**0.4)
    assert found.length_w == pytest.approx(0.3048 * h)
    assert found.length == pytest.approx(0.3048 * h / ratio**1.2)


@pytest.mark.parametrize(
    ("height_ft", "sigmas_fps"),
    [(3750.0, (7.4, 10.6, 23.0)), (15_000.0, (4.6, 8.0, 22.1)), (35_000.0, (0.4, 5.0, 16.0))],
)
def test_far_above_it_they_are_read_from_the_curves_of_figure_7(height_ft, sigmas_fps):
    for level, sigma_fps in zip(LEVELS, sigmas_fps, strict=True):
        sigma, length = 0.3048 * sigma_fps, 0.3048 * 1750.0
        assert scales_at(level, 0.3048 * height_ft) == pytest.approx((sigma, length) * 2)


@pytest.mark.parametrize("level", LEVELS)
def test_between_1000_and_2000_ft_they_are_linear(level):
    low, high = (scales_at(level, height) for height in (LOW_ALTITUDE, MEDIUM_ALTITUDE))
    for part in (1e-9, 0.25, 0.5, 1.0 - 1e-9):
        found = scales_at(level, LOW_ALTITUDE + part * (MEDIUM_ALTITUDE - LOW_ALTITUDE))
        assert found == pytest.approx(tuple(np.array(low) + part * (np.array(high) - low)))


def test_heights_below_10_ft_are_as_10_ft():
    assert scales_at(Turbulence.LIGHT, -3.0) == scales_at(Turbulence.LIGHT, 10.0 * FT)


@given(distances)
def test_a_step_keeps_the_variance_whatever_its_length(x):
    F, L = transition(x), input_matrix(x)
    kept = F @ F.T + L @ L.T
    assert kept == pytest.approx(np.eye(2), abs=1e-12)
    assert along_path(1.0, x, 0.0) ** 2 + along_path(0.0, x, 1.0) ** 2 == pytest.approx(1.0)


@given(distances, distances)
def test_two_steps_are_one(x, y):
    assert transition(y) @ transition(x) == pytest.approx(transition(x + y), abs=1e-12)
    F, L, M = transition(y), input_matrix(x), input_matrix(y)
    whole = input_matrix(x + y)
    noise = F @ L @ L.T @ F.T + M @ M.T
    assert noise == pytest.approx(whole @ whole.T, abs=1e-12)


@given(distances)
def test_correlations_are_those_of_the_spectra(x):
    # The cosine transforms of Dryden's spectra, by the tables of any textbook.
    assert along_path(1.0, x, 0.0) == pytest.approx(math.exp(-x))
    assert transition(x)[0, 0] == pytest.approx((1.0 - 0.5 * x) * math.exp(-x))


@given(st.lists(st.tuples(speeds, headings), min_size=1, max_size=20), st.floats(1e-6, 10.0))
def test_no_path_strengthens_what_is_there(path, dt):
    """The state without noise: its length never grows, whatever airspeeds and headings do."""
    gusts, before = Gusts(1.0, -1.0, 0.5, Stages(1.0, -0.5)), math.inf
    for speed, heading in path:
        v_air_n = (speed * math.cos(heading), speed * math.sin(heading), 0.0)
        gusts = flown_on(gusts, v_air_n, dt, UNIT, Noise(0.0, 0.0, 0.0, 0.0, 0.0))
        length = math.hypot(gusts.north, gusts.east, gusts.second, *gusts.vertical)
        assert length <= before + 1e-12
        before = length


@given(vectors, st.floats(-10.0, 12_000.0), st.floats(0.0, 5.0), st.sampled_from(list(Turbulence)))
def test_gusts_are_finite_anywhere(v_air_n, height, dt, level):
    air = GustyAir(level, 3)
    for gust in (
        air.gust_at(height),
        air.fly(v_air_n, height, dt),
        air.fly((0.0,) * 3, height, dt),
    ):
        assert np.abs(gust).max() < 6.0 * 25.0 * FT
        assert level is not Turbulence.NONE or gust == (0.0, 0.0, 0.0)


@given(headings, headings, numbers, numbers)
def test_an_aircraft_that_turns_does_not_turn_the_air(one, other, north, east):
    gusts = Gusts(north, east, 0.3, Stages(0.1, 0.2))
    no_noise = Noise(0.0, 0.0, 0.0, 0.0, 0.0)
    for heading in (one, other):
        v_air_n = (25.0 * math.cos(heading), 25.0 * math.sin(heading), 0.0)
        gusts = flown_on(gusts, v_air_n, 1e-5, UNIT, no_noise)
    assert (gusts.north, gusts.east) == pytest.approx((north, east), abs=1e-4)


@given(headings, vectors, st.floats(0.001, 1.0))
def test_the_air_has_no_preferred_direction(turn, noise, dt):
    """Gusts, path and noise turned by an angle give gusts turned by it."""
    c, s = math.cos(turn), math.sin(turn)

    def gusts_after(v_air_n, north, east):
        start = Gusts(north, east, 0.4, Stages(0.0, 0.0))
        after = flown_on(start, v_air_n, dt, UNIT, Noise(*noise, 0.0, 0.0))
        return after.north, after.east, after.second

    north, east, second = gusts_after((20.0, 0.0, 0.0), 0.7, -0.2)
    turned = gusts_after((20.0 * c, 20.0 * s, 0.0), c * 0.7 + s * 0.2, s * 0.7 - c * 0.2)
    assert turned == pytest.approx((c * north - s * east, s * north + c * east, second), abs=1e-9)


@pytest.mark.parametrize(("speed", "changes"), [(10.5, 1.5), (25.0, 2.0), (50.0, 8.0)])
def test_an_airspeed_that_changes_does_not_make_gusts_stronger(speed, changes):
    """Filters whose coefficients follow the airspeed make two to five times as much of them."""
    dt, rng = 0.2, np.random.default_rng(4)
    noise, change, airspeeds = rng.normal(size=40_000), 0.0, []
    for each in noise:
        change += dt / 0.5 * -change + changes * math.sqrt(2.0 * dt / 0.5) * each
        airspeeds.append(max(3.0, speed + change))
    gusts = flown(airspeeds, [0.0] * len(airspeeds), dt, 5)
    assert gusts.std(axis=0) == pytest.approx([1.0, 1.0, 1.0], rel=0.1)


def test_nor_do_turns():
    n, dt = 40_000, 0.5
    gusts = flown([15.0] * n, np.cumsum([0.3] * n), dt, 6)
    assert gusts.std(axis=0) == pytest.approx([1.0, 1.0, 1.0], rel=0.1)


def test_they_are_as_strong_from_the_first_instant():
    first = np.array([GustyAir(Turbulence.SEVERE, seed).gust_at(200.0) for seed in range(1000)])
    assert first.std(axis=0) == pytest.approx([2.64, 2.64, 2.31], rel=0.1)
    assert np.corrcoef(first.T) == pytest.approx(np.eye(3), abs=0.1)


def test_seeds_alone_make_the_gusts():
    def met(seed):
        air = GustyAir(Turbulence.LIGHT, seed)
        return [air.fly((20.0, 5.0, 0.0), 100.0, 0.005) for _ in range(50)]

    assert met(1) == met(1)
    assert met(1) != met(2)
    assert met(2**63 + 5) != met(1)


def test_w20_are_15_30_and_45_kt():
    assert [level.value.wind_at_20_ft / KT for level in LEVELS] == pytest.approx([15, 30, 45])
