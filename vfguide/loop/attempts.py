"""Attempts at goals: how often they were missed, and when one is given up."""

from typing import NamedTuple

from vfguide.kernels.compiled import compiled
from vfguide.loop.legs import Goal

ATTEMPT_MISS = 50.0
"""Largest miss of a pass that counts as an attempt, unless the goal's tolerance is larger [m];
chosen, farther passes are part of the path."""


class Attempts(NamedTuple):
    """Numbers of missed passes and of goals that were given up."""

    missed: int
    """Number of passes that missed the present goal."""
    given_up: int
    """Number of goals that were given up."""


@compiled
def no_attempts() -> Attempts:
    """The attempts before the first pass."""
    return Attempts(0, 0)


@compiled
def once_more(attempts: Attempts) -> Attempts:
    """The attempts after the present goal was missed again."""
    return Attempts(attempts.missed + 1, attempts.given_up)


@compiled
def gives_up(attempts: Attempts, goal: Goal) -> bool:
    """Whether the goal was missed as often as it may be, `goal.attempts`; never if that is 0."""
    return 0 < goal.attempts <= attempts.missed


@compiled
def at_next(attempts: Attempts, given_up: bool) -> Attempts:
    """The attempts at the next goal, after one that was reached or `given_up`."""
    return Attempts(0, attempts.given_up + 1 if given_up else attempts.given_up)
