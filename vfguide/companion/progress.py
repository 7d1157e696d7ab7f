"""Whether a leg comes to its end: a vehicle that flies on without coming nearer is told of."""

import math
from typing import NamedTuple

from vfguide.flight.leg import AWAY, Leg
from vfguide.geometry.angles import TURN
from vfguide.geometry.compiled import compiled

MARGIN = 5.0
"""A path that is shorter by less than this is no progress [m]."""


class Progress(NamedTuple):
    """What is remembered of a leg."""

    least: float
    """Least length of the path to the goal so far [m]."""
    longest: float
    """Greatest length of a path to the goal since then [m]."""
    flown: float
    """Distance over ground since then [m]."""
    alarmed: bool
    """Whether it has flown a full circle more than those paths need to come nearer."""


@compiled
def fresh_progress() -> Progress:
    """Nothing of the leg is flown yet."""
    return Progress(math.inf, 0.0, 0.0, False)


@compiled
def after_step(progress: Progress, remaining: float, leg: Leg, flown: float) -> Progress:
    """Progress after one step; an alarm stays until the leg is over.

    Args:
        progress: after the step before.
        remaining: length of the path to the goal [m]; away from the goal it is none.
        leg: that is flown.
        flown: distance over ground in the step [m].
    """
    if leg.phase != AWAY and remaining < progress.least - MARGIN:
        return Progress(remaining, remaining, 0.0, progress.alarmed)
    longest = progress.longest
    if leg.phase != AWAY:
        longest = max(longest, remaining)
    flown += progress.flown
    enough = TURN * leg.radius + longest - progress.least
    return Progress(progress.least, longest, flown, progress.alarmed or flown > enough > 0.0)
