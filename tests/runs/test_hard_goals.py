"""Goals on the simulated Aerosonde that once were missed for ever, or reached in no good order."""

import math
from itertools import pairwise

import numpy as np
import pytest

from vfguide.preflight.load import load_scenario
from vfguide.results.judge import judge
from vfguide.runs.lockstep import fly_scenario

pytestmark = pytest.mark.slow


def flown(folder, start, heading_deg, goals, wind=(0.0, 0.0), *changes):
    """Result and record of a flight; goals (x, y, z, heading, climb), wind (speed, from)."""
    written = ", ".join(
        f"{{position_m=[{x}, {y}, {z}], heading_deg={heading % 360.0}, climb_deg={climb}}}"
        for x, y, z, heading, climb in goals
    )
    loaded = load_scenario(
        "first-flight",
        (
            f"vehicle.0.position_m={list(start)}",
            f"vehicle.0.heading_deg={heading_deg}",
            f"vehicle.0.goal=[{written}]",
            f"wind.speed_mps={wind[0]}",
            f"wind.from_deg={wind[1]}",
            "guidance.airspeed_mps=25",
            "origin.altitude_m=0",
            "duration_s=200",
            *changes,
        ),
    )
    flight = fly_scenario(loaded, folder)
    return judge(loaded.scenario, flight.records, flight.sim_s, flight.wall_s), flight.records[0]


@pytest.mark.parametrize(
    ("start", "heading", "goal", "wind"),
    [
        pytest.param(
            (44.9, 112.5, -60.7), 208.0, (0, 0, -150, 255.3, 0.0), (0, 0), id="from above"
        ),
        pytest.param(
            (10.0, 5.0, -230.0), 17.0, (0, 0, -150, 57.3, 0.0), (0, 0), id="over the goal"
        ),
        pytest.param((28.4, -239.7, -76.3), 319.4, (0, 0, -150, 141.9, 0.0), (0, 0), id="climbing"),
        pytest.param(
            (216.7, 65.2, -91.4), 102.0, (0, 0, -150, 215.5, 5.7), (0, 0), id="dived to the ground"
        ),
        pytest.param(
            (63.2, 5.9, -208.8), 320.0, (0, 0, -150, 150.3, -6.9), (8, 38), id="climbed away"
        ),
        pytest.param(
            (-600.0, 100.0, -150.0), 0.0, (0, 0, -150, 0.0, 8.0), (0, 0), id="climb angle"
        ),
    ],
)
def test_a_hard_goal_is_reached_exactly_and_soon(tmp_path, start, heading, goal, wind):
    result, record = flown(tmp_path, start, heading, [goal], wind)
    assert result.verdict == "good", result.reasons
    (found,) = result.vehicles[0].goals
    assert found.miss_m < 0.35
    assert found.course_error_deg < 1.0
    assert found.climb_error_deg < 1.0
    assert found.time_s < 60.0
    lowest, highest = max(start[2], goal[2]), min(start[2], goal[2])
    assert record.p_n[:, 2].max() < lowest + 8.0
    assert record.p_n[:, 2].min() > highest - 8.0


def test_goals_in_line_are_flown_through_in_line(tmp_path):
    goals = [(20.0 * k, 0.0, -150.0, 0.0, 0.0) for k in range(4)]
    result, _ = flown(tmp_path, (-400.0, 0.0, -150.0), 0.0, goals)
    assert result.verdict == "good", result.reasons
    times = [goal.time_s for goal in result.vehicles[0].goals]
    assert max(goal.miss_m for goal in result.vehicles[0].goals) < 0.1
    assert [later - sooner for sooner, later in pairwise(times)] == pytest.approx(
        [0.8] * 3, abs=0.1
    )


def test_a_long_descent_does_not_exceed_the_airspeed(tmp_path):
    """The engine at rest, 10 degrees down: 35.5 m/s once, the limit is 32."""
    start, goal = (-1500.0, 0.0, -450.0), (0.0, 0.0, -100.0, 0.0, 0.0)
    result, record = flown(tmp_path, start, 0.0, [goal])
    assert result.verdict == "good", result.reasons
    assert record.airspeed.max() < 32.0


@pytest.mark.parametrize("airspeed", [18.8, 31.0])
@pytest.mark.parametrize("height", [-60.0, 60.0])
def test_height_changes_at_the_slowest_and_the_fastest_airspeed_too(tmp_path, airspeed, height):
    result, record = flown(
        tmp_path,
        (-300.0, 50.0, -150.0 + height),
        0.0,
        [(0.0, 0.0, -150.0, 57.3, 0.0)],
        (3.0, 215.0),
        f"guidance.airspeed_mps={airspeed}",
        f"vehicle.0.airspeed_mps={airspeed}",
    )
    assert result.verdict == "good", result.reasons
    assert record.airspeed.min() > 17.2
    assert np.isfinite(record.load_factor).all()
    assert math.isfinite(result.vehicles[0].goals[0].time_s)
