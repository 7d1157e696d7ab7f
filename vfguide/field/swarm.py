"""The field for many robots at once, each giving way to those above it."""

from collections.abc import Sequence
from typing import cast

import numpy as np

from vfguide.field.avoidance import no_deflection
from vfguide.field.composite import compose, deflect_by_obstacles, deflect_by_robot, free_field
from vfguide.field.composite_arrays import CompositeArrays, empty_fields, store
from vfguide.field.goal_frame import GoalFrame, read_goal
from vfguide.field.neighbours import Neighbours, no_neighbours, robots_with_priority
from vfguide.field.obstacle import Rows
from vfguide.field.robots import Robot, Spacing, read_robot
from vfguide.geometry.dual import Dual3
from vfguide.geometry.vector import Vectors
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import columns, table_of


def fields_of_robots(
    goals: Rows, robots: Rows, t: float, obstacles: Rows, spacing: Spacing | None
) -> CompositeArrays:
    """F_CA and its frame for N robots (Algorithm 1); the cost grows with their neighbours.

    Args:
        goals: of `goal_rows`, N rows.
        robots: a `Robot` a row as they are at time `t`, (N, 6), in the order of priority.
        t: time [s], for the motion of the obstacles.
        obstacles: of `obstacle_rows`, M rows.
        spacing: r_c and r_d; None: robots take no notice of each other.
    """
    robots = np.ascontiguousarray(robots, np.float64)
    if spacing is None:
        spacing, neighbours = Spacing(0.0, 0.0), no_neighbours(len(robots))
    else:
        neighbours = robots_with_priority(
            cast("Vectors", columns(Robot, robots).p_n), spacing.detection_range
        )
    fields = empty_fields(len(robots), len(obstacles))
    _of_robots(goals, robots, t, obstacles, neighbours, spacing, fields)
    return fields


def goal_rows(goals: Sequence[GoalFrame]) -> Rows:
    """The goals as a table, a `GoalFrame` a row."""
    return table_of(GoalFrame, goals)


@compiled
def _of_robots(
    goals: Rows,
    robots: Rows,
    t: float,
    obstacles: Rows,
    neighbours: Neighbours,
    spacing: Spacing,
    fields: CompositeArrays,
) -> None:
    for i in range(len(robots)):
        goal, robot, chi = read_goal(goals[i]), read_robot(robots[i]), fields.chi[i]
        p = Dual3(robot.p_n, robot.v_n)
        free = free_field(goal, p)
        by = deflect_by_obstacles(no_deflection(), free, p, t, obstacles, chi)
        for k in range(neighbours.start[i], neighbours.start[i + 1]):
            other = read_robot(robots[neighbours.others[k]])
            by = deflect_by_robot(by, free, p, other, spacing)
        store(fields, i, compose(goal, p, free, by, chi))
