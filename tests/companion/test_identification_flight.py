"""The test flight before the first goal: where it leads, when it is over, what is told of it."""

import math
from dataclasses import replace

import numpy as np
import pytest
from conversations import Testing, plan
from flight_states import NORTH
from hypothesis import given
from hypothesis import strategies as st
from plans import TEST_FLIGHT

from vfguide.autopilots.px4 import Px4Mode
from vfguide.companion.circuit import AIRSPEED_CHANGE, ROOM_SPACING, circuit

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_places_are_close_together_along_the_whole_circuit(side):
    legs = circuit(NORTH, TEST_FLIGHT.vehicle, side)
    places = np.array([NORTH.p_n, *(place for leg in legs for place in leg.places)])
    assert np.linalg.norm(np.diff(places, axis=0), axis=1).max() <= ROOM_SPACING + 1e-9
    assert all(leg.places[-1] == leg.goal.p_n for leg in legs)
    length = np.linalg.norm(np.diff(places, axis=0), axis=1).sum()
    radius = 0.5 * np.ptp(places[:, 1])
    assert length == pytest.approx(19.0 * 25 + 18.4 * 25 + 2.0 * (math.pi + 0.7) * radius, rel=0.02)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_the_circuit_ends_near_its_beginning_and_on_its_course(side):
    legs = circuit(NORTH, TEST_FLIGHT.vehicle, side)
    ends = np.array([leg.goal.p_n for leg in legs])
    courses = [math.cos(leg.goal.course) for leg in legs]
    assert np.linalg.norm(ends[-1] - NORTH.p_n) < 30.0
    assert courses == pytest.approx([1.0, 1.0, 1.0, -1.0, -1.0, -1.0, 1.0])
    assert math.copysign(1.0, ends[3, 1]) == side
    assert ends[:, 2].max() == pytest.approx(-150.0), "it goes no lower than it begins"
    assert ends[1, 2] < -160.0


@given(st.floats(10.0, 40.0), st.floats(1.0, 1.6), st.floats(1.0, 1.6))
def test_airspeeds_stay_inside_what_the_aircraft_flies(slowest, cruise, fastest):
    speed = slowest * cruise
    its = replace(
        TEST_FLIGHT,
        aircraft=TEST_FLIGHT.aircraft._replace(airspeed_min=slowest, airspeed_max=speed * fastest),
        gains=TEST_FLIGHT.gains._replace(airspeed=speed),
    )
    speeds = {leg.name: leg.airspeed for leg in circuit(NORTH, its.vehicle, 1.0)}
    assert slowest <= speeds["slow flight"] <= speed <= speeds["fast flight"] <= speed * fastest


def test_it_changes_the_airspeed_by_as_much_as_it_says():
    speeds = [leg.airspeed for leg in circuit(NORTH, TEST_FLIGHT.vehicle, 1.0)]
    assert max(speeds) == pytest.approx(25.0 * (1.0 + AIRSPEED_CHANGE))
    assert min(speeds) == pytest.approx(25.0 * (1.0 - AIRSPEED_CHANGE))


def test_it_begins_with_the_gains_of_a_slow_aircraft_and_wide_turns():
    talk = Testing(replace(plan(), identify=True))
    talk.engage()
    assert talk.told[-1] == "test flight: level flight"
    assert talk.flight.is_testing
    gains, ours = talk.flight.plan.tuned, plan().tuned
    assert gains.bank_max == ours.bank_max, "an escape may take it all"
    wider = math.tan(math.radians(50.0)) / math.tan(math.radians(30.0))
    assert gains.turn_margin == pytest.approx(ours.turn_margin * wider)
    assert gains.k_w == pytest.approx(ours.k_w * 0.08 / 0.3)
    assert gains.response_lag == pytest.approx(0.3 - 0.08)


def test_it_begins_anew_when_the_autopilot_follows_again():
    talk = Testing(replace(plan(), identify=True))
    talk.engage()
    first = talk.flight.plan.goals
    talk.fly(10.0, Px4Mode.OFFBOARD)
    assert "test flight: a climb" in talk.told
    talk.told.clear()
    talk.fly(4.0, None, flying=False)
    talk.fly(0.1, None)  # its clock is heard, which tells that it is the same autopilot
    talk.fly(1.0, Px4Mode.OFFBOARD)
    assert "test flight: level flight" in talk.told
    assert talk.flight.plan.goals[0].p_n[0] > first[0].p_n[0] + 100.0


def test_a_leg_that_comes_to_no_end_is_left():
    """The aeroplane of the conversation flies straight to the north for ever."""
    talk = Testing(replace(plan(), identify=True))
    talk.engage()
    talk.fly(600.0, Px4Mode.OFFBOARD)
    tests = [note for note in talk.told if note.startswith("test flight")]
    assert len(tests) == 7
    assert not talk.flight.is_testing
    end = talk.told.index("flying to goal 1 of 1")
    assert talk.told[end - 1].startswith("not seen well enough")
    assert talk.flight.identified.aircraft == plan().aircraft
    assert talk.flight.plan.goals == plan().goals
    assert talk.flight.plan.tuned.response_lag == pytest.approx(0.3 - 0.08), (
        "its response is unknown"
    )
