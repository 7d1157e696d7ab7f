"""Escape manoeuvres, their timing for an aircraft, and the trajectories that they fly."""

import math
from typing import NamedTuple

from vfguide.aircraft.point_mass import Dynamics, PointMass, advance
from vfguide.geometry.angles import FULL_TURN
from vfguide.geometry.units import G0
from vfguide.geometry.vector import Vec3, Vectors
from vfguide.kernels.compiled import compiled

TURN_TIME = 13.44
"""Time of a full turn at 25 m/s and 50 degrees of bank, to which all times of manoeuvres are scaled
[s]: 2 pi V / (g tan bank)."""
TURN_DURATIONS = (1.2, 2.2, 3.4, 5.0, 1e9)
"""Times for which an escape turns at the largest bank before it flies straight [s], chosen: from a
swerve to an endless turn."""
HORIZON = 15.2
"""Duration of a predicted trajectory at 25 m/s and 50 degrees of bank [s]; chosen longer than a
full turn."""
TRAJECTORY_STEP = 0.2
"""Time between two points of a predicted trajectory at 25 m/s and 50 degrees of bank [s]; chosen,
5 m of flight."""
MANOEUVRE_KINDS = 33
"""Number of escapes: straight, and five turns to either side, each level, climbing and
descending."""
STEADY = 5e-3
"""Sum of the errors of bank and path angle below which a manoeuvre is flown with both constant
[rad]; chosen."""


class Manoeuvre(NamedTuple):
    """A turn at the largest bank for some time, then straight, with one path angle throughout."""

    side: float
    """+1 right, -1 left, 0 straight."""
    turning: float
    """Time for which the turn lasts from now on [s]."""
    climb: float
    """+1 the steepest climb, -1 the steepest descent, 0 level."""


@compiled
def time_scale(limits: Dynamics, airspeed: float) -> float:
    """Ratio of the time of a full turn at `airspeed` [m/s] to TURN_TIME, dimensionless.

    The turn takes 2 pi V / (g tan bank_max).
    """
    return FULL_TURN * airspeed / (G0 * math.tan(limits.bank_max)) / TURN_TIME


@compiled
def manoeuvre(kind: int, scale: float) -> Manoeuvre:
    """Escape number `kind` of the MANOEUVRE_KINDS, its times multiplied by `scale`."""
    turn, climb = kind // 3, float(kind % 3)
    climb = -1.0 if climb == 2.0 else climb
    if turn == 0:
        return Manoeuvre(0.0, 0.0, climb)
    return Manoeuvre(1.0 if turn % 2 == 1 else -1.0, scale * TURN_DURATIONS[(turn - 1) // 2], climb)


@compiled
def bank_of(flown: Manoeuvre, limits: Dynamics) -> float:
    """The bank that a manoeuvre commands now [rad]."""
    return flown.side * limits.bank_max if flown.turning > 0.0 else 0.0


@compiled
def climb_of(flown: Manoeuvre, limits: Dynamics) -> float:
    """The path angle that a manoeuvre commands [rad]; air that sinks may forbid level flight."""
    asked = flown.climb * (limits.climb_max if flown.climb > 0.0 else limits.descent_max)
    return max(-limits.descent_max, min(limits.climb_max, asked))


@compiled
def remainder(flown: Manoeuvre, dt: float) -> Manoeuvre:
    """The rest of a manoeuvre after `dt` [s]."""
    return Manoeuvre(flown.side, max(0.0, flown.turning - dt), flown.climb)


@compiled
def fly_for(
    point_mass: PointMass, flown: Manoeuvre, wind_n: Vec3, limits: Dynamics, dt: float
) -> PointMass:
    """The point mass after `dt` [s] of a manoeuvre; a turn ends at its exact time."""
    climb = climb_of(flown, limits)
    if 0.0 < flown.turning < dt:
        point_mass = advance(
            point_mass, bank_of(flown, limits), climb, wind_n, limits, flown.turning
        )
        return advance(point_mass, 0.0, climb, wind_n, limits, dt - flown.turning)
    return advance(point_mass, bank_of(flown, limits), climb, wind_n, limits, dt)


@compiled
def fly_out(
    point_mass: PointMass,
    flown: Manoeuvre,
    wind_n: Vec3,
    limits: Dynamics,
    dt: float,
    trajectory: Vectors,
) -> None:
    """Write the positions (N, 3) of the manoeuvre, `dt` apart [s], into `trajectory`, NED [m]."""
    k, last = 0, len(trajectory) - 1
    while True:
        trajectory[k, 0], trajectory[k, 1], trajectory[k, 2] = point_mass.p_n
        if k == last:
            return
        bank = bank_of(flown, limits)
        settled = (
            abs(point_mass.bank - bank) + abs(point_mass.gamma - climb_of(flown, limits)) < STEADY
        )
        if settled:
            steps = last - k
            if flown.turning > 0.0:
                steps = int(min(float(steps), flown.turning / dt))
            there = PointMass(
                point_mass.p_n,
                point_mass.azimuth,
                bank,
                climb_of(flown, limits),
                point_mass.airspeed,
            )
            point_mass = fly_steadily(there, wind_n, dt, trajectory[k : k + steps + 1])
            flown, k = remainder(flown, steps * dt), k + steps
            if steps > 0:
                continue
        point_mass = fly_for(point_mass, flown, wind_n, limits, dt)
        flown, k = remainder(flown, dt), k + 1


@compiled
def fly_steadily(point_mass: PointMass, wind_n: Vec3, dt: float, trajectory: Vectors) -> PointMass:
    """As `fly_out` while bank and path angle are constant: each chord is turned by one angle."""
    turn = dt * G0 * math.tan(point_mass.bank) / point_mass.airspeed
    c, s = math.cos(turn), math.sin(turn)
    along, flat = (
        point_mass.azimuth + 0.5 * turn,
        dt * point_mass.airspeed * math.cos(point_mass.gamma),
    )
    u, v = flat * math.cos(along), flat * math.sin(along)
    down = dt * (wind_n[2] - point_mass.airspeed * math.sin(point_mass.gamma))
    x, y, z = point_mass.p_n
    steps = len(trajectory) - 1
    for k in range(1, steps + 1):
        x, y, z = x + u + dt * wind_n[0], y + v + dt * wind_n[1], z + down
        u, v = c * u - s * v, s * u + c * v
        trajectory[k, 0], trajectory[k, 1], trajectory[k, 2] = x, y, z
    azimuth = point_mass.azimuth + steps * turn
    return PointMass((x, y, z), azimuth, point_mass.bank, point_mass.gamma, point_mass.airspeed)
