"""The state of a law of guidance."""

import math
from typing import NamedTuple

from vfguide.kernels.compiled import compiled


class GuidanceState(NamedTuple):
    """What a law of guidance keeps from one step to the next."""

    slope: float
    """Wanted slope dh/ds of the path over ground, its rate limited."""
    turning: float
    """Side of the present turn, +1 right, -1 left."""
    leads: bool
    """Whether the field leads, in law `field`."""
    nearest: float
    """Least length of the field's line to the goal on this leg [m]."""
    since: float
    """When it was least [s]."""


@compiled
def fresh_guidance() -> GuidanceState:
    """The state of guidance before the first step."""
    return GuidanceState(0.0, 1.0, True, math.inf, 0.0)
