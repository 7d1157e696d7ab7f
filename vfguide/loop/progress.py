"""Progress of a leg: the operator is warned of a vehicle that flies on without coming nearer."""

import math
from typing import NamedTuple

from vfguide.aircraft.command import GuidanceCommand
from vfguide.estimation.estimation import NavState
from vfguide.geometry.angles import FULL_TURN
from vfguide.geometry.vector import sub
from vfguide.geometry.velocity import horizontal_norm
from vfguide.kernels.compiled import compiled
from vfguide.paths.leg import OUTBOUND
from vfguide.planning.objective import Objective

PROGRESS_MARGIN = 5.0
"""Length by which the path to the goal must become shorter to count as progress [m]; chosen."""


class Progress(NamedTuple):
    """State of the progress on a leg."""

    least: float
    """Least length of the path to the goal so far [m]."""
    longest: float
    """Greatest length of a path to the goal since then [m]."""
    flown: float
    """Distance over ground since then [m]."""
    alarmed: bool
    """Whether it has flown farther without progress than a full circle and `longest` - `least`."""


@compiled
def fresh_progress() -> Progress:
    """The progress at the start of a leg."""
    return Progress(math.inf, 0.0, 0.0, False)


@compiled
def update(nav: NavState, goal: Objective, command: GuidanceCommand, s: Progress) -> Progress:
    """Progress after one step; an alarm stays until the leg is over.

    Args:
        nav: state of the vehicle, and its position at the step before.
        goal: objective of the mission.
        command: the command that is flown.
        s: progress after the step before.
    """
    if goal.begins:
        return fresh_progress()
    if not goal.is_goal or not nav.is_continuous:
        return s
    flown = horizontal_norm(sub(nav.state.p_n, nav.p_n_before))
    return after_step(s, command, flown)


@compiled
def after_step(progress: Progress, command: GuidanceCommand, flown: float) -> Progress:
    """Progress on a leg that goes on.

    Args:
        progress: after the step before.
        command: the command that is flown; its `remaining` has no meaning in phase OUTBOUND.
        flown: distance over ground in the step [m].
    """
    remaining, counts = command.remaining, command.phase != OUTBOUND
    if counts and remaining < progress.least - PROGRESS_MARGIN:
        return Progress(remaining, remaining, 0.0, progress.alarmed)
    longest = progress.longest
    if counts:
        longest = max(longest, remaining)
    flown += progress.flown
    enough = FULL_TURN * command.radius + longest - progress.least
    return Progress(progress.least, longest, flown, progress.alarmed or flown > enough > 0.0)
