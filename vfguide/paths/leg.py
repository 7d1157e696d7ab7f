"""The leg to one goal: what is remembered of how it is flown."""

from typing import NamedTuple

from vfguide.geometry.compiled import compiled
from vfguide.paths.course_laws import Planar
from vfguide.paths.dubins import DubinsPath
from vfguide.paths.path_progress import LAST_TURN, PathProgress

NEW, FIELD, ON_PATH, OUTBOUND = 0, 1, 2, 3
"""Phases: nothing flown yet; along the paper's field; along a path; away from the goal."""


class Leg(NamedTuple):
    """Memory of the leg to one goal."""

    phase: int
    radius: float
    """Of the turns [m]: kept, so that the path does not move during the approach."""
    final_approach: float
    """Length of the straight end [m]."""
    outbound: float
    """Course in phase OUTBOUND, from the goal's [rad]."""
    circles: float
    """Full circles that the path will have when it is flown after that."""
    progress: PathProgress
    """That is flown in phase ON_PATH."""


@compiled
def new_leg() -> Leg:
    """A leg of which nothing has been flown."""
    path = DubinsPath(1.0, 0.0, 0.0, 0.0, 1.0, 0.0)
    return Leg(NEW, 0.0, 0.0, 0.0, 0.0, PathProgress(0.0, 0.0, 0.0, path, 1.0, LAST_TURN, 0.0))


@compiled
def keep_radius(leg: Leg, radius: float) -> Leg:
    """The leg with turns of `radius` [m], changed only where aircraft or wind ask for another.

    Once it is begun only where they ask for a very different one, because it is planned anew then:
    a gusty wind comes and goes in less time than the leg takes.
    """
    change = 1.2 if leg.phase == NEW else 1.4
    if leg.radius < change * radius and radius <= change * leg.radius:
        return leg
    phase = NEW if leg.phase == ON_PATH else leg.phase
    return with_radius(in_phase(leg, phase, leg.progress), radius)


@compiled
def in_phase(leg: Leg, phase: int, progress: PathProgress) -> Leg:
    """The leg in another phase."""
    return Leg(phase, leg.radius, leg.final_approach, leg.outbound, leg.circles, progress)


@compiled
def with_radius(leg: Leg, radius: float) -> Leg:
    """The leg with turns of another radius [m]."""
    return Leg(leg.phase, radius, leg.final_approach, leg.outbound, leg.circles, leg.progress)


@compiled
def with_final_approach(leg: Leg, final_approach: float) -> Leg:
    """The leg with another length of its straight end [m]."""
    return Leg(leg.phase, leg.radius, final_approach, leg.outbound, leg.circles, leg.progress)


@compiled
def before_end(leg: Leg, at: Planar) -> Planar:
    """The vehicle in the plane whose origin is the beginning of the straight end."""
    return moved(at, leg.final_approach)


@compiled
def moved(at: Planar, farther: float) -> Planar:
    """The vehicle, seen from so much before the origin [m]."""
    return Planar(at.x + farther, at.y, at.vx, at.vy)
