"""What is flown to at one step."""

from typing import NamedTuple

from vfguide.flight.memory import Target
from vfguide.flight.state import FlightState
from vfguide.geometry.compiled import compiled


class Objective(NamedTuple):
    """What the mission asks for at one step."""

    target: Target
    state: FlightState
    """The vehicle in the frame in which the target stands still: over the ground, or in the air
    while it holds against a wind that is too strong."""
    begins: bool
    """Whether a leg begins at this step."""
    is_goal: bool
    """Whether it is a goal of the mission, to which there is progress: no circle, no hold."""


@compiled
def objective_at(target: Target, state: FlightState) -> Objective:
    """A target that stands still over the ground, its leg begun before."""
    return Objective(target, state, False, target.circle == 0.0)
