"""Reference for the length of routes: BIT* of the Open Motion Planning Library on Dubins paths.

ompl is no dependency of the project: `pip install ompl`. Clearance is looked up on a fine grid of
exact distances from the obstacles.
"""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray
from search_worlds import HEIGHT, World

from vfguide.field.obstacle import Rows, obstacle_distance, read_obstacle
from vfguide.geometry.vector import Vector
from vfguide.kernels.compiled import compiled

try:
    from ompl import base, geometric, util
except ImportError:
    base = geometric = util = None

MISSING = "the reference is BIT* of ompl, which is not installed: pip install ompl"
CELL = 2.5
"""Side of a cell of the grid [m]; chosen."""
AROUND = 500.0
"""Distance that the reference may fly beyond start and goal [m]; chosen."""


def is_installed() -> bool:
    """Whether ompl is installed, so that there is a reference."""
    return base is not None


@compiled
def free_cells(
    obstacles: Rows, low: tuple[float, float], shape: tuple[int, int], apart: float
) -> NDArray[np.bool_]:
    """Whether each cell of a grid at HEIGHT is farther than `apart` [m] from all obstacles."""
    free = np.ones(shape, np.bool_)
    for m in range(shape[0]):
        for n in range(shape[1]):
            x, y = low[0] + CELL * m, low[1] + CELL * n
            for i in range(len(obstacles)):
                obstacle = read_obstacle(obstacles[i])
                a, b, _ = obstacle.semi_axes
                north, east, _ = obstacle.p_n
                if math.hypot(x - north, y - east) - math.hypot(a, b) > apart:
                    continue
                if obstacle_distance(obstacles, i, (x, y, -HEIGHT), 0.0) <= apart:
                    free[m, n] = False
                    break
    return free


def reference_length(world: World, radius: float, apart: float, seconds: float, seed: int) -> float:
    """Length of the shortest path that BIT* finds in some seconds [m], infinite for none.

    Raises:
        ModuleNotFoundError: ompl is not installed.
    """
    if not is_installed():
        raise ModuleNotFoundError(MISSING)
    util.setLogLevel(util.LogLevel.LOG_NONE)
    util.RNG.setSeed(seed + 1)
    ends = np.array([(pose.x, pose.y) for pose in (world.start, world.goal)])
    low: Vector = ends.min(axis=0) - AROUND
    high: Vector = ends.max(axis=0) + AROUND
    cells = tuple(int(n) for n in np.ceil((high - low) / CELL))
    free = free_cells(world.obstacles, (float(low[0]), float(low[1])), (cells[0], cells[1]), apart)
    space = base.DubinsStateSpace(radius)
    bounds = base.RealVectorBounds(2)
    for k in range(2):
        bounds.setLow(k, float(low[k]))
        bounds.setHigh(k, float(high[k]))
    space.setBounds(bounds)
    setup = geometric.SimpleSetup(space)

    def is_valid(state: Any) -> bool:
        m, n = int((state.getX() - low[0]) / CELL + 0.5), int((state.getY() - low[1]) / CELL + 0.5)
        return 0 <= m < cells[0] and 0 <= n < cells[1] and bool(free[m, n])

    setup.setStateValidityChecker(is_valid)
    setup.getSpaceInformation().setStateValidityCheckingResolution(5.0 / space.getMaximumExtent())
    begin, end = space.allocState(), space.allocState()
    for state, pose in ((begin, world.start), (end, world.goal)):
        state.setX(pose.x)
        state.setY(pose.y)
        state.setYaw(math.remainder(pose.course, 2.0 * math.pi))
    setup.setStartAndGoalStates(begin, end)
    setup.setPlanner(geometric.BITstar(setup.getSpaceInformation()))
    setup.solve(seconds)
    if not setup.haveExactSolutionPath():
        return math.inf
    return float(setup.getSolutionPath().length())
