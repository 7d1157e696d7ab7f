"""Warnings of a plan: `check`, `run` and `fly` tell each of them once."""

import signal

import pytest
from programs import Program, companion_port, free_vehicles
from typer.testing import CliRunner

from vfguide.cli.app import app

pytestmark = pytest.mark.slow

MEETING = """
name = "meeting"
duration_s = 25.0
[avoidance]
detection_range_m = 60.0
[[vehicle]]
id = {one}
position_m = [-500.0, 0.0, -120.0]
heading_deg = 0.0
[[vehicle.goal]]
position_m = [600.0, 0.0, -120.0]
heading_deg = 0.0
[[vehicle]]
id = {other}
position_m = [0.0, -500.0, -120.0]
heading_deg = 90.0
[[vehicle.goal]]
position_m = [0.0, 600.0, -120.0]
heading_deg = 90.0
[[obstacle]]
name = "tower"
shape = "cylinder"
position_m = [900.0, 900.0, 0.0]
radius_m = 50.0
height_m = 400.0
"""
RANGE = "avoidance.detection_range_m = 60 m is less than the "


@pytest.fixture
def ids():
    return free_vehicles(2)


@pytest.fixture
def file(tmp_path, ids):
    path = tmp_path / "meeting.toml"
    path.write_text(MEETING.format(one=ids[0], other=ids[1]))
    return path


def told_once(output, ids):
    text = " ".join(output.split())
    assert text.count(RANGE) == 1
    assert text.count(f"vehicles {ids[0]} and {ids[1]} come within") == 1


def test_check(file, ids):
    done = CliRunner().invoke(app, ["check", str(file)])
    assert done.exit_code == 0
    told_once(done.output, ids)


@pytest.mark.parametrize(
    "command", [("run", "--no-report", "--set", "duration_s=21"), ("fly", "--connect")]
)
def test_run_and_fly(command, file, ids):
    name, *options = command
    if name == "fly":
        options = ("--vehicle", ids[0], *options, f"udpin:127.0.0.1:{companion_port(ids[0])}")
    with Program(name, file, *options, cwd=file.parent) as program:
        if name == "fly":
            program.says("waiting for the autopilot")
            program.send(signal.SIGINT)
        program.status(120.0)
        told_once(program.text, ids)
