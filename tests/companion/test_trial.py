"""The test flight before the first goal: where it leads, when it is over, what is told of it."""

import math
from dataclasses import replace

import numpy as np
import pytest
from conversations import Conversation
from conversations import plan as plain_plan

from vfguide.companion.plan import Plan
from vfguide.companion.trial import CHANGE, circuit
from vfguide.flight.performance import AIRSPEED_GAIN
from vfguide.flight.state import FlightState
from vfguide.geometry.so3 import from_euler
from vfguide.link.px4 import Px4Mode
from vfguide.scenario.load import load_scenario
from vfguide.scenario.plans import plan_of

NORTH = FlightState(
    5.0, (0.0, 0.0, -150.0), (25.0, 0.0, 0.0), from_euler(0.0, 0.0, 0.0), 25.0, (math.nan,) * 3
)


def plan(*changes: str, aircraft: str = "aerosonde") -> Plan:
    loaded = load_scenario("identify", (f'vehicle.0.aircraft="{aircraft}"', *changes))
    return plan_of(loaded, loaded.scenario.vehicles[0])


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_the_circuit_ends_near_its_beginning_and_on_its_course(side):
    legs = circuit(NORTH, plan(), side)
    ends = np.array([leg.goal.p_n for leg in legs])
    courses = [leg.goal.course for leg in legs]
    assert np.linalg.norm(ends[-1] - NORTH.p_n) < 30.0
    assert courses == [0.0, 0.0, 0.0, math.pi, math.pi, math.pi, 0.0]
    assert math.copysign(1.0, ends[3, 1]) == side
    assert ends[:, 2].max() == pytest.approx(-150.0), "it goes no lower than it begins"
    assert ends[1, 2] < -160.0


@pytest.mark.parametrize("aircraft", ["aerosonde", "easystar", "c172p"])
def test_airspeeds_stay_inside_what_the_aircraft_flies(aircraft):
    for change in (1.0, 0.8, 1.2):
        its = plan(f"vehicle.0.airspeed_mps={change * CRUISE[aircraft]}", aircraft=aircraft)
        speeds = [leg.airspeed for leg in circuit(NORTH, its, 1.0)]
        assert min(speeds) >= min(1.1 * its.aircraft.airspeed_min, its.gains.airspeed)
        assert max(speeds) <= max(0.95 * its.aircraft.airspeed_max, its.gains.airspeed)


CRUISE = {"aerosonde": 25.0, "easystar": 11.0, "c172p": 45.0}


def test_it_changes_the_airspeed_by_as_much_as_it_says():
    speeds = [leg.airspeed for leg in circuit(NORTH, plan(), 1.0)]
    assert max(speeds) == pytest.approx(25.0 * (1.0 + CHANGE))
    assert min(speeds) == pytest.approx(25.0 * (1.0 - CHANGE))


class Testing(Conversation):
    """The companion of a plan with a test flight."""

    __test__ = False

    def __init__(self, its: Plan) -> None:
        super().__init__()
        self.companion = type(self.companion)(1, its, engage=True)

    def engage(self) -> None:
        self.fly(1.0)
        self.fly(1.0, Px4Mode.OFFBOARD)

    @property
    def route(self):
        return self.companion.route


def test_each_leg_is_told_and_flown_at_its_airspeed():
    talk = Testing(replace(plain_plan(), untuned=plain_plan().gains))
    talk.engage()
    assert talk.told[-1] == "test flight: level flight"
    assert talk.route.is_testing
    trial = talk.route._trial
    speeds = [trial.law(leg)[AIRSPEED_GAIN] for leg in range(7)]
    assert speeds == pytest.approx([25.0, 25.0, 25.0, 25.0, 28.75, 21.25, 25.0])
    assert talk.route.plan.gains.bank_max == pytest.approx(math.radians(30.0))


def test_it_begins_anew_when_the_autopilot_follows_again():
    talk = Testing(replace(plain_plan(), untuned=plain_plan().gains))
    talk.engage()
    first = talk.route.plan.goals
    talk.fly(10.0, Px4Mode.OFFBOARD)
    assert "test flight: a climb" in talk.told
    talk.told.clear()
    talk.fly(4.0, None, flying=False)
    talk.fly(1.0, Px4Mode.OFFBOARD)
    assert "test flight: level flight" in talk.told
    assert talk.route.plan.goals[0].p_n[0] > first[0].p_n[0] + 100.0


def test_a_leg_that_comes_to_no_end_is_left():
    """The aeroplane of the conversation flies straight to the north for ever."""
    talk = Testing(replace(plain_plan(), untuned=plain_plan().gains))
    talk.engage()
    talk.fly(600.0, Px4Mode.OFFBOARD)
    tests = [note for note in talk.told if note.startswith("test flight")]
    assert len(tests) == 7
    assert not talk.route.is_testing
    end = talk.told.index("flying to goal 1 of 1")
    assert talk.told[end - 1].startswith("not seen well enough")
    assert talk.route.identified.aircraft == plain_plan().aircraft
    assert talk.route.plan.goals == plain_plan().goals


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
        turned = talk.route.plan.goals[3].p_n[1] + 300.0
        assert math.copysign(1.0, turned) == side
    else:
        assert not talk.route.is_testing
        assert any(note.startswith("no room for a test flight") for note in talk.told)
        assert talk.told[-1] == "flying to goal 1 of 1"
