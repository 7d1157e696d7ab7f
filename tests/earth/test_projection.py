import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.earth.geodesy import ned_to_geodetic, tangent_plane
from vfguide.earth.projection import (
    EARTH_RADIUS,
    Projection,
    geodetic_of,
    project,
    reproject,
)

MICRORADIAN_E3 = 1e-9
METRES = MICRORADIAN_E3 * EARTH_RADIUS

latitudes = st.floats(-math.pi / 2, math.pi / 2)
longitudes = st.floats(-3.14, 3.14)
offsets = st.floats(-2e6, 2e6)


def haversine(lat0, lon0, lat, lon):
    a = math.sin((lat - lat0) / 2) ** 2
    b = math.cos(lat0) * math.cos(lat) * math.sin((lon - lon0) / 2) ** 2
    return 2.0 * EARTH_RADIUS * math.asin(math.sqrt(min(1.0, a + b)))


@given(latitudes, longitudes, latitudes, longitudes)
def test_distances_from_the_origin_are_those_on_the_sphere(lat0, lon0, lat, lon):
    great_circle = haversine(lat0, lon0, lat, lon)
    if great_circle < 3.0 * EARTH_RADIUS:
        assert math.hypot(*project(lat0, lon0, lat, lon)) == pytest.approx(
            great_circle, rel=1e-12, abs=1e-6
        )


@pytest.mark.parametrize("metres", [0.0, 1e-6, 1.0, 1e3, 1e6])
def test_due_north_and_along_the_equator(metres):
    angle = metres / EARTH_RADIUS
    assert project(0.3, 0.7, 0.3 + angle, 0.7) == pytest.approx((metres, 0.0), abs=1e-8)
    assert project(0.0, 0.7, 0.0, 0.7 + angle) == pytest.approx((0.0, metres), abs=1e-8)


@given(st.floats(-1.5, 1.5), longitudes, offsets, offsets)
def test_a_position_comes_back(lat0, lon0, x, y):
    lat, lon = reproject(lat0, lon0, x, y)
    assert -math.pi / 2 <= lat <= math.pi / 2
    assert -math.pi <= lon < math.pi
    assert project(lat0, lon0, lat, lon) == pytest.approx((x, y), abs=METRES)


@given(st.floats(-1.5, 1.5), longitudes, st.floats(-1.5, 1.5), longitudes)
def test_a_latitude_and_longitude_come_back(lat0, lon0, lat, lon):
    if haversine(lat0, lon0, lat, lon) < 3.0 * EARTH_RADIUS:
        there = reproject(lat0, lon0, *project(lat0, lon0, lat, lon))
        assert there == pytest.approx((lat, lon), abs=MICRORADIAN_E3)


def test_across_the_date_line():
    lat0, lon0 = 0.2, math.pi - 1e-5
    x, y = project(lat0, lon0, 0.2, -math.pi + 1e-5)
    assert 0.0 < y < 200.0
    assert reproject(lat0, lon0, x, y) == pytest.approx((0.2, -math.pi + 1e-5), abs=1e-12)


def test_three_metres_off_the_tangent_plane_one_kilometre_east():
    plane = tangent_plane(math.radians(46.8), math.radians(8.0), 0.0)
    lat, lon, _ = ned_to_geodetic(plane, (0.0, 1000.0, 0.0))
    _, east = project(plane.lat, plane.lon, lat, lon)
    assert abs(east - 1000.0) == pytest.approx(3.0, abs=0.2)


@pytest.mark.parametrize("kind", Projection, ids=lambda kind: kind.name)
def test_every_kind_of_frame_is_about_its_origin_and_true_near_it(kind):
    assert geodetic_of(int(kind), 0.8, 0.1, 0.0, 0.0) == pytest.approx((0.8, 0.1))
    north, east = geodetic_of(int(kind), 0.8, 0.1, 10.0, 20.0)
    assert haversine(0.8, 0.1, north, east) == pytest.approx(math.hypot(10.0, 20.0), rel=2e-3)


def test_px4s_frame_is_the_azimuthal_equidistant_one():
    there = geodetic_of(int(Projection.AZIMUTHAL_EQUIDISTANT), 0.8, 0.1, 3e5, -2e5)
    assert there == reproject(0.8, 0.1, 3e5, -2e5)


def test_a_frame_of_no_known_kind_gives_no_numbers():
    assert all(math.isnan(each) for each in geodetic_of(len(Projection), 0.8, 0.1, 10.0, 20.0))
