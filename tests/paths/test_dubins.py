"""The yardstick of path lengths, against paths put together of its own pieces."""

import math

import pytest
from dubins import dubins_length
from hypothesis import given
from hypothesis import strategies as st

WORDS = [(1, 0, 1), (-1, 0, -1), (1, 0, -1), (-1, 0, 1), (1, -1, 1), (-1, 1, -1)]
turns = st.floats(0.0, 3.0)


def along(pose, curvature, length):
    x, y, course = pose
    after = course + curvature * length
    if curvature == 0:
        return (x + length * math.cos(course), y + length * math.sin(course), course)
    dx, dy = math.sin(after) - math.sin(course), math.cos(course) - math.cos(after)
    return (x + dx / curvature, y + dy / curvature, after)


@given(st.sampled_from(WORDS), turns, st.floats(0.0, 6.0), turns, st.floats(1.0, 100.0))
def test_no_path_of_three_pieces_is_shorter(path, first, middle, last, radius):
    end = (0.0, 0.0, 0.0)
    for curvature, length in zip(path, (first, middle, last), strict=True):
        end = along(end, curvature, length)
    scaled = (radius * end[0], radius * end[1], end[2])
    shortest = dubins_length((0.0, 0.0, 0.0), scaled, radius)
    assert shortest <= radius * (first + middle + last) * (1.0 + 1e-6) + 1e-6 * radius
    assert shortest >= math.hypot(*scaled[:2]) * (1.0 - 1e-9) - 1e-9 * radius


@pytest.mark.parametrize(
    ("end", "length"),
    [
        ((40.0, 0.0, 0.0), 40.0),
        ((0.0, 20.0, math.pi), 10.0 * math.pi),
        ((0.0, 40.0, math.pi), 20.0 + 10.0 * math.pi),
        ((10.0, 10.0, 0.5 * math.pi), 5.0 * math.pi),
    ],
    ids=["straight", "half a circle", "two quarters", "a quarter"],
)
def test_paths_worked_by_hand(end, length):
    assert dubins_length((0.0, 0.0, 0.0), end, 10.0) == pytest.approx(length)
