"""A point at which a field is wanted, and the field there."""

from typing import NamedTuple

from vfguide.geometry.vector import Mat3, Vec3
from vfguide.kernels.rows import python_reader


class Point(NamedTuple):
    """A point at which the field is wanted, in the scenario frame."""

    p_n: Vec3
    """Position [m]."""
    v_n: Vec3
    """Velocity [m/s]."""
    time: float
    """Time [s]."""


point_of = python_reader(Point)


class FieldPoint(NamedTuple):
    """The field at one point, in the scenario frame; what a law does not have is None."""

    F: Vec3
    """Law paper: F of the composite, not normalised. Law flight: the direction through the air in
    which the plan begins, a unit vector."""
    G: Vec3 | None
    """G' of the same composite, orthogonal to F."""
    H: Vec3 | None
    """H' of the same composite, orthogonal to F and G."""
    R_a: Mat3
    """The auxiliary attitude; law flight: the reference attitude of a vehicle that has settled on
    the plan. Body to NED."""
    Omega_a: Vec3
    """Body rates of R_a for the motion through the point [rad/s]; law flight: along the plan."""
    chi: tuple[float, ...]
    """chi of each obstacle; law flight: none."""
