"""`--set key=value` on a scenario."""

from pathlib import Path

import pytest
from scenario_samples import loaded_from

from vfguide.files.errors import InputError


def test_values_arrive_in_order_and_missing_tables_are_made(tmp_path: Path) -> None:
    overrides = ("wind.speed_mps=3", "wind.speed_mps=5", "vehicle.0.position_m.2=-200")
    scenario = loaded_from(tmp_path, overrides=overrides).scenario
    assert scenario.wind.speed_mps == 5.0
    assert scenario.vehicles[0].position_m == (-500.0, 0.0, -200.0)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            "guidance.k_ww=3",
            "guidance.k_ww: unknown key, did you mean k_w?; allowed: rate_hz, airspeed_mps, "
            "bank_max_deg, k_w, k_v, k_lateral, k_elevation, loiter, loiter_radius_m, remedies",
        ),
        (
            "nowhere.k=3",
            "nowhere: unknown key; allowed: name, plant, law, duration_s, seed, start_time, "
            "origin, wind, weather, sensors, autopilot, link, guidance, avoidance, fence, "
            "traffic_receiver, vehicle, obstacle, traffic, vary",
        ),
        ("seed=x", 'seed = "x": wrong type, a whole number is required'),
        ("wind.speed_mps=99", "wind.speed_mps = 99: too large, allowed 0 to 50"),
        (
            "vehicle.0.airspeed_mps=12",
            "vehicle[0].airspeed_mps = 12.0: below the minimum of aerosonde at 588 m, "
            "allowed 18.6 to 32.9 (true airspeed)",
        ),
        ("vehicle.1.id=2", "1 is no index here, allowed 0 to 0"),
        ("vehicle.x.id=2", "x is no index here, allowed 0 to 0"),
        ("vehicle.0.position_m.3=2", "3 is no index here, allowed 0 to 2"),
        ("name.x=2", "unknown key, x leads to nothing"),
        ("wind.0=2", "unknown key, 0 leads to nothing"),
    ],
)
def test_messages_name_the_override(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(InputError) as error:
        loaded_from(tmp_path, overrides=("duration_s=20", text, "wind.from_deg=10"))
    assert str(error.value) == f"{tmp_path / 'x.toml'}, --set {text}: {message}"
