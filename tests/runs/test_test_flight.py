"""Test flights before the goals: what an aircraft shows of which hardly anything is known."""

import json
import math
import shutil
import tomllib

import pytest
import tomli_w
from commands import vfguide

from vfguide.earth.atmosphere import isa_density
from vfguide.files.aircraft_file import load_aircraft
from vfguide.files.data import AircraftFiles, data_folder, find_aircraft
from vfguide.preflight.load import load_scenario
from vfguide.results.judge import judge
from vfguide.runs.lockstep import fly_scenario

pytestmark = pytest.mark.slow

SCENARIOS = {"aerosonde": "first-flight", "easystar": "easystar", "c172p": "cessna"}


def rough(folder, name):
    """A scenario whose aircraft file has airspeeds, limits, and a wrong trim and roll response."""
    ours = data_folder() / "aircraft" / name
    shutil.copytree(ours, folder / "aircraft" / name)
    known = tomllib.loads((ours / f"{name}.toml").read_text())
    del known["lift"]
    known["thrust"] = {"trim": known["thrust"]["trim"] + 0.2}
    known["response"] = {"roll_s": 0.3}
    (folder / "aircraft" / name / f"{name}.toml").write_text(tomli_w.dumps(known))
    path = folder / "rough.toml"
    shutil.copy(data_folder() / "scenarios" / f"{SCENARIOS[name]}.toml", path)
    return path


def fly(path, folder, *changes):
    loaded = load_scenario(path, ("vehicle.0.identify=true", "duration_s=600", *changes))
    flight = fly_scenario(loaded, folder)
    return judge(loaded.scenario, flight.records, flight.sim_s, flight.wall_s), flight.records[0]


def found_in(result):
    return {its.key.partition(".")[2]: its for its in result.vehicles[0].identified}


@pytest.mark.parametrize("name", SCENARIOS)
def test_what_is_left_out_of_a_file_is_found_in_flight(name, tmp_path):
    result, _ = fly(rough(tmp_path, name), tmp_path)
    found, known = found_in(result), load_aircraft(find_aircraft(name))
    assert all(its.used for its in found.values()), found
    assert found["alpha_zero_deg"].value == pytest.approx(known.lift.alpha_zero_deg, abs=0.2)
    load = known.lift.alpha_load_deg_m2ps2
    assert found["alpha_load_deg_m2ps2"].value == pytest.approx(load, rel=0.06)
    assert found["trim"].value == pytest.approx(known.thrust.trim, abs=0.02)
    assert found["per_climb"].value == pytest.approx(known.thrust.per_climb, rel=0.1)
    assert found["per_load"].value == pytest.approx(known.thrust.per_load, abs=0.07)
    assert found["thrust_s"].value == pytest.approx(known.response.thrust_s, rel=0.2)
    assert found["roll_s"].value == pytest.approx(known.response.roll_s, rel=0.3)
    assert result.verdict == "good", result.reasons
    assert all(
        goal.miss_m < 0.5 and goal.course_error_deg < 1.0 for goal in result.vehicles[0].goals
    )


@pytest.mark.parametrize("name", SCENARIOS)
def test_it_flies_without_a_test_flight_too(name, tmp_path):
    """Without [lift] there was once a division by zero in the first step."""
    changes = ("wind.turbulence=light", "vehicle.0.identify=false")
    result, _ = fly(rough(tmp_path, name), tmp_path, *changes)
    assert result.verdict == "good", result.reasons
    assert all(goal.course_error_deg < 3.0 for goal in result.vehicles[0].goals)


@pytest.mark.parametrize(
    "weather",
    [
        ("wind.speed_mps=8",),
        ("link.delay_ms=100",),
        ("wind.speed_mps=5", "wind.turbulence=light", "sensors={}"),
        ("wind.speed_mps=8", "wind.turbulence=moderate", "sensors={}"),
        ("autopilot.airspeed_fails_at_s=0",),
    ],
)
def test_what_is_found_is_found_in_any_weather(weather, tmp_path):
    """Turbulence and errors of sensors may hide a number, and must not make a wrong one."""
    result, _ = fly(rough(tmp_path, "aerosonde"), tmp_path, *weather)
    found, known = found_in(result), load_aircraft(find_aircraft("aerosonde"))
    assert found["roll_s"].used
    assert 0.06 < found["roll_s"].value < 0.11
    if found["per_climb"].used:
        # 3.23 in calm air, at this height and with the thrust that carries some of the weight.
        assert found["per_climb"].value == pytest.approx(3.23, rel=0.1)
    if found["alpha_load_deg_m2ps2"].used:
        load = known.lift.alpha_load_deg_m2ps2
        assert found["alpha_load_deg_m2ps2"].value == pytest.approx(load, rel=0.1)
    assert found["per_climb"].used == ("airspeed" not in weather[0])
    assert result.verdict == "good", result.reasons


@pytest.mark.parametrize("fault", ["missing", "frozen", "blocked"])
@pytest.mark.parametrize("after", [5.0, 20.0, 60.0])
def test_a_sensor_that_fails_on_the_way_leaves_no_wrong_number(fault, after, tmp_path):
    changes = (f"autopilot.airspeed_fails_at_s={after}", f"autopilot.airspeed_fault={fault}")
    result, _ = fly("identify", tmp_path, *changes)
    found, known = found_in(result), load_aircraft(find_aircraft("aerosonde"))
    assert found["roll_s"].used
    if found["trim"].used:
        assert found["trim"].value == pytest.approx(known.thrust.trim, abs=0.1)
    if found["per_climb"].used:
        assert found["per_climb"].value == pytest.approx(3.23, rel=0.2)
    if found["alpha_load_deg_m2ps2"].used:
        load = known.lift.alpha_load_deg_m2ps2
        assert found["alpha_load_deg_m2ps2"].value == pytest.approx(load, rel=0.2)
    assert result.verdict == "good", result.reasons
    assert result.vehicles[0].airspeed_mps[0] > 17.6


def test_an_aircraft_slower_than_its_file_says_is_found_out(tmp_path):
    """Servos of 0.125 s where the file's roll response is that of 0.03 s."""
    ours = data_folder() / "aircraft" / "easystar"
    shutil.copytree(ours, tmp_path / "aircraft" / "easystar")
    model = tmp_path / "aircraft" / "easystar" / "easystar.xml"
    model.write_text(model.read_text().replace("<lag> 33.3333 </lag>", "<lag> 8 </lag>"))
    shutil.copy(data_folder() / "scenarios" / "easystar.toml", tmp_path)
    result, record = fly(tmp_path / "easystar.toml", tmp_path)
    assert result.verdict == "good", result.reasons
    assert found_in(result)["roll_s"].value == pytest.approx(0.13, rel=0.15)
    flown = record.load_factor[record.time > record.goals_from]
    unknown, _ = fly(tmp_path / "easystar.toml", tmp_path, "vehicle.0.identify=false")
    assert min(flown) > unknown.vehicles[0].load_factor[0]
    assert all(goal.course_error_deg < 1.0 for goal in result.vehicles[0].goals)


def test_it_is_broken_off_when_something_comes_in_the_way(tmp_path):
    """An obstacle that is not known at the beginning stands on the way, after 48 s of it."""
    _, free = fly("identify", tmp_path)
    (there,) = free.p_n[abs(free.time - 48.0) < 0.005].tolist()
    mast = f'name="mast",shape="cylinder",position_m=[{there[0]},{there[1]},-150]'
    seen_late = f"obstacle=[{{{mast},radius_m=60,height_m=300,visible_from_m=90}}]"
    (tmp_path / "again").mkdir()
    result, record = fly("identify", tmp_path / "again", seen_late)
    assert result.verdict == "good", result.reasons
    assert result.vehicles[0].identified == ()
    assert 40.0 < record.goals_from < 48.0


def test_a_run_leaves_a_file_to_fly_by(tmp_path):
    done = vfguide("run", "identify", "--out", "out", cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    path = tmp_path / "out" / "aircraft-1" / "aerosonde.toml"
    assert vfguide("check", path, cwd=tmp_path).returncode == 0
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    its = load_aircraft(AircraftFiles("aerosonde", path.parent, path, None))
    found = {its["key"]: its["value"] for its in result["vehicles"][0]["identified"]}
    assert its.thrust.trim == pytest.approx(found["thrust.trim"], rel=1e-3)
    assert its.response.roll_s == pytest.approx(found["response.roll_s"], rel=1e-3)
    assert its.limits == load_aircraft(find_aircraft("aerosonde")).limits
    assert its.source.startswith("Measured in flight")
    assert "trim 0.3" in its.source or "trim 0.2" in its.source
    report = (tmp_path / "out" / "report.html").read_text()
    assert "Test flight" in report
    assert "lift.alpha_zero_deg" in report


def test_a_pass_of_the_goal_during_the_test_flight_does_not_count(tmp_path):
    """The goal lies on the first leg of the test flight, on its course."""
    changes = (
        "vehicle.0.position_m=[0, 0, -150]",
        "vehicle.0.heading_deg=0",
        "vehicle.0.goal.0.position_m=[60, 0, -150]",
        "vehicle.0.goal.0.heading_deg=0",
        "wind.speed_mps=0",
    )
    result, record = fly("identify", tmp_path, *changes)
    assert result.verdict == "good", result.reasons
    assert record.goals_from > 60.0
    tested = record.airspeed[record.time < record.goals_from]
    cruise = 25.0 * math.sqrt(isa_density(0.0) / isa_density(638.0))
    assert max(tested) == pytest.approx(1.15 * cruise, abs=0.5)
    assert min(tested) == pytest.approx(0.85 * cruise, abs=1.0)
    assert result.vehicles[0].goals[0].time_s > record.goals_from
    assert all(its.time > record.goals_from for its in record.legs().passes[0])


def test_a_rigid_body_has_nothing_to_be_found(tmp_path):
    text = (data_folder() / "scenarios" / "paper" / "example-1.toml").read_text()
    path = tmp_path / "body.toml"
    path.write_text(text.replace("[[vehicle]]\n", "[[vehicle]]\nidentify = true\n", 1))
    done = vfguide("check", path, cwd=tmp_path)
    assert done.returncode == 2
    assert "vehicle[0].identify" in done.stderr
    assert "Traceback" not in done.stderr
