"""The draws of a campaign: for each flight its seed, and the values of what is varied."""

import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import assert_never

import numpy as np
from numpy.random import Generator, SeedSequence

from vfguide.files.overrides import Override, drawn_override
from vfguide.files.vary import Distribution, Normal, Uniform

SEEDS = 2**32
"""Number of seeds that a scenario may have, from 0 on."""
SEED_STREAM = 0
"""Number of the random stream from which the seed of a flight is drawn; the streams of the keys
have those of their names, so that a key that is added changes no other one's values."""


@dataclass(frozen=True)
class Draw:
    """What differs between a flight and the others of its campaign."""

    index: int
    """Number of the flight in the campaign, from 0."""
    seed: int
    """Seed of its scenario."""
    values: tuple[tuple[str, float], ...]
    """The dotted keys that are varied, each with its value."""

    @property
    def overrides(self) -> tuple[Override, ...]:
        """What replaces the written values of the scenario."""
        values = (drawn_override(key, value) for key, value in self.values)
        return (drawn_override("seed", self.seed), *values)


def draw(campaign_seed: int, index: int, vary: Mapping[str, Distribution]) -> Draw:
    """The draw of one flight, which depends on nothing but the arguments.

    Args:
        campaign_seed: seed of the campaign.
        index: number of the flight.
        vary: the distributions by their dotted keys.
    """
    seed = int(stream(campaign_seed, index, SEED_STREAM).integers(SEEDS))
    values = tuple(
        (key, value_of(each, stream(campaign_seed, index, zlib.crc32(key.encode()))))
        for key, each in vary.items()
    )
    return Draw(index, seed, values)


def stream(campaign_seed: int, index: int, number: int) -> Generator:
    """A random stream of one flight, by its number."""
    return np.random.default_rng(SeedSequence(campaign_seed, spawn_key=(index, number)))


def value_of(distribution: Distribution, rng: Generator) -> float:
    """One value of a distribution."""
    match distribution:
        case Uniform(low, high):
            return float(rng.uniform(low, high))
        case Normal(mean, std):
            return float(rng.normal(mean, std))
        case _:
            assert_never(distribution)
