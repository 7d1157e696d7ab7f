"""Spectra, standard deviations and scale lengths of long records against MIL-F-8785C."""

from itertools import pairwise

import numpy as np
import pytest
from gust_samples import UNIT, straight
from scipy.signal import welch

pytestmark = pytest.mark.slow

SAMPLES = 200_000
CYCLES = 900
"""Independent cycles in an octave, with which it is known to 1 part in 30."""


def along(lw):
    """Dryden's spectrum of u over sigma^2 L, by L W."""
    return 2.0 / np.pi / (1.0 + lw**2)


def across(lw):
    """That of v and w."""
    return (1.0 + 3.0 * lw**2) / (1.0 + lw**2) ** 2 / np.pi


COMPONENTS = ((0, along, UNIT.length), (1, across, UNIT.length), (2, across, UNIT.length_w))


def octaves_of(gusts, dt, wanted, length, speed):
    """What is found over what is wanted in each octave, as far as a record knows it.

    Below the lowest it is too short, above the highest its samples take one frequency for another.
    """
    frequency, found = welch(gusts, 1.0 / dt, nperseg=SAMPLES // 24)
    to_space = 2.0 * np.pi / speed
    expected = wanted(length * to_space * frequency) * length * to_space
    edges = np.geomspace(CYCLES / (SAMPLES * dt), 0.072 / dt, 5)
    for low, high in pairwise(edges):
        band = (frequency >= low) & (frequency < high)
        yield found[band].sum() / expected[band].sum()


@pytest.mark.parametrize(
    ("speed", "dt"),
    [(5.0, 3.0), (25.0, 0.5), (80.0, 0.2), (25.0, 0.02), (5.0, 0.005), (80.0, 0.005)],
)
def test_spectra(speed, dt):
    gusts = straight(speed, dt, SAMPLES)
    for k, wanted, length in COMPONENTS:
        ratios = list(octaves_of(gusts[:, k], dt, wanted, length, speed))
        assert ratios == pytest.approx(np.ones(4), abs=0.1), k


@pytest.mark.parametrize("metres", [5.0, 15.0, 60.0])
def test_standard_deviations(metres):
    gusts = straight(25.0, metres / 25.0, SAMPLES)
    assert gusts.std(axis=0) == pytest.approx([1.0, 1.0, 1.0], rel=0.05)


def correlation(gusts, lag):
    """Correlation of a record with itself `lag` samples later."""
    return np.mean(gusts[lag:] * gusts[:-lag]) / np.mean(gusts**2)


@pytest.mark.parametrize("metres", [0.5, 5.0, 15.0, 50.0])
def test_scale_lengths(metres):
    """L from the correlation over half of it, whose slope there is -exp(-1/2) / L or steeper."""
    gusts = straight(25.0, metres / 25.0, 2 * SAMPLES)
    for k, wanted, length in COMPONENTS:
        x = (lag := round(0.5 * length / metres)) * metres / length
        found = correlation(gusts[:, k], lag)
        lengths = np.linspace(0.5, 2.0, 301)
        then = np.exp(-x / lengths) * (1.0 if wanted is along else 1.0 - 0.5 * x / lengths)
        assert np.interp(found, then, lengths) == pytest.approx(1.0, abs=0.15), k
