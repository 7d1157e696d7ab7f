"""What is reported from the row of the loop."""

import pytest
from loop_rows import flown, numbered

from vfguide.estimation.air_state import report_air
from vfguide.kernels.rows import leaves, place, row_of
from vfguide.loop.loop_report import (
    air_report,
    changes,
    decision_of_row,
    goal_of_row,
    has_news,
    is_alarmed,
    is_in_doubt,
    noted_numbers,
    number_of_resets,
    route_of_row,
    trusts_sensor_of_row,
)
from vfguide.loop.state import (
    LoopState,
)

pytestmark = pytest.mark.slow


def test_what_is_reported_is_taken_from_its_place():
    row, s = numbered(), flown()
    assert goal_of_row(row) == s.mission.goal
    assert decision_of_row(row) == s.assurance.decision
    assert (row_of(route_of_row(row)) == row_of(s.planning.following)).all()
    assert number_of_resets(row) == s.estimation.resets.number
    assert is_alarmed(row) == s.progress.alarmed == 1
    assert trusts_sensor_of_row(row) == s.estimation.air.sensor.trusted == 1
    air, decision = report_air(s.estimation.air), s.assurance.decision
    assert air_report(row) == air
    assert noted_numbers(row) == (
        *(air.wind_north, air.wind_east, air.wind_sigma, air.airspeed, air.airspeed_sigma),
        *(decision.reason, decision.margin, decision.conflict, decision.hazard),
        s.guidance.progress.leader,
    )


NEWS = {
    "estimation.resets.number",
    "mission.wind_hold.holds",
    "progress.alarmed",
    "guidance.progress.leader",
    "estimation.air.sensor.trusted",
}


@pytest.mark.parametrize("leaf", [leaf for leaf in leaves(LoopState) if leaf.size == 1])
def test_only_what_the_operator_reads_of_is_news(leaf):
    before, after = numbered(), numbered()
    after[place(LoopState, leaf.name)] -= 1.0
    assert has_news(before, after) == (leaf.name in NEWS)


def test_the_first_look_at_the_air_is_news():
    before = numbered()
    before[place(LoopState, "estimation.air.time")] = -1.0
    assert has_news(before, numbered())


DOUBTS = [
    f"estimation.consistency.{name}"
    for name in (
        "yaw_doubt",
        "velocity_doubt",
        "attitude_doubt",
        "air.wind_doubt",
        "air.airspeed_doubt",
    )
]


def undoubted():
    row = numbered()
    for name in DOUBTS:
        row[place(LoopState, name)] = 0.0
    return row


@pytest.mark.parametrize("name", DOUBTS)
def test_a_doubt_that_begins_lasts_or_ends_may_have_to_be_told(name):
    doubted, sure = undoubted(), undoubted()
    doubted[place(LoopState, name)] = 0.5
    assert is_in_doubt(doubted)
    assert not is_in_doubt(sure)
    for before, after in ((sure, doubted), (doubted, doubted), (doubted, sure)):
        assert changes(before, after) == (True, False)
    assert changes(sure, sure) == (False, False)


@pytest.mark.parametrize("name", sorted(NEWS))
def test_news_is_told_without_a_doubt(name):
    before, after = undoubted(), undoubted()
    after[place(LoopState, name)] -= 1.0
    assert changes(before, after) == (False, True)
