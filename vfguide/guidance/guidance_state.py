"""What a law of guidance remembers from step to step."""

from typing import NamedTuple

from vfguide.estimation.estimation import NavState
from vfguide.geometry.compiled import compiled

FIRST_STEP = 0.02
"""The time step that the first step counts as [s]."""
SHORTEST_STEP, LONGEST_STEP = 1e-3, 0.2
"""Bounds of the time between two steps that filters and rate limits take [s]."""


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


@compiled
def step_time(nav: NavState) -> float:
    """Time since the step before, bounded [s]."""
    return FIRST_STEP if nav.is_first else min(max(nav.elapsed, SHORTEST_STEP), LONGEST_STEP)
