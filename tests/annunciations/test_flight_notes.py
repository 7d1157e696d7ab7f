"""What the operator is told of goals and of no progress."""

import math
from itertools import pairwise

from flight_states import VEHICLE
from loop_legs import FAR, GOALS
from loop_steps import step_told

from vfguide.aircraft.state import FlightState
from vfguide.annunciations.flight_notes import leader_notes, progress_notes
from vfguide.annunciations.goal_announcement import announcement
from vfguide.annunciations.goal_notes import passage_note
from vfguide.geometry.angles import FULL_TURN
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG
from vfguide.guidance.guidance_state import FieldProgress, GuidanceState, Leader
from vfguide.guidance.laws import FLIGHT
from vfguide.kernels.rows import row_of
from vfguide.loop.attempts import Attempts
from vfguide.loop.loop_report import has_news
from vfguide.loop.mission import MissionState
from vfguide.loop.state import fresh_state, row_of_state
from vfguide.planning.excess_wind import fresh_wind_hold


def note(goal_before, missed, goal_after, given_up):
    """What is told where a goal was passed 5.1 m off."""
    before = MissionState(goal_before, Attempts(missed, 0), fresh_wind_hold())
    after = MissionState(goal_after, Attempts(0, given_up), fresh_wind_hold())
    rows = (row_of_state(fresh_state()._replace(mission=each)) for each in (before, after))
    return passage_note(announcement(*rows, 5.1), len(GOALS))


def test_the_operator_is_told_what_became_of_a_goal():
    assert note(0, 2, 1, 1) == "goal 1 missed 3 times: going on to goal 2"
    assert note(1, 0, 2, 1) == "goal 2 missed once: loitering"
    assert note(0, 1, 0, 0) == "goal 1 missed by 5.1 m or by its course: going round"
    assert note(0, 1, 1, 0) == "goal 1 reached, 5.1 m off; flying to goal 2 of 2"


def circling(seconds):
    """Rows of the loop of a vehicle that flies a level circle of 80 m whatever it is told."""
    row, flown = row_of_state(fresh_state()), []
    for k in range(round(seconds / 0.02)):
        course = 25.0 / 80.0 * 0.02 * k
        place = (80.0 * math.sin(course), -80.0 * math.cos(course), -150.0)
        v_n = (25.0 * math.cos(course), 25.0 * math.sin(course), 0.0)
        R_nb = from_euler(38.0 * DEG, 0.05, course)
        state = FlightState(1.0 + 0.02 * k, place, v_n, R_nb, 25.0, (0.0, 0.0, 0.0))
        _, row, _ = step_told(state, row, FAR, None, FLIGHT, row_of(VEHICLE))
        flown.append(row)
    return flown


def test_a_vehicle_that_circles_for_ever_is_told_of_once():
    flown = circling(100.0)
    notes = [
        (0.02 * k, note)
        for k, (before, after) in enumerate(pairwise(flown))
        for note in progress_notes(before, after)
    ]
    ((time, note),) = notes
    period = FULL_TURN * 80.0 / 25.0
    assert period < time < 3.0 * period
    assert note.startswith("no progress to goal 1: flown a full circle more than its path has")


def led_by(leader, goal=0):
    """The row of a state in which a leader of law field was followed to a goal."""
    s = fresh_state()
    progress = FieldProgress(leader, 100.0, 90.0, 3.0, 2.0)
    mission = s.mission._replace(goal=goal)
    return row_of_state(s._replace(guidance=GuidanceState(0.0, 1.0, progress), mission=mission))


def test_a_route_of_law_field_is_told_once():
    field, approach, route = map(led_by, (Leader.FIELD, Leader.APPROACH, Leader.ROUTE))
    assert leader_notes(field, route) == ["the field does not lead to goal 1: a route is flown"]
    assert leader_notes(approach, route) == [
        "the approach leads away from goal 1: a route is flown"
    ]
    assert leader_notes(route, field) == ["the field leads again to goal 1"]
    for before, after in ((field, field), (route, route), (field, approach), (route, approach)):
        assert leader_notes(before, after) == []
    assert leader_notes(route, led_by(Leader.FIELD, goal=1)) == []


def test_who_leads_is_news():
    assert has_news(led_by(Leader.FIELD), led_by(Leader.ROUTE))
