"""Fields from sea level to 6000 m: each aircraft flies there as it does below, or is refused."""

import math
from pathlib import Path

import pytest

from vfguide.aircraft.envelope import turn_radius
from vfguide.files.errors import InputError
from vfguide.preflight.load import load_scenario
from vfguide.results.judge import judge
from vfguide.results.result import VehicleResult
from vfguide.runs.lockstep import fly_scenario
from vfguide.scenario.loaded import LoadedScenario

pytestmark = pytest.mark.slow

FLOWN = [
    ("aerosonde", 0, None),
    ("aerosonde", 1500, None),
    ("aerosonde", 3000, None),
    ("aerosonde", 4500, 28.0),
    ("aerosonde", 6000, 28.0),
    ("easystar", 0, None),
    ("easystar", 1500, None),
    ("easystar", 3000, None),
    ("easystar", 4500, None),
    ("easystar", 6000, None),
    ("c172p", 0, None),
    ("c172p", 1500, None),
    ("c172p", 3000, None),
]
"""Aircraft, height of the field [m], and airspeed where it is not the cruise [m/s]."""
REFUSED = [("aerosonde", 4500), ("aerosonde", 6000), ("c172p", 4500)]
"""Aircraft and heights of fields where the thrust does not hold the cruise."""
SIZES = {"aerosonde": 55.0, "easystar": 13.0, "c172p": 206.0}
"""Turn radii at sea level, to which the places are scaled [m]."""


def field(folder: Path, aircraft: str, altitude: float, airspeed: float | None) -> Path:
    """A scenario of two poses, 5 to 10 turn radii apart, with a climb and a descent."""
    size, speed = SIZES[aircraft], "" if airspeed is None else f"airspeed_mps = {airspeed}"
    low, high = -(130.0 + 2.0 * size), -(130.0 + 2.6 * size)
    path = folder / "field.toml"
    path.write_text(f"""\
name = "field"
duration_s = 400

[origin]
altitude_m = {altitude}

[[vehicle]]
id = 1
position_m = [{-8.5 * size}, {-5.5 * size}, {low}]
heading_deg = 20
aircraft = "{aircraft}"
{speed}

[[vehicle.goal]]
position_m = [0, 0, {high}]
heading_deg = 100

[[vehicle.goal]]
position_m = [{-6.0 * size}, {7.0 * size}, {low}]
heading_deg = 350
""")
    return path


def flown(path: Path) -> tuple[LoadedScenario, VehicleResult]:
    """The scenario of a file and its result."""
    loaded = load_scenario(path)
    flight = fly_scenario(loaded, path.parent)
    result = judge(loaded.scenario, flight.records, flight.sim_s, flight.wall_s)
    return loaded, result.vehicles[0]


@pytest.mark.parametrize(("aircraft", "altitude", "airspeed"), FLOWN)
def test_poses_are_met_in_any_air(tmp_path, aircraft, altitude, airspeed):
    loaded, result = flown(field(tmp_path, aircraft, altitude, airspeed))
    vehicle = loaded.scenario.vehicles[0]
    gains = loaded.gains(vehicle)
    radius = turn_radius(gains.airspeed, 0.0, gains.bank_max, 1.0)
    for goal in result.goals:
        assert goal.reached
        assert goal.miss_m < 0.02 * radius + 0.5
        assert max(goal.course_error_deg, goal.climb_error_deg) < 3.0
    assert result.max_bank_deg < 55.0
    assert result.load_factor[0] > 0.3
    assert result.load_factor[1] < 2.2
    assert result.airspeed_mps[0] > 1.1 * loaded.performance_aloft(vehicle).airspeed_min


@pytest.mark.parametrize(("aircraft", "altitude"), REFUSED)
def test_what_the_thrust_does_not_hold_is_refused_with_what_it_holds(tmp_path, aircraft, altitude):
    highest = altitude + 130.0 + 2.6 * SIZES[aircraft]
    rule = rf"is not held by the thrust of {aircraft} at {highest:.0f} m, allowed \d"
    with pytest.raises(InputError, match=rule) as refused:
        load_scenario(field(tmp_path, aircraft, altitude, None))
    allowed = str(refused.value).split("allowed ")[1].split(" (")[0]
    slowest, fastest = map(float, allowed.split(" to "))
    for airspeed in (slowest, fastest):
        load_scenario(field(tmp_path, aircraft, altitude, airspeed))
    for airspeed in (slowest - 0.2, fastest + 0.2):
        with pytest.raises(InputError, match=r"vehicle\[0\]\.airspeed_mps"):
            load_scenario(field(tmp_path, aircraft, altitude, airspeed))


@pytest.mark.parametrize(("aircraft", "altitude"), [("aerosonde", 9500), ("c172p", 6000)])
def test_above_its_ceiling_an_aircraft_is_told_how_high_it_may_fly(tmp_path, aircraft, altitude):
    with pytest.raises(InputError, match="nor any other one; allowed are goals up to ") as refused:
        load_scenario(field(tmp_path, aircraft, altitude, None))
    height = float(str(refused.value).split("up to ")[1].split(" m")[0])
    room = 130.0 + 2.6 * SIZES[aircraft]
    assert height < altitude + room
    with pytest.raises(InputError, match=r", allowed [0-9.]+ to "):
        load_scenario(field(tmp_path, aircraft, height - room, None))


def test_airspeeds_of_scenarios_are_true_and_those_of_aircraft_equivalent(tmp_path):
    for altitude in (0, 1500, 3000):
        loaded = load_scenario(field(tmp_path, "aerosonde", altitude, None))
        vehicle = loaded.scenario.vehicles[0]
        thinner = (1.0 - 0.0065 * (altitude + 273.0) / 288.15) ** 4.255876
        assert vehicle.airspeed_mps == pytest.approx(25.0 / math.sqrt(thinner), rel=1e-4)
        least = loaded.performance_aloft(vehicle).airspeed_min
        assert least == pytest.approx(18.0 / math.sqrt(thinner), rel=1e-4)
        with pytest.raises(InputError, match="below the minimum of aerosonde"):
            load_scenario(field(tmp_path, "aerosonde", altitude, least - 0.1))
