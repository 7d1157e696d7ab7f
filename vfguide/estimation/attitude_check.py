"""Attitude against body rates: an attitude may only turn as fast as the body does.

An estimator that is reset, or a compass that is disturbed, turns the reported attitude while the
body does not turn. Such a turn about the vertical is taken back: the yaw to fly on is the reported
one less the turns that no body rate shows. After one about a horizontal axis roll and pitch are
doubted, and have no replacement.
"""

import math
from typing import NamedTuple

from vfguide.geometry.so3 import exp, log, rot_z
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import ZERO, Mat3, Vec3, add, matmul, scale, transpose
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import replacing

UNEXPLAINED_TURN = 10.0 * DEG
"""Turn of the attitude that no body rate shows above which the aircraft has not made it [rad];
chosen well above what samples of the rates miss."""
TURN_MEMORY = 2.0
"""Time constant with which smaller unexplained turns are forgotten [s]; chosen, so that biases of
the body rates do not add up."""
LONGEST_PREDICTION = 0.1
"""Time between two attitudes above which body rates do not predict the turn [s]; chosen, since
they are sampled at its ends."""
YAW_MEMORY = 3.0
"""Time constant with which a doubted yaw is led to the one without sideslip [s]; chosen."""
YAW_AGREES = 4.0 * DEG
"""Correction below which a doubted yaw is believed again [rad]; chosen above the sideslip of steady
flight."""


class AttitudeCheck(NamedTuple):
    """The attitude that was reported last, and what its turns have shown."""

    R_nb: Mat3
    """Attitude, body to NED."""
    omega_b: Vec3
    """Body rates [rad/s]."""
    unexplained_n: Vec3
    """Turn that no body rate shows, NED rotation vector [rad]."""
    yaw_correction: float
    """Angle to add to the reported yaw [rad]; 0: it is believed."""
    is_by_wind: bool
    """Whether the wind triangle alone asks for it: the reported wind may be wrong instead."""
    is_tilted: bool
    """Whether roll or pitch have turned though the body has not."""


@compiled
def first_attitude(R_nb: Mat3, omega_b: Vec3) -> AttitudeCheck:
    """The check after one attitude, body to NED, and body rates [rad/s]: nothing is known yet."""
    return AttitudeCheck(R_nb, omega_b, ZERO, 0.0, False, False)


@compiled
def follow_attitude(s: AttitudeCheck, R_nb: Mat3, omega_b: Vec3, dt: float) -> AttitudeCheck:
    """The check `dt` [s] later, with the next attitude, body to NED, and body rates [rad/s].

    The turn that no body rate shows is log(R (R_before exp(omega dt))^T).
    """
    unexplained, correction = scale(max(0.0, 1.0 - dt / TURN_MEMORY), s.unexplained_n), 0.0
    if dt <= LONGEST_PREDICTION:
        turn = exp(scale(0.5 * dt, add(s.omega_b, omega_b)))
        unexplained = add(unexplained, log(matmul(R_nb, transpose(matmul(s.R_nb, turn)))))
    is_tilted = math.hypot(unexplained[0], unexplained[1]) > UNEXPLAINED_TURN
    if abs(unexplained[2]) > UNEXPLAINED_TURN:
        correction = -unexplained[2]
        unexplained = (unexplained[0], unexplained[1], 0.0)
    yaw_correction = s.yaw_correction + correction
    return AttitudeCheck(R_nb, omega_b, unexplained, yaw_correction, s.is_by_wind, is_tilted)


with_correction = replacing(AttitudeCheck, "yaw_correction", "is_by_wind")


@compiled
def turned_by(s: AttitudeCheck, angle: float) -> AttitudeCheck:
    """The check with the yaw corrected by an angle [rad] more, as the wind triangle asks for."""
    return with_correction(s, s.yaw_correction + angle, s.is_by_wind or s.yaw_correction == 0.0)


@compiled
def uncorrected(s: AttitudeCheck) -> AttitudeCheck:
    """The check with the yaw as it is reported."""
    return with_correction(s, 0.0, False)


@compiled
def corrected_attitude(s: AttitudeCheck, R_nb: Mat3) -> Mat3:
    """An attitude, body to NED, with the yaw to fly on."""
    return R_nb if s.yaw_correction == 0.0 else matmul(rot_z(s.yaw_correction), R_nb)


@compiled
def with_slip(s: AttitudeCheck, sideslip: float, dt: float) -> AttitudeCheck:
    """The check `dt` [s] later; a doubted yaw is led to where the `sideslip` [rad] is zero.

    The sideslip is the azimuth of the air velocity less that of the corrected attitude.
    """
    if s.yaw_correction == 0.0:
        return s
    correction = s.yaw_correction + sideslip * dt / (YAW_MEMORY + dt)
    if abs(correction) < YAW_AGREES:
        return uncorrected(s)
    return with_correction(s, correction, s.is_by_wind)
