"""The field for many robots at once, each giving way to those above it."""

from collections.abc import Sequence

import numpy as np

from vfguide.field.avoidance import no_deflection
from vfguide.field.composite import (
    compose,
    deflect_by_obstacles,
    deflect_by_robot,
    free_field,
)
from vfguide.field.composite_arrays import CompositeArrays, empty_fields, store
from vfguide.field.dual import Dual3
from vfguide.field.goal_frame import GoalFrame
from vfguide.field.neighbours import Neighbours, no_neighbours, robots_with_priority
from vfguide.field.obstacle import Rows
from vfguide.field.robots import Spacing
from vfguide.geometry.compiled import compiled


def fields_of_robots(
    goals: Rows, robots: Rows, t: float, obstacles: Rows, spacing: Spacing | None
) -> CompositeArrays:
    """F_CA and its frame for N robots (Algorithm 1); the cost grows with their neighbours.

    Args:
        goals: (N, 12), of `goal_rows`.
        robots: (N, 6), position and velocity at time `t`, NED, in the order of priority.
        t: time [s], for the motion of the obstacles.
        obstacles: (M, COLUMNS), of `obstacle_rows`.
        spacing: r_c and r_d; None: robots take no notice of each other.
    """
    robots = np.ascontiguousarray(robots, np.float64)
    if spacing is None:
        spacing, neighbours = Spacing(0.0, 0.0), no_neighbours(len(robots))
    else:
        neighbours = robots_with_priority(robots[:, :3], spacing.detection_range)
    fields = empty_fields(len(robots), len(obstacles))
    _of_robots(goals, robots, t, obstacles, neighbours, spacing, fields)
    return fields


def goal_rows(goals: Sequence[GoalFrame]) -> Rows:
    """The goals as an array (N, 12): position, then R_ng row by row."""
    return np.array([(*goal.p_n, *np.ravel(goal.R_ng)) for goal in goals]).reshape(-1, 12)


@compiled
def _goal(row: Rows) -> GoalFrame:
    """The goal in a row of `goal_rows`."""
    return GoalFrame(
        (row[0], row[1], row[2]),
        ((row[3], row[4], row[5]), (row[6], row[7], row[8]), (row[9], row[10], row[11])),
    )


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
        goal, r, chi = _goal(goals[i]), robots[i], fields.chi[i]
        p = Dual3((r[0], r[1], r[2]), (r[3], r[4], r[5]))
        free = free_field(goal, p)
        by = deflect_by_obstacles(no_deflection(), free, p, t, obstacles, chi)
        for k in range(neighbours.start[i], neighbours.start[i + 1]):
            by = deflect_by_robot(by, free, p, robots[neighbours.others[k]], spacing)
        store(fields, i, compose(goal, p, free, by, chi))
