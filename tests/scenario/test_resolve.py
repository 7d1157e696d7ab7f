"""Scenarios as they are flown: defaults, goals in the scenario frame, the round trip."""

import math
from datetime import UTC, datetime
from pathlib import Path

import pymap3d
import pytest
from hypothesis import given
from hypothesis import strategies as st
from resolving import resolved_file, resolved_text
from scenario_texts import MINIMAL, SECOND

from vfguide.scenario.resolved import Scenario

RICH = """\
name = "rich 2.0_b-c"
duration_s = 60
seed = 4294967295
start_time = 2026-03-01T12:00:00.25+01:00

[origin]
latitude_deg = -33.9
longitude_deg = 151.2
altitude_m = 20

[wind]
speed_mps = 4.5
from_deg = -90
turbulence = "moderate"

[guidance]
airspeed_mps = 27.0
bank_max_deg = 45
loiter = "left"

[avoidance]
between_vehicles = false

[[vehicle]]
id = 250
position_m = [-500, 1e-7, -100]

[[vehicle.goal]]
latitude_deg = -33.903
longitude_deg = 151.207
altitude_m = 170
direction = [1, -1, -0.1]

[[vehicle.goal]]
position_m = [0.1, 0.2, -100.3]
heading_deg = 360
climb_deg = -3
tolerance_m = 2
tolerance_deg = 5

[[vehicle]]
id = 3
position_m = [-500, 0, -100]

[[vehicle.goal]]
position_m = [0, 0, -100]
heading_deg = 12.3456789012345
"""


def again(folder: Path, scenario: Scenario) -> Scenario:
    return resolved_text(folder, scenario.to_toml()).scenario


@pytest.mark.parametrize("text", [MINIMAL, MINIMAL + SECOND, RICH])
def test_the_resolved_file_resolves_to_the_same_scenario(tmp_path: Path, text: str) -> None:
    loaded = resolved_text(tmp_path, text)
    loaded.write_resolved(tmp_path / "scenario.toml")
    resolved = resolved_file(tmp_path / "scenario.toml")
    assert resolved.scenario == loaded.scenario
    assert resolved.aircraft == loaded.aircraft
    assert resolved.scenario.to_toml() == loaded.scenario.to_toml()


@given(
    st.floats(-80, 80),
    st.floats(-180, 180),
    st.floats(-1000, 1000),
    st.floats(-1000, 1000),
    st.floats(-500, -1),
    st.floats(-360, 360),
)
def test_no_bit_is_lost_on_the_way_through_the_file(
    tmp_path_factory: pytest.TempPathFactory,
    latitude: float,
    longitude: float,
    north: float,
    east: float,
    down: float,
    heading: float,
) -> None:
    folder = tmp_path_factory.mktemp("again")
    overrides = (
        f"origin.latitude_deg={latitude!r}",
        f"origin.longitude_deg={longitude!r}",
        f"vehicle.0.goal.0.position_m=[{north!r}, {east!r}, {down!r}]",
        f"vehicle.0.goal.0.heading_deg={heading!r}",
    )
    scenario = resolved_text(folder, overrides=overrides).scenario
    assert scenario.vehicles[0].goals[0].position_m == (north, east, down)
    assert again(folder, scenario) == scenario


def test_every_value_of_the_file_arrives(tmp_path: Path) -> None:
    scenario = resolved_text(tmp_path, RICH).scenario
    assert scenario.start_time == datetime(2026, 3, 1, 11, 0, 0, 250_000, tzinfo=UTC)
    assert (scenario.duration_s, scenario.seed) == (60.0, 4294967295)
    assert (scenario.wind.speed_mps, scenario.wind.turbulence) == (4.5, "moderate")
    assert scenario.guidance.loiter == "left"
    assert [vehicle.id for vehicle in scenario.vehicles] == [250, 3]
    second = scenario.vehicles[0].goals[1]
    assert second.model_dump() == {
        "position_m": (0.1, 0.2, -100.3),
        "heading_deg": 360.0,
        "climb_deg": -3.0,
        "tolerance_m": 2.0,
        "tolerance_deg": 5.0,
        "attempts": 0,
    }


def test_geographic_goals_lie_in_the_tangent_plane_at_the_origin(tmp_path: Path) -> None:
    goal = resolved_text(tmp_path, RICH).scenario.vehicles[0].goals[0]
    expected = pymap3d.geodetic2ned(-33.903, 151.207, 170.0, -33.9, 151.2, 20.0)
    assert goal.position_m == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize(
    ("direction", "heading", "climb"),
    [
        ("[1, 0, 0]", 0.0, 0.0),
        ("[0, 2, 0]", 90.0, 0.0),
        ("[-1, 0, 0]", 180.0, 0.0),
        ("[0, -0.5, 0]", -90.0, 0.0),
        ("[1, 1, 0]", 45.0, 0.0),
        ("[1, 0, -0.1]", 0.0, math.degrees(math.atan(0.1))),
        ("[1e-9, 0, 1e-10]", 0.0, -math.degrees(math.atan(0.1))),
    ],
)
def test_directions(tmp_path: Path, direction: str, heading: float, climb: float) -> None:
    text = MINIMAL.replace("heading_deg = 0", f"direction = {direction}")
    goal = resolved_text(tmp_path, text).scenario.vehicles[0].goals[0]
    assert (goal.heading_deg, goal.climb_deg) == pytest.approx((heading, climb), abs=1e-12)


def test_speeds_and_bank_to_fly(tmp_path: Path) -> None:
    text = MINIMAL.replace("id = 1", "id = 1\nairspeed_mps = 22.0")
    own = resolved_text(tmp_path, text)
    gains = own.gains(own.scenario.vehicles[0])
    assert (gains.airspeed, gains.bank_max) == pytest.approx((22.0, math.radians(50.0)))
    common = resolved_text(tmp_path, RICH)
    gains = common.gains(common.scenario.vehicles[1])
    assert (gains.airspeed, gains.bank_max) == pytest.approx((27.0, math.radians(45.0)))


@pytest.mark.parametrize(
    ("roll_s", "k_w", "k_lateral", "k_elevation", "response_lag"),
    [
        (0.04, 3.5, 1.2, 0.5, 0.0),
        (0.08, 3.5, 1.2, 0.5, 0.0),
        (0.16, 1.75, 1.2, 0.25, 0.08),
        (0.4, 0.7, 0.6, 0.1, 0.32),
    ],
)
def test_gains_follow_the_roll_response(
    tmp_path: Path,
    roll_s: float,
    k_w: float,
    k_lateral: float,
    k_elevation: float,
    response_lag: float,
) -> None:
    text = resolved_text(tmp_path).files["aerosonde"].performance.read_text()
    (tmp_path / "aircraft").mkdir()
    own = tmp_path / "aircraft" / "aerosonde.toml"
    own.write_text(text.replace("roll_s = 0.08", f"roll_s = {roll_s}"))
    loaded = resolved_text(tmp_path)
    gains = loaded.gains(loaded.scenario.vehicles[0])
    found = (gains.k_w, gains.k_lateral, gains.k_elevation, gains.response_lag)
    assert found == pytest.approx((k_w, k_lateral, k_elevation, response_lag))


def test_less_bank_is_asked_for_where_rolling_takes_long(tmp_path: Path) -> None:
    """With 1.2 a Cessna swung between 44 degrees to either side before the goal."""
    text = resolved_text(tmp_path).files["aerosonde"].performance.read_text()
    (tmp_path / "aircraft").mkdir()
    own = tmp_path / "aircraft" / "aerosonde.toml"
    own.write_text(text.replace("roll_rate_max_dps = 80.0", "roll_rate_max_dps = 20.0"))
    loaded = resolved_text(tmp_path)
    gains = loaded.gains(loaded.scenario.vehicles[0])
    bank_per_error = gains.k_lateral * gains.airspeed / 9.80665
    assert bank_per_error / math.radians(20.0) == pytest.approx(6.0)


def test_an_own_aircraft_goes_with_the_resolved_scenario(tmp_path: Path) -> None:
    own = tmp_path / "aircraft" / "mine"
    own.mkdir(parents=True)
    shipped = resolved_text(tmp_path).files["aerosonde"].performance.read_text()
    (own / "mine.toml").write_text(shipped.replace('name = "aerosonde"', 'name = "mine"'))
    (own / "mine.xml").write_text("<fdm_config/>")
    text = MINIMAL.replace("id = 1", 'id = 1\naircraft = "mine"')
    loaded = resolved_text(tmp_path, text)
    run = tmp_path / "run"
    run.mkdir()
    loaded.write_resolved(run / "scenario.toml")
    resolved = resolved_file(run / "scenario.toml")
    assert resolved.aircraft == loaded.aircraft
    assert resolved.files["mine"].model == run / "aircraft" / "mine" / "mine.xml"
    loaded.write_resolved(tmp_path / "scenario.toml")
    assert resolved_file(tmp_path / "scenario.toml").scenario == loaded.scenario
