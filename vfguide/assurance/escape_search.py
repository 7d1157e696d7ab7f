"""The search for a way out: which manoeuvre stays clear, or the least bad one."""

import math
from typing import NamedTuple

import numpy as np

from vfguide.aircraft.point_mass import Dynamics, Motion, advance
from vfguide.airspace.hazards import Hazards
from vfguide.assurance.backup_manoeuvre import (
    HORIZON,
    KINDS,
    STEP,
    Manoeuvre,
    bank_of,
    climb_of,
    fly_out,
    manoeuvre,
)
from vfguide.assurance.trajectory_clearance import Clearance, clearance_along
from vfguide.field.obstacle import Rows
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3, norm

LENGTH = round(HORIZON / STEP) + 1
"""Points of a track."""
CONTACT = 1.0
"""Nearer than this a hazard is hit [m]."""
KEPT, NO_CONTACT = 1.0, 1e6
"""What the stored manoeuvre, and any without contact, has ahead of others [m]."""
AFTER = 15
"""The least bad of several manoeuvres without contact is judged from this point on: where it
is too near already, the one that gets away."""


Command = tuple[float, float]
"""Bank and path angle [rad]."""
Limits = tuple[float, float]
"""A clearance that is enough, and one that is too little [m]."""


class World(NamedTuple):
    """Everything but the motion that a search needs."""

    hazards: Hazards
    wind_n: Vec3
    """NED, blowing toward [m/s]."""
    growth: float
    """Of the doubt about the own position [m/s]."""
    limits: Dynamics
    scale: float
    """Of all times of manoeuvres."""
    track: Rows
    """Room for one track (LENGTH, 3)."""


class Found(NamedTuple):
    """A manoeuvre, and how clear it stays."""

    plan: Manoeuvre
    seen: Clearance


@compiled
def follow(
    world: World,
    motion: Motion,
    plan: Manoeuvre,
    t: float,
    least: tuple[float, float],
    suspect: int,
) -> Clearance:
    """Clearance along the manoeuvre from `motion` at time `t`: `least` is (enough, too little)."""
    dt = STEP * world.scale
    fly_out(motion, plan, world.wind_n, world.limits, dt, world.track)
    return clear(world, motion, t, 0, least, suspect)


@compiled
def clear(
    world: World, motion: Motion, t: float, first: int, least: Limits, suspect: int
) -> Clearance:
    """Clearance along the track as it was flown last, from point `first` on."""
    dt, speed = STEP * world.scale, motion.airspeed + norm(world.wind_n)
    track, t = world.track[first:], t + first * dt
    return clearance_along(
        world.hazards, track, t, dt, speed, world.growth, least[0], least[1], suspect
    )


@compiled
def way_out(
    world: World,
    motion: Motion,
    t: float,
    wish: Command,
    stored: Manoeuvre,
    margin: float,
    level: bool,
) -> Found:
    """A manoeuvre that stays clear from `motion` on, the stored one or the nearest to the wish.

    What is found has `seen.hazard` -1; if nothing is, it is the stored one. With `level` climbs
    and descents are not tried.
    """
    seen = follow(world, motion, stored, t, (margin, margin), 0)
    if seen.hazard < 0 or seen.lost == 0.0:
        return Found(stored, seen)
    suspect = seen.hazard
    for kind in np.argsort(distances_from_wish(world, wish)):
        plan = manoeuvre(kind, world.scale)
        if level and plan.climb != 0.0:
            continue
        other = follow(world, motion, plan, t, (margin, margin), suspect)
        if other.hazard < 0:
            return Found(plan, other)
        suspect = other.hazard
    return Found(stored, seen)


@compiled
def distances_from_wish(world: World, wish: Command) -> Rows:
    """How far each manoeuvre's first command is from the wish, shorter turns first: (KINDS,)."""
    far = np.empty(KINDS)
    limits = world.limits
    climbs = max(limits.climb_max + limits.descent_max, 1e-3)  # the air may leave none
    for kind in range(KINDS):
        plan = manoeuvre(kind, 1.0)
        bank = abs(bank_of(plan, limits) - wish[0]) / limits.bank_max
        climb = abs(climb_of(plan, limits) - wish[1]) / climbs
        far[kind] = bank + climb + 0.01 * min(plan.turning, 10.0)
    return far


@compiled
def best_from(
    world: World, motion: Motion, t: float, wish: Command, stored: Manoeuvre, margin: float
) -> Found:
    """The clear manoeuvre nearest to the wish, or the least bad one.

    That goes least deep; of several without contact it is the one that gets away. The stored one
    is kept unless another is better by a metre.
    """
    seen, merit = judged(world, motion, t, stored, margin, -math.inf, 0)
    best, merit = Found(stored, seen), merit + KEPT
    for kind in np.argsort(distances_from_wish(world, wish)):
        plan = manoeuvre(kind, world.scale)
        seen, other = judged(world, motion, t, plan, margin, merit, max(best.seen.hazard, 0))
        if seen.hazard < 0:
            return Found(plan, seen)
        if other > merit:
            best, merit = Found(plan, seen), other
    return best


@compiled
def judged(
    world: World,
    motion: Motion,
    t: float,
    plan: Manoeuvre,
    margin: float,
    beat: float,
    suspect: int,
) -> tuple[Clearance, float]:
    """Clearance along a manoeuvre, and its merit: the least clearance [m], more without contact.

    The merit of one that is found not to reach `beat` is minus infinity.
    """
    if beat == math.inf:
        seen = follow(world, motion, plan, t, (margin, margin), suspect)
        return seen, -math.inf
    seen = follow(world, motion, plan, t, (CONTACT, CONTACT), suspect)
    if seen.hazard >= 0:
        if beat >= CONTACT + KEPT:
            return seen, -math.inf
        deepest = clear(world, motion, t, 0, (CONTACT, beat), seen.hazard)
        merit = deepest.least if deepest.lost == math.inf else -math.inf
        return Clearance(deepest.least, seen.lost, deepest.hazard), merit
    seen = clear(world, motion, t, 0, (margin, CONTACT), suspect)
    if seen.hazard < 0:
        return seen, math.inf
    away = clear(world, motion, t, AFTER, (margin, CONTACT), seen.hazard)
    return seen, NO_CONTACT + seen.least + away.least


@compiled
def time_to_conflict(world: World, motion: Motion, t: float, wish: Command) -> Clearance:
    """Clearance if the wish were held: when contact is made, and with what."""
    dt = STEP * world.scale
    for k in range(LENGTH):
        world.track[k, 0], world.track[k, 1], world.track[k, 2] = motion.p_n
        motion = advance(motion, wish[0], wish[1], world.wind_n, world.limits, dt)
    return clear(world, motion, t, 0, (2.0 * CONTACT, CONTACT), 0)
