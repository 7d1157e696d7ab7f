"""Position resets: jumps of the autopilot's estimate, which are let in slowly.

When an autopilot's estimator is reset, position or origin jump while the aircraft does not. The
position used by guidance continues from where it was, and the offset decays: the reference attitude
stays continuous, and no goal is passed by a jump.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.state import FlightState
from vfguide.geometry.vector import Vec3, add, norm, scale, sub
from vfguide.kernels.compiled import compiled

RESET_DISTANCE = 2.0
"""Distance from the predicted position above which a step counts as a reset [m]; chosen above the
noise of positions."""
RESET_ACCELERATION = 10.0
"""Growth of the reset distance with the square of the time step [m/s^2]; chosen as what an aircraft
may deviate from a straight line."""
LONGEST_PAUSE = 1.0
"""Time between two steps above which no reset is looked for [s]; chosen."""
HOLD_TIME = 0.5
"""Time for which the offset of a reset is held [s]; chosen as the time to ask the autopilot whether
its origin moved."""
DECAY_TIME = 1.0
"""Time constant with which the offset decays after that [s]; chosen."""
SETTLED_OFFSET = 1.0
"""Offset above which no goal counts as passed [m]; chosen."""


class PositionResets(NamedTuple):
    """State of the position resets."""

    offset_n: Vec3
    """Measured position less the one that guidance uses, NED [m]."""
    number: int
    """Number of resets so far."""
    size: float
    """Size of the latest reset [m]."""
    age: float
    """Time since the latest reset [s]."""


@compiled
def no_resets() -> PositionResets:
    """The state before the first reset."""
    return PositionResets((0.0, 0.0, 0.0), 0, 0.0, 0.0)


@compiled
def follow_resets(
    jumps: PositionResets,
    before: tuple[Vec3, Vec3],
    told: FlightState,
    dt: float,
    farther: float = 0.0,
) -> PositionResets:
    """The position resets after a step of `dt` [s].

    Args:
        jumps: resets at the step before.
        before: position that guidance used [m] and velocity [m/s] at the step before, NED.
        told: the state of this step, before resets are let in slowly.
        dt: time step [s].
        farther: time by which the state is predicted farther ahead than at the step before [s]:
            where the delay of the link has changed, the position moves, but has not jumped.
    """
    p_n, v_n = before
    if not 0.0 < dt < LONGEST_PAUSE:
        return PositionResets((0.0, 0.0, 0.0), jumps.number, jumps.size, 0.0)
    moved = scale(0.5 * (dt + farther), add(v_n, told.v_n))
    off = sub(told.p_n, add(add(p_n, jumps.offset_n), moved))
    age = jumps.age + dt
    left = scale(math.exp(-dt / DECAY_TIME), jumps.offset_n) if age > HOLD_TIME else jumps.offset_n
    size = norm(off)
    if not size > RESET_DISTANCE + RESET_ACCELERATION * dt * dt:
        return PositionResets(left, jumps.number, jumps.size, age)
    return PositionResets(add(left, off), jumps.number + 1, size, 0.0 if settled(jumps) else age)


@compiled
def smoothed(told: FlightState, jumps: PositionResets) -> FlightState:
    """The state for guidance: the measured one less the remaining offset."""
    p_n = sub(told.p_n, jumps.offset_n)
    return FlightState(told.time, p_n, told.v_n, told.R_nb, told.airspeed, told.wind_n)


@compiled
def settled(jumps: PositionResets) -> bool:
    """Whether the position for guidance is the measured one, within SETTLED_OFFSET."""
    return norm(jumps.offset_n) < SETTLED_OFFSET
