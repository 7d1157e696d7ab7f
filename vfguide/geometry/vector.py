"""Vectors of three floats and 3x3 matrices as plain tuples, for compiled code.

And the names of arrays that may be subscripted by number: `tools/check_records.py` refuses that
of any other array, since it may be the row of a record.
"""

import math

import numpy as np
from numpy.typing import NDArray

from vfguide.kernels.compiled import compiled

Vec3 = tuple[float, float, float]
Mat3 = tuple[Vec3, Vec3, Vec3]
"""A 3x3 matrix as its three rows."""
ZERO: Vec3 = (0.0, 0.0, 0.0)
"""The zero vector, dimensionless or in any unit."""

Vector = NDArray[np.float64]
"""The components of a vector, (n,)."""
Vectors = NDArray[np.float64]
"""Many vectors, or points, along the last axis, (..., n)."""
Matrix = NDArray[np.float64]
"""The elements of a matrix, (m, n)."""
Matrices = NDArray[np.float64]
"""Many matrices along the last two axes, (..., m, n)."""
Series = NDArray[np.float64]
"""One number at each of n instants, or of each of n like things, (n,)."""
Indices = NDArray[np.int64]
"""Places in a sequence of like things, or counts of them, (n,)."""
Mask = NDArray[np.bool_]
"""Which of n like things, (n,)."""


@compiled
def vec3(a: Vector) -> Vec3:
    """The three components of an array (3,), for kernels over arrays.

    Raises:
        ValueError: the array is not of length 3.
    """
    if len(a) != 3:
        raise ValueError("the last axis must have the three components of a vector")
    return (a[0], a[1], a[2])


@compiled
def mat3(a: Matrix) -> Mat3:
    """An array (3, 3) as its three rows."""
    return (
        (a[0, 0], a[0, 1], a[0, 2]),
        (a[1, 0], a[1, 1], a[1, 2]),
        (a[2, 0], a[2, 1], a[2, 2]),
    )


@compiled
def add(a: Vec3, b: Vec3) -> Vec3:
    """Sum a + b."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


@compiled
def sub(a: Vec3, b: Vec3) -> Vec3:
    """Difference a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


@compiled
def scale(k: float, a: Vec3) -> Vec3:
    """Multiple k a."""
    return (k * a[0], k * a[1], k * a[2])


@compiled
def dot(a: Vec3, b: Vec3) -> float:
    """Dot product a . b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@compiled
def cross(a: Vec3, b: Vec3) -> Vec3:
    """Cross product a x b."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


@compiled
def norm(a: Vec3) -> float:
    """Euclidean length of a."""
    return math.sqrt(dot(a, a))


@compiled
def unit(a: Vec3) -> Vec3:
    """Direction a / |a|; a must not be zero."""
    return scale(1.0 / norm(a), a)


@compiled
def matvec(m: Mat3, a: Vec3) -> Vec3:
    """Product M a."""
    return (dot(m[0], a), dot(m[1], a), dot(m[2], a))


@compiled
def transpose(m: Mat3) -> Mat3:
    """Transpose M^T."""
    return (
        (m[0][0], m[1][0], m[2][0]),
        (m[0][1], m[1][1], m[2][1]),
        (m[0][2], m[1][2], m[2][2]),
    )


@compiled
def matmul(a: Mat3, b: Mat3) -> Mat3:
    """Product A B."""
    c = transpose(b)
    return (
        (dot(a[0], c[0]), dot(a[0], c[1]), dot(a[0], c[2])),
        (dot(a[1], c[0]), dot(a[1], c[1]), dot(a[1], c[2])),
        (dot(a[2], c[0]), dot(a[2], c[1]), dot(a[2], c[2])),
    )
