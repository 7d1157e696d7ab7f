"""Over what is in the way: which obstacles a height passes, and what it costs."""

import math

import numpy as np
import pytest
from aeroplanes import AEROSONDE
from flight_states import GAINS, state
from guidance_targets import GOAL
from hypothesis import given
from hypothesis import strategies as st

from vfguide.airspace.footprint import Band
from vfguide.field.obstacle import Obstacle, obstacle_rows, put_out_of_sight
from vfguide.geometry.shapes import shape
from vfguide.planning.overflight import (
    HEIGHT_COST,
    MAX_LEVELS,
    NO_LEVEL,
    PASSED_MARGIN,
    AltitudePlan,
    aim_at,
    altitude_plan_by,
    altitude_plan_left,
    band_of,
    change_length,
    cost_of,
    distance_beside,
    is_passed,
    left_in_path,
    levels_for,
)

MARGIN = 25.0
HERE, THERE = (0.0, 0.0, -70.0), (2000.0, 0.0, -70.0)
OPEN = -math.inf
STILL = (0.0, 0.0, 0.0)


def ridge(north: float, wide: float = 1600.0, top: float = 110.0, bottom: float = 0.0, v_n=STILL):
    body = shape.box((80.0, wide, top - bottom))
    return Obstacle(body, (north, 0.0, -0.5 * (top + bottom)), v_n=v_n)


def by(
    level: float, rise: float = 400.0, fall: float = 700.0, here=HERE, there=THERE
) -> AltitudePlan:
    return AltitudePlan(here, there, level, rise, fall)


def left(heights: AltitudePlan, *obstacles: Obstacle) -> int:
    return len(left_in_path(obstacle_rows(list(obstacles)), heights, MARGIN))


@pytest.mark.parametrize(("level", "stays"), [(-135.1, 0), (-134.9, 1), (-70.0, 1), (0.0, 1)])
def test_a_ridge_is_passed_by_its_margin_or_not_at_all(level, stays):
    assert left(by(level), ridge(700.0)) == stays


def test_nothing_is_passed_under():
    assert left(by(-100.0), ridge(700.0, top=300.0, bottom=150.0)) == 1


@pytest.mark.parametrize(("north", "stays"), [(466.0, 0), (464.0, 1), (1234.0, 0), (1236.0, 1)])
def test_what_is_met_on_the_way_up_or_down_stays_in_the_way(north, stays):
    """25 m and half of its 80 m before the end of the climb, or after the beginning of the fall."""
    assert left(by(-140.0), ridge(north)) == stays


def test_what_is_passed_at_the_height_of_an_end_as_well_may_be_near_it():
    high = (0.0, 0.0, -140.0)
    assert left(by(-140.0, here=high), ridge(60.0)) == 0
    assert left(by(-140.0, here=high, there=(2000.0, 0.0, -136.0)), ridge(1990.0)) == 0


@pytest.mark.parametrize("v_n", [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, -1.0)])
def test_what_moves_is_not_passed_so(v_n):
    assert left(by(-300.0), ridge(700.0, v_n=v_n)) == 1


def test_without_a_level_everything_stays():
    assert left(by(NO_LEVEL), ridge(700.0), ridge(900.0, top=20.0)) == 2
    assert band_of(by(NO_LEVEL)) == Band(-70.0, -70.0)
    assert band_of(by(-140.0)) == Band(-140.0, -70.0)
    assert band_of(by(-30.0)) == Band(-70.0, -30.0)


@given(st.floats(-300.0, 300.0), st.floats(-600.0, 600.0))
def test_the_distance_of_a_long_ridge_is_that_of_its_side(north, east):
    distance = distance_beside(obstacle_rows([ridge(0.0)]), 0, (north, east, 0.0))
    assert distance == pytest.approx(abs(north) - 40.0, abs=8.0)


@pytest.mark.parametrize("up", [60.0, 20.0, -60.0])
def test_a_change_of_height_takes_longer_downwind_and_with_less_of_the_slope(up):
    calm = change_length(up, 0.7, STILL, AEROSONDE, GAINS)
    assert calm > abs(up) / math.tan(AEROSONDE.climb_max)
    assert change_length(up, 0.9, STILL, AEROSONDE, GAINS) < calm
    assert change_length(up, 0.7, (3.0, -4.0, 0.0), AEROSONDE, GAINS) > calm
    assert change_length(0.0, 0.7, STILL, AEROSONDE, GAINS) == 0.0


def test_on_the_way_up_less_path_is_enough_than_was_planned():
    """Else a gust that is taken for the wind would end it."""
    here = state((-1500.0, 0.0, -100.0), 0.0)
    planned = altitude_plan_by(-190.0, here, GOAL, AEROSONDE, GAINS)
    windier = here._replace(wind_n=(5.0, 0.0, 0.0))
    now = altitude_plan_left(-190.0, planned.fall, windier, GOAL, AEROSONDE, GAINS)
    assert now.rise < planned.rise
    assert now.fall == planned.fall


def test_levels_are_those_that_pass_something_under_the_ceiling():
    rows = obstacle_rows([ridge(700.0), ridge(900.0, top=150.0, bottom=120.0)])
    assert levels_for(rows, -70.0, -80.0, -210.0, MARGIN).tolist() == [-70.0, -80.0, -135.0, -175.0]
    assert levels_for(rows, -70.0, -80.0, -174.0, MARGIN).tolist() == [-70.0, -80.0, -135.0]
    assert levels_for(rows, -70.0, -80.0, math.inf, MARGIN).tolist() == [-70.0]  # as high as it is


def test_equal_levels_are_tried_once_and_the_costliest_always():
    tops = [140.0] * 20 + [150.0 + k for k in range(20)]
    rows = obstacle_rows([ridge(700.0, top=top) for top in tops])
    levels = levels_for(rows, -70.0, -80.0, OPEN, MARGIN).tolist()
    assert len(levels) == len(set(levels)) == MAX_LEVELS
    assert levels[:3] == [-70.0, -80.0, -140.0 - MARGIN]
    assert levels[-1] == -169.0 - MARGIN


@pytest.mark.parametrize(
    ("up", "passed"), [(PASSED_MARGIN + 0.1, True), (PASSED_MARGIN - 0.1, False)]
)
def test_what_is_under_the_vehicle_already_is_passed_by_a_level_that_is_no_lower(up, passed):
    here = (700.0, 0.0, -110.0 - up)
    heights = by(-110.0 - MARGIN, here=here, there=(3000.0, 0.0, -70.0))
    assert is_passed(obstacle_rows([ridge(700.0)]), 0, heights, MARGIN) == passed


def test_no_level_is_below_both_ends():
    """Nobody knows of the ground."""
    rows = obstacle_rows([ridge(700.0, top=10.0), ridge(700.0, top=30.0)])
    assert levels_for(rows, -70.0, -60.0, OPEN, MARGIN).tolist() == [-70.0, -60.0]
    assert -55.0 in levels_for(rows, -80.0, -40.0, OPEN, MARGIN).tolist()


def test_levels_for_what_moves_or_is_not_known_are_none():
    rows = obstacle_rows([ridge(700.0, v_n=(0.0, 3.0, 0.0)), ridge(900.0, top=150.0)])
    put_out_of_sight(rows[1])
    assert levels_for(rows, -70.0, -80.0, OPEN, MARGIN).tolist() == [-70.0, -80.0]


@given(st.floats(-300.0, 0.0), st.floats(-300.0, 0.0), st.floats(-300.0, 0.0))
def test_a_level_between_the_ends_costs_nothing(level, here, goal):
    beyond = max(0.0, level - max(here, goal)) + max(0.0, min(here, goal) - level)
    assert cost_of(level, here, goal) == pytest.approx(2.0 * HEIGHT_COST * beyond, abs=1e-9)


def test_levels_come_cheapest_first():
    rng = np.random.default_rng(3)
    rows = obstacle_rows([ridge(700.0, top=high) for high in rng.uniform(20.0, 400.0, 9)])
    costs = [cost_of(z, -70.0, -110.0) for z in levels_for(rows, -70.0, -110.0, OPEN, MARGIN)]
    assert costs == sorted(costs)
    assert len(costs) > 5


def test_the_level_is_aimed_at_until_the_fall():
    assert aim_at(-200.0, 500.0, GOAL, 501.0).p_n == (*GOAL.p_n[:2], -200.0)
    assert aim_at(-200.0, 500.0, GOAL, 500.0) == GOAL
    assert aim_at(NO_LEVEL, 500.0, GOAL, 501.0) == GOAL
    circle = GOAL._replace(circle=-1.0, radius=90.0)
    assert aim_at(-200.0, 500.0, circle, math.inf) == circle, "a hold is at its own height"
