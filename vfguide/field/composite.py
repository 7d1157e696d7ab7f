"""The field for one robot among obstacles and other robots, for any goal, in NED.

F_OA and F_CA are one composite: every obstacle, and every robot to give way to, is a barrier of
the same product and sum (Theorem 3, Algorithm 1).
"""

from typing import NamedTuple

import numpy as np

from vfguide.field.attitude import AXIS, attitude, frame, frame_rate
from vfguide.field.avoidance import Barrier, Deflection, FreeField, deflect, no_deflection
from vfguide.field.composite_frame import avoidance_frame_fields, goal_axis
from vfguide.field.goal_frame import GoalFrame, position_in_goal, velocity_in_goal
from vfguide.field.navigation import (
    navigation_field,
    navigation_field_rate,
    normal_field,
    normal_field_rate,
)
from vfguide.field.obstacle import Rows, from_centre, is_known, obstacle_surface, read_obstacle
from vfguide.field.robots import Robot, Spacing, read_robot, robot_barrier
from vfguide.field.transition import transition
from vfguide.geometry import dual, vector
from vfguide.geometry.dual import Dual3
from vfguide.geometry.vector import Mat3, Series, Vec3
from vfguide.kernels.compiled import compiled


class Composite(NamedTuple):
    """The field at a moving point, NED."""

    F: Vec3
    """F_OA or F_CA, not normalised."""
    G: Vec3
    """G', orthogonal to F, not normalised; a unit vector where it would vanish."""
    H: Vec3
    """H' = G' x F."""
    R_na: Mat3
    """The auxiliary attitude R_a, to NED."""
    Omega_a: Vec3
    """Its body rates [rad/s]."""
    chi: Series
    """chi of each obstacle, (M,)."""


@compiled
def composite_field(
    goal: GoalFrame,
    p_n: Vec3,
    v_n: Vec3,
    t: float,
    obstacles: Rows,
    others: Rows,
    spacing: Spacing,
) -> Composite:
    """The field for a robot that is at `p_n` and moves with `v_n`, NED [m], [m/s].

    Args:
        goal: the pose to reach.
        p_n: position.
        v_n: velocity; F, G, H and R_a do not depend on it, Omega_a does.
        t: time [s], for the motion of the obstacles.
        obstacles: of `obstacle_rows`, (M, width of PlacedObstacle).
        others: the robots to give way to as they are at time `t`, a `Robot` a row; those out of
            range have no effect.
        spacing: r_c and r_d between robots.
    """
    p = Dual3(p_n, v_n)
    free = free_field(goal, p)
    chi = np.empty(len(obstacles))
    by = deflect_by_obstacles(no_deflection(), free, p, t, obstacles, chi)
    for other in others:
        by = deflect_by_robot(by, free, p, read_robot(other), spacing)
    return compose(goal, p, free, by, chi)


@compiled
def free_field(goal: GoalFrame, p: Dual3) -> FreeField:
    """F~ and G~ (Corollary 1) at the moving point `p`, NED."""
    p_g, v_g = position_in_goal(goal, p.value), velocity_in_goal(goal, p.rate)
    F = Dual3(navigation_field(p_g), navigation_field_rate(p_g, v_g))
    on_axis = vector.norm((0.0, p_g[1], p_g[2])) <= AXIS * vector.norm(p_g)
    G = dual.zero3() if on_axis else Dual3(normal_field(p_g), normal_field_rate(p_g, v_g))
    return FreeField(dual.matvec(goal.R_ng, F), dual.matvec(goal.R_ng, G), goal_axis(goal, 1))


@compiled
def deflect_by_obstacles(
    by: Deflection, free: FreeField, p: Dual3, t: float, obstacles: Rows, chi: Series
) -> Deflection:
    """The deflection with all obstacles added; writes their chi, (M,)."""
    for i in range(len(obstacles)):
        chi[i] = 1.0
        obstacle = read_obstacle(obstacles[i])
        d = from_centre(obstacle, p, t)
        near = vector.dot(d.value, d.value) < obstacle.reach**2
        if near and is_known(obstacles, i, p.value, t):
            surface = obstacle_surface(obstacles, i, p, t)
            barrier = Barrier(transition(surface.U, 1.0, obstacle.reactive_level), surface.n)
            by = deflect(by, free, barrier)
            chi[i] = barrier.chi.value
    return by


@compiled
def deflect_by_robot(
    by: Deflection, free: FreeField, p: Dual3, other: Robot, spacing: Spacing
) -> Deflection:
    """The deflection with one robot added."""
    there = Dual3(other.p_n, other.v_n)
    return deflect(by, free, robot_barrier(dual.sub(p, there), spacing))


@compiled
def compose(goal: GoalFrame, p: Dual3, free: FreeField, by: Deflection, chi: Series) -> Composite:
    """Field and frame of a deflection; where nothing deflects, the frame of free space."""
    fields = avoidance_frame_fields(goal, free, by)
    H = vector.cross(fields.G, fields.F)
    if by.chi.value == 1.0:
        R_na, Omega_a = attitude(goal, p.value, p.rate)
    elif vector.norm(fields.F) == 0.0:
        R_na, Omega_a = goal.R_ng, (0.0, 0.0, 0.0)
    else:
        R_na, Omega_a = frame(fields), frame_rate(fields)
    return Composite(fields.F, fields.G, H, R_na, Omega_a, chi)
