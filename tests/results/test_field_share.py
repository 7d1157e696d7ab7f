"""In how much of a flight the field leads."""

from dataclasses import replace

import numpy as np
import pytest
from flight_samples import record_of, straight
from scenario_samples import loaded_from

from vfguide.assurance.decision import Reason
from vfguide.guidance.guidance_state import Leader
from vfguide.results.field_share import field_result
from vfguide.results.judge import judge
from vfguide.results.record import Decisions


@pytest.fixture
def record(tmp_path):
    """A straight flight of which the first tenth has no setpoint, led by the field."""
    flown = record_of(loaded_from(tmp_path).scenario.vehicles[0], straight, 25.0)
    thrust = np.full(len(flown.time), 0.5)
    thrust[: len(thrust) // 10] = np.nan
    return replace(flown, thrust=thrust, leaders=np.zeros(len(thrust)))


def led_by(record, *parts):
    """The flight, its tenths led by others; `parts` are a leader, the first and the last tenth."""
    leaders, tenth = record.leaders.copy(), len(record.time) // 10
    for leader, first, last in parts:
        leaders[first * tenth : last * tenth] = leader
    return replace(record, leaders=leaders)


def test_the_field_alone(record):
    its = field_result(record)
    assert (its.leading_share, its.leading_share_of_flight, its.routes) == (1.0, 1.0, 0)


def test_routes_approach_and_circle(record):
    parts = (
        (Leader.ROUTE, 2, 3),
        (Leader.ROUTE, 4, 5),
        (Leader.APPROACH, 7, 9),
        (Leader.CIRCLE, 9, 11),
    )
    its = field_result(led_by(record, *parts))
    assert its.leading_share == pytest.approx(4 / 6, abs=2e-3)
    assert its.route_share == pytest.approx(2 / 6, abs=2e-3)
    assert its.leading_share_of_flight == pytest.approx(4 / 8, abs=2e-3)
    assert its.routes == 2


def test_in_an_escape_the_field_does_not_lead(record):
    reason, none = np.zeros(len(record.time)), np.zeros(len(record.time))
    tenth = len(reason) // 10
    reason[3 * tenth : 6 * tenth] = Reason.RECOVERY
    its = field_result(replace(record, decisions=Decisions(reason, none, none, none)))
    assert its.leading_share == pytest.approx(6 / 9, abs=2e-3)
    assert its.route_share == 0.0


def test_a_flight_without_setpoints_has_no_share(record):
    its = field_result(replace(record, thrust=np.full(len(record.time), np.nan)))
    assert (its.leading_share, its.leading_share_of_flight, its.route_share) == (None, None, None)


def test_other_laws_have_none(record, tmp_path):
    assert field_result(replace(record, leaders=None)) is None
    scenario = loaded_from(tmp_path).scenario
    assert judge(scenario, [record], 25.0, 0.1).vehicles[0].field == field_result(record)
