"""Levels, transitions and distances of obstacles over arrays of points.

Positions are (..., 3), NED [m], times (...) [s]; they broadcast against each other. `obstacles`
is the table of `obstacle_rows`, M rows; results are (..., M).
"""

from typing import Any

from vfguide.field.obstacle import obstacle_distance, obstacle_surface
from vfguide.geometry.dual import Dual3
from vfguide.geometry.vector import ZERO, vec3
from vfguide.kernels.over_points import over_points


@over_points("(n),(),(m,k)->(m)")
def levels(p_n: Any, t: float, obstacles: Any, U: Any) -> None:
    """U of each obstacle: 1 on its surface, below 1 inside."""
    for i in range(len(obstacles)):
        U[i] = obstacle_surface(obstacles, i, Dual3(vec3(p_n), ZERO), t).U.value


@over_points("(n),(),(m,k)->(m)")
def distances(p_n: Any, t: float, obstacles: Any, distance: Any) -> None:
    """Distance from the surface of each obstacle [m], negative inside."""
    for i in range(len(obstacles)):
        distance[i] = obstacle_distance(obstacles, i, vec3(p_n), t)
