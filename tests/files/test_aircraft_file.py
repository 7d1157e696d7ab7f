"""What the companion knows of an aircraft."""

import math
from pathlib import Path

import pytest
from aeroplanes import AEROSONDE, CESSNA, EASYSTAR

from vfguide.files.aircraft_file import load_aircraft
from vfguide.files.data import AircraftFiles, find_aircraft
from vfguide.files.errors import InputError

SHIPPED = find_aircraft("aerosonde")


@pytest.mark.parametrize(
    ("airspeed", "alpha_deg"), [(18.0, 8.3), (20.0, 6.25), (25.0, 3.11), (30.0, 1.40)]
)
def test_alpha_is_that_of_the_trimmed_model(airspeed: float, alpha_deg: float) -> None:
    its = load_aircraft(SHIPPED).performance()
    alpha = its.alpha_zero + its.alpha_load / airspeed**2
    assert math.degrees(alpha) == pytest.approx(alpha_deg, abs=0.02)


def test_the_flight_law_gets_si_and_radians() -> None:
    its = load_aircraft(SHIPPED).performance()
    assert (its.airspeed_min, its.airspeed_cruise, its.airspeed_max) == (18.0, 25.0, 32.0)
    assert (its.load_min, its.load_max) == (0.3, 1.7)
    assert its.bank_max == pytest.approx(math.radians(50.0))
    assert (its.climb_max, its.descent_max) == pytest.approx((math.radians(10.0),) * 2)
    assert its.rate_max == pytest.approx([math.radians(rate) for rate in (80.0, 35.0, 29.0)])


def test_the_thrust_slope_of_a_climb_is_weight_over_full_thrust() -> None:
    weight, full = 11.0 * 9.80665, 36.0
    its = load_aircraft(SHIPPED).performance()
    assert its.thrust_per_climb == pytest.approx(weight / full, rel=0.01)
    steepest = its.thrust_trim + its.thrust_per_climb * math.sin(its.climb_max)
    assert steepest < 0.9, "the steepest climb leaves thrust to hold the airspeed"


def test_a_level_turn_at_the_bank_limit_keeps_the_load_limit() -> None:
    its = load_aircraft(SHIPPED).performance()
    assert 1.0 / math.cos(its.bank_max) < its.load_max


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("min_mps = 18.0", "", "airspeed.min_mps: missing, but required"),
        (
            "min_mps = 18.0",
            "min_mps = 26.0",
            "airspeed.cruise_mps = 25.0: not between min_mps 26.0 and max_mps 32.0",
        ),
        (
            'name = "aerosonde"',
            'name = "x"',
            'name = "x": not the name of the file, allowed "aerosonde"',
        ),
        (
            "bank_max_deg = 50.0",
            "bank_max_deg = 90.0",
            "limits.bank_max_deg = 90.0: too large, allowed 5 to 75",
        ),
        (
            "roll_s = 0.08",
            "roll_s = 0.08\nroll = 1",
            "response.roll: unknown key, did you mean roll_s?; allowed: roll_s, thrust_s",
        ),
        ("trim = 0.30", "trim = nan", "thrust.trim = nan: not a number that can be used"),
    ],
)
def test_bad_files(tmp_path: Path, old: str, new: str, message: str) -> None:
    file = tmp_path / "aerosonde.toml"
    text = SHIPPED.performance.read_text()
    assert old in text
    file.write_text(text.replace(old, new))
    with pytest.raises(InputError) as error:
        load_aircraft(AircraftFiles("aerosonde", tmp_path, file, None))
    assert str(error.value).startswith(f"{file}: {message}")


@pytest.mark.parametrize(
    ("name", "same"), [("aerosonde", AEROSONDE), ("c172p", CESSNA), ("easystar", EASYSTAR)]
)
def test_the_aeroplanes_of_the_other_tests_are_those_of_the_files(name, same) -> None:
    assert load_aircraft(find_aircraft(name)).performance() == same
