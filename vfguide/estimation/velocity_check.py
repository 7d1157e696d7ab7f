"""Ground velocity against the motion of the position, of which it must be the rate.

The velocity to fly on is the reported one plus a correction, as in a complementary filter: fast
changes are taken from the reported velocity, slow ones from the position.
"""

from typing import NamedTuple

from vfguide.geometry.vector import ZERO, Vec3, add, norm, scale, sub
from vfguide.kernels.compiled import compiled

VELOCITY_JUMP = 3.0
"""Change of the ground velocity in a step above which the aircraft has not made it [m/s]; chosen
above the noise of velocities."""
MOST_ACCELERATION = 30.0
"""Growth of `VELOCITY_JUMP` with the time step [m/s^2]; chosen as the most an aircraft
accelerates."""
POSITION_JUMP = 2.0
"""Motion of the position beyond the velocity that counts as a position reset [m]; chosen above the
noise of positions."""
CORRECTION_TIME = 1.0
"""Time constant of the correction [s]; chosen, so that a position noise of 0.5 m passes as 0.5
m/s."""
VELOCITY_ERROR = 3.0
"""Error above which the ground velocity is doubted [m/s]; chosen above those of good estimators."""
VELOCITY_AGREES = 1.5
"""Error below which a doubted ground velocity is believed again [m/s]; chosen as hysteresis."""


class VelocityCheck(NamedTuple):
    """What was reported last, and the error that it has shown."""

    p_n: Vec3
    """Position, NED [m]."""
    v_n: Vec3
    """Velocity over ground, NED [m/s]."""
    correction_n: Vec3
    """Velocity of the position less the reported one, smoothed, NED [m/s]."""
    age: float
    """Time since the first position [s]."""
    is_doubted: bool
    """Whether the correction is flown on."""


@compiled
def first_velocity(p_n: Vec3, v_n: Vec3) -> VelocityCheck:
    """The check after one position [m] and velocity [m/s], NED: nothing is known yet."""
    return VelocityCheck(p_n, v_n, ZERO, 0.0, False)


@compiled
def velocity_jumps(before_n: Vec3, v_n: Vec3, dt: float) -> bool:
    """Whether a velocity, NED [m/s], has changed more in `dt` [s] than an aircraft's can."""
    return norm(sub(v_n, before_n)) > VELOCITY_JUMP + MOST_ACCELERATION * dt


@compiled
def follow_velocity(s: VelocityCheck, p_n: Vec3, v_n: Vec3, dt: float) -> VelocityCheck:
    """The check `dt` [s] later, with the next position [m] and velocity [m/s], NED.

    Up to an age of CORRECTION_TIME the correction is the plain mean of all errors. It has more of
    the noise of the position then, so that its limit is wider.
    """
    correction, age = s.correction_n, s.age + dt
    if velocity_jumps(s.v_n, v_n, dt):
        correction = sub(correction, sub(v_n, s.v_n))
    beyond = sub(sub(p_n, s.p_n), scale(0.5 * dt, add(s.v_n, v_n)))
    if norm(beyond) < POSITION_JUMP:
        error = sub(scale(1.0 / dt, beyond), correction)
        correction = add(correction, scale(dt / min(age, CORRECTION_TIME), error))
    limit = (VELOCITY_AGREES if s.is_doubted else VELOCITY_ERROR) * max(1.0, CORRECTION_TIME / age)
    return VelocityCheck(p_n, v_n, correction, age, norm(correction) > limit)


@compiled
def corrected_velocity(s: VelocityCheck, v_n: Vec3) -> Vec3:
    """A velocity over ground, NED [m/s], as it is flown on."""
    return add(v_n, s.correction_n) if s.is_doubted else v_n
