"""Law paper on plant jsbsim: it runs, is judged, and is told as what it is."""

import json

import numpy as np
import pytest
from commands import vfguide

from vfguide.guidance.laws import PAPER
from vfguide.loop.rows import step_measured
from vfguide.preflight.load import load_scenario
from vfguide.runs.lockstep import fly_scenario
from vfguide.runs.steps import Steps

pytestmark = pytest.mark.slow


def test_it_is_flown_and_judged_with_a_warning(tmp_path):
    done = vfguide(
        "run", "first-flight", "--set", "law=paper", "--no-report", "--out", "out", cwd=tmp_path
    )
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    assert "the paper's field as printed, to see what it does" in done.stderr + done.stdout
    assert done.returncode == (0 if result["verdict"] == "good" else 1)
    (vehicle,) = result["vehicles"]
    assert vehicle["setpoints"] > 1000
    assert vehicle["assurance"] is None
    replayed = vfguide("replay", "out/vehicle-1.tlog", cwd=tmp_path)
    assert replayed.returncode == 0, replayed.stdout


def test_among_obstacles_no_route_is_planned_and_nothing_is_assured(tmp_path):
    seen = []

    def watched(measured, origin, before, legs, airspace, law, vehicle):
        seen.append((law, airspace is not None))
        return step_measured(measured, origin, before, legs, airspace, law, vehicle)

    loaded = load_scenario("towers", ["law=paper", "duration_s=3"])
    flight = fly_scenario(loaded, tmp_path, steps=Steps(measured=watched))
    assert seen[-1] == (PAPER, True)
    record = flight.records[0]
    assert record.decisions is None
    assert np.isfinite(record.p_n).all()


def test_it_is_not_for_a_real_aircraft(tmp_path):
    url = "udpin:127.0.0.1:15999"
    path = tmp_path / "paper.toml"
    path.write_text(load_scenario("first-flight", ["law=paper"]).scenario.to_toml())
    done = vfguide("fly", path, "--vehicle", "1", "--connect", url, cwd=tmp_path)
    assert done.returncode == 2
    assert 'law = "paper": only vfguide run flies it, allowed "flight", "field"' in done.stderr


def test_a_test_flight_is_law_flights_alone(tmp_path):
    done = vfguide("check", "identify", cwd=tmp_path)
    assert done.returncode == 0
    done = vfguide("run", "identify", "--set", "law=paper", "--out", "out", cwd=tmp_path)
    assert done.returncode == 2
    assert 'only law = "flight" flies a test flight, allowed here false' in done.stderr
