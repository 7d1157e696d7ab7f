"""The whole step: it turns with the world, stays finite, and stays within the limits."""

import math

import numpy as np
import pytest
from aeroplanes import AEROSONDE
from flight_states import GAINS, VEHICLE, is_within_limits, state, turned
from flown_stages import Memory, fresh_memory, guide, guide_within_limits, steps
from guidance_targets import GOAL
from hypothesis import given
from hypothesis import strategies as st

from vfguide.aircraft.envelope import flyable_radius, usable_bank
from vfguide.aircraft.path_limits import AT_FLOOR, NEAR_FLOOR, path_limits
from vfguide.aircraft.performance import turn_length
from vfguide.aircraft.state import FlightState
from vfguide.airspace.detection import Airspace
from vfguide.airspace.fence import fences
from vfguide.airspace.hazards import Hazards, traffic_rows
from vfguide.airspace.keep_out import NO_FENCE
from vfguide.control.airspeed_control import thrust_for
from vfguide.control.control import ControlState
from vfguide.estimation.estimation import known_state
from vfguide.field.obstacle import obstacle_rows
from vfguide.geometry.se2 import Pose
from vfguide.geometry.so3 import from_euler, rot_z
from vfguide.geometry.vector import matvec
from vfguide.guidance import flight_law
from vfguide.guidance.flight_law import LEVEL_BANK
from vfguide.guidance.guidance_state import GuidanceState, fresh_guidance
from vfguide.paths.edge import EDGE_WIDTH, Edge, edge_row, next_path
from vfguide.paths.leg import new_leg
from vfguide.planning import planning
from vfguide.planning.leg_planning import predicted_state
from vfguide.planning.objective import objective_at
from vfguide.planning.route import Route, fresh_route
from vfguide.planning.route_following import begin_route, fresh_following
from vfguide.planning.route_search import FoundRoute

PLACES = st.tuples(st.floats(-900, 900), st.floats(-900, 900), st.floats(-250, -50))
ANGLES = st.floats(-math.pi, math.pi)
WINDS = st.tuples(st.floats(-8, 8), st.floats(-8, 8), st.just(0.0))


@given(PLACES, ANGLES, WINDS, ANGLES)
def test_it_turns_with_the_world(p_n, yaw, wind, angle):
    flown = [state(p_n, yaw, wind=wind), state(p_n, yaw + 0.01, wind=wind, time=1.02)]
    R = rot_z(angle)
    goal = GOAL._replace(p_n=matvec(R, GOAL.p_n), course=GOAL.course + angle)
    here, _ = steps(flown, GOAL)
    there, _ = steps([turned(R, each) for each in flown], goal)
    assert there.omega_b == pytest.approx(here.omega_b, abs=1e-6)
    assert there.thrust == pytest.approx(here.thrust, abs=1e-9)


def mirrored(each, roll):
    north, east, down = each.p_n
    v, w = each.v_n, each.wind_n
    yaw = math.atan2(v[1] - w[1], v[0] - w[0])
    return FlightState(
        each.time,
        (north, -east, down),
        (v[0], -v[1], v[2]),
        from_euler(-roll, 0.06, -yaw),
        25.0,
        (w[0], -w[1], w[2]),
    )


@given(PLACES, st.floats(-3.0, 3.0), WINDS)
def test_in_a_mirror_roll_and_yaw_change_their_sign(p_n, yaw, wind):
    flown = [state(p_n, yaw, wind=wind), state(p_n, yaw + 0.01, wind=wind, time=1.02)]
    here, wish = steps(flown, GOAL)
    there, other = steps(
        [mirrored(each, 0.1) for each in flown], GOAL._replace(course=-GOAL.course)
    )
    if wish.phase == other.phase and abs(wish.bank + other.bank) < 1e-6:
        p, q, r = here.omega_b
        assert there.omega_b == pytest.approx((-p, q, -r), abs=1e-6)


STRANGE = [
    state((0.0, 0.0, -150.0), 0.5),
    state((0.0, 0.0, -150.0), 0.5 + math.pi),
    state((1e6, -1e6, -1e4), 0.0),
    state((0.0, 0.0, -150.0), 0.0)._replace(v_n=(0.0, 0.0, 0.0)),
    state((10.0, 0.0, -150.0), 0.0)._replace(airspeed=0.0, v_n=(0.0, 0.0, 0.0)),
    state((-50.0, 0.0, -150.0), 0.0, wind=(-40.0, 0.0, 0.0)),
    state((-50.0, 0.0, -150.0), 0.0, wind=(0.0, 40.0, 0.0)),
    state((-50.0, 5.0, -150.0), 0.0)._replace(R_nb=from_euler(math.pi, 0.0, 0.0)),
    state((-50.0, 5.0, -150.0), 0.0)._replace(R_nb=from_euler(0.0, 0.5 * math.pi, 0.0)),
    state((-50.0, 5.0, -150.0), 0.0)._replace(v_n=(0.0, 0.0, -25.0)),
]


@pytest.mark.parametrize("strange", STRANGE)
@pytest.mark.parametrize("circle", [0.0, 1.0])
def test_strange_states_give_finite_setpoints_within_the_limits(strange, circle):
    target = GOAL._replace(circle=circle, radius=100.0)
    memory = fresh_memory()
    for time in (1.0, 1.0, 1.02, 50.0):  # no time at all, and too much of it
        setpoint, memory, wish = guide_within_limits(
            strange._replace(time=time), target, VEHICLE, memory
        )
        assert is_within_limits(setpoint)
        assert all(map(math.isfinite, (wish.course, wish.azimuth, wish.bank, wish.gamma)))


def test_with_a_state_that_is_no_number_the_setpoint_is_level_flight():
    broken = state((math.nan, 0.0, -150.0), 0.0)
    setpoint, _, _ = guide_within_limits(broken, GOAL, VEHICLE, fresh_memory())
    assert is_within_limits(setpoint)


@given(st.floats(10.0, 40.0), st.floats(10.0, 40.0))
def test_more_airspeed_allows_more_bank(one, other):
    slower, faster = sorted((one, other))
    assert usable_bank(AEROSONDE, GAINS, slower) <= usable_bank(AEROSONDE, GAINS, faster)
    assert usable_bank(AEROSONDE, GAINS, faster) <= GAINS.bank_max


def test_the_memory_is_a_record_that_compiled_code_gives_back():
    _, memory, _ = guide(state((-300.0, 20.0, -140.0), 0.4), GOAL, VEHICLE, fresh_memory())
    assert isinstance(memory, Memory)
    assert memory.time == 1.0
    kinds = [type(part) for part in (memory.route, memory.guidance, memory.control)]
    assert kinds == [Route, GuidanceState, ControlState]


def test_an_aircraft_slow_to_roll_turns_wider_and_earlier():
    here, response_lag = state((-300.0, 20.0, -140.0), 0.4, wind=(3.0, -4.0, 0.0)), 0.3
    slow = GAINS._replace(response_lag=response_lag)
    radius_factor = flyable_radius(here, 0.8, slow) - flyable_radius(here, 0.8, GAINS)
    assert radius_factor == pytest.approx(0.5 * (25.0 + 5.0) * response_lag)
    ahead = np.subtract(predicted_state(here, slow).p_n, here.p_n)
    assert ahead == pytest.approx(0.5 * response_lag * np.array(here.v_n))
    assert predicted_state(here, GAINS) == here


def test_no_turn_is_faster_than_an_aircraft_rolls():
    still = state((-300.0, 20.0, -140.0), 0.4)
    assert flyable_radius(still, 0.8, GAINS._replace(airspeed=8.0)) == 2.5 * 8.0
    assert flyable_radius(still, 0.8, GAINS) > 2.6 * 25.0


def test_where_the_air_sinks_faster_than_it_can_climb_thrust_is_set_for_all_of_the_climb():
    """The airspeed that it brings soon allows a steeper one."""
    below = (-300.0, 0.0, GOAL.p_n[2] + 20.0)
    sinking = state(below, 0.0, wind=(0.0, 0.0, 8.0))._replace(airspeed=27.0)
    setpoint, _, wish = guide(sinking, GOAL, VEHICLE, fresh_memory())
    v, speed = sinking.v_n, GAINS.airspeed
    assert (
        wish.gamma == path_limits(math.hypot(v[0], v[1], v[2] - 8.0), speed, math.inf, AEROSONDE)[1]
    )
    assert wish.climb > wish.gamma + 0.05
    assert setpoint.thrust == thrust_for(AEROSONDE, speed - 27.0, wish.climb, wish.load, 0.0)
    _, _, wish = guide(state(below, 0.0), GOAL, VEHICLE, fresh_memory())
    assert wish.climb == wish.gamma


def above_a_floor(height: float) -> Airspace:
    """Nothing in the way at the height of the goal, and a floor so far below it."""
    floor = -GOAL.p_n[2] - height
    empty = Hazards(obstacle_rows([]), traffic_rows([]), fences([]), floor, math.inf)
    return Airspace(empty, NO_FENCE, 0.0, 1.0)


def planned(here, target, route=None, airspace=None):
    """The wish for a state, the first one or on a route."""
    nav, goal = known_state(here, -1.0), objective_at(target, here)
    before = fresh_route() if route is None else route
    route = planning.update(nav, goal, None, True, before, 0.0, VEHICLE)
    return flight_law.update(nav, goal, route, airspace, fresh_guidance(), VEHICLE)[0]


def wished(sinking: float, above: float, airspeed: float = 25.0):
    """The wish 300 m beside the goal and at its height, flying away from it."""
    here = state((-300.0, 300.0, GOAL.p_n[2]), 2.0, wind=(0.0, 0.0, sinking))
    here = here._replace(airspeed=airspeed)
    return planned(here, GOAL, airspace=above_a_floor(above))


def test_without_an_airspace_there_is_no_floor():
    here = state((-300.0, 300.0, GOAL.p_n[2]), 2.0, wind=(0.0, 0.0, 9.0))
    assert planned(here, GOAL) == wished(9.0, math.inf)


def test_near_the_floor_air_that_sinks_is_flown_out_of_with_wings_level():
    turn = wished(0.0, 20.0).bank
    assert abs(turn) > 0.35
    assert abs(wished(9.0, 20.0).bank) <= LEVEL_BANK + 1e-9
    assert wished(9.0, 200.0).bank == wished(9.0, math.inf).bank
    assert abs(wished(9.0, 200.0).bank) > 0.25
    between = abs(wished(9.0, 0.5 * (AT_FLOOR + NEAR_FLOOR) * turn_length(25.0)).bank)
    assert abs(wished(9.0, 20.0).bank) <= between <= abs(turn)


def test_a_turn_is_not_left_out_for_what_is_no_sink():
    """An engine that is too weak would fly straight on for ever."""
    for sinking, airspeed in ((0.0, 19.0), (0.0, 25.0), (-6.0, 25.0)):
        bank = wished(sinking, 20.0, airspeed).bank
        assert abs(bank) > 0.25
        assert bank == wished(sinking, math.inf, airspeed).bank


def test_the_bank_changes_steadily_with_the_air_and_with_the_height():
    by_height = [wished(10.0, above).bank for above in np.linspace(-20.0, 120.0, 1401).tolist()]
    by_air = [wished(sinking, 40.0).bank for sinking in np.linspace(-12.0, 12.0, 2401).tolist()]
    for banks in (by_height, by_air):
        assert np.ptp(banks) > 0.2
        assert np.abs(np.diff(banks)).max() < 0.02


def test_a_hold_is_flown_in_the_middle_of_a_detour_too():
    """In wind that is too strong: the hops are no place to wait."""
    here, begin = state((-300.0, 300.0, GOAL.p_n[2]), 2.0), Pose(-300.0, 300.0, 2.0)
    end = Pose(500.0, 900.0, 0.5)
    hop = edge_row(Edge(begin, next_path(begin, end, 80.0, -1.0))).reshape(1, EDGE_WIDTH)
    found = FoundRoute(hop, 900.0, 25.0, 1)
    on_route = Route(new_leg(), begin_route(fresh_following(), found, end, 80.0))
    circle = GOAL._replace(circle=1.0, radius=120.0)
    assert planned(here, circle, on_route) == planned(here, circle)
    assert planned(here, GOAL, on_route) != planned(here, GOAL)
