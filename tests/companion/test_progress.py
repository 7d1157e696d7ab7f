"""An alarm after a full circle without progress, and none where circles are planned."""

import math
from itertools import pairwise

import pytest

from vfguide.companion.legs import Goal, leg_rows
from vfguide.companion.notes import progress_notes
from vfguide.companion.progress import MARGIN, after_step, fresh_progress
from vfguide.companion.route_memory import fresh_route, packed_memory
from vfguide.companion.step import step
from vfguide.flight.leg import AWAY, FIELD, WAY, new_leg
from vfguide.flight.outlines import NO_FENCE
from vfguide.flight.performance import Gains, packed
from vfguide.flight.state import FlightState
from vfguide.geometry.angles import TURN
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG
from vfguide.scenario.aircraft_file import load_aircraft
from vfguide.scenario.data import find_aircraft

STEP = 0.05
"""Turned in one step [rad]."""
LAW = packed(load_aircraft(find_aircraft("aerosonde")).performance(), Gains(25.0))
LEGS = leg_rows((Goal((3000.0, 0.0, -150.0), 0.0, 0.0, 5.0, 10.0 * DEG),), 1.0, 100.0)


def in_phase(phase):
    return new_leg()._replace(phase=phase)


def winding(turns):
    """A leg along a way that turns by so much, a straight of 7 radii between two turns."""
    leg = in_phase(WAY)
    word = leg.way.word._replace(arc=turns - 1.0, middle=0.0, reach=7.0, end=1.0)
    return leg._replace(way=leg.way._replace(word=word))


def circle(leg, angle, remaining=500.0, progress=None, step=STEP):
    """After turning by an angle with a path that does not become shorter."""
    progress = progress or after_step(fresh_progress(), remaining, leg, 0.0)
    for _ in range(round(angle / step)):
        progress = after_step(progress, remaining, leg, math.copysign(step, angle))
    return progress


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize(
    ("leg", "planned"),
    [(in_phase(FIELD), 0.0), (winding(2.0), 2.0), (winding(3.0 * TURN), 3.0 * TURN)],
)
def test_it_is_told_after_a_full_circle_more_than_planned(leg, planned, side):
    step = side * STEP
    assert not circle(leg, side * (TURN + planned - STEP), step=step).alarmed
    assert circle(leg, side * (TURN + planned + 2.0 * STEP), step=step).alarmed


def test_a_path_that_becomes_shorter_is_progress():
    progress = fresh_progress()
    for k in range(1000):
        progress = after_step(progress, 5000.0 - 0.5 * k, in_phase(FIELD), STEP)
    assert not progress.alarmed
    assert progress.least == pytest.approx(4501.0, abs=MARGIN)
    assert 0.0 <= progress.turned <= (2.0 * MARGIN + 1.0) * STEP


def test_turns_to_both_sides_are_no_circles():
    progress = circle(in_phase(FIELD), 1.0)
    for _ in range(20):
        progress = circle(in_phase(FIELD), -2.0, progress=progress, step=-STEP)
        progress = circle(in_phase(FIELD), 2.0, progress=progress)
    assert not progress.alarmed


def test_the_most_winding_way_since_the_last_progress_counts():
    progress = circle(winding(2.0 * TURN), 6.0)
    progress = circle(in_phase(FIELD), 12.0, remaining=900.0, progress=progress)
    assert not progress.alarmed
    assert circle(in_phase(FIELD), 2.0, remaining=900.0, progress=progress).alarmed


def test_away_from_the_goal_no_path_is_measured():
    away = after_step(fresh_progress(), 100.0, in_phase(AWAY), 0.5)
    assert (away.least, away.turned) == (math.inf, 0.5)
    assert after_step(away, 2000.0, winding(2.0), 0.0).least == 2000.0


def test_an_alarm_stays_until_the_leg_is_over():
    alarmed = circle(in_phase(FIELD), 7.0)
    after = after_step(alarmed, 100.0, in_phase(FIELD), 0.0)
    assert (after.alarmed, after.least, after.turned) == (True, 100.0, 0.0)


def circling(seconds):
    """Memories of a vehicle that flies a level circle of 80 m whatever it is told."""
    memory, flown = fresh_route(), []
    for k in range(round(seconds / 0.02)):
        course = 25.0 / 80.0 * 0.02 * k
        place = (80.0 * math.sin(course), -80.0 * math.cos(course), -150.0)
        v_n = (25.0 * math.cos(course), 25.0 * math.sin(course), 0.0)
        R_nb = from_euler(38.0 * DEG, 0.05, course)
        state = FlightState(1.0 + 0.02 * k, place, v_n, R_nb, 25.0, (0.0, 0.0, 0.0))
        memory = step(state, LEGS, LAW, memory, None, NO_FENCE, 0.0)[1]
        flown.append(packed_memory(memory))
    return flown


def test_a_vehicle_that_circles_for_ever_is_told_of_once():
    flown = circling(100.0)
    notes = [
        (0.02 * k, note)
        for k, (before, after) in enumerate(pairwise(flown))
        for note in progress_notes(before, after)
    ]
    ((time, note),) = notes
    period = TURN * 80.0 / 25.0
    assert period < time < 3.0 * period
    assert note.startswith("no progress to goal 1: a full circle more than its way has")
