"""Flights among other aircraft: kept clear of by their reports, hit without them."""

import json

import pytest
from commands import vfguide
from flights import scenario_file

pytestmark = pytest.mark.slow

HEAD_ON = """
name = "short"
duration_s = 90.0
[[vehicle]]
id = 7
position_m = [-800.0, 0.0, -120.0]
airspeed_mps = 25.0
[[vehicle.goal]]
position_m = [700.0, 0.0, -120.0]
heading_deg = 0.0
[[traffic]]
name = "HEADON"
position_m = [600.0, 10.0, -122.0]
velocity_mps = [-25.0, 0.0, 0.0]
position_error_m = 3.0
delay_s = 0.3
"""
UNHEARD = ("--no-report", "--set", "traffic_receiver.range_m=0")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("traffic")


def fly(folder, name, *options):
    done = vfguide("run", scenario_file(folder, HEAD_ON), "--out", name, *options, cwd=folder)
    return done, json.loads((folder / name / "result.json").read_text())


@pytest.fixture(scope="module")
def heard(folder):
    return fly(folder, "heard")


def test_it_keeps_clear_of_head_on_traffic(heard):
    done, result = heard
    assert done.returncode == 0, done.stderr + done.stdout
    (its,) = result["vehicles"][0]["traffic"]
    assert its["name"] == "HEADON"
    assert its["min_clearance_m"] > 0.0
    assert its["min_horizontal_m"] is None or its["min_horizontal_m"] > 50.0


def test_terminal_and_report_tell_of_the_traffic(folder, heard):
    done, result = heard
    (its,) = result["vehicles"][0]["traffic"]
    meeting = (600.0 + 800.0) / 50.0
    assert its["closest_s"] == pytest.approx(meeting, abs=3.0)
    assert its["closest_m"] >= its["min_clearance_m"]
    line = f"traffic: HEADON came within {its['closest_m']:.0f} m of vehicle 7 after "
    assert line + f"{its['closest_s']:.1f} s, {its['min_clearance_m']:.0f} m from" in done.stdout
    report = (folder / "heard" / "report.html").read_text()
    section = report[report.index("<h2>Other aircraft</h2>") :]
    row = section[section.index("<tr><td>HEADON") : section.index("</tr>\n    </tbody>")]
    assert f"<td>7</td>\n      <td>{its['closest_m']:.1f}</td>" in row


def test_without_the_reports_it_would_hit(folder):
    done, result = fly(folder, "unheard", *UNHEARD)
    assert done.returncode == 1
    (its,) = result["vehicles"][0]["traffic"]
    assert its["min_horizontal_m"] < 15.0
    assert its["min_vertical_m"] < 5.0
    assert any(reason.startswith("traffic: vehicle 7 in") for reason in result["reasons"])


def test_replay_is_identical(folder, heard):
    done = vfguide("replay", "heard/vehicle-7.tlog", cwd=folder)
    assert done.returncode == 0, done.stderr + done.stdout
    assert "identical" in done.stdout
