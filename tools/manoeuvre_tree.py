"""Whether an escape existed: every sequence of hard manoeuvres, by branch and bound.

Nine actions (bank hard left, none, hard right; climb, level, descend), four of them in sequence,
each for 2 s by default. The collision check is the exact distance at every
0.05 s.
"""

import math

import numpy as np
from avoidance_flights import true_distance
from avoidance_worlds import TICK, World

from vfguide.aircraft.point_mass import Dynamics, PointMass, advance
from vfguide.field.obstacle import Rows
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import reader, width, writer

read_motion, write_motion = reader(PointMass), writer(PointMass)
MOTION_NUMBERS = width(PointMass)
ACTIONS, LEVELS, HOLD = 9, 4, 2.0


@compiled
def act(
    world: World,
    rows: Rows,
    motion: PointMass,
    t: float,
    action: int,
    limits: Dynamics,
    bound: float,
    hold: float,
) -> tuple[PointMass, float]:
    """The point mass after one action, and the least distance on the path [m].

    It ends early where that is below `bound` [m].
    """
    bank = limits.bank_max * (action % 3 - 1)
    gamma = limits.climb_max if action // 3 == 1 else 0.0
    gamma = -limits.descent_max if action // 3 == 2 else gamma
    least = math.inf
    for k in range(round(hold / TICK)):
        motion = advance(motion, bank, gamma, world.wind_n, limits, TICK)
        distance, _ = true_distance(world, rows, motion.p_n, t + (k + 1) * TICK)
        least = min(least, distance)
        if least <= bound:
            break
    return motion, least


@compiled
def best_escape(
    world: World,
    rows: Rows,
    motion: PointMass,
    t: float,
    limits: Dynamics,
    enough: float,
    levels: int = LEVELS,
    hold: float = HOLD,
) -> float:
    """The largest of the least distances of all sequences [m]; the search ends at `enough`.

    `rows` are all obstacles, known or not, as they move at time `t` [s]. A sequence has `levels`
    actions, each for `hold` [s].
    """
    best, _ = true_distance(world, rows, motion.p_n, t)
    if best <= 0.0:
        return best
    ceiling, best = min(best, enough), -math.inf
    motions = np.zeros((levels + 1, MOTION_NUMBERS))
    least = np.full(levels + 1, ceiling)
    action = np.full(levels + 1, -1)
    level = 0
    write_motion(motion, motions[level])
    while level >= 0 and best < ceiling:
        action[level] += 1
        if action[level] == ACTIONS:
            action[level], level = -1, level - 1
            continue
        before = read_motion(motions[level])
        start = t + level * hold
        after, found = act(world, rows, before, start, action[level], limits, best, hold)
        found = min(found, least[level])
        if found <= best:
            continue
        if level == levels - 1:
            best = found
            continue
        level += 1
        least[level] = found
        write_motion(after, motions[level])
    return best
