"""Same seed, same bytes; recorded inputs, same setpoints."""

import json
import tomllib

import pytest
from commands import vfguide, vfguide_alone
from flights import FIRST_FLIGHT, scenario_file

from vfguide.files.data import find_scenario, shipped_scenarios
from vfguide.preflight.load import load_scenario
from vfguide.runs.lockstep import fly_scenario

pytestmark = pytest.mark.slow


def fly(path, folder, *changes):
    folder.mkdir()
    fly_scenario(load_scenario(path, changes), folder)
    return (folder / "flight.tlog").read_bytes(), (folder / "vehicle-7.tlog").read_bytes()


@pytest.fixture(scope="module")
def flown(tmp_path_factory):
    """One flight of the short scenario: its folder and its bytes."""
    folder = tmp_path_factory.mktemp("flown")
    done = vfguide_alone("run", scenario_file(folder), "--out", "run", "--no-report", cwd=folder)
    assert done.returncode == 0, done.stderr + done.stdout
    return folder / "run"


def test_same_bytes_in_another_process_and_after_other_runs(flown, tmp_path):
    path = scenario_file(tmp_path)
    fly(path, tmp_path / "other", "seed=5", "wind.turbulence='severe'", "duration_s=8")
    fly(path, tmp_path / "another", "vehicle.0.heading_deg=200", "duration_s=5")
    everything, own = fly(path, tmp_path / "again")
    assert everything == (flown / "flight.tlog").read_bytes()
    assert own == (flown / "vehicle-7.tlog").read_bytes()


def test_the_resolved_scenario_flies_the_same(flown, tmp_path):
    everything, _ = fly(flown / "scenario.toml", tmp_path / "again")
    assert everything == (flown / "flight.tlog").read_bytes()


def test_another_seed_gives_other_gusts(flown, tmp_path):
    everything, _ = fly(scenario_file(tmp_path), tmp_path / "other", "seed=2")
    assert everything != (flown / "flight.tlog").read_bytes()


def test_another_vehicle_does_not_change_this_one(flown, tmp_path):
    second = FIRST_FLIGHT + FIRST_FLIGHT[FIRST_FLIGHT.index("[[vehicle]]") :].replace(
        "id = 7", "id = 3"
    ).replace("[-300.0, 100.0, -120.0]", "[-300.0, 400.0, -160.0]").replace(
        "[0.0, 0.0, -125.0]", "[0.0, 500.0, -165.0]"
    )
    _, own = fly(scenario_file(tmp_path, second), tmp_path / "two")
    alone = (flown / "vehicle-7.tlog").read_bytes()
    shorter = min(len(own), len(alone))
    assert shorter > 100_000
    assert own[:shorter] == alone[:shorter]


def test_replay_is_identical_in_a_new_process(flown):
    done = vfguide_alone("replay", flown / "vehicle-7.tlog", cwd=flown)
    assert done.returncode == 0, done.stderr + done.stdout
    assert "identical" in done.stdout


def test_replay_from_the_log_of_everything(flown):
    done = vfguide("replay", flown / "flight.tlog", cwd=flown)
    assert done.returncode == 0, done.stderr + done.stdout


def test_replay_with_another_gain_names_the_first_difference(flown):
    done = vfguide("replay", "vehicle-7.tlog", "--set", "guidance.k_w=3.4", cwd=flown)
    assert done.returncode == 1
    assert "different, first at setpoint 0" in done.stdout
    assert "rate: recorded" in done.stdout


def test_replay_writes_what_it_received_and_sent(flown, tmp_path):
    done = vfguide("replay", "vehicle-7.tlog", "--out", tmp_path / "new", cwd=flown)
    assert done.returncode == 0, done.stderr
    again = vfguide(
        *("replay", tmp_path / "new" / "vehicle-7.tlog", "--scenario", "scenario.toml"), cwd=flown
    )
    assert again.returncode == 0, again.stderr


def names_a_plant(scenario):
    """Plant jsbsim is that of those that name none."""
    return "plant" in tomllib.loads(find_scenario(scenario).read_text())


AEROPLANES = [name for name in shipped_scenarios() if not names_a_plant(name)]


@pytest.mark.parametrize("name", AEROPLANES)
def test_every_shipped_flight_of_aeroplanes_is_good_and_replays(name, tmp_path):
    done = vfguide("run", name, "--out", "run", "--no-report", cwd=tmp_path)
    assert done.returncode == 0, done.stderr + done.stdout
    result = json.loads((tmp_path / "run" / "result.json").read_text())
    assert result["verdict"] == "good"
    for vehicle in result["vehicles"]:
        log = tmp_path / "run" / f"vehicle-{vehicle['id']}.tlog"
        replayed = vfguide("replay", log, cwd=tmp_path)
        assert replayed.returncode == 0, replayed.stderr + replayed.stdout
