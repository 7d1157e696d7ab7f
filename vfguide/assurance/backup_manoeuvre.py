"""Escape manoeuvres, their timing for an aircraft, and the trajectories that they fly."""

import math
from typing import NamedTuple

from vfguide.aircraft.point_mass import Dynamics, PointMass, advance
from vfguide.geometry.compiled import compiled
from vfguide.geometry.units import G0
from vfguide.geometry.vector import Vec3, Vectors

TURN_TIME = 13.44
"""Of a full turn at 25 m/s and 50 degrees of bank, for which the times below are made [s]."""
TURNS = (1.2, 2.2, 3.4, 5.0, 1e9)
"""How long a hard turn goes on before the aircraft flies straight [s]."""
HORIZON, STEP = 15.2, 0.2
"""Length and step of a trajectory [s]."""
KINDS = 33
"""Straight, and the turns to either side; each level, climbing and descending."""
STEADY = 5e-3
"""A bank or path angle this near to the commanded one is there [rad]."""


class Manoeuvre(NamedTuple):
    """A hard turn for some time, then straight; a path angle throughout."""

    side: float
    """+1 right, -1 left, 0 straight."""
    turning: float
    """How long the turn goes on [s]."""
    climb: float
    """+1 the steepest climb, -1 the steepest descent, 0 level."""


@compiled
def time_scale(limits: Dynamics, airspeed: float) -> float:
    """The aircraft's full turn over that for which the times here are made."""
    return 2.0 * math.pi * airspeed / (G0 * math.tan(limits.bank_max)) / TURN_TIME


@compiled
def manoeuvre(kind: int, scale: float) -> Manoeuvre:
    """One of the KINDS, its times scaled."""
    turn, climb = kind // 3, float(kind % 3)
    climb = -1.0 if climb == 2.0 else climb
    if turn == 0:
        return Manoeuvre(0.0, 0.0, climb)
    return Manoeuvre(1.0 if turn % 2 == 1 else -1.0, scale * TURNS[(turn - 1) // 2], climb)


@compiled
def bank_of(flown: Manoeuvre, limits: Dynamics) -> float:
    """The bank it asks for now [rad]."""
    return flown.side * limits.bank_max if flown.turning > 0.0 else 0.0


@compiled
def climb_of(flown: Manoeuvre, limits: Dynamics) -> float:
    """The path angle it asks for [rad]; level where the air lets it."""
    asked = flown.climb * (limits.climb_max if flown.climb > 0.0 else limits.descent_max)
    return max(-limits.descent_max, min(limits.climb_max, asked))


@compiled
def remainder(flown: Manoeuvre, dt: float) -> Manoeuvre:
    """What is left of it `dt` later [s]."""
    return Manoeuvre(flown.side, max(0.0, flown.turning - dt), flown.climb)


@compiled
def fly_for(
    point_mass: PointMass, flown: Manoeuvre, wind_n: Vec3, limits: Dynamics, dt: float
) -> PointMass:
    """The motion `dt` later [s], the end of the turn to the instant."""
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
    """The same while neither bank nor path angle changes: every chord turned by one angle."""
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
