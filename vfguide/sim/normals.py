"""Standard normal numbers of one random stream."""

from collections.abc import Iterator

import numpy as np

BLOCK = 4096
"""Number of random numbers that are drawn at once, since one at a time costs a microsecond."""


def normals(seed: int) -> Iterator[float]:
    """Standard normal numbers without end."""
    rng = np.random.Generator(np.random.PCG64(seed))
    while True:
        yield from rng.standard_normal(BLOCK).tolist()
