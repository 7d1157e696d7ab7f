"""Escape search: the manoeuvre that stays clear, or the one with the shallowest conflict."""

import math
from typing import NamedTuple

import numpy as np

from vfguide.aircraft.point_mass import PointMass
from vfguide.assurance.backup_manoeuvre import (
    MANOEUVRE_KINDS,
    Manoeuvre,
    bank_of,
    climb_of,
    manoeuvre,
)
from vfguide.assurance.manoeuvre_clearance import CONTACT, Command, World, clear, follow
from vfguide.assurance.trajectory_clearance import Clearance
from vfguide.geometry.vector import Series
from vfguide.kernels.compiled import compiled

BACKUP_ADVANTAGE = 1.0
"""Merit by which another escape must be better than the stored one [m]; chosen as hysteresis."""
NO_CONTACT = 1e6
"""Merit that is added to that of an escape without contact [m]; chosen above every clearance."""
SETTLED_POINT = 15
"""Index of the trajectory point from which on escapes without contact are compared, 3 s ahead;
chosen so that, where all are too near now, the one that moves away is taken."""
TURN_TIME_WEIGHT = 0.01
"""Distance from the command that each second of an escape's turn counts [1/s]; chosen small, so
that it decides only between equal manoeuvres."""
COUNTED_TURN_TIME = 10.0
"""Time beyond which a longer turn of an escape counts no more [s]; chosen, since the endless turn
has no time."""


class Found(NamedTuple):
    """A manoeuvre and the clearance along it."""

    plan: Manoeuvre
    """The manoeuvre."""
    seen: Clearance
    """Clearance along it."""


@compiled
def find_escape(
    world: World,
    point_mass: PointMass,
    t: float,
    command: Command,
    backup: Manoeuvre,
    margin: float,
    level_only: bool,
) -> Found:
    """A manoeuvre that stays clear from `point_mass` on: the backup, or the nearest to the command.

    Where one is found, `seen.hazard` is -1; else the backup is returned.

    Args:
        world: hazards, wind and limits.
        point_mass: the aircraft at time `t`.
        t: time on the clock of the obstacles [s].
        command: bank and path angle of guidance [rad].
        backup: the stored escape, from `t` on.
        margin: clearance to keep [m].
        level_only: whether climbs and descents are not tried.
    """
    seen = follow(world, point_mass, backup, t, (margin, margin), 0)
    if seen.hazard < 0 or seen.lost == 0.0:
        return Found(backup, seen)
    suspect = seen.hazard
    for kind in np.argsort(distances_from_command(world, command)):
        plan = manoeuvre(kind, world.scale)
        if level_only and plan.climb != 0.0:
            continue
        other = follow(world, point_mass, plan, t, (margin, margin), suspect)
        if other.hazard < 0:
            return Found(plan, other)
        suspect = other.hazard
    return Found(backup, seen)


@compiled
def distances_from_command(world: World, command: Command) -> Series:
    """Distance of each manoeuvre's command from `command`, dimensionless, (MANOEUVRE_KINDS,).

    Of equal ones the shorter turn is nearer.
    """
    far = np.empty(MANOEUVRE_KINDS)
    limits = world.limits
    climbs = max(limits.climb_max + limits.descent_max, 1e-3)  # the wind may leave none
    for kind in range(MANOEUVRE_KINDS):
        plan = manoeuvre(kind, 1.0)
        bank = abs(bank_of(plan, limits) - command[0]) / limits.bank_max
        climb = abs(climb_of(plan, limits) - command[1]) / climbs
        far[kind] = bank + climb + TURN_TIME_WEIGHT * min(plan.turning, COUNTED_TURN_TIME)
    return far


@compiled
def best_from(
    world: World,
    point_mass: PointMass,
    t: float,
    command: Command,
    backup: Manoeuvre,
    margin: float,
) -> Found:
    """The clear manoeuvre nearest to the command, or the one with the most merit.

    That is the one with the shallowest conflict, or, of several without contact, the one that moves
    away. The backup is kept unless another is better by BACKUP_ADVANTAGE.

    Args:
        world: hazards, wind and limits.
        point_mass: the aircraft at time `t`.
        t: time on the clock of the obstacles [s].
        command: bank and path angle of guidance [rad].
        backup: the stored escape, from `t` on.
        margin: clearance to keep [m].
    """
    seen, merit = judged(world, point_mass, t, backup, margin, -math.inf, 0)
    best, merit = Found(backup, seen), merit + BACKUP_ADVANTAGE
    for kind in np.argsort(distances_from_command(world, command)):
        plan = manoeuvre(kind, world.scale)
        seen, other = judged(world, point_mass, t, plan, margin, merit, max(best.seen.hazard, 0))
        if seen.hazard < 0:
            return Found(plan, seen)
        if other > merit:
            best, merit = Found(plan, seen), other
    return best


@compiled
def judged(
    world: World,
    point_mass: PointMass,
    t: float,
    plan: Manoeuvre,
    margin: float,
    beat: float,
    suspect: int,
) -> tuple[Clearance, float]:
    """Clearance along a manoeuvre, and its merit: the least clearance [m], more without contact.

    Args:
        world: hazards, wind and limits.
        point_mass: the aircraft at time `t`.
        t: time on the clock of the obstacles [s].
        plan: the manoeuvre.
        margin: clearance to keep [m].
        beat: merit to exceed [m]; as soon as that is impossible, the merit is minus infinity.
        suspect: number of the hazard to look at first.
    """
    if beat == math.inf:
        seen = follow(world, point_mass, plan, t, (margin, margin), suspect)
        return seen, -math.inf
    seen = follow(world, point_mass, plan, t, (CONTACT, CONTACT), suspect)
    if seen.hazard >= 0:
        if beat >= CONTACT + BACKUP_ADVANTAGE:
            return seen, -math.inf
        deepest = clear(world, point_mass, t, 0, (CONTACT, beat), seen.hazard)
        merit = deepest.least if deepest.lost == math.inf else -math.inf
        return Clearance(deepest.least, seen.lost, deepest.hazard), merit
    seen = clear(world, point_mass, t, 0, (margin, CONTACT), suspect)
    if seen.hazard < 0:
        return seen, math.inf
    away = clear(world, point_mass, t, SETTLED_POINT, (margin, CONTACT), seen.hazard)
    return seen, NO_CONTACT + seen.least + away.least
