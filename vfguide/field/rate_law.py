"""The law that makes the body follow a reference attitude."""

from vfguide.geometry.so3 import log
from vfguide.geometry.vector import Mat3, Vec3, add, matmul, matvec, scale, transpose
from vfguide.kernels.compiled import compiled


@compiled
def rate_law(R_nb: Mat3, R_na: Mat3, Omega_a: Vec3, k_w: float) -> Vec3:
    """Omega [rad/s], the body rates under which the attitude error decays as exp(-k_w t).

    Lemma 4 (lem_R_e_stabilize), eq_Omega_design as a vector:
    Omega = -k_w log(R_a^T R) + R^T R_a Omega_a. At an error of 180 degrees, where the logarithm
    has two values, it takes one of them and turns the body out of there.

    Args:
        R_nb: attitude, body to NED.
        R_na: reference attitude, to NED.
        Omega_a: body rates of the reference [rad/s].
        k_w: gain [1/s].
    """
    R_ab = matmul(transpose(R_na), R_nb)
    feedback = scale(-k_w, log(R_ab))
    return add(feedback, matvec(transpose(R_ab), Omega_a))
