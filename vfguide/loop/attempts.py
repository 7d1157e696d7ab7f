"""How often goals were missed, and when one is given up."""

from typing import NamedTuple

from vfguide.geometry.compiled import compiled
from vfguide.loop.legs import Goal

ATTEMPT_MISS = 50.0
"""A pass by more than this is no try at the goal, unless its tolerance is larger [m]."""


class Attempts(NamedTuple):
    """What is remembered of missed passes."""

    missed: int
    """Passes that missed the goal that is flown to."""
    given_up: int
    """Goals that were given up."""


@compiled
def no_attempts() -> Attempts:
    """Nothing was missed."""
    return Attempts(0, 0)


@compiled
def once_more(attempts: Attempts) -> Attempts:
    """The present goal was missed again."""
    return Attempts(attempts.missed + 1, attempts.given_up)


@compiled
def gives_up(attempts: Attempts, goal: Goal) -> bool:
    """Whether the goal was missed as often as it may be; without a number it never is."""
    return 0 < goal.attempts <= attempts.missed


@compiled
def at_next(attempts: Attempts, given_up: bool) -> Attempts:
    """At the next goal, after one that was reached or `given_up`."""
    return Attempts(0, attempts.given_up + 1 if given_up else attempts.given_up)
