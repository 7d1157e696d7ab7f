"""Whether a leg comes to its end: a vehicle that circles without coming nearer is told of."""

import math
from typing import NamedTuple

from vfguide.flight.leg import AWAY, WAY, Leg
from vfguide.geometry.angles import TURN
from vfguide.geometry.compiled import compiled

MARGIN = 5.0
"""A path that is shorter by less than this is no progress [m]."""


class Progress(NamedTuple):
    """What is remembered of a leg."""

    least: float
    """Least length of the path to the goal so far [m]."""
    turned: float
    """Net change of the course over ground since then, clockwise [rad]."""
    planned: float
    """What the longest winding way since then turns [rad]."""
    alarmed: bool
    """Whether it has turned a full circle more than planned since then."""


@compiled
def fresh_progress() -> Progress:
    """Nothing of the leg is flown yet."""
    return Progress(math.inf, 0.0, 0.0, False)


@compiled
def after_step(progress: Progress, remaining: float, leg: Leg, turned: float) -> Progress:
    """Progress after one step; an alarm stays until the leg is over.

    Args:
        progress: after the step before.
        remaining: length of the path to the goal [m]; away from the goal it is none.
        leg: that is flown.
        turned: change of the course over ground in the step [rad].
    """
    planned = turns_of(leg)
    if leg.phase != AWAY and remaining < progress.least - MARGIN:
        return Progress(remaining, 0.0, planned, progress.alarmed)
    turned, planned = progress.turned + turned, max(progress.planned, planned)
    alarmed = progress.alarmed or abs(turned) > TURN + planned
    return Progress(progress.least, turned, planned, alarmed)


@compiled
def turns_of(leg: Leg) -> float:
    """The turns of the way that is flown, full circles included [rad]; 0 where there is no way."""
    if leg.phase != WAY:
        return 0.0
    word = leg.way.word
    return word.arc + (0.0 if word.middle == 0.0 else word.reach) + word.end
