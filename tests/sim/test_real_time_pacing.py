"""The schedule of a simulation in real time."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.sim.real_time_pacing import LONGEST_BACKLOG, RealTimePacing

PERIOD = 0.005


def take_due(pace, now):
    due = pace.due(now)
    for _ in range(due):
        pace.take()
    return due


def test_nothing_is_due_before_the_first_period_is_over():
    pace = RealTimePacing(10.0, PERIOD)
    assert pace.due(10.004) == 0
    assert pace.wait(10.004) == pytest.approx(0.001)
    assert pace.due(10.0051) == 1
    assert pace.wait(10.0051) == 0.0


def test_steps_are_counted_from_the_start_however_they_are_taken():
    pace = RealTimePacing(0.0, PERIOD)
    assert take_due(pace, 0.0201) == 4
    assert take_due(pace, 0.0202) == 0
    assert pace.take() == 5


def test_an_hour_of_jitter_does_not_make_it_drift():
    pace = RealTimePacing(123.4, PERIOD)
    late = (0.0, 0.0013, 0.0031, 0.0004)
    for number in range(100_000):
        now = 123.4 + 0.036 * number + late[number % 4]
        take_due(pace, now)
    assert pace.taken == int((now - 123.4) / PERIOD)


@given(st.lists(st.floats(0.0, 0.9 * LONGEST_BACKLOG), min_size=1, max_size=30))
def test_what_is_late_by_less_than_the_limit_is_caught_up(naps):
    pace, now = RealTimePacing(0.0, PERIOD), 0.0
    for nap in naps:
        now += nap
        take_due(pace, now)
    assert pace.taken == pytest.approx(now / PERIOD, abs=1.01)
    assert pace.lost == 0.0


def test_what_is_late_by_more_is_given_up_and_told():
    pace = RealTimePacing(0.0, PERIOD)
    assert pace.due(60.0) == pytest.approx(LONGEST_BACKLOG / PERIOD, abs=2)
    assert pace.worst == pytest.approx(60.0 - PERIOD)
    assert pace.lost == pytest.approx(59.0, abs=0.01)
    take_due(pace, 60.0)
    assert pace.due(60.0) == 0
    assert take_due(pace, 60.5) == pytest.approx(0.5 / PERIOD, abs=2)
    assert pace.lost == pytest.approx(59.0, abs=0.01)


def test_being_late_is_counted_from_the_first_step_that_waits():
    pace = RealTimePacing(0.0, PERIOD)
    pace.due(0.025)
    assert pace.worst == pytest.approx(0.020)
