"""Conflicts with traffic, and when the operator hears of them."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.airspace.hazards import Intruder
from vfguide.surveillance.alerts import (
    ENOUGH,
    LOOKAHEAD,
    LOOKS,
    RELEASE_FACTOR,
    Alert,
    encounter,
    look,
)
from vfguide.surveillance.report import Ownship, Report

OWN = Ownship(1000, (0.0, 0.0, -100.0), (25.0, 0.0, 0.0))
part = st.floats(-300.0, 300.0)
speed = st.floats(-40.0, 40.0)


def of(x, y=0.0, z=-100.0, v_n=(-25.0, 0.0, 0.0), time_ms=1000, uncertainty_rate=0.0):
    its = Intruder((x, y, z), v_n, 0.0, 50.0, 30.0, uncertainty_rate, 0.0)
    return Report(1, "ABC123", time_ms, its)


def test_head_on():
    met = encounter((600.0, 20.0, 10.0), (-50.0, 0.0, 0.0), 50.0, 30.0)
    assert met == (pytest.approx(12.0), pytest.approx(20.0), True)


@pytest.mark.parametrize(
    ("x_n", "v_n", "violates"),
    [
        ((600.0, 51.0, 0.0), (-50.0, 0.0, 0.0), False),
        ((600.0, 49.0, 0.0), (-50.0, 0.0, 0.0), True),
        ((600.0, 0.0, 31.0), (-50.0, 0.0, 0.0), False),
        ((600.0, 0.0, 55.0), (-50.0, 0.0, -2.0), True),  # 31 m above when nearest, 29 m 1 s later
        ((600.0, 0.0, 64.0), (-50.0, 0.0, -2.0), False),
        ((600.0, 0.0, 0.0), (50.0, 0.0, 0.0), False),
        ((50.0 * LOOKAHEAD + 51.0, 0.0, 0.0), (-50.0, 0.0, 0.0), False),
        ((0.0, 0.0, 500.0), (0.0, 0.0, -20.0), True),
        ((0.0, 0.0, 10.0), (0.0, 0.0, 0.0), True),
    ],
)
def test_the_volume_is_entered_or_not(x_n, v_n, violates):
    assert encounter(x_n, v_n, 50.0, 30.0).violates is violates


@given(st.tuples(part, part, part), st.tuples(speed, speed, speed))
def test_as_a_look_at_every_moment_says(x_n, v_n):
    t = np.linspace(0.0, LOOKAHEAD, 3001)[:, None]
    there = np.array(x_n) + t * np.array(v_n)
    flat, upright = np.hypot(there[:, 0], there[:, 1]), np.abs(there[:, 2])
    met = encounter(x_n, v_n, 50.0, 30.0)
    assert met.miss <= flat.min() + 1e-6
    if np.any((flat < 50.0) & (upright < 30.0)):
        assert met.violates
    if not np.any((flat < 51.0) & (upright < 31.0)):
        assert not met.violates


def test_m_of_n():
    alert, notes = Alert(), []
    for conflict in (True, False, True, False, False, True, True, True):
        alert, note = look(alert, of(600.0, 0.0 if conflict else 500.0), OWN)
        notes.append(note)
    assert [bool(note) for note in notes] == [False] * 6 + [True, False]
    assert notes[6] == "traffic ABC123 in 12 s, 0 m"


def test_one_look_less_than_enough_is_none():
    alert = Alert()
    for _ in range(ENOUGH - 1):
        alert, note = look(alert, of(600.0), OWN)
        assert not note
    assert not alert.is_on


def test_it_ends_only_when_all_the_last_looks_are_clear_of_the_wider_volume():
    alert = Alert()
    for _ in range(LOOKS):
        alert, _ = look(alert, of(600.0), OWN)
    between = 50.0 * 0.5 * (1.0 + RELEASE_FACTOR)
    for _ in range(3 * LOOKS):
        alert, note = look(alert, of(600.0, between), OWN)
        assert (alert.is_on, note) == (True, "")
    for number in range(LOOKS):
        alert, note = look(alert, of(600.0, 50.0 * RELEASE_FACTOR + 1.0), OWN)
        assert bool(note) is (number == LOOKS - 1)
    assert not alert.is_on


def test_an_old_report_counts_as_larger():
    on = {
        age: look(
            Alert(is_on=True), of(600.0, 90.0, time_ms=1000 - age, uncertainty_rate=3.0), OWN
        )[0].is_on
        for age in (0, 5000)
    }
    assert on == {0: False, 5000: True}
    assert math.isclose(RELEASE_FACTOR * (50.0 + 5.0 * 3.0), 97.5)
