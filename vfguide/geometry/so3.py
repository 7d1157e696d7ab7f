"""Rotations as 3x3 matrices: SO(3), its logarithm, quaternions and Euler angles.

`R_ab` takes the components of a vector in frame b to those in frame a. Angles are radians.
"""

import math

from vfguide.geometry.vector import Mat3, Vec3, matmul, norm, scale
from vfguide.kernels.compiled import compiled

Quaternion = tuple[float, float, float, float]
"""w, x, y, z."""

IDENTITY: Mat3 = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
"""The rotation by no angle, dimensionless."""


@compiled
def bank_angle(R_nb: Mat3) -> float:
    """Bank [rad] of an attitude, body FRD to NED, right wing down positive: roll of Euler."""
    return math.atan2(R_nb[2][1], R_nb[2][2])


@compiled
def exp(w: Vec3) -> Mat3:
    """Rotation about `w` by the angle |w| [rad], of any size."""
    angle = norm(w)
    if angle == 0.0:
        return IDENTITY
    half = 0.5 * angle
    x, y, z = scale(math.sin(half) / angle, w)
    return from_quaternion((math.cos(half), x, y, z))


@compiled
def log(R: Mat3) -> Vec3:
    """Rotation vector of `R`: w with exp(w) = R and |w| in [0, pi].

    Through the quaternion, hence as exact at small angles and at pi as anywhere. At pi, where
    both signs are right, the component of largest size is positive.
    """
    w, x, y, z = to_quaternion(R)
    sine = norm((x, y, z))
    if sine == 0.0:
        return (2.0 * x, 2.0 * y, 2.0 * z)
    return scale(2.0 * math.atan2(sine, w) / sine, (x, y, z))


@compiled
def from_quaternion(q: Quaternion) -> Mat3:
    """Rotation matrix of the quaternion w, x, y, z, of any length but zero."""
    w, x, y, z = q
    k = 2.0 / (w * w + x * x + y * y + z * z)
    return (
        (1.0 - k * (y * y + z * z), k * (x * y - w * z), k * (x * z + w * y)),
        (k * (x * y + w * z), 1.0 - k * (x * x + z * z), k * (y * z - w * x)),
        (k * (x * z - w * y), k * (y * z + w * x), 1.0 - k * (x * x + y * y)),
    )


@compiled
def to_quaternion(R: Mat3) -> Quaternion:
    """Unit quaternion w, x, y, z of `R`, w >= 0.

    S. W. Shepperd, Quaternion from Rotation Matrix, 1978: each branch is q times four times its
    largest component, so that nothing cancels.
    """
    (a, b, c), (d, e, f), (g, h, i) = R
    ww, xx, yy, zz = 1.0 + a + e + i, 1.0 + a - e - i, 1.0 - a + e - i, 1.0 - a - e + i
    largest = max(ww, xx, yy, zz)
    if ww == largest:
        q = (ww, h - f, c - g, d - b)
    elif xx == largest:
        q = (h - f, xx, b + d, c + g)
    elif yy == largest:
        q = (c - g, b + d, yy, f + h)
    else:
        q = (d - b, c + g, f + h, zz)
    w, x, y, z = q
    length = math.sqrt(w * w + x * x + y * y + z * z)
    k = 1.0 / length if w >= 0.0 else -1.0 / length
    return (k * w, k * x, k * y, k * z)


@compiled
def rot_x(angle: float) -> Mat3:
    """Rotation about the first axis."""
    c, s = math.cos(angle), math.sin(angle)
    return ((1.0, 0.0, 0.0), (0.0, c, -s), (0.0, s, c))


@compiled
def rot_y(angle: float) -> Mat3:
    """Rotation about the second axis: nose up for a body FRD."""
    c, s = math.cos(angle), math.sin(angle)
    return ((c, 0.0, s), (0.0, 1.0, 0.0), (-s, 0.0, c))


@compiled
def rot_z(angle: float) -> Mat3:
    """Rotation about the third axis: clockwise seen from above in NED."""
    c, s = math.cos(angle), math.sin(angle)
    return ((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0))


@compiled
def from_euler(roll: float, pitch: float, yaw: float) -> Mat3:
    """R_nb of the Euler angles z-y-x: Rz(yaw) Ry(pitch) Rx(roll), body FRD to NED."""
    return matmul(rot_z(yaw), matmul(rot_y(pitch), rot_x(roll)))


@compiled
def body_rates(roll: float, pitch: float, rates: Vec3) -> Vec3:
    """Angular velocity in body axes [rad/s] where roll, pitch and yaw change at `rates` [rad/s].

    It is that of `from_euler`.
    """
    c, s = math.cos(roll), math.sin(roll)
    level = rates[2] * math.cos(pitch)
    p = rates[0] - rates[2] * math.sin(pitch)
    return p, c * rates[1] + s * level, c * level - s * rates[1]


@compiled
def to_euler(R_nb: Mat3) -> Vec3:
    """Roll, pitch and yaw of `R_nb`, the inverse of `from_euler`; pitch in [-pi/2, pi/2].

    Roll is read after yaw is taken out, so that the three always give `R_nb` again. Nose
    straight up or down, yaw is whatever rounding says (0 in the exact case).
    """
    yaw = math.atan2(R_nb[1][0], R_nb[0][0])
    c, s = math.cos(yaw), math.sin(yaw)
    pitch = math.atan2(-R_nb[2][0], c * R_nb[0][0] + s * R_nb[1][0])
    roll = math.atan2(s * R_nb[0][2] - c * R_nb[1][2], c * R_nb[1][1] - s * R_nb[0][1])
    return (roll, pitch, yaw)


@compiled
def quaternion_from_euler(roll: float, pitch: float, yaw: float) -> Quaternion:
    """`to_quaternion` of `from_euler`, in one call from Python."""
    return to_quaternion(from_euler(roll, pitch, yaw))
