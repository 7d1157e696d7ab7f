"""What is flown to at one step."""

from typing import NamedTuple

from vfguide.aircraft.state import FlightState
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3


class GuidanceTarget(NamedTuple):
    """What to fly to: a pose to pass, or a circle to fly round."""

    p_n: Vec3
    """The goal, or a point of the circle [m]."""
    course: float
    """Course over ground there [rad]."""
    slope: float
    """Slope dh/ds of the path at the goal."""
    circle: float
    """0: a goal. +1, -1: the circle that leaves the point to the right or to the left."""
    radius: float
    """Radius of the circle [m]; it grows where wind and bank ask for more."""


class Objective(NamedTuple):
    """What the mission asks for at one step."""

    target: GuidanceTarget
    state: FlightState
    """The vehicle in the frame in which the target stands still: over the ground, or in the air
    while it holds against a wind that is too strong."""
    begins: bool
    """Whether a leg begins at this step."""
    is_goal: bool
    """Whether it is a goal of the mission, to which there is progress: no circle, no hold."""


@compiled
def objective_at(target: GuidanceTarget, state: FlightState) -> Objective:
    """A target that stands still over the ground, its leg begun before."""
    return Objective(target, state, False, target.circle == 0.0)
