import math

import numpy as np
import pymap3d
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.earth import geodesy
from vfguide.geometry.vector import matvec, norm, sub

NANOMETRE = 1e-9
ROUNDING = 5.0 * NANOMETRE
"""A few units in the last place of an earth radius [m]."""
EARTH_RADIUS = 6.4e6

latitudes = st.floats(-math.pi / 2, math.pi / 2)
longitudes = st.floats(-math.pi, math.pi)
altitudes = st.floats(-1e4, 1e5)
points = st.tuples(latitudes, longitudes, altitudes)
flown = st.tuples(st.floats(-2e5, 2e5), st.floats(-2e5, 2e5), st.floats(-2e4, 2e4))

ZURICH = geodesy.tangent_plane(math.radians(47.397742), math.radians(8.545594), 488.0)


def distance(a, b):
    return norm(sub(tuple(map(float, a)), tuple(map(float, b))))


def test_semi_axes_of_the_ellipsoid():
    assert geodesy.geodetic_to_ecef(0.0, 0.0, 0.0) == (6378137.0, 0.0, 0.0)
    assert distance(
        geodesy.geodetic_to_ecef(math.pi / 2, 0.0, 0.0), (0.0, 0.0, 6356752.314245179)
    ) == pytest.approx(0.0, abs=ROUNDING)


@given(points)
def test_ecef_is_pymap3ds(point):
    lat, lon, alt = point
    expected = pymap3d.geodetic2ecef(lat, lon, alt, deg=False)
    assert distance(geodesy.geodetic_to_ecef(lat, lon, alt), expected) < ROUNDING


@given(st.tuples(latitudes, longitudes, st.floats(-5e4, 1e7)))
def test_ecef_comes_back(point):
    p_e = geodesy.geodetic_to_ecef(*point)
    lat, lon, alt = geodesy.ecef_to_geodetic(p_e)
    assert distance(geodesy.geodetic_to_ecef(lat, lon, alt), p_e) < 2.0 * ROUNDING
    assert lat == pytest.approx(point[0], abs=ROUNDING / EARTH_RADIUS)
    assert alt == pytest.approx(point[2], abs=2.0 * ROUNDING)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_the_poles_come_back(sign):
    lat, _, alt = geodesy.ecef_to_geodetic((0.0, 0.0, sign * (geodesy.SEMI_MINOR + 100.0)))
    assert lat == sign * math.pi / 2
    assert alt == pytest.approx(100.0, abs=NANOMETRE)


@given(points, points)
def test_ned_is_pymap3ds(origin, point):
    plane = geodesy.tangent_plane(*origin)
    expected = pymap3d.geodetic2ned(*point, *origin, deg=False)
    assert distance(geodesy.geodetic_to_ned(plane, *point), expected) < 2.0 * ROUNDING


@given(points, flown)
def test_ned_comes_back(origin, p_n):
    plane = geodesy.tangent_plane(*origin)
    there = geodesy.ned_to_geodetic(plane, p_n)
    assert distance(geodesy.geodetic_to_ned(plane, *there), p_n) < 2.0 * ROUNDING


def test_the_origin_of_a_plane():
    p_n = geodesy.geodetic_to_ned(ZURICH, ZURICH.lat, ZURICH.lon, ZURICH.alt + 10.0)
    assert distance(p_n, (0.0, 0.0, -10.0)) < ROUNDING


def test_the_earth_falls_off_0_7_m_at_3_km():
    lat, lon, _ = geodesy.ned_to_geodetic(ZURICH, (3000.0, 0.0, 0.0))
    down = geodesy.geodetic_to_ned(ZURICH, lat, lon, ZURICH.alt)[2]
    assert down == pytest.approx(0.7, abs=0.02)


@given(st.tuples(st.floats(-1.5, 1.5), longitudes), flown)
def test_level_rotation_is_how_a_step_looks_in_the_plane(origin, p_n):
    plane = geodesy.tangent_plane(*origin, 0.0)
    lat, lon, alt = geodesy.ned_to_geodetic(plane, p_n)
    step = (3.0, -2.0, 1.0)
    after = pymap3d.ned2geodetic(*step, lat, lon, alt, deg=False)
    moved = sub(geodesy.geodetic_to_ned(plane, *map(float, after)), p_n)
    assert distance(matvec(geodesy.R_level(plane, lat, lon), step), moved) < 1e-7


def test_level_rotation_at_the_origin_is_none():
    np.testing.assert_allclose(
        geodesy.R_level(ZURICH, ZURICH.lat, ZURICH.lon), np.eye(3), atol=1e-15
    )
