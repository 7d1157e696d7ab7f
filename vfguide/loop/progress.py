"""Whether a leg comes to its end: a vehicle that flies on without coming nearer is told of."""

import math
from typing import NamedTuple

from vfguide.estimation.estimation import NavState
from vfguide.geometry.angles import FULL_TURN
from vfguide.geometry.compiled import compiled
from vfguide.paths.leg import OUTBOUND, Leg
from vfguide.planning.objective import Objective

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
def update(nav: NavState, goal: Objective, leg: Leg, remaining: float, s: Progress) -> Progress:
    """Progress after one step; an alarm stays until the leg is over.

    Args:
        nav: the vehicle, and where it was at the step before.
        goal: what is flown to.
        leg: that is flown.
        remaining: length of the path to the goal [m].
        s: what the step before left.
    """
    if goal.begins:
        return fresh_progress()
    if not goal.is_goal or not nav.is_continuous:
        return s
    before, now = nav.p_n_before, nav.state.p_n
    return after_step(s, remaining, leg, math.hypot(now[0] - before[0], now[1] - before[1]))


@compiled
def after_step(progress: Progress, remaining: float, leg: Leg, flown: float) -> Progress:
    """Progress on a leg that goes on.

    Args:
        progress: after the step before.
        remaining: length of the path to the goal [m]; away from the goal it is none.
        leg: that is flown.
        flown: distance over ground in the step [m].
    """
    if leg.phase != OUTBOUND and remaining < progress.least - MARGIN:
        return Progress(remaining, remaining, 0.0, progress.alarmed)
    longest = progress.longest
    if leg.phase != OUTBOUND:
        longest = max(longest, remaining)
    flown += progress.flown
    enough = FULL_TURN * leg.radius + longest - progress.least
    return Progress(progress.least, longest, flown, progress.alarmed or flown > enough > 0.0)
