"""The objective of the mission at one step."""

from typing import NamedTuple

from vfguide.aircraft.state import FlightState
from vfguide.geometry.se2 import Pose
from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled


class GuidanceTarget(NamedTuple):
    """A pose to pass, or a circle to fly."""

    p_n: Vec3
    """The goal, or a point of the circle, NED [m]."""
    course: float
    """Course over ground there [rad]."""
    slope: float
    """Slope dh/ds of the path at the goal."""
    circle: float
    """0 for a goal; +1 or -1 for the circle that leaves the point to the right or to the left."""
    radius: float
    """Radius of the circle [m]; it grows where wind and bank ask for more."""


@compiled
def pose_of_target(target: GuidanceTarget) -> Pose:
    """The pose of a target in the horizontal plane, NED."""
    return Pose(target.p_n[0], target.p_n[1], target.course)


class Objective(NamedTuple):
    """What the mission asks for at one step."""

    target: GuidanceTarget
    state: FlightState
    """The vehicle in the frame in which the target does not move: that of the ground, or that of
    the air during a wind hold."""
    begins: bool
    """Whether a leg starts at this step."""
    is_goal: bool
    """Whether it is a goal of the mission, and neither a circle nor a wind hold."""


@compiled
def objective_at(target: GuidanceTarget, state: FlightState) -> Objective:
    """The objective of a target that does not move over ground, on a leg that started before."""
    return Objective(target, state, False, target.circle == 0.0)
