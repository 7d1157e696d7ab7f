"""The paper's examples 1 and 2 for aeroplanes, in law field: judged by the truth, and replayed."""

import json

import numpy as np
import pytest
from commands import vfguide

from vfguide.aircraft.envelope import flyable_radius, usable_bank
from vfguide.aircraft.state import FlightState
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.vector import ZERO
from vfguide.preflight.load import load_scenario
from vfguide.scenario.plans import plan_of

pytestmark = pytest.mark.slow

SCALE = 18.0
"""Metres of these scenarios for one of the paper's."""
HIGHER = 0.25
"""Height of a start above the goal, as a share of the paper's to that scale."""
WINDS = {
    "calm": (),
    "headwind": ("--set", "wind.speed_mps=5"),
    "from the left": ("--set", "wind.speed_mps=5", "--set", "wind.from_deg=270"),
}
"""At the goal, whose course is north."""


@pytest.mark.parametrize("wind", WINDS)
@pytest.mark.parametrize("name", ["field/example-1", "field/example-2"])
def test_every_aeroplane_reaches_the_goal_outside_all_surfaces(name, wind, tmp_path):
    done = vfguide("run", name, *WINDS[wind], "--no-report", "--out", "out", cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    for vehicle in result["vehicles"]:
        (goal,) = vehicle["goals"]
        assert goal["reached"]
        assert goal["miss_m"] < 1.0
        assert abs(goal["course_error_deg"]) < 1.0
        assert abs(goal["climb_error_deg"]) < 1.0
        assert all(obstacle["min_level"] > 1.0 for obstacle in vehicle["obstacles"])
        replayed = vfguide("replay", f"out/vehicle-{vehicle['id']}.tlog", cwd=tmp_path)
        assert replayed.returncode == 0, replayed.stdout


@pytest.mark.parametrize(("number", "vehicles"), [(1, 6), (2, 3)])
def test_they_are_the_papers_to_another_scale(number, vehicles):
    paper = load_scenario(f"paper/example-{number}").scenario
    flown = load_scenario(f"field/example-{number}").scenario
    assert len(paper.vehicles) == len(flown.vehicles) == vehicles
    for robot, aeroplane in zip(paper.vehicles, flown.vehicles, strict=True):
        (there,), (here,) = robot.goals, aeroplane.goals
        assert (here.heading_deg, here.climb_deg) == (there.heading_deg, there.climb_deg)
        from_goal = np.subtract(robot.position_m, there.position_m)
        start = np.subtract(aeroplane.position_m, here.position_m)
        assert start == pytest.approx(SCALE * from_goal * (1.0, 1.0, HIGHER))
        for body, obstacle in zip(paper.obstacles, flown.obstacles, strict=True):
            assert obstacle.semi_axes_m == pytest.approx(SCALE * np.array(body.semi_axes_m))
            assert obstacle.exponents == body.exponents
            assert np.subtract(obstacle.position_m, here.position_m) == pytest.approx(
                SCALE * np.subtract(body.position_m, there.position_m)
            )


def test_the_least_semi_axis_is_two_turn_radii():
    loaded = load_scenario("field/example-2")
    plan = plan_of(loaded, loaded.scenario.vehicles[0])
    aircraft, gains, _ = plan.vehicle
    level = from_euler(0.0, 0.0, 0.0)
    state = FlightState(0.0, ZERO, (25.0, 0.0, 0.0), level, 25.0, ZERO)
    radius = flyable_radius(state, usable_bank(aircraft, gains, gains.airspeed), gains)
    least = min(min(obstacle.semi_axes_m) for obstacle in loaded.scenario.obstacles)
    assert least == pytest.approx(2.0 * radius, rel=0.02)
