"""What a law of guidance is asked for, and what it commands."""

from typing import NamedTuple

from vfguide.geometry.vector import Vec3


class Target(NamedTuple):
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


class Wish(NamedTuple):
    """What the law wanted at one step: for displays, logs and tests."""

    course: float
    """Over ground [rad]."""
    azimuth: float
    """Of the air velocity [rad]."""
    gamma: float
    """Path angle through the air [rad]."""
    climb: float
    """The same, or the steeper one that the height asks for: thrust is set for it [rad]."""
    bank: float
    load: float
    remaining: float
    """Path length to the goal [m]."""
    phase: int
    radius: float
    """Turn radius of the approach [m]."""
