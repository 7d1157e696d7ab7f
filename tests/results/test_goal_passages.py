"""Passes of goals against flights that are known in closed form."""

import math

import numpy as np
import pytest
from flight_samples import Path3, moved, spiral, straight
from hypothesis import given
from hypothesis import strategies as st

from vfguide.geometry.vector import Vec3
from vfguide.results.goal_passages import Legs, Pass, Sample, interpolate
from vfguide.scenario.resolved import Goal

pytestmark = pytest.mark.slow

ORIGIN = (0.0, 0.0, -100.0)


def goal(
    position: Vec3 = ORIGIN,
    heading_deg: float = 0.0,
    climb_deg: float = 0.0,
    tolerance_m: float = 5.0,
    tolerance_deg: float = 10.0,
    attempts: int = 0,
) -> Goal:
    return Goal(
        position_m=position,
        heading_deg=heading_deg,
        climb_deg=climb_deg,
        tolerance_m=tolerance_m,
        tolerance_deg=tolerance_deg,
        attempts=attempts,
    )


def samples(path: Path3, seconds: float, rate: float) -> list[Sample]:
    time = np.arange(round(seconds * rate) + 1) / rate
    h = 1e-5
    p_n, v_n = path(time), (path(time + h) - path(time - h)) / (2.0 * h)
    rows = zip(time.tolist(), p_n.tolist(), v_n.tolist(), strict=True)
    return [Sample(t, tuple(p), tuple(v)) for t, p, v in rows]


def fly(goals: list[Goal], path: Path3, seconds: float, rate: float = 50.0) -> Legs:
    legs = Legs(goals)
    for sample in samples(path, seconds, rate):
        legs.feed(sample)
    return legs


def only_pass(legs: Legs) -> Pass:
    ((one,),) = legs.passes
    return one


@given(st.floats(-30.0, 30.0), st.floats(-30.0, 30.0), st.floats(-170.0, 170.0))
def test_a_straight_line_misses_by_its_distance(east: float, down: float, off: float) -> None:
    legs = fly([goal((3.3, east, down - 100.0), heading_deg=off)], straight, 30.0)
    its = only_pass(legs)
    assert its.miss == pytest.approx(math.hypot(east, down), abs=1e-6)
    assert its.time == pytest.approx(20.0 + 3.3 / 25.0, abs=1e-6)
    assert math.degrees(its.course_error) == pytest.approx(abs(off), abs=1e-6)
    assert its.climb_error == pytest.approx(0.0, abs=1e-9)


def circle(time: np.ndarray) -> np.ndarray:
    """North at first, then to the right about (0, 80), radius 80 m, 25 m/s."""
    angle = 25.0 / 80.0 * time
    return np.column_stack((80.0 * np.sin(angle), 80.0 - 80.0 * np.cos(angle), 0.0 * time - 100.0))


@pytest.mark.parametrize("rate", [10.0, 50.0, 200.0])
@given(st.floats(0.5, 5.5), st.floats(-30.0, 30.0))
def test_a_circle_misses_by_the_distance_from_its_rim(
    rate: float, angle: float, outside: float
) -> None:
    radius = 80.0 + outside
    at = (radius * math.sin(angle), 80.0 - radius * math.cos(angle), -100.0)
    course = math.degrees(angle)
    its = only_pass(fly([goal(at, heading_deg=course)], circle, 2 * math.pi * 80.0 / 25.0, rate))
    assert its.miss == pytest.approx(abs(outside), abs=1e-3)
    assert its.time == pytest.approx(angle * 80.0 / 25.0, abs=2e-3)
    assert math.degrees(its.course_error) == pytest.approx(0.0, abs=0.05)


def s_curve(time: np.ndarray) -> np.ndarray:
    """North at 25 m/s, swinging 40 m to both sides with a period of 20 s, climbing."""
    swing = 40.0 * np.sin(2.0 * np.pi * time / 20.0)
    return np.column_stack((25.0 * (time - 20.0), swing, -100.0 - 2.0 * time))


def test_an_s_through_the_goal_comes_within_a_millimetre() -> None:
    slope = 40.0 * 2.0 * math.pi / 20.0
    its = only_pass(fly([goal((0.0, 0.0, -140.0))], s_curve, 30.0))
    assert its.time == pytest.approx(20.0, abs=1e-5)
    assert its.miss < 1e-3
    assert its.course_error == pytest.approx(math.atan2(slope, 25.0), abs=1e-5)
    assert its.climb_error == pytest.approx(math.atan2(2.0, math.hypot(slope, 25.0)), abs=1e-5)


def test_course_errors_go_the_short_way_round() -> None:
    def south(time: np.ndarray) -> np.ndarray:
        return straight(time) * (-1.0, 1.0, 1.0) + 0.01 * time[:, None] * (0.0, 1.0, 0.0)

    its = only_pass(fly([goal((0.0, 0.2, -100.0), heading_deg=-179.0)], south, 30.0))
    assert math.degrees(its.course_error) == pytest.approx(1.023, abs=1e-3)


@pytest.mark.parametrize(
    ("position", "heading", "climb", "reaches"),
    [
        ((0.0, 4.999, -100.0), 0.0, 0.0, True),
        ((0.0, 5.001, -100.0), 0.0, 0.0, False),
        ((0.0, 0.0, -104.999), 0.0, 0.0, True),
        ((0.0, 0.0, -105.001), 0.0, 0.0, False),
        ((0.0, 0.0, -100.0), 9.999, 0.0, True),
        ((0.0, 0.0, -100.0), -10.001, 0.0, False),
        ((0.0, 0.0, -100.0), 0.0, 9.999, True),
        ((0.0, 0.0, -100.0), 0.0, -10.001, False),
    ],
)
def test_a_pass_reaches_up_to_each_tolerance(
    position: Vec3, heading: float, climb: float, reaches: bool
) -> None:
    legs = fly([goal(position, heading, climb)], straight, 30.0)
    assert only_pass(legs).reaches is reaches
    assert legs.finished is reaches


def test_feed_tells_the_sample_after_the_goal() -> None:
    legs = Legs([goal((0.3, 0.0, -100.0))])
    told = [sample.time for sample in samples(straight, 30.0, 50.0) if legs.feed(sample)]
    assert told == pytest.approx([20.02])


def test_goals_are_flown_in_order() -> None:
    ahead, behind = goal((100.0, 0.0, -100.0)), goal((-100.0, 0.0, -100.0))
    legs = fly([behind, ahead], straight, 30.0)
    assert [its.time for (its,) in legs.passes] == pytest.approx([16.0, 24.0])
    backward = fly([ahead, behind], straight, 30.0)
    assert [len(its) for its in backward.passes] == [1, 0]
    assert backward.leg == 1
    assert backward.best()[1] is None


def test_goals_between_two_samples_are_all_found() -> None:
    row = [goal((north, 0.0, -100.0)) for north in (0.1, 0.3, 0.6, 2.6)]
    legs = fly(row, straight, 30.0, rate=10.0)
    assert [its.time for (its,) in legs.passes] == pytest.approx([20.004, 20.012, 20.024, 20.104])


def test_the_end_of_one_leg_is_no_pass_of_the_next() -> None:
    twice = [goal(), goal()]
    assert [len(its) for its in fly(twice, straight, 30.0).passes] == [1, 0]


def test_a_path_that_begins_or_ends_at_the_goal_has_no_pass() -> None:
    assert fly([goal((-500.0, 0.0, -100.0))], straight, 30.0).best() == [None]
    assert fly([goal((250.0, 0.0, -100.0))], straight, 29.9).best() == [None]


def test_figures_are_of_the_nearest_pass_until_one_reaches() -> None:
    period = 2.0 * math.pi * 90.0 / 25.0
    level = -100.0 - 1.5 * 2.0 * period
    legs = fly([goal((0.0, 0.0, level), tolerance_m=0.5, climb_deg=3.43)], spiral, 3.4 * period)
    below, first, second = legs.passes[0]
    assert [below.reaches, first.reaches, second.reaches] == [False, False, True]
    assert below.miss > first.miss > second.miss
    assert legs.best() == [second]
    never = fly([goal((0.0, 0.0, level), tolerance_m=0.5, heading_deg=180.0)], spiral, 3.4 * period)
    assert not any(its.reaches for its in never.passes[0])
    assert [its.miss for its in never.passes[0]][:3] == [below.miss, first.miss, second.miss]
    assert len(never.passes[0]) == 4
    assert never.best() == [never.passes[0][2]]


@pytest.mark.parametrize(("attempts", "passes", "leg"), [(0, 4, 0), (1, 1, 1), (3, 3, 1)])
def test_a_goal_that_was_tried_often_enough_is_given_up(
    attempts: int, passes: int, leg: int
) -> None:
    period = 2.0 * math.pi * 80.0 / 25.0
    away = goal((500.0, 0.0, -100.0))
    rounds = moved(circle, (0.0, 5.0, 0.0))
    legs = fly([goal((10.0, 0.0, -100.0), 7.2, attempts=attempts), away], rounds, 3.5 * period)
    assert len(legs.passes[0]) == passes
    assert (legs.leg, legs.reached, legs.finished) == (leg, 0, False)


def test_after_the_last_goal_is_given_up_the_flight_is_over() -> None:
    legs = fly([goal((0.0, 10.0, -100.0), attempts=1)], straight, 30.0)
    assert legs.finished
    assert legs.reached == 0
    assert not only_pass(legs).reaches


@pytest.mark.parametrize(
    ("east", "heading", "leg"), [(49.0, 0.0, 1), (51.0, 0.0, 0), (9.0, 59.0, 1), (9.0, 61.0, 0)]
)
def test_only_a_pass_that_was_meant_for_the_goal_is_a_try(
    east: float, heading: float, leg: int
) -> None:
    assert fly([goal((0.0, east, -100.0), heading, attempts=1)], straight, 30.0).leg == leg


def test_a_standing_vehicle_passes_nothing() -> None:
    legs = Legs([goal()])
    for step in range(10):
        assert not legs.feed(Sample(0.1 * step, ORIGIN, (0.0, 0.0, 0.0)))
    assert legs.best() == [None]


def test_numbers_that_are_none_pass_nothing() -> None:
    legs = Legs([goal()])
    for sample in samples(straight, 30.0, 50.0):
        legs.feed(sample._replace(p_n=(math.nan, 0.0, 0.0)))
    assert legs.best() == [None]


@given(
    st.lists(st.floats(-1e3, 1e3), min_size=12, max_size=12),
    st.floats(0.01, 1.0),
    st.floats(0.0, 1.0),
)
def test_interpolation_is_exact_for_cubics(
    coefficients: list[float], span: float, part: float
) -> None:
    powers = np.array(coefficients).reshape(4, 3)

    def at(s: float) -> Sample:
        p = powers[0] + s * powers[1] + s**2 * powers[2] + s**3 * powers[3]
        v = powers[1] + 2.0 * s * powers[2] + 3.0 * s**2 * powers[3]
        return Sample(s, tuple(p.tolist()), tuple(v.tolist()))

    between = interpolate(at(0.0), at(span), part * span)
    assert between.p_n == pytest.approx(at(part * span).p_n, abs=1e-8)
    assert between.v_n == pytest.approx(at(part * span).v_n, abs=1e-6)
