"""Polygons whose sides cross, against those that are drawn so that they cannot."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.geometry.crossing_sides import crossing_sides

RADII = st.lists(st.integers(10, 1000), min_size=3, max_size=12)


def star(radii):
    """A star-shaped polygon round the origin: its sides cannot cross."""
    step = 2.0 * math.pi / len(radii)
    return [(r * math.cos(i * step), r * math.sin(i * step)) for i, r in enumerate(radii)]


@given(RADII, st.integers(0, 11))
def test_a_star_shaped_polygon_is_in_order_also_with_a_corner_repeated(radii, at):
    corners = star(radii)
    assert crossing_sides(corners) is None
    at %= len(corners)
    assert crossing_sides([*corners[: at + 1], *corners[at:]]) is None
    assert crossing_sides([*corners, corners[0]]) is None


@given(st.lists(st.integers(10, 1000), min_size=4, max_size=4))
def test_two_corners_exchanged_make_sides_cross(radii):
    a, b, c, d = star(radii)
    assert crossing_sides([a, c, b, d]) is not None


@pytest.mark.parametrize(
    ("corners", "sides"),
    [
        ([(0, 0), (100, 100), (100, 0), (0, 100)], (1, 3)),
        ([(0, 0), (100, 0), (50, 0)], (1, 2)),
        ([(0, 0), (100, 0), (100, 100), (50, 0), (0, 100)], (1, 3)),
    ],
)
def test_the_sides_are_named(corners, sides):
    assert crossing_sides(corners) == sides
