"""F_OA for an aircraft: the avoidance field on velocities relative to what it has to keep clear of.

The paper's F_OA = (prod chi_i) F + sum (1 - chi_i) tau_b_i leaves the speed free and looks at the
place of an obstacle alone. Here F is the wanted velocity over ground of an aircraft whose airspeed
V is given, g = |g| F / |F|, and

    u_i  = g - v_i                              relative to barrier i
    g_i  = v_i + lambda tau_i,  |g_i - w| = V   tau_i = (n_i x u_i) x n_i, the unit tangent
    F_OA = (prod chi_i) g + sum (1 - chi_i) g_i

with the velocity v_i of the barrier and the wind w. For one barrier that stands, in still air, it
is the direction of the paper's F_OA with unit normal and unit tangent. Barriers that are not
approached, u_i . n_i >= 0, do nothing.
"""

import math
from typing import NamedTuple

from vfguide.geometry.vector import Vec3, add, cross, dot, norm, scale, sub, unit
from vfguide.geometry.velocity import horizontal_norm
from vfguide.kernels.compiled import compiled

COLLINEAR_SINE = 0.17
"""Sine of the angle between n and the relative velocity below which the side to pass is that of the
step before, a number; chosen, 10 degrees, above the noise of a measured velocity."""
LEAST_SINE = 1e-9
"""Sine of an angle below which two directions count as one, a number; chosen well above
rounding."""
RETURN_RATE = 0.3
"""Rate at which a clearance that has become negative is taken back [1/s]; chosen."""


class MovingBarrier(NamedTuple):
    """Something to keep clear of, near the aircraft."""

    chi: float
    """Transition: 0 where the field is tangential, 1 where the barrier has no effect."""
    n: Vec3
    """Outward unit normal, NED."""
    v_n: Vec3
    """Its velocity, NED [m/s]."""
    clearance: float
    """Distance beyond the margin [m]; negative inside it."""


class FlownField(NamedTuple):
    """The composite of the barriers so far."""

    chi: float
    """Product of all chi_i."""
    tangents: Vec3
    """Sum of (1 - chi_i) g_i [m/s]."""


class AircraftMotion(NamedTuple):
    """How the aircraft moves, and what the field may ask of it."""

    v_n: Vec3
    """Velocity over ground, NED [m/s]."""
    wind_n: Vec3
    """Wind, blowing toward, NED [m/s]."""
    airspeed: float
    """True airspeed to fly [m/s]."""
    keeps_side: bool
    """Whether what is dead ahead is passed on the side to which the aircraft moves already."""
    has_airspeed: bool
    """Whether each term of the sum has the airspeed; else a tangent is as long as it is."""


@compiled
def no_barriers() -> FlownField:
    """The composite in free space."""
    return FlownField(1.0, (0.0, 0.0, 0.0))


@compiled
def past_barrier(
    by: FlownField, g: Vec3, barrier: MovingBarrier, motion: AircraftMotion
) -> FlownField:
    """The composite with one more barrier.

    Args:
        by: the composite so far.
        g: wanted velocity over ground, NED [m/s].
        barrier: the barrier.
        motion: of the aircraft.
    """
    chi, n, v_n, clearance = barrier
    u = sub(g, v_n)
    if dot(u, n) >= 0.0 or chi >= 1.0:
        return by
    moving = cross(n, sub(motion.v_n, v_n))[2] if motion.keeps_side else 0.0
    tangent = side_tangent(u, n, moving)
    outward = scale(max(0.0, -RETURN_RATE * clearance), n)
    past = add(v_n, outward)
    if motion.has_airspeed:
        along = speed_along(sub(past, motion.wind_n), tangent, motion.airspeed)
    else:
        along = dot(u, tangent)
    g_i = add(past, scale(along, tangent))
    return FlownField(by.chi * chi, add(by.tangents, scale(1.0 - chi, g_i)))


@compiled
def speed_along(base: Vec3, tangent: Vec3, airspeed: float) -> float:
    """The larger root of |base + speed tangent| = airspeed [m/s]; the nearest where there is none.

    Args:
        base: velocity through the air without it, NED [m/s].
        tangent: unit vector, NED.
        airspeed: true airspeed [m/s].
    """
    b = dot(base, tangent)
    return -b + math.sqrt(max(0.0, b * b - dot(base, base) + airspeed * airspeed))


@compiled
def side_tangent(u: Vec3, n: Vec3, moving: float) -> Vec3:
    """Unit tangent of a barrier along a relative velocity.

    Straight ahead the print has no direction but G, which is zero on the axis of the goal. There
    the level tangent is taken, to the side to which the aircraft moves, or else so that the
    barrier is to the right.

    Args:
        u: wanted velocity relative to the barrier, NED [m/s].
        n: outward unit normal, NED.
        moving: side to which the aircraft moves, as n x velocity downward; 0 for neither.
    """
    tangent = sub(u, scale(dot(u, n), n))
    size, wanted = norm(tangent), cross(n, tangent)[2]
    sine = size / norm(u)
    if sine > COLLINEAR_SINE or (sine > LEAST_SINE and wanted * moving >= 0.0):
        tangent = scale(1.0 / size, tangent)
        return unit(sub(tangent, scale(dot(tangent, n), n)))
    if horizontal_norm(n) <= LEAST_SINE:
        return 1.0, 0.0, 0.0
    return scale(math.copysign(1.0, moving), unit((-n[1], n[0], 0.0)))


@compiled
def flown_field(by: FlownField, g: Vec3) -> Vec3:
    """F_OA as a velocity over ground, NED [m/s]; its length has no meaning."""
    return add(scale(by.chi, g), by.tangents)
