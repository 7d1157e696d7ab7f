"""Other aircraft as scenarios write them, and how near they came."""

import pytest

from vfguide.airspace.hazards import Intruder
from vfguide.files.errors import InputError
from vfguide.kernels.rows import width
from vfguide.preflight.load import load_scenario
from vfguide.scenario.hazards import hazards_of
from vfguide.scenario.plans import plan_of

BASE = """
name = "two"
[[vehicle]]
id = 1
icao = "4b1a2c"
position_m = [0.0, 0.0, -100.0]
[[vehicle.goal]]
position_m = [500.0, 0.0, -100.0]
heading_deg = 0.0
"""
ONE = """
[[traffic]]
name = "ONE"
position_m = [900.0, 0.0, -100.0]
velocity_mps = [-30.0, 0.0, 0.0]
"""
CHANGES = """
[[traffic.change]]
time_s = 10.0
velocity_mps = [0.0, 30.0, 0.0]
[[traffic.change]]
time_s = {again}
velocity_mps = [0.0, 30.0, -3.0]
"""


def load(tmp_path, text, *overrides):
    path = tmp_path / "two.toml"
    path.write_text(text)
    return load_scenario(path, overrides)


def test_what_is_resolved_is_the_same_again(tmp_path):
    scenario = load(tmp_path, BASE + ONE + CHANGES.format(again=15.0)).scenario
    assert scenario.traffic[0].icao == "000001"
    assert scenario.vehicles[0].icao == "4B1A2C"
    assert load(tmp_path, scenario.to_toml()).scenario == scenario


def test_traffic_makes_the_companion_heed_reports(tmp_path):
    alone, among = load(tmp_path, BASE), load(tmp_path, BASE + ONE)
    asked = load(tmp_path, BASE, "avoidance.traffic=true")
    assert hazards_of(alone.scenario) is None
    assert hazards_of(among.scenario).traffic.shape == (0, width(Intruder))
    assert hazards_of(asked.scenario) is not None


def test_the_plan_has_volume_and_own_address(tmp_path):
    loaded = load(tmp_path, BASE, "avoidance.traffic_radius_m=153.0")
    plan = plan_of(loaded, loaded.scenario.vehicles[0])
    assert plan.volume == (153.0, 30.0, 3.0, 1.5)
    assert plan.own_icao == 0x4B1A2C


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (ONE + ONE, "already the name of traffic[0]"),
        (ONE + 'icao = "00000G"', "six hexadecimal digits"),
        (ONE + 'icao = "000000"', "six hexadecimal digits"),
        (ONE.replace("ONE", "TOO LONG!"), "1 to 8 letters and digits"),
        (ONE.replace("-30.0", "-301.0"), "allowed -300 to 300"),
        (ONE + CHANGES.format(again=14.0), "allowed from 15 on"),
        (ONE + 'icao = "000002"' + ONE.replace("ONE", "TWO"), "already the icao of traffic[0]"),
    ],
)
def test_what_is_not_allowed(tmp_path, text, says):
    with pytest.raises(InputError) as caught:
        load(tmp_path, BASE + text)
    assert says in str(caught.value)


def test_the_kinematic_plant_has_none(tmp_path):
    with pytest.raises(InputError, match="allowed none"):
        load(tmp_path, BASE.replace("\n", '\nplant = "kinematic"\n', 1) + ONE)
