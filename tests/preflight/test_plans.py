"""From a scenario to what its companions are asked to do."""

import math
from dataclasses import replace

import numpy as np
import pytest
from plans import AMONG_TOWERS, FIRST_FLIGHT, TEST_FLIGHT

from vfguide.airspace.keep_out import NO_FENCE
from vfguide.companion.plan import Plan
from vfguide.earth.atmosphere import isa_density
from vfguide.field.obstacle import PlacedObstacle
from vfguide.kernels.rows import columns
from vfguide.preflight.load import load_scenario
from vfguide.scenario.hazards import hazard_names, hazards_of
from vfguide.scenario.plans import plan_of


@pytest.mark.parametrize(("name", "same"), [("first-flight", FIRST_FLIGHT)])
def test_the_plans_of_the_other_tests_are_those_of_the_files(name, same):
    loaded = load_scenario(name)
    plan = plan_of(loaded, loaded.scenario.vehicles[0])
    assert len(plan.fence.table) == len(NO_FENCE.table) == 0
    assert replace(plan, fence=NO_FENCE) == same


def at_cruise(plan: Plan, density: float) -> Plan:
    """The plan flown at the cruise of the file, an equivalent airspeed, in air of a density."""
    speed = 25.0 * math.sqrt(1.225 / density)
    radius = 1.57 * speed * speed / 9.80665
    return replace(plan, gains=plan.gains._replace(airspeed=speed), loiter_radius=radius)


def test_the_test_flight_is_flown_at_the_cruise_of_its_height():
    loaded = load_scenario("identify")
    plan = plan_of(loaded, loaded.scenario.vehicles[0])
    same = at_cruise(TEST_FLIGHT, isa_density(638.0))
    assert plan.gains == pytest.approx(same.gains, rel=1e-5)
    assert plan.loiter_radius == pytest.approx(same.loiter_radius, rel=1e-5)
    written = replace(plan, gains=same.gains, loiter_radius=same.loiter_radius, fence=NO_FENCE)
    assert written == same


def test_so_are_the_obstacles():
    scenario = load_scenario("towers").scenario
    found, same = hazards_of(scenario), AMONG_TOWERS.hazards
    kept = columns(PlacedObstacle, found.obstacles)
    for name, column in columns(PlacedObstacle, same.obstacles)._asdict().items():
        if name != "visible_from":
            np.testing.assert_array_equal(getattr(kept, name), column)
    assert (len(found.fences.zones), found.floor, found.ceiling) == (0, same.floor, same.ceiling)
    assert hazard_names(scenario) == AMONG_TOWERS.hazard_names
