"""Cubics with given positions and velocities at both ends (Hermite): the path between two samples.

C. de Boor, A Practical Guide to Splines, 1978, chapter IV.
"""

from typing import Any, NamedTuple


class Cubic(NamedTuple):
    """The polynomial a + b s + c s^2 + d s^3 of s from 0 to 1.

    Its coefficients are numbers, or arrays of the same shape.
    """

    a: Any
    b: Any
    c: Any
    d: Any


def hermite(p0: Any, p1: Any, d0: Any, d1: Any) -> Cubic:
    """The cubic from `p0` to `p1` with derivatives `d0` and `d1` by s: velocity times duration."""
    step = p1 - p0
    return Cubic(p0, d0, 3.0 * step - 2.0 * d0 - d1, d0 + d1 - 2.0 * step)


def value_at(cubic: Cubic, s: Any) -> Any:
    """The value of a cubic at `s`."""
    a, b, c, d = cubic
    return a + s * (b + s * (c + s * d))


def derivative_at(cubic: Cubic, s: Any) -> Any:
    """The derivative of a cubic by s at `s`."""
    _, b, c, d = cubic
    return b + s * (2.0 * c + s * 3.0 * d)
