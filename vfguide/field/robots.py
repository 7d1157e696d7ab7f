"""Robots with priority, as barriers of the paper's field F_CA."""

from typing import NamedTuple

from vfguide.field.avoidance import Barrier
from vfguide.field.transition import transition
from vfguide.geometry import dual
from vfguide.geometry.dual import Dual3
from vfguide.geometry.vector import Vec3, norm
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import reader, writer


class Robot(NamedTuple):
    """Position and velocity of a robot."""

    p_n: Vec3
    """Position, NED [m]."""
    v_n: Vec3
    """Velocity, NED [m/s]."""


read_robot, write_robot = reader(Robot), writer(Robot)


class Spacing(NamedTuple):
    """Safety radius and detection range of robots; r_d must be more than 2 r_c."""

    safety_radius: float
    """r_c of one robot: centres have to stay 2 r_c apart [m]."""
    detection_range: float
    """r_d, the distance within which robots react to each other [m]."""


@compiled
def robot_barrier(d: Dual3, spacing: Spacing) -> Barrier:
    """chi_j and n_Psi_j of a robot from which one's own position differs by `d` [m].

    Psi_j = |p - p_j|, so that n_Psi_j is a unit vector (n_Psi). chi_j is 0 at Psi_j = 2 r_c and
    1 at r_d: eq_chi_j has r_c there, which would let the robots touch.
    """
    if norm(d.value) == 0.0:
        return Barrier(dual.rest(0.0), dual.zero3())
    inner = 2.0 * spacing.safety_radius
    return Barrier(transition(dual.norm(d), inner, spacing.detection_range), dual.unit(d))
