"""Warnings of vehicles that would meet, against meetings that are known by hand."""

import math
import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scenario_samples import loaded_from

from vfguide.preflight.encounter_checks import closest_approach
from vfguide.preflight.prediction import PREDICTION_STEP

pytestmark = pytest.mark.slow

CROSSING = """
name = "crossing"
duration_s = 100.0
[[vehicle]]
id = 4
position_m = [-500.0, 0.0, -120.0]
heading_deg = 0.0
[[vehicle.goal]]
position_m = [600.0, 0.0, -120.0]
heading_deg = 0.0
[[vehicle]]
id = 9
position_m = [{north}, {east}, {down}]
heading_deg = 90.0
[[vehicle.goal]]
position_m = [{north}, 600.0, {down}]
heading_deg = 90.0
"""


def warnings_of(
    folder: Path, *changes: str, north: float = 0.0, east: float = -500.0, down: float = -120.0
) -> tuple[str, ...]:
    text = CROSSING.format(north=north, east=east, down=down)
    return loaded_from(folder, text, changes).warnings


def test_two_that_meet_are_named_with_time_and_distance(tmp_path: Path) -> None:
    (warning,) = warnings_of(tmp_path)
    assert warning == (
        f"{tmp_path / 'x.toml'}: vehicles 4 and 9 come within 0 m of each other after 19 s as they "
        "are planned, where 20 m are kept; they do not avoid each other: move a start or a goal"
    )


@pytest.mark.parametrize("late", [0.0, 10.0, 24.0, 27.0, 32.0, 60.0, 200.0])
@pytest.mark.parametrize("above", [0.0, 12.0, 40.0])
def test_two_at_right_angles_pass_at_a_distance_known_by_hand(
    tmp_path: Path, late: float, above: float
) -> None:
    """Equally fast, one `late` [m] behind: late / sqrt 2 apart, and what is above."""
    warnings = warnings_of(tmp_path, east=-500.0 - late, down=-120.0 - above)
    apart = math.hypot(late / math.sqrt(2.0), above)
    assert len(warnings) == (apart < 20.0)
    for each in warnings:
        distance, time = map(float, re.findall(r"within (\d+) m .* after (\d+) s", each)[0])
        assert distance == pytest.approx(apart, abs=1.0)
        assert time == pytest.approx(20.0 + 0.5 * late / 25.0, abs=1.0)


def test_the_radius_of_the_scenario_counts(tmp_path: Path) -> None:
    assert warnings_of(tmp_path, east=-550.0) == ()
    (warning,) = warnings_of(tmp_path, "avoidance.safety_radius_m=30", east=-550.0)
    assert "within 35 m" in warning
    assert "where 60 m are kept" in warning


def test_who_need_not_be_apart_or_avoids_the_other_is_not_warned_of(tmp_path: Path) -> None:
    assert warnings_of(tmp_path, "avoidance.between_vehicles=false") == ()
    assert warnings_of(tmp_path, 'plant="kinematic"', 'law="paper"') == ()
    assert len(warnings_of(tmp_path, 'plant="kinematic"')) == 1


def test_nothing_is_predicted_beyond_the_end_of_the_run(tmp_path: Path) -> None:
    assert len(warnings_of(tmp_path, "duration_s=25.0")) == 1
    assert warnings_of(tmp_path, "duration_s=15.0") == ()


paths = st.lists(
    st.tuples(st.floats(-90, 90), st.floats(-90, 90), st.floats(-9, 9)), min_size=3, max_size=6
)


@given(paths, paths)
def test_the_closest_approach_is_the_least_of_many_distances(
    one: list[tuple[float, float, float]], other: list[tuple[float, float, float]]
) -> None:
    count = min(len(one), len(other))
    first, second = np.array(one[:count]), np.array(other[:count])
    found = closest_approach(first, second)
    fine = np.linspace(0.0, count - 1.0, 100 * (count - 1) + 1)
    apart = np.column_stack(
        [np.interp(fine, np.arange(count), (first - second)[:, axis]) for axis in range(3)]
    )
    distances = np.linalg.norm(apart, axis=1)
    assert found.distance <= distances.min() + 1e-9
    assert found.distance >= distances.min() - 3.7
    at = np.interp(found.time / PREDICTION_STEP, fine, distances)
    assert found.distance == pytest.approx(at, abs=3.7)
