"""From a scenario to what its companions are asked to do."""

from dataclasses import replace

from plans import FIRST_FLIGHT

from vfguide.airspace.keep_out import NO_FENCE
from vfguide.scenario.load import load_scenario
from vfguide.scenario.plans import plan_of


def test_the_plan_of_the_other_tests_is_that_of_the_file():
    loaded = load_scenario("first-flight")
    plan = plan_of(loaded, loaded.scenario.vehicles[0])
    assert len(plan.fence.table) == len(NO_FENCE.table) == 0
    assert replace(plan, fence=NO_FENCE) == FIRST_FLIGHT
