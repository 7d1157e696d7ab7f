"""Route search: a flyable route around hazards, with as much clearance as there is room for."""

from typing import NamedTuple

import numpy as np

from vfguide.airspace.footprint import Band
from vfguide.airspace.keep_out import KeepOutZones, joined, obstacle_zones
from vfguide.field.obstacle import Rows
from vfguide.kernels.compiled import compiled
from vfguide.paths.dubins import length_of
from vfguide.paths.edge import EDGE_WIDTH, RouteEdges, next_path, route_length
from vfguide.planning.collision_check import Task, demand_of
from vfguide.planning.graph_search import search
from vfguide.planning.shortcutting import shortened

CLEARANCES = (25.0, 18.0, 12.0, 8.0, 5.0)
"""Clearances that are tried one after the other [m]; chosen, the first about twice the margin of
the assurance."""
EFFORTS = (3500, 1500, 2500, 2500, 1000)
"""Largest number of Dubins paths that are computed for each clearance, see `search`; chosen for the
time of a step."""
LONG_ROUTE = 1.4
"""Ratio of the length of a route to the one without hazards above which less clearance is tried
too; chosen."""
GATE = 2
"""Index in CLEARANCES of the clearance that is tried too where the route is long: it lets a route
through gaps between obstacles."""
GATE_RATIO = 0.75
"""Ratio of the length of a route through a gap to that of the long one below which it is taken;
chosen."""


class FoundRoute(NamedTuple):
    """A route from the start to the goal."""

    route_edges: RouteEdges
    """Up to `roadmap.MAX_ROUTE_EDGES`, NED, one `Edge` a row; none where no route was found."""
    length: float
    """Length of the route [m]; 0 where there is none."""
    clearance: float
    """Clearance from every hazard [m]; around the ends it may be less."""
    effort: int
    """Effort that was spent, see `search`."""


@compiled
def find_route(obstacles: Rows, fence: KeepOutZones, band: Band, task: Task) -> FoundRoute:
    """The route around obstacles and within a fence.

    Args:
        obstacles: rows of `obstacle_rows`.
        fence: zones of the fence in the band; `keep_out.NO_FENCE` for none.
        band: heights between those of the start and of the goal.
        task: start, goal, turn radius and wind.
    """
    spent = 0
    for i in range(len(CLEARANCES)):
        found = route_with(obstacles, fence, band, task, CLEARANCES[i], EFFORTS[i])
        spent += found.effort
        if len(found.route_edges) > 0:
            free = task.radius * length_of(next_path(task.start, task.goal, task.radius, -1.0))
            if found.length > LONG_ROUTE * free and CLEARANCES[i] > CLEARANCES[GATE]:
                through = route_with(obstacles, fence, band, task, CLEARANCES[GATE], EFFORTS[GATE])
                spent += through.effort
                if 0.0 < through.length < GATE_RATIO * found.length:
                    found = through
            return FoundRoute(found.route_edges, found.length, found.clearance, spent)
    return FoundRoute(np.empty((0, EDGE_WIDTH)), 0.0, 0.0, spent)


@compiled
def route_with(
    obstacles: Rows, fence: KeepOutZones, band: Band, task: Task, wanted: float, effort: int
) -> FoundRoute:
    """The route with the clearance `wanted` [m]; other arguments are those of `find_route`."""
    hazards = joined(obstacle_zones(obstacles, band, wanted), fence)
    demand = demand_of(hazards, task, wanted)
    route_edges, left = search(hazards, task, demand, effort)
    if len(route_edges) == 0:
        return FoundRoute(route_edges, 0.0, 0.0, effort - left)
    route_edges = shortened(hazards, task, demand, route_edges)
    return FoundRoute(route_edges, route_length(route_edges, task.radius), wanted, effort - left)
