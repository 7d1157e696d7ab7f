"""Body rates from matrices that are skew but for rounding or differences."""

import numpy as np


def vee(S):
    """Vectors of the skew parts of matrices (..., 3, 3)."""
    skew = 0.5 * (S - np.swapaxes(S, -1, -2))
    return np.stack([skew[..., 2, 1], skew[..., 0, 2], skew[..., 1, 0]], axis=-1)
