"""Jumps of what the autopilot believes of its place: let in slowly, never flown at once.

When an autopilot's estimator is reset, position or origin jump while the aircraft does not. The
place that is flown on goes on from where it was, and the difference dies away: the reference
attitude stays continuous, and no goal is passed by a jump.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.state import FlightState
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3, add, norm, scale, sub

LEAST, BOUND = 2.0, 10.0
"""More than this [m], plus this times the time squared [m/s^2], no aeroplane strays from its
course between two steps."""
LONGEST = 1.0
"""After a pause longer than this nothing is known of a jump [s]."""
PATIENCE = 0.5
"""A difference stands for this long [s]: time to ask whether it was the origin that moved."""
DECAY = 1.0
"""Then it dies away with this time constant [s]."""
SMALL = 1.0
"""Above this difference no goal counts as passed [m]."""


class PositionResets(NamedTuple):
    """Memory of the jumps."""

    offset_n: Vec3
    """What was told less what is flown on, NED [m]."""
    number: int
    """How many there were."""
    size: float
    """Of the latest [m]."""
    age: float
    """Time since then [s]."""


@compiled
def no_resets() -> PositionResets:
    """Nothing has jumped yet."""
    return PositionResets((0.0, 0.0, 0.0), 0, 0.0, 0.0)


@compiled
def follow_resets(
    jumps: PositionResets, before: tuple[Vec3, Vec3], told: FlightState, dt: float
) -> PositionResets:
    """The jumps after a step of `dt` [s].

    Args:
        jumps: at the step before.
        before: position that was flown on [m] and velocity [m/s] at the step before.
        told: the state as it is told now.
        dt: the time step [s].
    """
    p_n, v_n = before
    if not 0.0 < dt < LONGEST:
        return PositionResets((0.0, 0.0, 0.0), jumps.number, jumps.size, 0.0)
    moved = scale(0.5 * dt, add(v_n, told.v_n))
    off = sub(told.p_n, add(add(p_n, jumps.offset_n), moved))
    age = jumps.age + dt
    left = scale(math.exp(-dt / DECAY), jumps.offset_n) if age > PATIENCE else jumps.offset_n
    size = norm(off)
    if not size > LEAST + BOUND * dt * dt:
        return PositionResets(left, jumps.number, jumps.size, age)
    return PositionResets(add(jumps.offset_n, off), jumps.number + 1, size, 0.0)


@compiled
def smoothed(told: FlightState, jumps: PositionResets) -> FlightState:
    """The state to fly on: the told one less what has not been let in yet."""
    p_n = sub(told.p_n, jumps.offset_n)
    return FlightState(told.time, p_n, told.v_n, told.R_nb, told.airspeed, told.wind_n)


@compiled
def settled(jumps: PositionResets) -> bool:
    """Whether the place that is flown on is the one that is told."""
    return norm(jumps.offset_n) < SMALL
