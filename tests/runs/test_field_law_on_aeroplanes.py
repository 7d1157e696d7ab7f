"""Law field on plant jsbsim: it leads to the goals, is assured, and replays to the bit."""

import json
from functools import cache

import numpy as np
import pytest
from commands import vfguide
from measure_reference import guided

from vfguide.field_points.field_law_points import led_field
from vfguide.field_points.field_point import Point
from vfguide.geometry.angles import wrap
from vfguide.geometry.so3 import log
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import matmul, norm, transpose
from vfguide.geometry.velocity import azimuth_of
from vfguide.guidance.guidance_state import Leader
from vfguide.guidance.laws import FIELD_LAW
from vfguide.guidance.remedies import Remedies
from vfguide.loop.rows import step_measured
from vfguide.loop.state import state_of_row
from vfguide.preflight.load import load_scenario
from vfguide.runs.lockstep import fly_scenario
from vfguide.runs.steps import Steps
from vfguide.scenario.plans import plan_of

pytestmark = pytest.mark.slow


class Watched:
    """The steps of a flight: the states before them, and whether the field led."""

    def __init__(self, name, *changes):
        self.loaded = load_scenario(name, changes)
        self.leads, self.alarmed = [], False

    def step(self, measured, origin, before, legs, airspace, law, vehicle):
        out = step_measured(measured, origin, before, legs, airspace, law, vehicle)
        _, _, _, after, _ = out
        state = state_of_row(after)
        self.leads.append(state.guidance.progress.leader == Leader.FIELD)
        self.alarmed |= bool(state.progress.alarmed)
        return out

    def fly(self, folder):
        return fly_scenario(self.loaded, folder, steps=Steps(measured=self.step))


@pytest.mark.parametrize("name", ["field/slalom", "field/crossing", "first-flight", "towers"])
def test_it_reaches_the_goals_and_replays(name, tmp_path):
    done = vfguide("run", name, "--set", "law=field", "--no-report", "--out", "out", cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    (vehicle,) = result["vehicles"]
    assert all(goal["reached"] and goal["miss_m"] < 1.0 for goal in vehicle["goals"])
    assert all(each["min_clearance_m"] > 6.0 for each in vehicle["obstacles"])
    replayed = vfguide("replay", "out/vehicle-1.tlog", cwd=tmp_path)
    assert replayed.returncode == 0, replayed.stdout


def test_points_of_every_law_in_a_scenario_of_law_field(tmp_path):
    """At the goal, in the approach and far away, at rest, and where there is no air."""
    head = "x,y,z,vx,vy,vz,t\n"
    points = ("850,0,-100,25,0,0,0", "840,0,-100,25,0,0,0", "-700,0,-100,25,0,0,0")
    (tmp_path / "points.csv").write_text(head + "\n".join((*points, "-700,0,-100,0,0,0,0\n")))
    (tmp_path / "high.csv").write_text(head + "0,0,-1e5,25,0,0,0\n")
    for law in ("flight", "field"):
        options = ("field", "field/slalom", "--vehicle", "1", "--law", law, "--points")
        done = vfguide(*options, "points.csv", cwd=tmp_path)
        assert done.returncode == 0, done.stderr
        assert all(each["R_a"] for each in json.loads(done.stdout))
        high = vfguide(*options, "high.csv", cwd=tmp_path)
        assert high.returncode in (0, 2), high.stderr
        assert "Traceback" not in high.stderr


def test_the_field_leads_and_not_the_search(tmp_path):
    """Outside of the last three turn radii; 4 to 5 s of the flight are inside."""
    watched = Watched("field/slalom")
    watched.fly(tmp_path)
    flown = np.array(watched.leads)
    last = np.flatnonzero(flown)[-1]
    assert flown[: last + 1].mean() > 0.99
    assert last > 0.6 * len(flown)
    assert not watched.alarmed, "it goes round, and comes nearer"


def test_other_remedies_are_flown_otherwise(tmp_path):
    """Each of them reaches the law: without it the path among walls is another one."""
    paths, alone = {}, Remedies(search=False)  # as the scenario has them
    for name in ("", *Remedies._fields):
        changes = [f"guidance.remedies.{name}=false"] if name else []
        loaded = load_scenario("field/slalom", changes)
        if name:
            law = plan_of(loaded, loaded.scenario.vehicles[0]).law
            assert law == FIELD_LAW._replace(remedies=alone._replace(**{name: False}))
        folder = tmp_path / (name or "all")
        folder.mkdir()
        record = fly_scenario(loaded, folder).records[0]
        paths[name] = record.p_n
    same = {name for name, p_n in paths.items() if name and np.array_equal(p_n, paths[""])}
    assert same <= {"relative_velocity", "search", "side", "bounded_circles"}, (
        "nothing moves here, the field comes nearer all the time, and the start is before the goal"
    )


@pytest.mark.parametrize("law", ["flight", "paper", "field"])
def test_remedies_that_nobody_heeds_are_told(law):
    warned = load_scenario("field/slalom", [f"law={law}"]).warnings
    told = f'guidance.remedies: law = "{law}" takes no notice of them'
    assert (told in warned) == (law != "field")


@cache
def slalom():
    loaded = load_scenario("field/slalom")
    return plan_of(loaded, loaded.scenario.vehicles[0])


class Points:
    """The steps of a flight: what the law was given and gave at each of them."""

    def __init__(self):
        self.seen = []

    def step(self, measured, origin, before, legs, airspace, law, vehicle):
        out = step_measured(measured, origin, before, legs, airspace, law, vehicle)
        given = guided(measured, origin, before, legs, airspace, law, vehicle)
        self.seen.append((given, state_of_row(out[3])))
        return out


@pytest.mark.parametrize("name", ["field/slalom", "field/crossing"])
def test_the_field_at_flown_points_is_what_was_flown_there(name, tmp_path):
    """The direction to 1e-9 rad.

    The attitude is as near as a point can tell: slope, side of the turn, airspeed and the learned
    angle of attack are what was before.
    """
    loaded, watch = load_scenario(name, []), Points()
    fly_scenario(loaded, tmp_path, steps=Steps(measured=watch.step))
    plan, off, turned = plan_of(loaded, loaded.scenario.vehicles[0]), [], []
    led = [
        (given, after)
        for given, after in watch.seen
        if given.leader == after.guidance.progress.leader == Leader.FIELD
    ]
    for given, after in led[:: max(1, len(led) // 600)]:
        state, known = given.nav.state, given.known
        at = led_field(plan, Point(state.p_n, state.v_n, known.time), state.wind_n)
        off.append(abs(wrap(azimuth_of(at.F) - given.command.course)))
        turned.append(norm(log(matmul(transpose(at.R_a), after.control.R_na))))
    assert len(off) >= 500
    assert max(off) < 1e-9
    assert np.median(turned) < 0.5 * DEG


def test_the_command_prints_it(tmp_path):
    (tmp_path / "points.csv").write_text("x,y,z,vx,vy,vz,t\n-700,0,-100,25,0,0,0\n")
    options = ("--vehicle", "1", "--points", "points.csv", "--law", "field")
    done = vfguide("field", "field/slalom", *options, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    (point,) = json.loads(done.stdout)
    assert point["F"][0] > 0.0
    assert point["G"] is None
    assert len(point["chi"]) == 4
