"""Every kind of bad input gives one message that names file, key, value and what is allowed."""

from pathlib import Path

import pytest
from scenario_samples import message_for
from scenario_texts import MINIMAL, SECOND

from vfguide.files.errors import InputError
from vfguide.preflight.load import load_scenario

HEAD = "[[vehicle]]\nid = 1"
SENSORS = {
    "position_m": 100,
    "height_m": 100,
    "velocity_mps": 10,
    "attitude_deg": 20,
    "attitude_bias_deg": 20,
    "yaw_deg": 45,
    "yaw_bias_deg": 45,
    "rate_dps": 50,
    "rate_bias_dps": 50,
    "airspeed_mps": 20,
    "airspeed_bias_mps": 20,
    "wind_mps": 20,
}
"""Their keys and the largest values."""
GOAL = "position_m = [0, 0, -100]\nheading_deg = 0"


def in_vehicle(line: str) -> str:
    return MINIMAL.replace("id = 1", f"id = 1\n{line}")


def in_goal(line: str) -> str:
    return MINIMAL + line + "\n"


def at_top(line: str) -> str:
    return MINIMAL.replace(HEAD, f"{line}\n\n{HEAD}")


def instead_of_goal(lines: str) -> str:
    return MINIMAL.replace(GOAL, lines)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        # Unknown keys, before what they cause.
        (
            in_vehicle("airspeed = 25.0"),
            "vehicle[0].airspeed: unknown key, did you mean airspeed_mps?; allowed: "
            "id, position_m, heading_deg, attitude_deg, airspeed_mps, aircraft, icao, identify, "
            "goal",
        ),
        (
            MINIMAL.replace("id = 1", "Id = 1"),
            "vehicle[0].Id: unknown key; allowed: "
            "id, position_m, heading_deg, attitude_deg, airspeed_mps, aircraft, icao, identify, "
            "goal",
        ),
        (
            at_top("[wnd]\nspeed_mps = 3"),
            "wnd: unknown key, did you mean wind?; allowed: name, plant, law, duration_s, seed, "
            "start_time, origin, wind, weather, sensors, autopilot, link, guidance, avoidance, "
            "fence, traffic_receiver, vehicle, obstacle, traffic, vary",
        ),
        # Missing keys and empty lists.
        (MINIMAL.replace('name = "minimal"', ""), "name: missing, but required"),
        (MINIMAL.replace("id = 1\n", ""), "vehicle[0].id: missing, but required"),
        ('name = "x"', "vehicle: missing, but required"),
        ('name = "x"\nvehicle = []', "vehicle: empty, at least one is required"),
        (MINIMAL.split("[[vehicle.goal]]")[0], "vehicle[0].goal: missing, but required"),
        # Wrong types.
        (
            in_vehicle('heading_deg = "east"'),
            'vehicle[0].heading_deg = "east": wrong type, a number is required',
        ),
        (
            in_vehicle("heading_deg = true"),
            "vehicle[0].heading_deg = true: wrong type, a number is required",
        ),
        (
            MINIMAL.replace("id = 1", "id = 1.0"),
            "vehicle[0].id = 1.0: wrong type, a whole number is required",
        ),
        (MINIMAL.replace('"minimal"', "3"), "name = 3: wrong type, a string is required"),
        (
            at_top("[avoidance]\nbetween_vehicles = 1"),
            "avoidance.between_vehicles = 1: wrong type, true or false is required",
        ),
        (at_top("wind = 3"), "wind = 3: wrong type, a table is required"),
        (
            MINIMAL.replace("[[vehicle]]", "[vehicle]"),
            "vehicle = a table: wrong type, a list of tables is required",
        ),
        (
            at_top('start_time = "2026-01-01T00:00:00Z"'),
            'start_time = "2026-01-01T00:00:00Z": wrong type, '
            "a date and time such as 2026-01-01T00:00:00Z is required",
        ),
        (
            at_top("start_time = 2026-01-01T00:00:00"),
            "start_time = 2026-01-01T00:00:00: wrong type, "
            "a time with its zone, such as 2026-01-01T00:00:00Z, is required",
        ),
        (
            at_top("start_time = 1969-12-31T00:00:00Z"),
            "start_time = 1969-12-31T00:00:00+00:00: allowed 1970 to 2200",
        ),
        (
            MINIMAL.replace("[-500, 0, -100]", "[-500, -100]"),
            "vehicle[0].position_m = [-500, -100]: 2 values, a list of three numbers is required",
        ),
        (
            MINIMAL.replace("[-500, 0, -100]", "{x = 1}"),
            "vehicle[0].position_m = a table: wrong type, a list of three numbers is required",
        ),
        (
            MINIMAL.replace("[-500, 0, -100]", '[-500, "0", -100]'),
            'vehicle[0].position_m[1] = "0": wrong type, a number is required',
        ),
        # Numbers that are none.
        (
            in_vehicle("heading_deg = nan"),
            "vehicle[0].heading_deg = nan: not a number that can be used, a finite one is required",
        ),
        (
            MINIMAL.replace("[-500, 0, -100]", "[-inf, 0, -100]"),
            "vehicle[0].position_m[0] = -inf: not a number that can be used, a finite "
            "one is required",
        ),
        # Out of range, at each kind of bound.
        (
            in_vehicle("heading_deg = 361"),
            "vehicle[0].heading_deg = 361: too large, allowed -360 to 360",
        ),
        (MINIMAL.replace("id = 1", "id = 0"), "vehicle[0].id = 0: too small, allowed 1 to 250"),
        (MINIMAL.replace("id = 1", "id = 251"), "vehicle[0].id = 251: too large, allowed 1 to 250"),
        (at_top("duration_s = 0"), "duration_s = 0: too small, allowed above 0, up to 86400"),
        (at_top("seed = 4294967296"), "seed = 4294967296: too large, allowed 0 to 4294967295"),
        (
            at_top("[origin]\nlatitude_deg = 90.0"),
            "origin.latitude_deg = 90.0: too large, allowed -89 to 89",
        ),
        (
            in_goal("attempts = -1"),
            "vehicle[0].goal[0].attempts = -1: too small, allowed 0 to 1000",
        ),
        (
            in_goal("attempts = 2.0"),
            "vehicle[0].goal[0].attempts = 2.0: wrong type, a whole number is required",
        ),
        (
            'plant = "kinematic"\nlaw = "paper"\n' + in_goal("attempts = 2"),
            'vehicle[0].goal[0].attempts = 2: law = "paper" passes a goal once, allowed 0 to 1',
        ),
        (
            at_top('plant = "kinematic"\nlaw = "field"'),
            'law = "field": only plant = "jsbsim" flies it, allowed here "flight", "paper"',
        ),
        (
            at_top('law = "field"\n[guidance.remedies]\nsides = true'),
            "guidance.remedies.sides: unknown key, did you mean side?; allowed: "
            "relative_velocity, reactive_range, lead, unit_sum, side, bounded_circles, approach, "
            "search",
        ),
        (
            in_goal("tolerance_m = 0.0"),
            "vehicle[0].goal[0].tolerance_m = 0.0: too small, allowed above 0, up to 1000",
        ),
        (
            MINIMAL.replace("[-500, 0, -100]", "[-500, 1e9, -100]"),
            "vehicle[0].position_m = [-500, 1000000000.0, -100]: "
            "too far from the origin, allowed -100000 to 100000 on each axis",
        ),
        # Words.
        (
            at_top('[wind]\nturbulence = "ligth"'),
            'wind.turbulence = "ligth": unknown, did you mean light?; '
            'allowed "none", "light", "moderate", "severe"',
        ),
        (
            MINIMAL.replace('"minimal"', '"../x"'),
            'name = "../x": allowed are letters, digits, - _ . and spaces, a letter or digit first',
        ),
        (
            MINIMAL.replace('"minimal"', '""'),
            'name = "": allowed are letters, digits, - _ . and spaces, a letter or digit first',
        ),
        # What a campaign draws.
        (
            MINIMAL + "[vary]\nseed = [1, 2]",
            "vary = a table: seed: the campaign gives every flight a seed of its own",
        ),
        # The aircraft.
        (
            in_vehicle('aircraft = "aerosond"'),
            'vehicle[0].aircraft = "aerosond": no such aircraft, did you mean '
            "aerosonde?; allowed: aerosonde, c172p, easystar",
        ),
        (
            in_vehicle('aircraft = "../x"'),
            'vehicle[0].aircraft = "../x": no such aircraft; allowed: aerosonde, c172p, easystar',
        ),
        (
            in_vehicle("airspeed_mps = 12.0"),
            "vehicle[0].airspeed_mps = 12.0: below the minimum of aerosonde at 588 m, "
            "allowed 18.6 to 32.9 (true airspeed)",
        ),
        (
            in_vehicle("airspeed_mps = 34.0"),
            "vehicle[0].airspeed_mps = 34.0: above the maximum of aerosonde at 588 m, "
            "allowed 18.6 to 32.9 (true airspeed)",
        ),
        (
            at_top("[guidance]\nairspeed_mps = 40.0"),
            "guidance.airspeed_mps = 40.0: above the maximum of aerosonde at 588 m, "
            "allowed 18.6 to 32.9 (true airspeed)",
        ),
        (
            at_top("[guidance]\nbank_max_deg = 55.0"),
            "guidance.bank_max_deg = 55.0: above the maximum of aerosonde, allowed 5 to 50",
        ),
        (
            in_goal("climb_deg = 12.0"),
            "vehicle[0].goal[0].climb_deg = 12.0: above the maximum of aerosonde, "
            "allowed -10 to 10",
        ),
        (
            in_goal("climb_deg = -12.0"),
            "vehicle[0].goal[0].climb_deg = -12.0: below the minimum of aerosonde, "
            "allowed -10 to 10",
        ),
        (
            instead_of_goal("position_m = [0, 0, -100]\ndirection = [1, 0, -1]"),
            "vehicle[0].goal[0].direction = [1.0, 0.0, -1.0]: climbs by 45.0 degrees, "
            "above the maximum of aerosonde, allowed -10 to 10",
        ),
        # The goal.
        (
            in_goal("latitude_deg = 47.0"),
            "vehicle[0].goal[0]: its place must be given in exactly one way: "
            "position_m, or latitude_deg, longitude_deg and altitude_m",
        ),
        (
            instead_of_goal("latitude_deg = 47.0\nlongitude_deg = 8.5\nheading_deg = 0"),
            "vehicle[0].goal[0]: its place must be given in exactly one way: "
            "position_m, or latitude_deg, longitude_deg and altitude_m",
        ),
        (
            instead_of_goal("heading_deg = 0"),
            "vehicle[0].goal[0]: its place must be given in exactly one way: "
            "position_m, or latitude_deg, longitude_deg and altitude_m",
        ),
        (
            instead_of_goal(
                "latitude_deg = 0.0\nlongitude_deg = 8.5\naltitude_m = 600\nheading_deg = 0"
            ),
            "vehicle[0].goal[0].latitude_deg = 0.0: 5103 km from the origin, "
            "allowed up to 100 km on each axis",
        ),
        (
            instead_of_goal("position_m = [0, 0, -100]"),
            "vehicle[0].goal[0]: its course must be given in exactly one way: "
            "heading_deg, or direction",
        ),
        (
            in_goal("direction = [1, 0, 0]"),
            "vehicle[0].goal[0]: its course must be given in exactly one way: "
            "heading_deg, or direction",
        ),
        (
            instead_of_goal("position_m = [0, 0, -100]\ndirection = [0, 0, 0]"),
            "vehicle[0].goal[0].direction = [0.0, 0.0, 0.0]: has no direction, allowed "
            "is any vector but zero",
        ),
        (
            instead_of_goal("position_m = [0, 0, -100]\ndirection = [1, 0, 0]\nclimb_deg = 0"),
            "vehicle[0].goal[0].climb_deg = 0.0: not allowed beside direction, which "
            "has a climb of its own",
        ),
        # The ground.
        (
            MINIMAL.replace("[-500, 0, -100]", "[-500, 0, 0]"),
            "vehicle[0].position_m = [-500.0, 0.0, 0.0]: not above the ground; "
            "z points down, allowed z < 0 (above the origin's 488 m)",
        ),
        (
            MINIMAL.replace("[0, 0, -100]", "[0, 0, 100]"),
            "vehicle[0].goal[0].position_m = [0.0, 0.0, 100.0]: not above the ground; "
            "z points down, allowed z < 0 (above the origin's 488 m)",
        ),
        (
            instead_of_goal(
                "latitude_deg = 47.397742\nlongitude_deg = 8.545594\naltitude_m = "
                "480.0\nheading_deg = 0",
            ),
            "vehicle[0].goal[0].altitude_m = 480.0: not above the ground, allowed "
            "above 488.0 (see [origin])",
        ),
        # Between vehicles.
        (
            MINIMAL + SECOND.replace("id = 2", "id = 1"),
            "vehicle[1].id = 1: already the id of vehicle[0], each needs its own",
        ),
        (
            MINIMAL + SECOND.replace("[-500, 200, -100]", "[-500, 20, -100]"),
            "vehicle[1].position_m = [-500.0, 20.0, -100.0]: 20.0 m from vehicle[0], "
            "allowed more than 20 (two safety_radius_m)",
        ),
        (
            at_top("[avoidance]\ndetection_range_m = 20.0"),
            "avoidance.detection_range_m = 20.0: not beyond two safety radii, allowed above 20",
        ),
        # Wind, sensors and what autopilots have.
        (
            at_top("[wind]\nspeed_mps = 51.0"),
            "wind.speed_mps = 51.0: too large, allowed 0 to 50",
        ),
        (
            at_top("[wind]\nshear_mps_per_100m = -21.0"),
            "wind.shear_mps_per_100m = -21.0: too small, allowed -20 to 20",
        ),
        (
            at_top("[wind]\nshear_height_m = -1.0"),
            "wind.shear_height_m = -1.0: too small, allowed 0 to 10000",
        ),
        (
            at_top("[wind]\nchange = 3"),
            "wind.change = 3: wrong type, a list of tables is required",
        ),
        (
            at_top("[[wind.change]]\nspeed_mps = 3"),
            "wind.change[0].time_s: missing, but required",
        ),
        (
            at_top("[[wind.change]]\ntime_s = 3"),
            "wind.change[0].speed_mps: missing, but required",
        ),
        (
            at_top("[[wind.change]]\ntime_s = 0\nspeed_mps = 3"),
            "wind.change[0].time_s = 0: too small, allowed above 0, up to 86400",
        ),
        (
            at_top("[[wind.change]]\ntime_s = 1\nspeed_mps = 51"),
            "wind.change[0].speed_mps = 51: too large, allowed 0 to 50",
        ),
        (
            at_top("[[wind.change]]\ntime_s = 1\nspeed_mps = 5\nfrom_deg = 361"),
            "wind.change[0].from_deg = 361: too large, allowed -360 to 360",
        ),
        (
            at_top(
                "[[wind.change]]\ntime_s = 9\nspeed_mps = 3\n"
                "[[wind.change]]\ntime_s = 9\nspeed_mps = 4"
            ),
            "wind.change[1].time_s = 9.0: not after the change before it, allowed above 9",
        ),
        *(
            (
                at_top(f"[sensors]\n{key} = -1"),
                f"sensors.{key} = -1: too small, allowed 0 to {most}",
            )
            for key, most in SENSORS.items()
        ),
        (
            at_top("[sensors]\ndrift_s = 0"),
            "sensors.drift_s = 0: too small, allowed above 0, up to 86400",
        ),
        (
            at_top("[autopilot]\nairspeed_fails_at_s = -1"),
            "autopilot.airspeed_fails_at_s = -1: too small, allowed 0 to 86400",
        ),
        (
            at_top('[autopilot]\nairspeed_fault = "blockd"'),
            'autopilot.airspeed_fault = "blockd": unknown, did you mean blocked?; '
            'allowed "missing", "frozen", "blocked"',
        ),
        (
            at_top("[autopilot]\nthrust_scale = 0.0"),
            "autopilot.thrust_scale = 0.0: too small, allowed above 0, up to 2",
        ),
        (
            at_top("[autopilot]\nthrust_sag_per_min = 1.1"),
            "autopilot.thrust_sag_per_min = 1.1: too large, allowed 0 to 1",
        ),
        (
            at_top("[autopilot]\nthrust_floor = -0.1"),
            "autopilot.thrust_floor = -0.1: too small, allowed 0 to 1",
        ),
        (
            at_top("[autopilot]\nwind_message = 0"),
            "autopilot.wind_message = 0: wrong type, true or false is required",
        ),
        (
            at_top("[[autopilot.reset]]\nposition_m = [1, 2, 3]"),
            "autopilot.reset[0].time_s: missing, but required",
        ),
        (
            at_top("[[autopilot.reset]]\ntime_s = -1"),
            "autopilot.reset[0].time_s = -1: too small, allowed 0 to 86400",
        ),
        (
            at_top("[[autopilot.reset]]\ntime_s = 1\nposition_m = [1, 2]"),
            "autopilot.reset[0].position_m = [1, 2]: 2 values, a list of three numbers is required",
        ),
        (
            at_top("[[autopilot.reset]]\ntime_s = 1\norigin_m = [1, 2, 1e6]"),
            "autopilot.reset[0].origin_m = [1, 2, 1000000.0]: "
            "too far from the origin, allowed -100000 to 100000 on each axis",
        ),
        *(
            (
                at_top(f"[link]\n{key} = {value}"),
                f"link.{key} = {value}: {side}, allowed 0 to 2000",
            )
            for key in ("delay_ms", "delay_back_ms")
            for value, side in (("-1.0", "too small"), ("2001.0", "too large"))
        ),
        # What a rigid body does not have.
        (
            at_top('plant = "kinematic"\n[sensors]'),
            'sensors: plant = "kinematic" has no autopilot, allowed none',
        ),
        (
            at_top('plant = "kinematic"\n[autopilot]\nwind_message = false'),
            'autopilot: plant = "kinematic" has no autopilot, allowed none',
        ),
        (
            at_top('plant = "kinematic"\n[weather]\nqnh_hpa = 990.0'),
            'weather: plant = "kinematic" has no air, allowed none',
        ),
        (
            at_top('plant = "kinematic"\n[link]\ndelay_ms = 1.0'),
            'link: plant = "kinematic" has no autopilot, allowed none',
        ),
        (
            at_top('plant = "kinematic"\n[wind]\nshear_mps_per_100m = 1.0'),
            'wind.shear_mps_per_100m = 1.0: plant = "kinematic" has no wind, allowed 0',
        ),
        (
            at_top('plant = "kinematic"\n[[wind.change]]\ntime_s = 1\nspeed_mps = 1'),
            'wind.change: plant = "kinematic" has no wind, allowed none',
        ),
        # Not TOML.
        ("name = \n", "not valid TOML: Invalid value (at line 1, column 8)"),
        (
            'name = "a"\nname = "b"\n',
            "not valid TOML: Cannot overwrite a value (at line 2, column 11)",
        ),
    ],
)
def test_message(tmp_path: Path, text: str, message: str) -> None:
    assert message_for(tmp_path, text) == message


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"name = '\xff'", "not a text file in UTF-8"),
        (b"seed = " + b"9" * 5000, "not valid TOML: Exceeds the limit"),
        (b"seed = " + b"[" * 50_000, "not valid TOML: "),
    ],
)
def test_unreadable_content(tmp_path: Path, content: bytes, message: str) -> None:
    file = tmp_path / "x.toml"
    file.write_bytes(content)
    with pytest.raises(InputError) as error:
        load_scenario(file)
    assert str(error.value).startswith(f"{file}: {message}")


def test_a_number_too_large_for_a_float(tmp_path: Path) -> None:
    message = message_for(tmp_path, at_top(f"duration_s = 1{'0' * 400}"))
    assert message.startswith("duration_s = 1000")
    assert message.endswith("...: wrong type, a number is required")


def test_vehicles_may_start_together_when_they_do_not_avoid_each_other(tmp_path: Path) -> None:
    text = at_top("[avoidance]\nbetween_vehicles = false")
    file = tmp_path / "x.toml"
    file.write_text(text + SECOND.replace("[-500, 200, -100]", "[-500, 20, -100]"))
    assert len(load_scenario(file).scenario.vehicles) == 2


def test_a_byte_order_mark_is_no_fault(tmp_path: Path) -> None:
    file = tmp_path / "x.toml"
    file.write_bytes(b"\xef\xbb\xbf" + MINIMAL.encode())
    assert load_scenario(file).scenario.name == "minimal"
