import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from shape_samples import floats

from vfguide.geometry import dual
from vfguide.geometry.dual import Dual, Dual3
from vfguide.geometry.so3 import rot_y
from vfguide.geometry.vector import norm

pytestmark = pytest.mark.slow

numbers = st.floats(-10.0, 10.0)
vectors = st.tuples(numbers, numbers, numbers)
duals = st.builds(Dual, numbers, numbers)
dual3s = st.builds(Dual3, vectors, vectors)
long_ones = dual3s.filter(lambda a: norm(a.value) > 0.1)

VECTOR_OPERATIONS = [
    (dual.add, np.add),
    (dual.sub, np.subtract),
    (dual.cross, np.cross),
    (dual.dot, np.dot),
]


def at(a, h):
    """Where a value with a rate is after a short time `h`."""
    return np.asarray(a.value) + h * np.asarray(a.rate)


def assert_is(result, plain):
    """`result` is the value and the rate of `plain(h)` at h = 0."""
    h = 1e-4
    rate = (plain(h) - plain(-h)) / (2.0 * h)
    size = 1.0 + np.abs(plain(0.0)).max() + np.abs(rate).max()
    np.testing.assert_allclose(result.value, plain(0.0), atol=1e-13 * size)
    np.testing.assert_allclose(result.rate, rate, atol=1e-4 * size)


@given(dual3s, dual3s)
@pytest.mark.parametrize(("operation", "plain"), VECTOR_OPERATIONS)
def test_operations_on_two_vectors(operation, plain, a, b):
    assert_is(operation(a, b), lambda h: plain(at(a, h), at(b, h)))


@given(duals, duals, dual3s)
def test_operations_on_numbers(a, b, c):
    assert_is(dual.plus(a, b), lambda h: at(a, h) + at(b, h))
    assert_is(dual.times(a, b), lambda h: at(a, h) * at(b, h))
    assert_is(dual.complement(a), lambda h: 1.0 - at(a, h))
    assert_is(dual.scale(a, c), lambda h: at(a, h) * at(c, h))


@given(long_ones)
def test_length_and_direction(a):
    assert_is(dual.norm(a), lambda h: np.linalg.norm(at(a, h)))
    slow = Dual3(a.value, floats(0.01 * np.array(a.rate)))
    assert_is(dual.unit(slow), lambda h: at(slow, h) / np.linalg.norm(at(slow, h)))
    assert abs(dual.dot(dual.unit(a), dual.unit(a)).rate) <= 1e-12 * max(map(abs, a.rate))


@given(dual3s)
def test_turned_by_a_constant_matrix(a):
    R = rot_y(0.3)
    assert_is(dual.matvec(R, a), lambda h: np.array(R) @ at(a, h))


def test_constants():
    assert dual.rest(3.0) == (3.0, 0.0)
    assert dual.zero3() == ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
