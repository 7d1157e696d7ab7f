"""Room for the test flight among the hazards of a scenario."""

import math

import pytest
from conversations import Testing
from flight_states import NORTH

from vfguide.companion.circuit import circuit, least_room
from vfguide.companion.identification_flight import NEEDED_ROOM
from vfguide.companion.plan import Plan
from vfguide.preflight.load import load_scenario
from vfguide.scenario.plans import plan_of


def plan(*changes: str, aircraft: str = "aerosonde") -> Plan:
    loaded = load_scenario("identify", (f'vehicle.0.aircraft="{aircraft}"', *changes))
    return plan_of(loaded, loaded.scenario.vehicles[0])


@pytest.mark.parametrize("along", [0.1, 0.35, 0.5, 0.62, 0.9])
def test_a_tower_anywhere_on_the_circuit_is_seen(along):
    its = plan()
    legs = circuit(NORTH, its.vehicle, 1.0)
    places = [place for leg in legs for place in leg.places]
    north, east, _ = places[int(along * len(places))]
    tower = (
        f'obstacle=[{{shape="cylinder",position_m=[{north + 9},{east - 7},-100],'
        "radius_m=15,height_m=200}]"
    )
    goal = ("vehicle.0.goal.0.position_m=[0,3000,-150]", "vehicle.0.position_m=[0,2500,-150]")
    hazards = plan(tower, *goal).hazards
    assert least_room(legs, hazards, 0.0) < NEEDED_ROOM


def fenced(east: tuple[float, float]) -> Plan:
    corners = [[-2000, east[0]], [2000, east[0]], [2000, east[1]], [-2000, east[1]]]
    zone = f'{{kind="include",polygon_m={corners}}}'
    goal = "vehicle.0.goal.0.position_m=[0,-300,-120]"
    start = "vehicle.0.position_m=[-300,-300,-120]"
    return plan(f"fence.zone=[{zone}]", "fence.floor_m=50", goal, start)


@pytest.mark.parametrize(
    ("east", "side"), [((-400.0, 400.0), 1.0), ((-1000.0, -200.0), -1.0), ((-450.0, -150.0), 0.0)]
)
def test_it_turns_to_where_there_is_room_and_is_left_out_where_there_is_none(east, side):
    talk = Testing(fenced(east))
    talk.engage()
    if side:
        turned = talk.flight.plan.goals[3].p_n[1] + 300.0
        assert math.copysign(1.0, turned) == side
    else:
        assert not talk.flight.is_testing
        assert any(note.startswith("no room for a test flight") for note in talk.told)
        assert "flying to goal 1 of 1" in talk.told
