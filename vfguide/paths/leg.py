"""The leg to one goal: its phase, its turns and its path."""

from typing import NamedTuple

from vfguide.geometry.se2 import ORIGIN
from vfguide.kernels.compiled import compiled
from vfguide.paths.course_laws import PlanarState
from vfguide.paths.dubins import DubinsPath
from vfguide.paths.edge import LAST_TURN, Edge
from vfguide.paths.path_progress import PathProgress

NEW = 0
"""Number of the phase before anything has been flown."""
FIELD = 1
"""Number of the phase along the paper's field."""
ON_PATH = 2
"""Number of the phase along a Dubins path."""
OUTBOUND = 3
"""Number of the phase away from the goal, which makes the leg longer."""
NEW_RADIUS_CHANGE = 1.2
"""Ratio between two turn radii above which a leg that has not started takes the other one;
chosen."""
FLOWN_RADIUS_CHANGE = 1.4
"""Ratio between two turn radii above which a leg that has started takes the other one; chosen
larger, since a gust lasts less time than a leg."""


class Leg(NamedTuple):
    """State of the leg to one goal."""

    phase: int
    """One of NEW, FIELD, ON_PATH and OUTBOUND."""
    radius: float
    """Radius of the turns over ground [m], kept so that the path does not move during a leg."""
    final_approach: float
    """Length of the final approach [m]."""
    outbound: float
    """Course in phase OUTBOUND, relative to the goal's [rad]."""
    circles: float
    """Number of full circles of the path that follows phase OUTBOUND."""
    progress: PathProgress
    """Path of phase ON_PATH, and the progress along it."""


@compiled
def new_leg() -> Leg:
    """A leg in phase NEW."""
    edge = Edge(ORIGIN, DubinsPath(1.0, 0.0, 0.0, 0.0, 1.0, 0.0))
    return Leg(NEW, 0.0, 0.0, 0.0, 0.0, PathProgress(edge, ORIGIN, 1.0, LAST_TURN, 0.0))


@compiled
def keep_radius(leg: Leg, radius: float) -> Leg:
    """The leg with turns of `radius` [m] if that differs much from its own; else unchanged.

    A leg on a path is planned anew with the other radius.
    """
    change = NEW_RADIUS_CHANGE if leg.phase == NEW else FLOWN_RADIUS_CHANGE
    if leg.radius < change * radius and radius <= change * leg.radius:
        return leg
    phase = NEW if leg.phase == ON_PATH else leg.phase
    return with_radius(in_phase(leg, phase, leg.progress), radius)


@compiled
def in_phase(leg: Leg, phase: int, progress: PathProgress) -> Leg:
    """The leg in another phase, with the progress along its path."""
    return Leg(phase, leg.radius, leg.final_approach, leg.outbound, leg.circles, progress)


@compiled
def with_radius(leg: Leg, radius: float) -> Leg:
    """The leg with turns of another radius [m]."""
    return Leg(leg.phase, radius, leg.final_approach, leg.outbound, leg.circles, leg.progress)


@compiled
def with_final_approach(leg: Leg, final_approach: float) -> Leg:
    """The leg with another length of its final approach [m]."""
    return Leg(leg.phase, leg.radius, final_approach, leg.outbound, leg.circles, leg.progress)


@compiled
def before_end(leg: Leg, at: PlanarState) -> PlanarState:
    """The vehicle in the plane whose origin is the start of the final approach."""
    return moved(at, leg.final_approach)


@compiled
def moved(at: PlanarState, farther: float) -> PlanarState:
    """The vehicle relative to a point `farther` [m] before the origin."""
    return PlanarState(at.x + farther, at.y, at.vx, at.vy)
