"""A flyable way round hazards, with as much clearance as there is room for."""

from typing import NamedTuple

import numpy as np

from vfguide.airspace.footprint import Band
from vfguide.airspace.keep_out import Outlines, hazards_of, joined
from vfguide.field.obstacle import Rows
from vfguide.geometry.compiled import compiled
from vfguide.paths.dubins import length_of
from vfguide.paths.edge import HOP_COLUMNS, Hops, next_word, way_length
from vfguide.planning.collision_check import Task, demand_of
from vfguide.planning.graph_search import search
from vfguide.planning.shortcutting import shortened

CLEARANCES = (25.0, 18.0, 12.0, 8.0, 5.0)
"""That are tried one after the other [m]."""
EFFORTS = (3500, 1500, 2500, 2500, 1000)
"""Words computed for each of them, at most; see `search`."""
LONG, GATE, WORTH = 1.4, 2, 0.75
"""A way longer than the one without hazards by the first factor is looked for with less clearance,
that of the second number, too, and left where that makes it shorter by the third factor."""


class Detour(NamedTuple):
    """A way from the start to the goal."""

    hops: Hops
    """Up to `roadmap.MOST_HOPS`, NED, a `Hop` a row; none where no way was found."""
    length: float
    """[m]; 0 where there is none."""
    clearance: float
    """That it keeps from every hazard [m]; less within a radius of the ends if it is less there."""
    effort: int
    """That was spent, see `search`."""


@compiled
def find_detour(obstacles: Rows, fence: Outlines, band: Band, task: Task) -> Detour:
    """The way round obstacles and within a fence.

    Args:
        obstacles: rows of `obstacle_rows`.
        fence: as far as it is in the band; `outlines.NO_FENCE` for none.
        band: heights between those of the start and of the goal.
        task: what is to be flown.
    """
    spent = 0
    for i in range(len(CLEARANCES)):
        detour = detour_with(obstacles, fence, band, task, CLEARANCES[i], EFFORTS[i])
        spent += detour.effort
        if len(detour.hops) > 0:
            free = task.radius * length_of(next_word(task.start, task.goal, task.radius, -1.0))
            if detour.length > LONG * free and CLEARANCES[i] > CLEARANCES[GATE]:
                through = detour_with(obstacles, fence, band, task, CLEARANCES[GATE], EFFORTS[GATE])
                spent += through.effort
                if 0.0 < through.length < WORTH * detour.length:
                    detour = through
            return Detour(detour.hops, detour.length, detour.clearance, spent)
    return Detour(np.empty((0, HOP_COLUMNS)), 0.0, 0.0, spent)


@compiled
def detour_with(
    obstacles: Rows, fence: Outlines, band: Band, task: Task, wanted: float, effort: int
) -> Detour:
    """The way with one clearance [m]; arguments of `find_detour`."""
    hazards = joined(hazards_of(obstacles, band, wanted), fence)
    demand = demand_of(hazards, task, wanted)
    hops, left = search(hazards, task, demand, effort)
    if len(hops) == 0:
        return Detour(hops, 0.0, 0.0, effort - left)
    hops = shortened(hazards, task, demand, hops)
    return Detour(hops, way_length(hops, task.radius), wanted, effort - left)
