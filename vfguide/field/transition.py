"""The transition chi: 0 where a field must be tangential, 1 where an obstacle has no effect."""

import math

from vfguide.geometry.dual import Dual
from vfguide.kernels.compiled import compiled

MAX_EXPONENT = 700.0
"""Exponent of e beyond which S is 0 or 1 with vanishing derivatives, near the largest number whose
exponential is finite (709)."""


@compiled
def smooth_step(s: float) -> tuple[float, float]:
    """S(s) and dS/ds: 0 up to s = 0, 1 from s = 1 on, every derivative continuous.

    S = e^(-1/s) / (e^(-1/s) + e^(-1/(1-s))), one of the paper's bump functions (eq_chi).
    """
    if s <= 0.0:
        return (0.0, 0.0)
    if s >= 1.0:
        return (1.0, 0.0)
    exponent = 1.0 / s - 1.0 / (1.0 - s)
    if abs(exponent) > MAX_EXPONENT:
        return (0.0 if exponent > 0.0 else 1.0, 0.0)
    q = math.exp(-abs(exponent))
    slope = q / (1.0 + q) ** 2 * (1.0 / s**2 + 1.0 / (1.0 - s) ** 2)
    return ((q if exponent > 0.0 else 1.0) / (1.0 + q), slope)


@compiled
def transition(level: Dual, closed: float, opened: float) -> Dual:
    """The transition chi = S((level - closed) / (opened - closed)): eq_chi, eq_chi_j.

    Args:
        level: U of an obstacle or the distance to a robot, with its rate.
        closed: level up to which chi is 0.
        opened: level from which on chi is 1.
    """
    width = opened - closed
    chi, slope = smooth_step((level.value - closed) / width)
    return Dual(chi, slope / width * level.rate)
