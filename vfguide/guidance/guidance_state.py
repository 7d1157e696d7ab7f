"""The state of a law of guidance."""

import math
from enum import IntEnum
from typing import NamedTuple

from vfguide.kernels.compiled import compiled


class Leader(IntEnum):
    """What law `field` follows."""

    FIELD = 0
    """The avoidance field."""
    APPROACH = 1
    """The approach of law `flight`, within the last turn radii to the goal."""
    ROUTE = 2
    """A route of law `flight`: the field is blocked or comes no nearer, or an approach was left."""
    CIRCLE = 3
    """The circle after the last goal, or that of a wind hold."""


class FieldProgress(NamedTuple):
    """How law `field` comes on along one leg."""

    leader: int
    """The `Leader` of the next step on this leg."""
    length: float
    """Length of the field's line to the goal [m]."""
    nearest: float
    """Least length of the field's line to the goal on this leg [m]."""
    since: float
    """When it was least [s]."""
    looked: float
    """When the path along the field was last predicted [s]."""


class GuidanceState(NamedTuple):
    """What a law of guidance keeps from one step to the next."""

    slope: float
    """Wanted slope dh/ds of the path over ground, its rate limited."""
    turning: float
    """Side of the present turn, +1 right, -1 left."""
    progress: FieldProgress
    """Of law `field`."""


@compiled
def leg_begins(time: float) -> FieldProgress:
    """The progress at the start of a leg; `time` is now [s]."""
    return FieldProgress(Leader.FIELD.value, math.inf, math.inf, time, -math.inf)


@compiled
def fresh_guidance() -> GuidanceState:
    """The state of guidance before the first step."""
    return GuidanceState(0.0, 1.0, leg_begins(0.0))
