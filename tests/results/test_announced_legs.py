"""Goals judged by the true path on the legs that the vehicle announces."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from flight_samples import record_of
from hypothesis import assume, given
from hypothesis import strategies as st
from scenario_samples import loaded_from
from scenario_texts import MINIMAL

from vfguide.annunciations.goal_announcement import GoalAnnouncement, GoalOutcome
from vfguide.results.announced_legs import AnnouncedLegs, TimedAnnouncement, announced_legs
from vfguide.results.goal_passages import Legs, Sample
from vfguide.results.judge import judge
from vfguide.scenario.resolved import Goal

pytestmark = pytest.mark.slow

SPEED = 25.0
RATE = 50.0
SPACING = 200.0


def goal(north: float, east: float = 0.0, tolerance_m: float = 5.0) -> Goal:
    return Goal(
        position_m=(north, east, -100.0),
        heading_deg=0.0,
        climb_deg=0.0,
        tolerance_m=tolerance_m,
        tolerance_deg=10.0,
    )


def northward(seconds: float) -> list[Sample]:
    """A straight path through the origin after 4 s."""
    times = (np.arange(round(seconds * RATE) + 1) / RATE).tolist()
    return [Sample(t, (SPEED * (t - 4.0), 0.0, -100.0), (SPEED, 0.0, 0.0)) for t in times]


def said(
    time: float, number: int, miss: float = 1.0, outcome: GoalOutcome = GoalOutcome.REACHED
) -> TimedAnnouncement:
    return TimedAnnouncement(time, GoalAnnouncement(number, outcome, miss, 0))


def row_of_goals(misses: list[float]) -> list[Goal]:
    return [goal(SPACING * number, miss) for number, miss in enumerate(misses)]


passes = st.lists(
    st.tuples(st.floats(-9.0, 9.0), st.floats(-0.6, 0.6), st.floats(0.0, 5.0)),
    min_size=2,
    max_size=4,
)
"""Of each goal: its true miss, how much later the pass is announced, and the miss that is told."""


@given(passes)
def test_each_goal_is_judged_on_the_leg_to_it(flown: list[tuple[float, float, float]]) -> None:
    misses = [miss for miss, _, _ in flown]
    assume(all(abs(abs(miss) - 5.0) > 1e-3 for miss in misses))
    times = [4.0 + SPACING / SPEED * number for number in range(len(flown))]
    announced = [
        said(time + late, number, told)
        for number, (time, (_, late, told)) in enumerate(zip(times, flown, strict=True))
    ]
    legs = announced_legs(row_of_goals(misses), northward(times[-1] + 4.0), announced)
    for number, (miss, _, told) in enumerate(flown):
        (one,) = legs.passes[number]
        assert one.time == pytest.approx(times[number], abs=1e-6)
        assert one.miss == pytest.approx(abs(miss), abs=1e-6)
        assert one.reaches is (abs(miss) < 5.0)
        believed = legs.believed(number)
        assert believed is not None
        assert believed.miss == told
    assert legs.finished is (abs(misses[-1]) < 5.0)
    assert legs.reached == sum(abs(miss) < 5.0 for miss in misses)


def test_without_announcements_a_missed_goal_hides_all_others() -> None:
    goals = row_of_goals([5.2, 0.1, 0.2, 0.0])
    path = northward(40.0)
    deaf = Legs(goals)
    for sample in path:
        deaf.feed(sample)
    assert deaf.best()[1:] == [None] * 3
    heard = announced_legs(goals, path, [said(4.0 + 8.0 * number, number) for number in range(4)])
    assert [one is not None and one.reaches for one in heard.best()] == [False, True, True, True]
    assert heard.reached == 3


def rounds(seconds: float) -> list[Sample]:
    """Level circles of 80 m about (0, 80), northward through the origin every 20.1 s."""
    times = (np.arange(round(seconds * RATE) + 1) / RATE - 4.0).tolist()
    return [
        Sample(
            t + 4.0,
            (80.0 * math.sin(a), 80.0 - 80.0 * math.cos(a), -100.0),
            (SPEED * math.cos(a), SPEED * math.sin(a), 0.0),
        )
        for t in times
        for a in [SPEED / 80.0 * t]
    ]


LAP = 2.0 * math.pi * 80.0 / SPEED


@given(
    st.lists(st.tuples(st.booleans(), st.floats(-0.6, 0.6)), min_size=1, max_size=4),
    st.floats(-8.0, 8.0),
)
def test_a_vehicle_that_goes_round_is_followed_whatever_is_true(
    laps: list[tuple[bool, float]], east: float
) -> None:
    """Each lap passes the same goal; the vehicle goes on when it believes so, not before."""
    assume(abs(abs(east) - 5.0) > 1e-3)
    onward = [goes for goes, _ in laps]
    goals = [goal(0.0, east) for _ in range(1 + sum(onward))]
    number, announced, laps_of = 0, [], [0 for _ in goals]
    for lap, (goes, late) in enumerate(laps):
        outcome = GoalOutcome.REACHED if goes else GoalOutcome.MISSED
        announced.append(said(4.0 + lap * LAP + late, number, 1.0, outcome))
        laps_of[number] += 1
        number += goes
    legs = announced_legs(goals, rounds(4.0 + (len(laps) - 1) * LAP + 0.4 * LAP), announced)
    assert legs.leg == sum(onward)
    near = [[one for one in each if one.miss < 10.0] for each in legs.passes]
    assert [len(each) for each in near] == laps_of
    assert all(one.reaches is (abs(east) < 5.0) for each in near for one in each)


def minima(path: list[Sample], at: Goal) -> list[float]:
    """Times at which the distance has a local minimum, between which samples."""
    p, v = np.array([s.p_n for s in path]), np.array([s.v_n for s in path])
    rate = np.einsum("ij,ij->i", p - np.array(at.position_m), v)
    falls = (rate[:-1] < 0.0) & (rate[1:] >= 0.0)
    return [path[k + 1].time for k in np.flatnonzero(falls)]


waves = st.lists(
    st.tuples(st.floats(0.0, 60.0), st.floats(0.1, 0.6), st.floats(0.0, 6.3)),
    min_size=3,
    max_size=3,
)
"""Of each axis of a made-up path: amplitude [m], angular frequency [rad/s], phase [rad]."""
places = st.tuples(st.floats(-80.0, 80.0), st.floats(-80.0, 80.0))


@given(
    waves,
    st.lists(places, min_size=1, max_size=4),
    st.lists(st.floats(0.0, 60.0), min_size=4, max_size=4),
)
def test_passes_are_the_minima_of_each_leg_on_any_path(
    waves: list[tuple[float, float, float]],
    places: list[tuple[float, float]],
    when: list[float],
) -> None:
    """An oracle that looks at the whole path at once: a leg ends at the pass next to its end."""
    times = np.arange(round(60.0 * RATE) + 1) / RATE
    p = np.array([a * np.sin(w * times + phase) for a, w, phase in waves]).T - (0.0, 0.0, 100.0)
    v = np.array([a * w * np.cos(w * times + phase) for a, w, phase in waves]).T
    path = [
        Sample(t, tuple(x), tuple(y))
        for t, x, y in zip(times.tolist(), p.tolist(), v.tolist(), strict=True)
    ]
    goals = [goal(*place) for place in places]
    ends = [min(times[times >= each]) for each in sorted(when)[: len(goals)]]
    legs = announced_legs(goals, path, [said(end, k) for k, end in enumerate(ends)])
    begin = -1.0
    for k, (at, end) in enumerate(zip(goals, ends, strict=True)):
        until = ends[k + 1] if k + 1 < len(ends) else math.inf
        sample = path[int(np.searchsorted(times, end))]
        closes = [t for t in minima(path, at) if end < t <= until]
        approaches = np.dot(np.subtract(sample.p_n, at.position_m), sample.v_n) < 0.0
        last = closes[0] if approaches and closes else end
        expected = [t for t in minima(path, at) if begin < t <= last]
        found = [one.time for one in legs.passes[k]]
        later = [at for at in found if at > begin + 1.0 / RATE]
        assert all(any(0.0 <= t - at <= 1.0 / RATE + 1e-9 for t in expected) for at in later)
        inner = [t for t in expected if t > begin + 1.0 / RATE]
        assert all(any(0.0 <= t - at <= 1.0 / RATE + 1e-9 for at in found) for t in inner)
        begin = last


def test_the_path_goes_on_where_no_pass_comes() -> None:
    """The goal is left behind far before it; the next one is passed first."""
    goals = [goal(1000.0), goal(100.0)]
    legs = announced_legs(goals, northward(20.0), [said(5.0, 0), said(8.5, 1, 2.0)])
    assert legs.passes[0] == []
    assert [one.time for one in legs.passes[1]] == pytest.approx([8.0])
    left = legs.believed(0)
    assert left is not None
    assert left.miss == 1.0


def test_the_pass_that_ends_a_leg_is_not_one_of_the_next() -> None:
    twice = [goal(0.0), goal(0.0)]
    for late in (-0.3, 0.3):
        legs = announced_legs(twice, northward(20.0), [said(4.0 + late, 0)])
        assert [len(each) for each in legs.passes] == [1, 0]
        assert not legs.finished


def test_a_goal_that_was_given_up_ends_the_flight_once_it_is_passed() -> None:
    legs = AnnouncedLegs([goal(0.0, 7.0)])
    given_up = GoalAnnouncement(0, GoalOutcome.GIVEN_UP, 6.0, 1)
    seen = []
    for sample in northward(6.0):
        legs.feed(sample)
        seen.append((sample.time, legs.finished))
        if sample.time == 3.5:
            legs.announce(given_up)
    finished = [time for time, over in seen if over]
    assert finished[0] == pytest.approx(4.0, abs=1.01 / RATE)
    assert legs.reached == 0


def test_the_result_tells_both_misses_and_what_was_believed(tmp_path: Path) -> None:
    text = MINIMAL + "\n[[vehicle.goal]]\nposition_m = [100, 0, -100]\nheading_deg = 0\n"
    scenario = loaded_from(tmp_path, text).scenario
    record = record_of(
        scenario.vehicles[0],
        lambda time: np.column_stack((25.0 * (time - 20.0), 0.0 * time + 5.2, 0.0 * time - 100.0)),
        30.0,
    )
    announced = (said(20.1, 0, 2.1), said(23.9, 1, 4.9))
    result = judge(scenario, [replace(record, announced=announced)], 30.0, 0.1, ("time",))
    first, second = result.vehicles[0].goals
    assert (first.miss_m, first.told_miss_m) == (pytest.approx(5.2, abs=1e-3), 2.1)
    assert (second.miss_m, second.told_miss_m) == (pytest.approx(5.2, abs=1e-3), 4.9)
    assert result.verdict == "bad"
    believed = "not reached, though its companion announced it as reached"
    assert result.reasons == (
        "time",
        f"goal 1 of vehicle 1 {believed}, 2.1 m off",
        f"goal 2 of vehicle 1 {believed}, 4.9 m off",
    )
