"""Dead ends into which a field leads, and the look ahead that asks for a route before them."""

import pytest
from flown_worlds import scenario_of
from world_tables import loaded_from

from vfguide.results.judge import judge
from vfguide.runs.lockstep import fly_scenario

pytestmark = pytest.mark.slow

SEED = 11
CARRIED = 52
"""World in which an escape on a circle is carried into a wall: it was entered by 6.6 m."""
CIRCLING = 25
"""World of a wide pocket, in which the field led a circle that a gust made too wide."""


def flown(number, tmp_path):
    table = {**scenario_of("dead-end", SEED, number), "law": "field"}
    loaded = loaded_from(table, tmp_path)
    flight = fly_scenario(loaded, tmp_path)
    (vehicle,) = judge(loaded.scenario, flight.records, 0.0, 0.0).vehicles
    return vehicle


@pytest.mark.parametrize("number", [CARRIED, CIRCLING])
def test_the_search_is_asked_before_a_pocket(number, tmp_path):
    vehicle = flown(number, tmp_path)
    assert min(each.min_clearance_m for each in vehicle.obstacles) > 12.0
    assert vehicle.field.routes >= 1
    assert vehicle.assurance.acting_share < 0.01
    assert vehicle.goals[0].reached
