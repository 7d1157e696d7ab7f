"""The height profile ends at the goal's height with the goal's slope."""

import pytest

from vfguide.flight.vertical import STANDOFF, goal_slope, path_needed


@pytest.mark.parametrize("slope", [0.0, 0.1, -0.12])
@pytest.mark.parametrize("height", [60.0, 5.0, -40.0])
def test_the_profile_is_the_parabola_that_ends_at_the_goal(height, slope):
    whole, step = 800.0, 0.05
    off = height + slope * whole  # from the goal's own line
    remaining = whole
    while remaining > STANDOFF:
        height += step * goal_slope(height, remaining, slope)
        remaining -= step
    left = off * (remaining / whole) ** 2
    assert height + slope * remaining == pytest.approx(left, abs=0.01)
    assert goal_slope(height, remaining, slope) == pytest.approx(
        slope - 2.0 * left / remaining, abs=1e-3
    )


def test_on_the_goals_line_the_slope_is_the_goals():
    assert goal_slope(-0.1 * 300.0, 300.0, 0.1) == pytest.approx(0.1)


def test_a_profile_at_the_steepest_slope_takes_the_path_needed():
    assert path_needed(50.0, 1000.0, 0.0, 0.1) == 500.0
    assert path_needed(-50.0, 1000.0, 0.0, 0.1) == 500.0
