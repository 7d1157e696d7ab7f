"""Directions to a surface for meshes of it: they crowd where the shape has an edge.

Latitudes are (N, 1), from z < 0 to z > 0, longitudes (M,) [rad]; directions are (N, M) or (N, 1)
along each of the body's axes, in semi-axes.
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Rays = tuple[Array, Array, Array]
"""The components of directions along the body's axes, in semi-axes."""


def upright_rays(latitude: Array, longitude: Array, p: float) -> Rays:
    """Directions to a body of revolution about the vertical: p-th roots of cosine and sine."""
    beside = root(np.cos(latitude), p)
    return beside * np.cos(longitude), beside * np.sin(longitude), root(np.sin(latitude), p)


def root(values: Array, p: float) -> Array:
    """The p-th root with the sign of the value; what is zero but for rounding is zero."""
    return np.where(np.abs(values) < 1e-15, 0.0, np.sign(values) * np.abs(values) ** (1.0 / p))
