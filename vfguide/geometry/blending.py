"""Blending of two values: linear interpolation, and the low-pass filter that goes on by it."""

from vfguide.kernels.compiled import compiled


@compiled
def blended(first: float, second: float, part: float) -> float:
    """Linear interpolation: the first at part 0, the second at part 1."""
    return first + part * (second - first)


@compiled
def low_pass_share(time: float, dt: float) -> float:
    """Part of a new value in the smoothed one, dimensionless: dt / (T + dt).

    A low-pass filter of first order with the time constant T = `time` [s], discretised backwards
    (implicit Euler) with the time step `dt` [s].
    """
    return dt / (time + dt)
