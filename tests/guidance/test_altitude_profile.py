"""The height profile ends at the goal's height with the goal's slope."""

import pytest

from vfguide.aircraft.performance import turn_length
from vfguide.geometry.units import G0
from vfguide.guidance.altitude_profile import (
    GENTLE_SLOPE,
    SMALL_ERROR_DISTANCE,
    STANDOFF,
    WAIT_DISTANCE,
    goal_slope,
)
from vfguide.paths.distance_for_altitude import (
    LINE_UP,
    RAMP,
    SLOPE_RATE,
    distance_for_altitude,
    profile_height,
)

SLOPES = [0.0, 0.1, -0.12]
UNIT = turn_length(25.0)


@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("height", [60.0, 5.0, -40.0])
def test_an_error_of_height_falls_in_a_line_and_ends_as_a_parabola(height, slope):
    whole, step = 800.0, 0.05
    line_up = LINE_UP * UNIT
    off = height - profile_height(whole, slope, UNIT)
    steady = off / (whole - 0.5 * line_up)
    remaining = whole
    while remaining > STANDOFF * UNIT:
        height += step * goal_slope(height, remaining, slope, UNIT)
        remaining -= step
        left = steady * (remaining - 0.5 * line_up)
        if remaining < line_up:
            left = steady * 0.5 * remaining**2 / line_up
        error = height - profile_height(remaining, slope, UNIT)
        most, waits = max(0.0, left), remaining - 0.5 * line_up - WAIT_DISTANCE * UNIT
        if waits > 0.0:
            most = max(most, min(off, GENTLE_SLOPE * (waits + SMALL_ERROR_DISTANCE * UNIT)))
        assert min(0.0, left) - 0.02 <= error <= most + 0.02


@pytest.mark.parametrize("height", [0.5, 10.0, 40.0])
def test_height_is_kept_until_a_gentle_descent_is_due(height):
    """It is what air that sinks can take: no metre is given away before."""
    due = height / GENTLE_SLOPE + (WAIT_DISTANCE + 0.5 * LINE_UP) * UNIT
    assert goal_slope(height, due + 1.0, 0.0, UNIT) == 0.0
    assert goal_slope(height, due - 10.0, 0.0, UNIT) < -0.01
    assert goal_slope(-height, due + 1.0, 0.0, UNIT) > 0.01


@pytest.mark.parametrize("slope", [0.07, 0.1])
def test_a_descent_that_has_to_be_steep_begins_at_once(slope):
    remaining = 1000.0
    over = remaining - 0.5 * LINE_UP * UNIT
    assert goal_slope(slope * over, remaining, 0.0, UNIT) == pytest.approx(-slope)


@pytest.mark.parametrize("slope", SLOPES)
def test_the_profile_ends_at_the_goal_with_its_slope_and_is_level_far_away(slope):
    assert profile_height(0.0, slope, UNIT) == 0.0
    step = 1e-4
    assert profile_height(step, slope, UNIT) / step == pytest.approx(-slope, abs=1e-5)
    assert profile_height(LINE_UP * UNIT, slope, UNIT) == profile_height(
        5.0 * LINE_UP * UNIT, slope, UNIT
    )


@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("remaining", [35.0, 60.0, 99.0, 400.0])
def test_on_the_profile_the_slope_is_the_profiles(slope, remaining):
    step = 1e-4
    rise = profile_height(remaining - step, slope, UNIT) - profile_height(
        remaining + step, slope, UNIT
    )
    on_it = profile_height(remaining, slope, UNIT)
    assert goal_slope(on_it, remaining, slope, UNIT) == pytest.approx(rise / (2.0 * step), abs=1e-6)


@pytest.mark.parametrize("before", [0.0, 0.06, -0.1, 0.3])
@pytest.mark.parametrize("height", [50.0, 5.0, 0.5, -2.0, -50.0])
def test_a_change_of_height_takes_the_path_needed_with_its_ramps(height, before):
    """What `plan_slope` may do, done as fast as planned: up to the slope, along it, and back."""
    most, ramp, step = 0.1, RAMP * SLOPE_RATE / (G0 * UNIT), 0.01
    sign = -1.0 if height > 0.0 else 1.0  # of the slope
    needed = distance_for_altitude(height, 1000.0, 0.0, most, UNIT, before)
    left, slope, flown = abs(height), max(-most, min(most, sign * before)), 0.0
    while abs(left) > 1e-3 or abs(slope) > 1e-3:
        lowering = slope * abs(slope) / (2.0 * ramp)  # what the ramp back still takes away
        slope += step * ramp if left > lowering else -step * ramp
        slope = max(-most, min(most, slope))
        left -= step * slope
        flown += step
    assert needed == pytest.approx(flown, abs=0.5)


def test_a_level_flight_at_its_height_needs_no_path():
    assert distance_for_altitude(0.0, 1000.0, 0.0, 0.1, UNIT, 0.0) == 0.0


@pytest.mark.parametrize("times", [0.2, 3.0])
def test_the_profile_of_another_aircraft_is_the_same_in_turn_lengths(times):
    for height, remaining, slope in ((20.0, 300.0, 0.1), (-8.0, 60.0, 0.0), (1.0, 10.0, -0.12)):
        large, far, unit = times * height, times * remaining, times * UNIT
        there = goal_slope(large, far, slope, unit)
        assert there == pytest.approx(goal_slope(height, remaining, slope, UNIT))
        needed = distance_for_altitude(large, far, slope, 0.1, unit, 0.03)
        assert needed == pytest.approx(
            times * distance_for_altitude(height, remaining, slope, 0.1, UNIT, 0.03)
        )
