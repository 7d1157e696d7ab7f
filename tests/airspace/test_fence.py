import numpy as np
import pytest

from vfguide.airspace.fence import Zone, fence_distance, fences

SQUARE = ((0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0))
CORNER = ((0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (60.0, 100.0), (60.0, 40.0), (0.0, 40.0))


def distance(zone, north, east, height=50.0):
    return fence_distance(fences([zone]), 0, (north, east, -height))


@pytest.mark.parametrize("corners", [SQUARE, SQUARE[::-1], SQUARE[2:] + SQUARE[:2]])
def test_square(corners):
    stay_in, stay_out = Zone(True, corners), Zone(False, corners)
    for north, east, inside in ((50.0, 50.0, 50.0), (10.0, 50.0, 10.0), (-3.0, -4.0, -5.0)):
        assert distance(stay_in, north, east) == pytest.approx(inside)
        assert distance(stay_out, north, east) == pytest.approx(-inside)


def test_a_polygon_need_not_be_convex():
    zone = Zone(True, CORNER)
    assert distance(zone, 20.0, 60.0) == pytest.approx(-20.0)
    assert distance(zone, 80.0, 60.0) == pytest.approx(20.0)
    assert distance(zone, 57.0, 44.0) == pytest.approx(-3.0)
    assert distance(zone, 63.0, 36.0) == pytest.approx(5.0)


def test_circle():
    zone = Zone(False, ((10.0, 20.0),), 30.0)
    assert distance(zone, 10.0, 60.0) == pytest.approx(10.0)
    assert distance(zone, 10.0, 25.0) == pytest.approx(-25.0)


def test_heights():
    stay_in = Zone(True, SQUARE, lowest=30.0, highest=120.0)
    stay_out = Zone(False, SQUARE, lowest=30.0, highest=120.0)
    assert distance(stay_in, 50.0, 50.0, 35.0) == pytest.approx(5.0)
    assert distance(stay_in, 50.0, 50.0, 130.0) == pytest.approx(-10.0)
    assert distance(stay_out, 50.0, 50.0, 20.0) == pytest.approx(10.0)
    assert distance(stay_out, -30.0, 50.0, 160.0) == pytest.approx(50.0)
    assert distance(stay_out, 50.0, 50.0, 119.0) == pytest.approx(-1.0)


def test_the_distance_changes_no_faster_than_the_point_moves():
    rng = np.random.default_rng(1)
    zones = [Zone(True, CORNER), Zone(False, CORNER, highest=60.0), Zone(False, ((0, 0),), 30.0)]
    packed = fences(zones)
    for _ in range(2000):
        p = rng.uniform(-150.0, 150.0, 3)
        step = rng.normal(size=3) * 10.0
        i = int(rng.integers(len(zones)))
        before, after = (fence_distance(packed, i, tuple(map(float, q))) for q in (p, p + step))
        assert abs(after - before) <= np.linalg.norm(step) + 1e-9


@pytest.mark.parametrize(
    "zone",
    [
        Zone(True, SQUARE[:2]),
        Zone(True, SQUARE, 10.0),
        Zone(True, SQUARE[:1]),
        Zone(True, SQUARE, lowest=10.0, highest=10.0),
    ],
)
def test_what_is_not_a_zone(zone):
    with pytest.raises(ValueError, match="zone"):
        fences([zone])
