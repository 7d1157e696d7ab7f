"""Sides of polygons and upright bodies against winding numbers, dense samples and optimisation."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from vfguide.geometry.polygon import prism_distance, prism_distances, side_from, signed_root

PLACE = st.floats(-100.0, 100.0)
CORNERS = st.lists(st.tuples(PLACE, PLACE), min_size=3, max_size=9)


def distance(corners, x, y):
    seen = [
        side_from(*one, *other, x, y)
        for one, other in zip(corners, corners[1:] + corners[:1], strict=True)
    ]
    return signed_root(min(s.square for s in seen), sum(s.crosses for s in seen) % 2 == 1)


@given(CORNERS, PLACE, PLACE)
def test_a_point_is_inside_where_the_polygon_winds_round_it_an_odd_number_of_times(corners, x, y):
    found = distance(corners, x, y)
    assume(abs(found) > 1e-6)
    angles = [math.atan2(b - y, a - x) for a, b in corners]
    pairs = zip(angles, angles[1:] + angles[:1], strict=True)
    turns = [math.remainder(b - a, 2.0 * math.pi) for a, b in pairs]
    assert (found < 0.0) == (round(sum(turns) / (2.0 * math.pi)) % 2 == 1)


@given(PLACE, PLACE, PLACE, PLACE, PLACE, PLACE)
def test_the_distance_from_a_side_is_that_of_its_nearest_point(x0, y0, x1, y1, x, y):
    shares = np.linspace(0.0, 1.0, 4001)
    dense = np.hypot(x0 + shares * (x1 - x0) - x, y0 + shares * (y1 - y0) - y).min()
    found = math.sqrt(side_from(x0, y0, x1, y1, x, y).square)
    assert found <= dense + 1e-9
    assert found == pytest.approx(dense, abs=0.1)


def test_a_side_without_length_is_a_point():
    assert side_from(1.0, 2.0, 1.0, 2.0, 4.0, 6.0) == (25.0, False)


def test_outside_of_an_upright_body_the_nearest_edge_counts():
    beside, above = np.array([3.0, -3.0, 3.0, -3.0]), np.array([4.0, 4.0, -4.0, -4.0])
    assert prism_distances(beside, above) == pytest.approx([5.0, 4.0, 3.0, -3.0])


@given(PLACE, PLACE)
def test_the_distance_from_an_upright_body_is_1_lipschitz_and_zero_on_its_surface(beside, above):
    assume(min(abs(beside), abs(above)) > 1e-100)  # whose squares are numbers
    here = prism_distance(beside, above)
    there = prism_distance(beside + 0.3, above - 0.4)
    assert abs(there - here) <= 0.5 + 1e-9
    assert (here <= 0.0) == (beside <= 0.0 and above <= 0.0)
