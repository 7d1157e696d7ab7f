"""Run-time assurance: what the guidance wishes is flown only if a way out remains afterwards.

The command is held for one period in the model of the motion. If one of the escape manoeuvres, or
what is left of the one stored before, stays clear from there, the command is sent and that
manoeuvre is stored. Else a manoeuvre that stays clear from now on is flown, the nearest to the
command; if there is none, the one that goes least deep.
"""

import math
from enum import IntEnum
from typing import NamedTuple

import numpy as np

from vfguide.aircraft.performance import Gains, Performance
from vfguide.aircraft.point_mass import Dynamics, PointMass, advance, dynamics
from vfguide.airspace.hazards import Hazards
from vfguide.assurance.backup_manoeuvre import Manoeuvre, bank_of, climb_of, remainder, time_scale
from vfguide.assurance.escape_search import (
    LENGTH,
    Found,
    World,
    best_from,
    find_escape,
    follow,
    time_to_conflict,
)
from vfguide.assurance.trajectory_clearance import Clearance
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3

MARGIN = 12.0
"""Distance that a clear trajectory keeps, at 25 m/s and 50 degrees of bank [m] ..."""
LEAST_MARGIN = 6.0
"""... less for smaller aircraft, but not less than this [m]."""
RETURN = 3.0
"""More than the margin that must be kept for the command to be followed again [m]."""
LEEWAY = 1.0 / 6.0
"""Part of the margin that a manoeuvre may lose while it is flown, to gusts and errors of the
model, before another is looked for."""
HOLD = 0.1
"""The command is held for at least this part of the scaled time [s]."""
GUST_UNCERTAINTY = 0.3
"""Growth of the doubt about the own position over the gusts' speed."""


class Reason(IntEnum):
    """The state of the run-time assurance, in the words of ASTM F3269."""

    NOMINAL = 0
    """The command of guidance is flown."""
    RECOVERY = 1
    """The command would leave no way out: an escape is flown now."""
    BEST_EFFORT = 2
    """Nothing stays clear: the manoeuvre that goes least deep is flown."""


class Assurance(NamedTuple):
    """What depends on the aircraft alone."""

    limits: Dynamics
    scale: float
    """Of all times: the aircraft's full turn over that at 25 m/s and 50 degrees."""
    margin: float
    """[m]"""


class BackupManoeuvre(NamedTuple):
    """What one decision leaves for the next: the way out, and whether it is being flown."""

    side: float
    turning: float
    climb: float
    """Fields of a `Manoeuvre`."""
    acting: float
    """1 while the command is not followed, else 0."""


class Decision(NamedTuple):
    """What to fly."""

    bank: float
    gamma: float
    """Bank, and path angle where the air neither sinks nor rises [rad]."""
    reason: int
    """A `Reason`."""
    margin: float
    """Least clearance along the way out, not above what was asked for [m]."""
    conflict: float
    """While acting: time until the command, held on, would come within 1 m [s]; infinite if
    never."""
    hazard: int
    """While acting: the hazard that it would come to; -1 for none."""


@compiled
def assurance(aircraft: Performance, gains: Gains) -> Assurance:
    """That of an aircraft, computed once."""
    limits = dynamics(aircraft, gains)
    scale = time_scale(limits, gains.airspeed)
    margin = max(LEAST_MARGIN, MARGIN * min(scale, gains.airspeed / 25.0))
    return Assurance(limits, scale, margin)


@compiled
def no_backup() -> BackupManoeuvre:
    """Before the first decision: straight on."""
    return BackupManoeuvre(0.0, 0.0, 0.0, 0.0)


@compiled
def assure(
    point_mass: PointMass,
    command: tuple[float, float],
    wind_n: Vec3,
    gust: float,
    hazards: Hazards,
    t: float,
    dt: float,
    aircraft: Assurance,
    backup: BackupManoeuvre,
) -> tuple[Decision, BackupManoeuvre]:
    """Decide what to fly until the next decision.

    Args:
        point_mass: the aircraft now, NED.
        command: bank and path angle that the guidance asks for [rad].
        wind_n: NED, blowing toward [m/s]; without a number it counts as none.
        gust: speed of the gusts, one standard deviation [m/s].
        hazards: all that are known.
        t: now, on the clock of the obstacles [s].
        dt: since the last decision [s].
        aircraft: of `assurance`.
        backup: what the last decision left.
    """
    limits, command = aircraft.limits, flyable(command, aircraft.limits)
    if not is_finite(point_mass):
        return Decision(command[0], command[1], Reason.BEST_EFFORT.value, 0.0, 0.0, -1), backup
    wind_n = (finite(wind_n[0]), finite(wind_n[1]), finite(wind_n[2]))
    uncertainty_rate, trajectory = GUST_UNCERTAINTY * max(finite(gust), 0.0), np.empty((LENGTH, 3))
    world = World(hazards, wind_n, uncertainty_rate, limits, aircraft.scale, trajectory)
    plan = Manoeuvre(backup.side, backup.turning, backup.climb)
    if backup.acting > 0.0:
        plan = remainder(plan, dt)
    margin = aircraft.margin

    acting = backup.acting > 0.0
    seen = Clearance(0.0, 0.0, 0)
    if acting:
        kept = margin * (1.0 - LEEWAY)
        seen = follow(world, point_mass, plan, t, (kept, kept), 0)
    if not acting or seen.hazard < 0:
        hold = max(dt, HOLD * aircraft.scale)
        after = advance(point_mass, command[0], command[1], wind_n, limits, hold)
        need = margin + RETURN * backup.acting
        out = find_escape(world, after, t + hold, command, plan, need, acting)
        if out.seen.hazard < 0:
            decision = Decision(
                command[0], command[1], Reason.NOMINAL.value, out.seen.least, math.inf, -1
            )
            return decision, BackupManoeuvre(out.plan.side, out.plan.turning, out.plan.climb, 0.0)
    out = Found(plan, seen)
    if seen.hazard >= 0:
        out = best_from(world, point_mass, t, command, plan, margin)
    reason = Reason.RECOVERY.value if out.seen.hazard < 0 else Reason.BEST_EFFORT.value
    conflict = time_to_conflict(world, point_mass, t, command)
    bank, gamma = bank_of(out.plan, limits), climb_of(out.plan, limits)
    decision = Decision(bank, gamma, reason, out.seen.least, conflict.lost, conflict.hazard)
    return decision, BackupManoeuvre(out.plan.side, out.plan.turning, out.plan.climb, 1.0)


@compiled
def flyable(command: tuple[float, float], limits: Dynamics) -> tuple[float, float]:
    """The command within the limits; what is not a number becomes level flight."""
    bank, gamma = finite(command[0]), finite(command[1])
    return (
        max(-limits.bank_max, min(limits.bank_max, bank)),
        max(-limits.descent_max, min(limits.climb_max, gamma)),
    )


@compiled
def finite(value: float) -> float:
    """The value, zero if it is not a finite number."""
    return value if math.isfinite(value) else 0.0


@compiled
def is_finite(point_mass: PointMass) -> bool:
    """Whether the motion can be predicted."""
    x, y, z = point_mass.p_n
    angles = point_mass.azimuth + point_mass.bank + point_mass.gamma
    return math.isfinite(x + y + z + angles) and 0.0 < point_mass.airspeed < math.inf
