"""`result.json`: its keys, its figures, the verdict."""

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from flight_samples import moved, record_of, spiral, straight
from scenario_samples import loaded_from
from scenario_texts import MINIMAL, SECOND

from vfguide import __version__
from vfguide.files.atomic import write_atomically
from vfguide.results.judge import judge
from vfguide.results.record import Decisions, FlightRecord
from vfguide.results.result import write_result
from vfguide.results.verdict import min_separation
from vfguide.scenario.resolved import Scenario

DOCUMENTED = json.loads(
    """
{"name": "...", "version": "...", "seed": 1, "verdict": "good", "reasons": [],
 "sim_s": 29.5, "wall_s": 0.15, "realtime_factor": 196.7, "min_separation_m": null,
 "vehicles": [{"id": 1, "goals": [{"reached": true, "time_s": 24.5, "miss_m": 0.03,
                                   "told_miss_m": null, "course_error_deg": 0.1,
                                   "climb_error_deg": 0.0}],
   "obstacles": [], "fence_clearance_m": null, "assurance": null, "field": null,
   "max_bank_deg": 47.0, "load_factor": [0.95, 1.53], "airspeed_mps": [24.8, 25.2],
   "altitude_m": [148.0, 151.0], "setpoints": 1475, "setpoint_rate_hz": 50.0,
   "traffic": [], "identified": []}]}
"""
)


def shape(value: Any) -> Any:
    """The keys and types of a JSON value, whole numbers and others alike."""
    if isinstance(value, dict):
        return {key: shape(its) for key, its in value.items()}
    if isinstance(value, list):
        return [shape(its) for its in value]
    return float if type(value) is int else type(value)


@pytest.fixture
def scenario(tmp_path: Path) -> Scenario:
    return loaded_from(tmp_path).scenario


@pytest.fixture
def pair(tmp_path: Path) -> Scenario:
    return loaded_from(tmp_path, MINIMAL + SECOND).scenario


@pytest.fixture
def record(scenario: Scenario) -> FlightRecord:
    return record_of(scenario.vehicles[0], straight, 25.0)


def test_the_file_has_the_documented_keys(
    tmp_path: Path, scenario: Scenario, record: FlightRecord
) -> None:
    write_result(judge(scenario, [record], 25.0, 0.1), tmp_path / "result.json")
    written = json.loads((tmp_path / "result.json").read_text())
    assert shape(written) == shape(DOCUMENTED)
    assert list(written) == list(DOCUMENTED)
    assert list(written["vehicles"][0]) == list(DOCUMENTED["vehicles"][0])


def test_figures_of_a_straight_flight(scenario: Scenario, record: FlightRecord) -> None:
    result = judge(scenario, [record], 25.0, 0.1)
    assert (result.name, result.version, result.seed) == ("minimal", __version__, 1)
    assert (result.verdict, result.reasons) == ("good", ())
    assert (result.sim_s, result.wall_s, result.realtime_factor) == (25.0, 0.1, 250.0)
    assert result.min_separation_m is None
    (vehicle,) = result.vehicles
    assert vehicle.goals[0].reached
    assert vehicle.goals[0].time_s == pytest.approx(20.0)
    assert vehicle.goals[0].miss_m == pytest.approx(0.0, abs=1e-3)
    assert vehicle.altitude_m == (588.0, 588.0)
    assert vehicle.airspeed_mps == pytest.approx((24.6, 25.4), abs=1e-3)
    assert (vehicle.setpoints, vehicle.setpoint_rate_hz) == (1251, 50.04)


def test_bank_and_load_factor_of_a_steady_turn(scenario: Scenario) -> None:
    result = judge(scenario, [record_of(scenario.vehicles[0], spiral, 25.0)], 25.0, 0.1)
    bank = math.atan(25.0**2 / 90.0 / 9.80665)
    (vehicle,) = result.vehicles
    assert vehicle.max_bank_deg == pytest.approx(math.degrees(bank), abs=1e-3)
    assert vehicle.load_factor == pytest.approx((1.0 / math.cos(bank),) * 2, abs=1e-4)


def test_bank_to_the_left_counts_as_much(scenario: Scenario) -> None:
    def mirrored(time: np.ndarray) -> np.ndarray:
        return spiral(time) * (1.0, -1.0, 1.0)

    left, right = (
        judge(scenario, [record_of(scenario.vehicles[0], path, 25.0)], 25.0, 0.1).vehicles[0]
        for path in (mirrored, spiral)
    )
    assert left.max_bank_deg == pytest.approx(right.max_bank_deg)


def test_a_goal_that_is_missed_makes_the_verdict_bad(scenario: Scenario) -> None:
    off = record_of(scenario.vehicles[0], moved(straight, (0.0, 6.0, 0.0)), 25.0)
    result = judge(scenario, [off], 25.0, 0.1)
    assert (result.verdict, result.reasons) == ("bad", ("goal 1 of vehicle 1 not reached",))
    assert result.vehicles[0].goals[0].miss_m == pytest.approx(6.0)


def test_a_goal_without_a_pass_has_no_figures(scenario: Scenario) -> None:
    short = record_of(scenario.vehicles[0], straight, 10.0)
    result = judge(scenario, [short], 10.0, 0.1, ended_early=("time",))
    assert result.reasons == ("time", "goal 1 of vehicle 1 not reached")
    goal = json.loads(result.to_json())["vehicles"][0]["goals"][0]
    assert goal == {
        "reached": False,
        "time_s": None,
        "miss_m": None,
        "told_miss_m": None,
        "course_error_deg": None,
        "climb_error_deg": None,
    }


def test_time_alone_makes_the_verdict_bad(scenario: Scenario, record: FlightRecord) -> None:
    result = judge(scenario, [record], 25.0, 0.1, ended_early=("time",))
    assert (result.verdict, result.reasons) == ("bad", ("time",))


@pytest.mark.parametrize(
    ("height", "reasons"), [(0.31, ()), (0.3, ("ground: vehicle 1 after 2.0 s",))]
)
def test_the_ground(
    scenario: Scenario, record: FlightRecord, height: float, reasons: tuple[str, ...]
) -> None:
    heights = record.height_above_ground.copy()
    heights[100:] = height
    result = judge(scenario, [replace(record, height_above_ground=heights)], 25.0, 0.1)
    assert result.reasons == reasons


@pytest.mark.parametrize(
    ("apart", "reasons"),
    [(20.001, ()), (20.0, ("separation: 20.0 m, not more than 20 m",))],
)
def test_separation(pair: Scenario, apart: float, reasons: tuple[str, ...]) -> None:
    one, other = pair.vehicles
    beside = other.model_copy(
        update={"goals": (other.goals[0].model_copy(update={"position_m": (0.0, apart, -100.0)}),)}
    )
    records = [
        record_of(one, straight, 25.0),
        record_of(beside, moved(straight, (0.0, apart, 0.0)), 25.0),
    ]
    result = judge(pair, records, 25.0, 0.1)
    assert result.min_separation_m == pytest.approx(apart)
    assert result.reasons == reasons
    free = pair.avoidance.model_copy(update={"between_vehicles": False})
    assert judge(pair.model_copy(update={"avoidance": free}), records, 25.0, 0.1).reasons == ()


def test_separation_is_found_between_samples(pair: Scenario) -> None:
    def crossing(time: np.ndarray) -> np.ndarray:
        return straight(time) * (-1.0, 1.0, 1.0) + (0.25, 3.0, 0.0)

    one, other = pair.vehicles
    records = [record_of(one, straight, 25.0), record_of(other, crossing, 25.0)]
    distances = np.linalg.norm(records[0].p_n - records[1].p_n, axis=1)
    assert distances.min() > 3.005
    assert min_separation(records) == pytest.approx(3.0, abs=1e-9)


def test_a_state_that_is_no_number_is_bad_and_still_json(
    scenario: Scenario, record: FlightRecord
) -> None:
    p_n = record.p_n.copy()
    p_n[1200:] = np.nan
    broken = replace(record, p_n=p_n, airspeed=np.full_like(record.airspeed, np.inf))
    result = judge(scenario, [broken], 25.0, 0.0)
    assert result.reasons == ("numbers: the state of vehicle 1 is not finite",)
    written = json.loads(result.to_json())
    assert written["vehicles"][0]["airspeed_mps"] == [None, None]
    assert written["realtime_factor"] is None


def test_a_file_is_replaced_whole(tmp_path: Path) -> None:
    file = tmp_path / "x.json"
    write_atomically(file, "first")
    write_atomically(file, b"second")
    assert file.read_bytes() == b"second"
    assert list(tmp_path.iterdir()) == [file]


TOWER = """
[[obstacle]]
name = "tower"
shape = "cylinder"
position_m = [-200, 60, -50]
radius_m = 20
height_m = 200
"""
FENCE = """
[fence]
floor_m = 60
ceiling_m = 150

[[fence.zone]]
kind = "include"
polygon_m = [[-600, -50], [300, -50], [300, 50], [-600, 50]]

[[fence.zone]]
kind = "exclude"
centre_m = [-200, 45]
radius_m = 30
"""


@pytest.fixture
def fenced(tmp_path: Path) -> Scenario:
    return loaded_from(tmp_path, MINIMAL + FENCE).scenario


def test_clearance_inside_a_fence(fenced: Scenario) -> None:
    result = judge(fenced, [record_of(fenced.vehicles[0], straight, 25.0)], 25.0, 0.1)
    assert result.verdict == "good"
    assert result.vehicles[0].fence_clearance_m == pytest.approx(15.0, abs=1e-3)


@pytest.mark.parametrize(
    ("by", "reasons"),
    [
        ((0.0, -53.1, 0.0), ["outside fence.zone[0] by 3.1 m after 0.0 s"]),
        ((0.0, 18.0, 0.0), ["inside fence.zone[1] by 3.0 m after 11.5 s"]),
        ((0.0, 0.0, 41.2), ["below fence.floor_m by 1.2 m after 0.0 s"]),
        ((0.0, 0.0, -52.0), ["above fence.ceiling_m by 2.0 m after 0.0 s"]),
        (
            (0.0, -51.0, -51.0),
            [
                "outside fence.zone[0] by 1.0 m after 0.0 s",
                "above fence.ceiling_m by 1.0 m after 0.0 s",
            ],
        ),
    ],
)
def test_a_violation_of_the_fence_is_bad(
    fenced: Scenario, by: tuple[float, float, float], reasons: list[str]
) -> None:
    result = judge(fenced, [record_of(fenced.vehicles[0], moved(straight, by), 25.0)], 25.0, 0.1)
    told = [reason for reason in result.reasons if reason.startswith("fence")]
    assert told == [f"fence: vehicle 1 {reason}" for reason in reasons]
    assert result.verdict == "bad"
    least = result.vehicles[0].fence_clearance_m
    assert least is not None
    assert least < 0.0


def guarded(scenario: Scenario, *acting: tuple[int, int, float, float]) -> FlightRecord:
    """A straight flight; `acting`: from and to which sample, for what reason and hazard."""
    record = record_of(scenario.vehicles[0], straight, 25.0)
    guard = np.tile((0.0, 12.0, np.inf, -1.0), (len(record.time), 1))
    guard[:10] = 0.0  # nothing decided yet
    for first, last, reason, hazard in acting:
        guard[first:last] = (reason, 9.0, 3.0, hazard)
    return replace(record, decisions=Decisions(*guard.T))


def test_episodes_of_the_assurance(tmp_path: Path) -> None:
    scenario = loaded_from(tmp_path, MINIMAL + TOWER + FENCE).scenario
    record = guarded(
        scenario,
        (100, 150, 1.0, 0.0),
        (190, 200, 1.0, -1.0),
        (300, 320, 2.0, 2.0),
        (500, 510, 1.0, -1.0),
        (600, 610, 1.0, 3.0),
    )
    its = judge(scenario, [record], 25.0, 0.1).vehicles[0].assurance
    assert its is not None
    assert (its.decided, its.escape, its.least_bad) == (1241, 80, 20)
    assert its.acting_share == pytest.approx(100 / 1241, abs=1e-6)
    assert its.min_margin_m == 9.0
    assert [(e.from_s, e.to_s, e.reason, e.hazard) for e in its.episodes] == [
        (2.0, 4.0, "escape", "tower"),
        (6.0, 6.4, "least bad", "fence.zone[1]"),
        (10.0, 10.2, "escape", None),
        (12.0, 12.2, "escape", "fence.floor_m"),
    ]


def test_an_assurance_that_never_acts(tmp_path: Path) -> None:
    scenario = loaded_from(tmp_path, MINIMAL + TOWER).scenario
    its = judge(scenario, [guarded(scenario)], 25.0, 0.1).vehicles[0].assurance
    assert its is not None
    assert (its.acting_share, its.episodes, its.min_margin_m) == (0.0, (), 12.0)
