"""The decision of the run-time assurance: follow the command, or fly an escape.

The command is held for one period in the point-mass model. If one of the escapes, or the rest of
the one stored before, stays clear from there, the command is sent and that escape is stored. Else
the escape nearest to the command that stays clear from now on is flown; if there is none, the one
with the shallowest conflict.

The states are those of ASTM F3269. The decision follows the Simplex architecture: a small verified
function stands behind one that is not (L. Sha, Using Simplicity to Control Complexity, 2001).
"""

import math
from enum import IntEnum
from typing import NamedTuple

import numpy as np

from vfguide.aircraft.performance import Gains, Performance
from vfguide.aircraft.point_mass import Dynamics, PointMass, advance, dynamics
from vfguide.airspace.hazards import Hazards
from vfguide.assurance.backup_manoeuvre import Manoeuvre, bank_of, climb_of, remainder, time_scale
from vfguide.assurance.escape_search import Found, best_from, find_escape
from vfguide.assurance.manoeuvre_clearance import TRAJECTORY_POINTS, World, follow, time_to_conflict
from vfguide.assurance.trajectory_clearance import Clearance
from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled

MARGIN = 12.0
"""Clearance that a safe trajectory keeps at 25 m/s and 50 degrees of bank [m]; chosen with
`tools/measure_assurance.py`."""
MARGIN_AIRSPEED = 25.0
"""Airspeed at which MARGIN is kept [m/s]; chosen, the one to which TURN_TIME belongs. A slower
aircraft keeps less, in proportion."""
LEAST_MARGIN = 6.0
"""Least clearance that a safe trajectory keeps, for smaller aircraft [m]; chosen."""
RETURN_MARGIN = 3.0
"""Clearance beyond the margin that must be kept before the command is followed again [m]; chosen as
hysteresis."""
LEEWAY = 1.0 / 6.0
"""Share of the margin that an escape may lose to gusts and errors of the model while it is flown;
tuned with `tools/measure_assurance.py`: without it, 2 % of the steps among static obstacles found
nothing clear, with it 0.3 %."""
HOLD = 0.1
"""Least time for which the command is held in the prediction, at 25 m/s and 50 degrees of bank [s];
chosen."""
GUST_UNCERTAINTY = 0.3
"""Ratio of the growth of the uncertainty of the own position to the standard deviation of gusts;
chosen."""


class Reason(IntEnum):
    """The state of the run-time assurance, in the words of ASTM F3269."""

    NOMINAL = 0
    """The command of guidance is flown."""
    RECOVERY = 1
    """The command would leave no escape: an escape is flown now."""
    BEST_EFFORT = 2
    """Nothing stays clear: the escape with the shallowest conflict is flown."""


class Assurance(NamedTuple):
    """Parameters of the assurance that depend on the aircraft alone."""

    limits: Dynamics
    """Limits and lags of its motion."""
    scale: float
    """Factor of all times: that of `time_scale`."""
    margin: float
    """Clearance that a safe trajectory keeps [m]."""


class BackupManoeuvre(NamedTuple):
    """The stored escape, and whether it is being flown."""

    side: float
    """Side of its turn, see `Manoeuvre`."""
    turning: float
    """Time for which its turn lasts [s]."""
    climb: float
    """Sign of its path angle, see `Manoeuvre`."""
    acting: float
    """1 while it is flown instead of the command, else 0."""


class Decision(NamedTuple):
    """What to fly until the next decision."""

    bank: float
    """Bank [rad], right wing down positive."""
    gamma: float
    """Path angle [rad], up positive: its sine is the vertical speed over ground, over airspeed."""
    reason: int
    """A `Reason`."""
    margin: float
    """Least clearance along the escape, at most the margin asked for [m]."""
    conflict: float
    """While an escape is flown: time until the held command would come within 1 m of a hazard [s];
    infinite if never."""
    hazard: int
    """While an escape is flown: number of that hazard; -1 for none."""


@compiled
def assurance(aircraft: Performance, gains: Gains) -> Assurance:
    """Parameters of the assurance for an aircraft and its gains."""
    limits = dynamics(aircraft, gains)
    scale = time_scale(limits, gains.airspeed)
    margin = max(LEAST_MARGIN, MARGIN * min(scale, gains.airspeed / MARGIN_AIRSPEED))
    return Assurance(limits, scale, margin)


@compiled
def no_backup() -> BackupManoeuvre:
    """The stored escape before the first decision: straight on, not flown."""
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
    parameters: Assurance,
    backup: BackupManoeuvre,
) -> tuple[Decision, BackupManoeuvre]:
    """Decide what to fly until the next decision.

    Args:
        point_mass: the aircraft now, NED.
        command: bank and path angle that guidance commands [rad].
        wind_n: wind, NED, blowing toward [m/s]; a component that is not finite counts as 0.
        gust: speed of the gusts, one standard deviation [m/s].
        hazards: the known hazards.
        t: present time on the clock of the obstacles [s].
        dt: time since the last decision [s].
        parameters: parameters of `assurance`.
        backup: the escape that the last decision stored.
    """
    limits, command = parameters.limits, flyable(command, parameters.limits)
    if not is_finite(point_mass):
        return Decision(command[0], command[1], Reason.BEST_EFFORT.value, 0.0, 0.0, -1), backup
    wind_n = (finite(wind_n[0]), finite(wind_n[1]), finite(wind_n[2]))
    uncertainty_rate, trajectory = (
        GUST_UNCERTAINTY * max(finite(gust), 0.0),
        np.empty((TRAJECTORY_POINTS, 3)),
    )
    world = World(hazards, wind_n, uncertainty_rate, limits, parameters.scale, trajectory)
    plan = Manoeuvre(backup.side, backup.turning, backup.climb)
    if backup.acting > 0.0:
        plan = remainder(plan, dt)
    margin = parameters.margin

    acting = backup.acting > 0.0
    seen = Clearance(0.0, 0.0, 0)
    if acting:
        kept = margin * (1.0 - LEEWAY)
        seen = follow(world, point_mass, plan, t, (kept, kept), 0)
    if not acting or seen.hazard < 0:
        hold = max(dt, HOLD * parameters.scale)
        after = advance(point_mass, command[0], command[1], wind_n, limits, hold)
        need = margin + RETURN_MARGIN * backup.acting
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
    """The command within the limits [rad]; a value that is not finite becomes 0."""
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
    """Whether all of the point mass is finite, so that its motion can be predicted."""
    x, y, z = point_mass.p_n
    angles = point_mass.azimuth + point_mass.bank + point_mass.gamma
    return math.isfinite(x + y + z + angles) and 0.0 < point_mass.airspeed < math.inf
