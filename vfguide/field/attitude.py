"""The auxiliary attitude R_a that the paper's robot tracks, and how fast it turns.

R_a = [F, H, G], each normalised (eq_auxi_atti_matrix). The paper leaves it undefined where G and
H vanish, on the whole x-axis of the goal frame, and where F does, at the goal. Here

- on the axis, nearer to it than AXIS times the distance to the goal, z is the part of the goal
  frame's z that is orthogonal to F. R_a e_x = F/|F| still holds (Lemma 3), R_a is the attitude of
  the goal frame, and a robot on the axis does not roll;
- at the goal, R_a is the attitude of the goal frame and does not turn.
"""

import math
from typing import NamedTuple

from vfguide.field.goal_frame import GoalFrame, position_in_goal, velocity_in_goal
from vfguide.field.navigation import (
    navigation_field,
    navigation_field_rate,
    normal_field,
    normal_field_rate,
)
from vfguide.geometry.vector import (
    Mat3,
    Vec3,
    add,
    cross,
    dot,
    matmul,
    norm,
    scale,
    sub,
    transpose,
    unit,
)
from vfguide.kernels.compiled import compiled

AXIS = 1e-9
"""Ratio r / |p| of the distances from the goal's axis and from the goal below which a point counts
as on the axis, dimensionless; chosen well above rounding."""


class Attitude(NamedTuple):
    """A reference attitude and its angular velocity."""

    R_na: Mat3
    """From the reference's body axes (forward, right, down) to NED."""
    Omega_a: Vec3
    """Its body rates [rad/s]: R_a^T dR_a/dt = Omega_a^."""


class FrameFields(NamedTuple):
    """Two orthogonal fields that span a frame, and their time derivatives at a moving point.

    All four are in the frame of the fields; only the directions of F and G count.
    """

    F: Vec3
    F_rate: Vec3
    G: Vec3
    G_rate: Vec3


@compiled
def frame(fields: FrameFields) -> Mat3:
    """R_a: the columns F, H = G x F and G, each normalised (eq_auxi_atti_matrix)."""
    x, z = unit(fields.F), unit(fields.G)
    return transpose((x, cross(z, x), z))


@compiled
def frame_rate(fields: FrameFields) -> Vec3:
    """Omega_a, the body rates of `frame` [rad/s]: Lemma 2 (lem_kine_R_a).

    With the columns x, y, z of R_a, Omega_a = (-y.z', -z.x', y.x'). The second term of
    eq_dot_auxi_unit_vec is along the column itself and drops out.
    """
    x, z = unit(fields.F), unit(fields.G)
    y = cross(z, x)
    F_turn = scale(1.0 / norm(fields.F), fields.F_rate)
    G_turn = scale(1.0 / norm(fields.G), fields.G_rate)
    return (-dot(y, G_turn), -dot(z, F_turn), dot(y, F_turn))


@compiled
def upright_fields(F: Vec3, F_rate: Vec3) -> FrameFields:
    """F with G = e_z - (e_z.F) F, for a unit vector F that is not upright itself."""
    G = sub((0.0, 0.0, 1.0), scale(F[2], F))
    G_rate = scale(-1.0, add(scale(F_rate[2], F), scale(F[2], F_rate)))
    return FrameFields(F, F_rate, G, G_rate)


@compiled
def frame_fields(p_g: Vec3, v_g: Vec3) -> FrameFields:
    """F, G and their rates at `p_g` moving with `v_g`, replaced where R_a is singular.

    F and G are homogeneous, so that only the direction of p counts: p and v are divided by |p|,
    and nothing over- or underflows between 1e-150 m and 1e150 m.
    """
    distance = norm(p_g)
    if distance == 0.0:
        return upright_fields((1.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    p, v = scale(1.0 / distance, p_g), scale(1.0 / distance, v_g)
    F, F_rate = navigation_field(p), navigation_field_rate(p, v)
    if math.hypot(p[1], p[2]) <= AXIS:
        return upright_fields(F, F_rate)
    return FrameFields(F, F_rate, normal_field(p), normal_field_rate(p, v))


@compiled
def goal_attitude(p_g: Vec3, v_g: Vec3) -> tuple[Mat3, Vec3]:
    """R_ga and Omega_a in the goal frame, at `p_g` [m] moving with `v_g` [m/s]."""
    fields = frame_fields(p_g, v_g)
    return (frame(fields), frame_rate(fields))


@compiled
def attitude(goal: GoalFrame, p_n: Vec3, v_n: Vec3) -> Attitude:
    """R_a and Omega_a for any goal, at `p_n` [m] moving with `v_n` [m/s], NED (Corollary 1)."""
    R_ga, Omega_a = goal_attitude(position_in_goal(goal, p_n), velocity_in_goal(goal, v_n))
    return Attitude(matmul(goal.R_ng, R_ga), Omega_a)
