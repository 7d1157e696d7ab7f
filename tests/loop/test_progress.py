"""An alarm after a full circle without progress, and none where circles are planned."""

import math

import pytest
from loop_legs import FAR

from vfguide.aircraft.command import GuidanceCommand, unknown_rates
from vfguide.aircraft.state import FlightState
from vfguide.estimation.estimation import known_state
from vfguide.geometry.angles import FULL_TURN
from vfguide.geometry.so3 import from_euler
from vfguide.loop import progress as stage
from vfguide.loop.legs import target_of
from vfguide.loop.progress import PROGRESS_MARGIN, Progress, after_step, fresh_progress
from vfguide.paths.leg import FIELD, ON_PATH, OUTBOUND
from vfguide.planning.objective import objective_at

STEP = 0.5
"""Flown in one step [m]."""
RADIUS = 100.0
CIRCLE = FULL_TURN * RADIUS


def on(phase, remaining):
    """A command on a leg."""
    straight_on = (0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
    return GuidanceCommand(*straight_on, remaining, phase, RADIUS, unknown_rates())


def fly_on(distance, remaining=500.0, progress=None, phase=ON_PATH):
    """After a distance with a path that does not become shorter."""
    command = on(phase, remaining)
    progress = progress or after_step(fresh_progress(), command, 0.0)
    for _ in range(round(distance / STEP)):
        progress = after_step(progress, command, STEP)
    return progress


def test_it_is_told_after_a_full_circle():
    assert not fly_on(CIRCLE - STEP).alarmed
    assert fly_on(CIRCLE + 2.0 * STEP).alarmed


@pytest.mark.parametrize("longer", [0.0, 100.0, 3.0 * CIRCLE])
def test_a_way_that_became_longer_is_flown_first(longer):
    progress = fly_on(STEP, remaining=500.0 + longer, progress=fly_on(10.0))
    assert not fly_on(longer + CIRCLE - 4.0 * STEP - 10.0, 500.0, progress).alarmed
    assert fly_on(longer + CIRCLE + 4.0 * STEP - 10.0, 500.0, progress).alarmed


def test_ways_that_are_planned_anew_again_and_again_lead_nowhere():
    """To either side in turn: the course over ground never makes a circle."""
    progress, flown = fresh_progress(), 0.0
    while not progress.alarmed:
        for _ in range(200):
            remaining = 1500.0 - STEP * (flown / STEP % 200)
            progress = after_step(progress, on(ON_PATH, remaining), STEP)
            flown += STEP
        assert flown < 5.0 * CIRCLE
    assert flown > CIRCLE


def test_a_path_that_becomes_shorter_is_progress():
    progress = fresh_progress()
    for k in range(9000):
        progress = after_step(progress, on(FIELD, 5000.0 - 0.5 * k), STEP)
    assert not progress.alarmed
    assert progress.least == pytest.approx(501.0, abs=PROGRESS_MARGIN)
    assert 0.0 <= progress.flown <= (2.0 * PROGRESS_MARGIN + 1.0) * STEP


def test_away_from_the_goal_no_path_is_measured():
    away = after_step(fresh_progress(), on(OUTBOUND, 100.0), 0.5)
    assert (away.least, away.flown) == (math.inf, 0.5)
    assert not fly_on(9.0 * CIRCLE, 100.0, away, OUTBOUND).alarmed
    begun = after_step(away, on(ON_PATH, 2000.0), 0.5)
    assert (begun.least, begun.longest, begun.flown) == (2000.0, 2000.0, 0.0)
    assert fly_on(CIRCLE + 2.0 * STEP, 100.0, begun, OUTBOUND).alarmed


def test_an_alarm_stays_until_the_leg_is_over():
    after = after_step(fly_on(2.0 * CIRCLE), on(FIELD, 100.0), 0.5)
    assert (after.alarmed, after.least, after.flown) == (True, 100.0, 0.0)


def on_the_way(**known):
    """The vehicle 0.5 m after the last step, and what it flies to."""
    state = FlightState(
        1.02, (0.5, 0.0, -150.0), (25.0, 0.0, 0.0), from_euler(0.0, 0.05, 0.0), 25.0, (0.0,) * 3
    )
    nav = known_state(state, 1.0)._replace(is_continuous=True, p_n_before=(0.0, 0.0, -150.0))
    return nav._replace(**known), objective_at(target_of(FAR, 0), state)


def test_what_is_flown_over_the_ground_is_counted():
    before, (nav, goal) = Progress(500.0, 510.0, 20.0, False), on_the_way()
    after = stage.update(nav, goal, on(ON_PATH, 505.0), before)
    assert after == after_step(before, on(ON_PATH, 505.0), 0.5)
    assert after.flown == 20.5


def test_on_a_circle_in_a_hold_and_after_a_pause_there_is_no_progress():
    before, (nav, goal) = Progress(500.0, 510.0, 20.0, True), on_the_way()
    held = goal._replace(is_goal=False)
    assert stage.update(nav, held, on(ON_PATH, 505.0), before) == before
    nav, goal = on_the_way(is_continuous=False)
    assert stage.update(nav, goal, on(ON_PATH, 505.0), before) == before


def test_where_a_leg_begins_nothing_of_it_is_flown():
    before, (nav, goal) = Progress(500.0, 510.0, 20.0, True), on_the_way()
    begun = goal._replace(begins=True)
    assert stage.update(nav, begun, on(ON_PATH, 505.0), before) == fresh_progress()
