"""Whole flights of aircraft that are not the Aerosonde, by the same code, judged by the truth.

The whole table is printed by tools/measure_poses.py --aircraft NAME.
"""

import json
import math
import os
import re
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import measure_poses
import pytest
from commands import vfguide
from pose_options import options

from vfguide.files.data import data_folder
from vfguide.preflight.load import load_scenario
from vfguide.results.judge import judge
from vfguide.runs.lockstep import fly_scenario

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize(
    ("aircraft", "number", "wind"),
    [
        ("easystar", 11, 3.7),
        ("easystar", 22, 3.7),
        ("easystar", 41, 3.7),
        ("easystar", 3, 0.0),
        ("easystar", 18, 0.0),
        ("c172p", 0, 15.0),
        ("c172p", 18, 15.0),
        ("c172p", 47, 15.0),
    ],
)
def test_random_start(aircraft, number, wind):
    """Among the worst of the table; EasyStar 3 and 18 and Cessna 0 once circled for ever."""
    flown, frame = (
        measure_poses.fly(number, options(aircraft=aircraft, wind=wind)),
        measure_poses.frame_of(aircraft),
    )
    assert flown.reached, flown
    assert flown.miss_m <= frame.most_miss
    assert flown.course_deg <= 3.0
    assert flown.bank_deg <= 55.0
    assert flown.load[0] >= 0.3
    assert flown.load[1] <= 2.2
    assert flown.airspeed[0] >= 1.2 * frame.stall
    assert flown.below_m <= 50.0


@pytest.mark.parametrize("number", [0, 5])
def test_a_slow_aircraft_reaches_its_goal_in_light_turbulence(number):
    """In a wind of a third of its airspeed; JSBSim's gusts made it miss by 2.1 and 0.8 m."""
    weather = {"wind": 3.5, "turbulence": "light", "nearest": 10.0, "height": 80.0}
    flown, frame = (
        measure_poses.fly(number, options(aircraft="easystar", **weather)),
        measure_poses.frame_of("easystar"),
    )
    assert flown.reached, flown
    assert flown.miss_m <= frame.most_miss
    assert flown.bank_deg <= 55.0
    assert flown.airspeed[0] >= 1.2 * frame.stall
    assert flown.below_m <= 10.0


def test_draws_are_alike_in_turn_radii():
    starts = {
        name: measure_poses.draw(1, 5, options(aircraft=name, wind=3.0))[2].partition("=")[2]
        for name in ("easystar", "c172p")
    }
    places = {
        name: [float(part) for part in text[1:-1].split(",")] for name, text in starts.items()
    }
    radii = {
        name: math.hypot(*place[:2]) / measure_poses.frame_of(name).radius
        for name, place in places.items()
    }
    assert radii["easystar"] == pytest.approx(radii["c172p"], rel=1e-3)
    assert measure_poses.frame_of("easystar").radius == pytest.approx(11.0**2 / 9.80665)
    assert measure_poses.frame_of("easystar").stall == pytest.approx(6.95, abs=0.1)


def test_a_stock_model_that_there_is_not_ends_with_one_message(tmp_path):
    shutil.copytree(data_folder() / "aircraft" / "c172p", tmp_path / "aircraft" / "c172p")
    file = tmp_path / "aircraft" / "c172p" / "c172p.toml"
    file.write_text(file.read_text().replace('stock = "c172p"', 'stock = "c172px"'))
    shutil.copy(data_folder() / "scenarios" / "cessna.toml", tmp_path)
    done = vfguide("run", "cessna.toml", "--out", "x", cwd=tmp_path)
    assert done.returncode == 2
    assert 'model.stock = "c172px": the jsbsim package ships no such aircraft' in done.stderr
    assert len(done.stderr.splitlines()) == 1
    assert not (tmp_path / "x").exists()


def with_slow_servos(folder: Path, roll_s: float) -> Path:
    """A scenario whose EasyStar has servos of 0.125 s instead of 0.03 s; its file says `roll_s`."""
    shutil.copytree(data_folder() / "aircraft" / "easystar", folder / "aircraft" / "easystar")
    model = folder / "aircraft" / "easystar" / "easystar.xml"
    model.write_text(model.read_text().replace("<lag> 33.3333 </lag>", "<lag> 8 </lag>"))
    file = model.with_suffix(".toml")
    file.write_text(file.read_text().replace("roll_s = 0.055", f"roll_s = {roll_s}"))
    shutil.copy(data_folder() / "scenarios" / "first-flight.toml", folder)
    return folder / "first-flight.toml"


def test_gains_follow_the_roll_response_of_the_file(tmp_path):
    changes, found = measure_poses.draw(1, 11, options(aircraft="easystar", wind=3.7)), []
    for roll_s in (0.055, 0.12):
        folder = tmp_path / str(roll_s)
        folder.mkdir()
        loaded = load_scenario(with_slow_servos(folder, roll_s), changes)
        flight = fly_scenario(loaded, folder)
        found.append(judge(loaded.scenario, flight.records, flight.sim_s, 1.0).vehicles[0])
    wrong, right = found
    assert right.goals[0].reached
    assert right.goals[0].course_error_deg <= 1.0
    assert right.load_factor[0] > 0.6 > wrong.load_factor[0]
    assert wrong.goals[0].course_error_deg > 2.0
    assert wrong.load_factor[1] - right.load_factor[1] > 0.2


def test_the_steps_of_the_page_work_as_written(tmp_path):
    """docs/aircraft.md, Another aircraft: from a stock model to a table of its flights."""
    text = (ROOT / "docs" / "aircraft.md").read_text().partition("## Another aircraft")[2]
    blocks = re.findall(r"^ +```(sh|toml)\n(.*?)^ +```", text, re.MULTILINE | re.DOTALL)
    commands = [textwrap.dedent(body) for kind, body in blocks if kind == "sh"]
    (scenario,) = [textwrap.dedent(body) for kind, body in blocks if kind == "toml"]
    (tmp_path / "tools").symlink_to(ROOT / "tools")
    (tmp_path / "cub.toml").write_text(scenario)
    where = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    said = ""
    for block in commands:
        done = subprocess.run(
            ["sh", "-ec", block],
            cwd=tmp_path,
            env={**os.environ, "PATH": where},
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, block + done.stdout + done.stderr
        said += done.stdout
    assert "the row holds" in said
    reached, starts, most = re.search(
        r"Here (\d+) of (\d+) were, missing by ([\d.]+) m at\s+most", text
    ).groups()
    assert f"reached     {reached} of {starts}" in said
    assert re.search(rf"miss \[m\] .* most {re.escape(most)}$", said, re.MULTILINE), said
    assert json.loads((tmp_path / "cub" / "result.json").read_text())["verdict"] == "good"
