"""What a law of guidance remembers from step to step."""

from typing import NamedTuple

from vfguide.geometry.compiled import compiled


class GuidanceState(NamedTuple):
    """What one step leaves for the next."""

    slope: float
    """Wanted slope of the path over ground, its rate limited."""
    turning: float
    """Side of the present turn, +1 right, -1 left."""


@compiled
def fresh_guidance() -> GuidanceState:
    """Memory before the first step."""
    return GuidanceState(0.0, 1.0)
