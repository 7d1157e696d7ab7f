"""How often goals were missed, and when one is given up."""

from typing import NamedTuple

from vfguide.companion.legs import Goal
from vfguide.geometry.compiled import compiled

NEAR = 50.0
"""A pass by more than this is no try at the goal, unless its tolerance is larger [m]."""


class Tries(NamedTuple):
    """What is remembered of missed passes."""

    missed: int
    """Passes that missed the goal that is flown to."""
    given_up: int
    """Goals that were given up."""


@compiled
def no_tries() -> Tries:
    """Nothing was missed."""
    return Tries(0, 0)


@compiled
def once_more(tries: Tries) -> Tries:
    """The present goal was missed again."""
    return Tries(tries.missed + 1, tries.given_up)


@compiled
def gives_up(tries: Tries, goal: Goal) -> bool:
    """Whether the goal was missed as often as it may be; without a number it never is."""
    return 0 < goal.attempts <= tries.missed


@compiled
def at_next(tries: Tries, given_up: bool) -> Tries:
    """At the next goal, after one that was reached or `given_up`."""
    return Tries(0, tries.given_up + 1 if given_up else tries.given_up)
