"""What the flight law is asked for, what it remembers from step to step, and what it wished for."""

from typing import NamedTuple

from vfguide.flight.leg import Leg, new_leg
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Mat3, Vec3


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


class Memory(NamedTuple):
    """What one step leaves for the next."""

    time: float
    """Of the last step [s]; negative before the first."""
    leg: Leg
    slope: float
    """Wanted slope, its rate limited."""
    turning: float
    """Side of the present turn, +1 right, -1 left."""
    R_na: Mat3
    """Reference attitude of the last step."""
    omega_a: Vec3
    """Its angular velocity, smoothed [rad/s]."""
    thrust_integral: float
    alpha_bias: float
    """Learned correction of the angle of attack [rad]."""


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


@compiled
def with_leg(m: Memory, leg: Leg) -> Memory:
    """The memory with another leg."""
    learned = (m.thrust_integral, m.alpha_bias)
    return Memory(m.time, leg, m.slope, m.turning, m.R_na, m.omega_a, *learned)


@compiled
def fresh_memory() -> Memory:
    """Memory before the first step."""
    level = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    return Memory(-1.0, new_leg(), 0.0, 1.0, level, (0.0, 0.0, 0.0), 0.0, 0.0)
