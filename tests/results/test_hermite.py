"""Cubics between samples against SciPy's."""

import numpy as np
from scipy.interpolate import CubicHermiteSpline

from vfguide.results.hermite import derivative_at, hermite, value_at


def test_numbers_and_arrays_are_those_of_the_spline():
    rng = np.random.default_rng(3)
    p, d, s = rng.normal(size=(2, 5, 3)), rng.normal(size=(2, 5, 3)), np.linspace(0.0, 1.0, 7)
    spline = CubicHermiteSpline([0.0, 1.0], p, d)
    cubic = hermite(p[0], p[1], d[0], d[1])
    for at in s:
        assert np.allclose(value_at(cubic, at), spline(at))
        assert np.allclose(derivative_at(cubic, at), spline.derivative()(at))
    one = hermite(*map(float, (p[0, 0, 0], p[1, 0, 0], d[0, 0, 0], d[1, 0, 0])))
    assert np.isclose(value_at(one, 0.3), spline(0.3)[0, 0])
