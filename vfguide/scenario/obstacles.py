"""The obstacles of a scenario: their records for field and assurance, and their checks."""

from collections.abc import Sequence

import numpy as np

from vfguide.field.obstacle import Obstacle, Rows, obstacle_rows
from vfguide.field.obstacle_arrays import levels
from vfguide.files.obstacle_entry import SIZES
from vfguide.files.source import Source
from vfguide.geometry.shapes.base import Shape
from vfguide.geometry.shapes.shape import SHAPES
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Vec3
from vfguide.scenario.resolved import Obstacle as ScenarioObstacle
from vfguide.scenario.resolved import Scenario


def rows_of(obstacles: Sequence[ScenarioObstacle]) -> Rows:
    """The rows of obstacles, as the fields take them."""
    return obstacle_rows([obstacle_of(obstacle) for obstacle in obstacles])


def obstacle_of(obstacle: ScenarioObstacle) -> Obstacle:
    """An obstacle in SI units and radians."""
    return Obstacle(
        shape_of(obstacle),
        obstacle.position_m,
        obstacle.heading_deg * DEG,
        obstacle.velocity_mps,
        obstacle.reactive_level,
        obstacle.visible_from_m,
    )


def shape_of(obstacle: ScenarioObstacle) -> Shape:
    """The shape of an obstacle, from the sizes that `SIZES` lists for it."""
    sizes = [getattr(obstacle, key) for key in SIZES[obstacle.shape]]
    return SHAPES[obstacle.shape](*sizes)


def check_obstacles(scenario: Scenario, source: Source) -> None:
    """Check that no two obstacles have one name, and that no start or goal is inside one.

    Goals are checked against obstacles that stand still.

    Raises:
        InputError: two have, or one is.
    """
    names = [obstacle.name for obstacle in scenario.obstacles]
    source.check_distinct("obstacle", "name", names)
    moving = np.array([any(obstacle.velocity_mps) for obstacle in scenario.obstacles], bool)
    rows = rows_of(scenario.obstacles)
    for index, vehicle in enumerate(scenario.vehicles):
        if (inside := first_inside(vehicle.position_m, rows)) is not None:
            rule = f'inside obstacle "{names[inside]}", allowed outside its surface'
            raise source.error(("vehicle", index, "position_m"), rule, vehicle.position_m)
        for number, goal in enumerate(vehicle.goals):
            if (inside := first_inside(goal.position_m, rows[~moving])) is not None:
                standing = [name for name, moves in zip(names, moving, strict=True) if not moves]
                rule = f'inside obstacle "{standing[inside]}", allowed outside its surface'
                raise source.error(("vehicle", index, "goal", number), rule, goal.position_m)


def first_inside(p_n: Vec3, rows: Rows) -> int | None:
    """Index of the first obstacle that contains a point, NED [m], at time zero; None: none does."""
    inside = np.flatnonzero(levels(np.array(p_n), 0.0, rows) <= 1.0)
    return int(inside[0]) if inside.size else None
