"""What a step leaves for the next: a record and its row; where a leg or a mission begins."""

import math

import numpy as np
import pytest
from aeroplanes import AEROSONDE
from loop_rows import OBSTACLES, flown, numbered

from vfguide.control.control import fresh_control
from vfguide.estimation.air_state import ACCELERATION_BIAS, AIRSPEED
from vfguide.estimation.consistency import fresh_consistency
from vfguide.estimation.estimation import fresh_estimation
from vfguide.guidance.guidance_state import fresh_guidance
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Row, leaves, place, row_of, width
from vfguide.loop.attempts import Attempts, no_attempts
from vfguide.loop.progress import fresh_progress
from vfguide.loop.state import (
    LoopState,
    begin_leg,
    begin_mission,
    forget_learned,
    fresh_state,
    leave_goal,
    read_state,
    row_of_state,
    state_of_row,
    take_over,
    watching,
    write_state,
)
from vfguide.planning.route import fresh_route


@compiled
def through_compiled_code(row: Row) -> Row:
    after = np.empty(len(row))
    write_state(read_state(row), after)
    return after


def test_every_number_of_a_state_is_in_its_own_place():
    assert (row_of_state(flown()) == numbered()).all()
    assert (through_compiled_code(numbered()) == numbered()).all()
    assert width(LoopState) == len(row_of_state(fresh_state()))
    assert (flown().detection.known == numbered()[-OBSTACLES:]).all()


def test_each_truth_value_has_a_place_of_its_own():
    for leaf in leaves(LoopState):
        if leaf.kind is bool:
            row = numbered()
            row[place(LoopState, leaf.name)] = 0.0
            assert (row_of_state(state_of_row(row)) == row).all(), leaf.name
            assert (through_compiled_code(row) == row).all(), leaf.name


@pytest.mark.parametrize("branch", [name for name in LoopState._fields if name != "thrust"])
def test_a_branch_of_the_row_is_the_row_of_the_branch(branch):
    part = numbered()[place(LoopState, branch)]
    assert (row_of(getattr(flown(), branch)) == part).all()


def test_a_fresh_state_goes_through_its_row():
    row = row_of_state(fresh_state(OBSTACLES))
    assert (row_of_state(state_of_row(row)) == row).all()
    assert (through_compiled_code(row) == row).all()


def changed(before: LoopState, after: LoopState) -> set[str]:
    """Names of the numbers and arrays that differ."""
    was, now = row_of_state(before), row_of_state(after)
    there = {leaf.name: place(LoopState, leaf.name) for leaf in leaves(LoopState)}
    return {name for name, at in there.items() if (was[at] != now[at]).any()}


def are_same(one, other) -> bool:
    return (row_of(one) == row_of(other)).all()


LEG_BEGINS = ("planning.", "progress.")
"""What is remembered of one leg alone."""


def test_at_the_beginning_of_a_leg_what_was_learned_stays():
    s = flown()
    after = begin_leg(s, 1, Attempts(0, 7))
    others = {name for name in changed(s, after) if not name.startswith(LEG_BEGINS)}
    goals = {"mission.goal", "mission.attempts.missed", "mission.attempts.given_up"}
    assert others == {"estimation.is_continuous"} | goals
    assert (after.mission.goal, after.mission.attempts) == (1, Attempts(0, 7))
    assert not after.estimation.is_continuous
    assert are_same(after.planning, fresh_route())
    assert after.progress == fresh_progress()


def test_a_goal_that_is_left_counts_as_given_up():
    s = flown()
    after = leave_goal(s)
    attempts = Attempts(0, s.mission.attempts.given_up + 1)
    assert (after.mission.goal, after.mission.attempts) == (s.mission.goal + 1, attempts)
    assert not changed(after, begin_leg(s, s.mission.goal + 1, attempts))


def test_when_the_autopilot_begins_to_follow_mission_air_and_doubts_are_remembered():
    s = flown()
    after = take_over(s)
    assert are_same(after.mission, s.mission)
    assert are_same(after.estimation.air, s.estimation.air)
    air, doubts = s.estimation.air, s.estimation.consistency
    kept = fresh_estimation()._replace(air=air, consistency=doubts)
    assert are_same(after.estimation, kept)
    assert are_same(after.planning, fresh_route())
    assert after.guidance == fresh_guidance()
    assert are_same(after.control, fresh_control())
    assert after.progress == fresh_progress()
    assert are_same(after.assurance, s.assurance), "an escape goes on"
    assert after.thrust == s.thrust
    assert are_same(after.detection, s.detection)


def test_while_the_autopilot_does_not_follow_only_doubts_are_remembered():
    s = flown()
    seen = s._replace(estimation=s.estimation._replace(time=9.0, consistency=fresh_consistency()))
    kept = state_of_row(watching(row_of_state(s), row_of_state(seen)))
    estimation = s.estimation._replace(consistency=fresh_consistency())
    assert are_same(kept, s._replace(estimation=estimation))


def test_another_mission_begins_at_its_first_goal():
    s = flown()
    after = begin_mission(s)
    assert (after.mission.goal, after.mission.attempts) == (0, no_attempts())
    assert are_same(after.mission.wind_hold, s.mission.wind_hold)
    others = {name for name in changed(after, take_over(s)) if not name.startswith("mission.")}
    assert others == set()


@pytest.mark.parametrize(
    ("better", "forgotten"),
    [
        ({}, set()),
        ({"climb_max": 0.2}, set()),
        ({"alpha_zero": 0.01}, {"control.alpha_bias"}),
        ({"alpha_load": 70.0}, {"control.alpha_bias"}),
        ({"thrust_trim": 0.4}, {"control.thrust_integral"}),
    ],
)
def test_corrections_of_what_is_known_better_are_forgotten(better, forgotten):
    s, after = flown(), AEROSONDE._replace(**better)
    left = forget_learned(s, AEROSONDE, after)
    model = {"estimation.air.estimate.x", "estimation.air.sensor.model_airspeed"}
    assert changed(s, left) == (forgotten | model if better else set())
    control, x = left.control, left.estimation.air.estimate.x.copy()
    assert control.alpha_bias == 0.0 or "control.alpha_bias" not in forgotten
    assert control.thrust_integral == 0.0 or "control.thrust_integral" not in forgotten
    if better:
        assert x[ACCELERATION_BIAS] == 0.0
        assert left.estimation.air.sensor.model_airspeed == x[AIRSPEED]
        x[ACCELERATION_BIAS] = s.estimation.air.estimate.x[ACCELERATION_BIAS]
        assert (x == s.estimation.air.estimate.x).all()


def test_nothing_is_changed_in_the_state_before():
    row = numbered()
    s = state_of_row(row)
    for after in (take_over(s), leave_goal(s), begin_mission(s)):
        assert after is not s
    forget_learned(s, AEROSONDE, AEROSONDE._replace(thrust_trim=0.4))
    assert (row == numbered()).all()


def test_nothing_is_known_at_first():
    s = fresh_state(OBSTACLES)
    assert s.estimation.time < 0.0
    assert s.estimation.air.time < 0.0
    assert (s.mission.goal, s.thrust, s.progress.least) == (0, 0.0, math.inf)
    assert not s.detection.known.any()
    assert len(s.detection.known) == OBSTACLES
