"""A flyable route round hazards, with as much clearance as there is room for."""

from typing import NamedTuple

import numpy as np

from vfguide.airspace.footprint import Band
from vfguide.airspace.keep_out import KeepOutZones, hazards_of, joined
from vfguide.field.obstacle import Rows
from vfguide.geometry.compiled import compiled
from vfguide.paths.dubins import length_of
from vfguide.paths.edge import EDGE_WIDTH, RouteEdges, next_path, route_length
from vfguide.planning.collision_check import Task, demand_of
from vfguide.planning.graph_search import search
from vfguide.planning.shortcutting import shortened

CLEARANCES = (25.0, 18.0, 12.0, 8.0, 5.0)
"""That are tried one after the other [m]."""
EFFORTS = (3500, 1500, 2500, 2500, 1000)
"""Dubins paths computed for each of them, at most; see `search`."""
LONG, GATE, SHORTER_PART = 1.4, 2, 0.75
"""A route longer than the one without hazards by the first factor is looked for with less
clearance, that of the second number, too, and left where that makes it shorter by the third
factor."""


class FoundRoute(NamedTuple):
    """A route from the start to the goal."""

    route_edges: RouteEdges
    """Up to `roadmap.MAX_ROUTE_EDGES`, NED, a `Edge` a row; none where no route was found."""
    length: float
    """[m]; 0 where there is none."""
    clearance: float
    """That it keeps from every hazard [m]; less within a radius of the ends if it is less there."""
    effort: int
    """That was spent, see `search`."""


@compiled
def find_route(obstacles: Rows, fence: KeepOutZones, band: Band, task: Task) -> FoundRoute:
    """The route round obstacles and within a fence.

    Args:
        obstacles: rows of `obstacle_rows`.
        fence: as far as it is in the band; `keep_out.NO_FENCE` for none.
        band: heights between those of the start and of the goal.
        task: what is to be flown.
    """
    spent = 0
    for i in range(len(CLEARANCES)):
        found = route_with(obstacles, fence, band, task, CLEARANCES[i], EFFORTS[i])
        spent += found.effort
        if len(found.route_edges) > 0:
            free = task.radius * length_of(next_path(task.start, task.goal, task.radius, -1.0))
            if found.length > LONG * free and CLEARANCES[i] > CLEARANCES[GATE]:
                through = route_with(obstacles, fence, band, task, CLEARANCES[GATE], EFFORTS[GATE])
                spent += through.effort
                if 0.0 < through.length < SHORTER_PART * found.length:
                    found = through
            return FoundRoute(found.route_edges, found.length, found.clearance, spent)
    return FoundRoute(np.empty((0, EDGE_WIDTH)), 0.0, 0.0, spent)


@compiled
def route_with(
    obstacles: Rows, fence: KeepOutZones, band: Band, task: Task, wanted: float, effort: int
) -> FoundRoute:
    """The route with one clearance [m]; arguments of `find_route`."""
    hazards = joined(hazards_of(obstacles, band, wanted), fence)
    demand = demand_of(hazards, task, wanted)
    route_edges, left = search(hazards, task, demand, effort)
    if len(route_edges) == 0:
        return FoundRoute(route_edges, 0.0, 0.0, effort - left)
    route_edges = shortened(hazards, task, demand, route_edges)
    return FoundRoute(route_edges, route_length(route_edges, task.radius), wanted, effort - left)
