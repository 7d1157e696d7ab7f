"""Values with their time derivatives: dual numbers and vectors of them, for compiled code.

A formula written with these operations has one version, and its rate is exact.
"""

from typing import NamedTuple

from vfguide.geometry import vector
from vfguide.geometry.vector import Mat3, Vec3
from vfguide.kernels.compiled import compiled


class Dual(NamedTuple):
    """A number and its time derivative."""

    value: float
    rate: float


class Dual3(NamedTuple):
    """A vector and its time derivative, in axes that stand still."""

    value: Vec3
    rate: Vec3


@compiled
def zero3() -> Dual3:
    """The zero vector, at rest."""
    return Dual3((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))


@compiled
def rest(a: float) -> Dual:
    """A constant."""
    return Dual(a, 0.0)


@compiled
def complement(a: Dual) -> Dual:
    """Difference 1 - a."""
    return Dual(1.0 - a.value, -a.rate)


@compiled
def plus(a: Dual, b: Dual) -> Dual:
    """Sum a + b of numbers."""
    return Dual(a.value + b.value, a.rate + b.rate)


@compiled
def times(a: Dual, b: Dual) -> Dual:
    """Product a b of numbers."""
    return Dual(a.value * b.value, a.rate * b.value + a.value * b.rate)


@compiled
def add(a: Dual3, b: Dual3) -> Dual3:
    """Sum a + b."""
    return Dual3(vector.add(a.value, b.value), vector.add(a.rate, b.rate))


@compiled
def sub(a: Dual3, b: Dual3) -> Dual3:
    """Difference a - b."""
    return Dual3(vector.sub(a.value, b.value), vector.sub(a.rate, b.rate))


@compiled
def scale(k: Dual, a: Dual3) -> Dual3:
    """Multiple k a."""
    rate = vector.add(vector.scale(k.rate, a.value), vector.scale(k.value, a.rate))
    return Dual3(vector.scale(k.value, a.value), rate)


@compiled
def dot(a: Dual3, b: Dual3) -> Dual:
    """Dot product a . b."""
    rate = vector.dot(a.rate, b.value) + vector.dot(a.value, b.rate)
    return Dual(vector.dot(a.value, b.value), rate)


@compiled
def cross(a: Dual3, b: Dual3) -> Dual3:
    """Cross product a x b."""
    rate = vector.add(vector.cross(a.rate, b.value), vector.cross(a.value, b.rate))
    return Dual3(vector.cross(a.value, b.value), rate)


@compiled
def norm(a: Dual3) -> Dual:
    """Length |a|; a must not be zero."""
    length = vector.norm(a.value)
    return Dual(length, vector.dot(a.value, a.rate) / length)


@compiled
def unit(a: Dual3) -> Dual3:
    """Direction a / |a|; a must not be zero. Its rate is orthogonal to it."""
    length = norm(a)
    e = vector.scale(1.0 / length.value, a.value)
    rate = vector.sub(a.rate, vector.scale(length.rate, e))
    return Dual3(e, vector.scale(1.0 / length.value, rate))


@compiled
def matvec(m: Mat3, a: Dual3) -> Dual3:
    """Product M a with a constant matrix."""
    return Dual3(vector.matvec(m, a.value), vector.matvec(m, a.rate))
