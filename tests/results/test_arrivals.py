"""Arrivals of law paper: where a goal is passed, in which pose, and who stands."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from vfguide.geometry.units import DEG
from vfguide.results.arrivals import ARRIVED, Arrivals, arrival_radius, entry
from vfguide.results.goal_passages import Sample
from vfguide.scenario.resolved import Goal

POINT = st.tuples(*[st.floats(-3.0, 3.0)] * 3)
NOSE = (1.0, 0.0, 0.0)


def goal(
    north=0.0, heading_deg=0.0, climb_deg=0.0, tolerance_m=5.0, tolerance_deg=10.0, attempts=0
):
    return Goal(
        position_m=(north, 0.0, 0.0),
        heading_deg=heading_deg,
        climb_deg=climb_deg,
        tolerance_m=tolerance_m,
        tolerance_deg=tolerance_deg,
        attempts=attempts,
    )


def nose_at(heading_deg, climb_deg=0.0):
    heading, climb = heading_deg * DEG, climb_deg * DEG
    level = math.cos(climb)
    return (level * math.cos(heading), level * math.sin(heading), -math.sin(climb))


def fly(goals, rows):
    """Rows: time, north, nose."""
    legs = Arrivals(goals)
    for time, north, nose in rows:
        legs.feed(Sample(time, (north, 0.0, 0.0), nose))
    return legs


@given(POINT, POINT, st.floats(0.05, 1.0))
def test_entry_is_where_the_path_is_first_within_the_radius(p, way, radius):
    s = np.linspace(0.0, 1.0, 2001)
    distance = np.linalg.norm(np.array(p) + s[:, None] * np.array(way), axis=1)
    assume(abs(distance.min() - radius) > 1e-4)
    found = entry(p, way, radius)
    inside = np.flatnonzero(distance <= radius)
    if inside.size == 0:
        assert found is None
    else:
        assert found == pytest.approx(s[inside[0]], abs=5.1e-4)


def test_entry_of_one_who_stands():
    assert entry((0.05, 0.0, 0.0), (0.0, 0.0, 0.0), 0.05) == 0.0
    assert entry((0.06, 0.0, 0.0), (0.0, 0.0, 0.0), 0.05) is None


@pytest.mark.parametrize(("tolerance", "radius"), [(5.0, 0.05), (0.05, 0.05), (0.02, 0.02)])
def test_a_goal_is_passed_at_5_cm_or_at_the_tolerance(tolerance, radius):
    its = goal(tolerance_m=tolerance)
    assert arrival_radius(its) == radius
    legs = fly([its], [(0.0, -1.0, NOSE), (1.0, -radius - 1e-9, NOSE)])
    assert not legs.passes[0]
    legs.feed(Sample(2.0, (-radius + 1e-9, 0.0, 0.0), NOSE))
    ((passed,),) = legs.passes
    assert passed.reaches
    assert passed.miss == pytest.approx(radius, abs=1e-12)


def test_time_and_nose_are_those_of_the_entry():
    legs = fly([goal(heading_deg=2.5)], [(4.0, -0.25, nose_at(0.0)), (5.0, 0.15, nose_at(10.0))])
    ((passed,),) = legs.passes
    assert passed.time == pytest.approx(4.5)  # half the way, from 0.25 m to 0.05 m
    assert passed.course_error == pytest.approx(2.5 * DEG, abs=1e-4)
    assert passed.miss == pytest.approx(ARRIVED)


@pytest.mark.parametrize(
    ("heading", "climb", "reaches"),
    [(9.9, 0.0, True), (10.1, 0.0, False), (0.0, -9.9, True), (0.0, 10.1, False)],
)
def test_a_goal_that_is_met_askew_is_not_reached_and_ends_the_flight(heading, climb, reaches):
    nose = nose_at(heading, climb)
    legs = fly([goal(), goal(50.0)], [(0.0, -1.0, nose), (1.0, 0.0, nose)])
    assert legs.passes[0][0].reaches == reaches
    assert legs.standing != reaches
    assert legs.leg == (1 if reaches else 0)
    for time, north in ((2.0, -1.0), (3.0, 0.0), (4.0, 50.0)):
        legs.feed(Sample(time, (north, 0.0, 0.0), nose_at(0.0)))
    assert len(legs.passes[0]) == 1  # once, and no second try
    assert legs.finished == reaches


def test_a_goal_of_one_attempt_that_is_met_askew_gives_way_to_the_next():
    back = nose_at(180.0)
    legs = fly([goal(attempts=1), goal(50.0)], [(0.0, -1.0, back), (1.0, 0.0, back)])
    assert (legs.leg, legs.standing, legs.reached) == (1, False, 0)
    legs.feed(Sample(2.0, (50.0, 0.0, 0.0), NOSE))
    assert (legs.finished, legs.reached) == (True, 1)


def test_goals_are_met_in_their_order_and_the_last_ends_the_flight():
    goals = [goal(0.0), goal(10.0), goal(5.0)]
    rows = [(float(k), north, NOSE) for k, north in enumerate((-1.0, 0.0, 5.0, 10.0, 7.0))]
    legs = fly(goals, rows)
    assert (legs.leg, legs.standing, legs.finished) == (2, False, False)
    legs.feed(Sample(9.0, (5.0, 0.0, 0.0), NOSE))
    assert (legs.leg, legs.standing, legs.finished) == (3, True, True)
    assert [one.time for (one,) in legs.passes] == pytest.approx([0.95, 2.99, 8.875])


def test_a_start_at_the_goal_has_arrived():
    assert fly([goal()], [(0.0, 0.01, NOSE)]).finished
    askew = fly([goal(heading_deg=90.0)], [(0.0, 0.01, NOSE)])
    assert askew.standing
    assert not askew.finished
