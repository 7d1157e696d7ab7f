"""Starts from which the approach once went wrong, found by searching among thousands."""

import pytest
from closed_loop import blowing, flown, goal
from flight_states import GAINS, VEHICLE, is_within_limits, state
from flown_stages import fresh_memory, guide_within_limits

from vfguide.geometry.units import DEG
from vfguide.paths.course_laws import PlanarState
from vfguide.paths.leg import ON_PATH, OUTBOUND, new_leg
from vfguide.paths.leg_phases import fly_leg, leg_course
from vfguide.paths.leg_start import Paths
from vfguide.planning.objective import GuidanceTarget

STILL_AIR = (0.0, 0.0)


def deg(radians):
    return radians / DEG


@pytest.mark.parametrize(
    ("start", "heading", "course", "wind"),
    [
        pytest.param((44.9, 112.5, -60.7), -2.654, -1.8276, STILL_AIR, id="90 m above"),
        pytest.param((10.0, 5.0, -230.0), 0.3, 1.0, STILL_AIR, id="80 m above the goal itself"),
        pytest.param((78.1, -105.5, -216.8), -3.063, 1.2896, STILL_AIR, id="67 m above"),
        pytest.param((-110.5, 155.6, -219.5), -0.3756, -0.5486, STILL_AIR, id="70 m above"),
        pytest.param((99.15, -152.28, -238.77), -0.5902, 1.5227, STILL_AIR, id="89 m above"),
        pytest.param((23.7, -218.8, -68.6), 2.691, 1.809, (5.0, 7.0), id="81 m below, in wind"),
        pytest.param((135.7, -407.1, -247.6), 2.531, 1.340, (12.0, 29.0), id="98 m, strong wind"),
    ],
)
def test_a_circle_for_height_changes_the_height_and_ends(start, heading, course, wind):
    """It was flown level, for ever."""
    to = goal(0.0, 0.0, course=deg(course))
    flight = flown(start, deg(heading), [to], blowing(*wind), 120.0)
    assert flight.finished
    assert flight.moments[-1].state.time < 65.0


@pytest.mark.parametrize(
    ("start", "heading", "course", "climb", "wind"),
    [
        pytest.param((216.7, 65.2, -91.4), 1.7818, -2.5226, 5.68, STILL_AIR, id="dived to earth"),
        pytest.param((-51.8, 2.8, -100.5), 1.4791, -1.7518, 7.51, (5.0, -1.0), id="dived in wind"),
        pytest.param((63.2, 5.9, -208.8), -0.697, 2.623, -6.89, (8.0, 218.6), id="climbed away"),
        pytest.param((-129.8, -7.6, -190.9), 0.8437, 0.2037, -0.45, STILL_AIR, id="climbed"),
    ],
)
def test_on_a_circle_for_height_the_goals_slope_is_not_flown(start, heading, course, climb, wind):
    """The wrong way at that: one dived 800 m and more, another climbed for ever."""
    to = goal(0.0, 0.0, course=deg(course), climb=climb)
    flight = flown(start, deg(heading), [to], blowing(*wind), 120.0)
    assert flight.finished
    z = flight.path[:, 2]
    assert z.max() < max(start[2], -150.0) + 10.0
    assert z.min() > min(start[2], -150.0) - 10.0


@pytest.mark.parametrize("climb", [-8.0, 8.0])
def test_the_climb_angle_is_there_when_the_goal_is_passed(climb):
    """In the last 30 m the wanted slope turned round: 1.5 m off, 6.7 degrees too flat."""
    flight = flown((-600.0, 100.0, -150.0), 0.0, [goal(0.0, 0.0, climb=climb)])
    assert flight.reached[0].miss < 0.5
    assert flight.reached[0].climb_error < 1.0 * DEG


def test_goals_close_in_line_are_no_reason_for_a_loop():
    """Beyond the beginning of the straight end the approach began anew: 17 s for each goal."""
    goals = [goal(20.0 * k, 0.0) for k in range(4)]
    flight = flown((-400.0, 0.0, -150.0), 0.0, goals)
    assert flight.moments[-1].state.time < 20.0


def test_the_goal_circle_is_not_entered_against_its_sense():
    """A tangent that needed 8 degrees of turn to the other side counted as the circle's end."""
    flight = flown((163.61, 244.60, -167.94), 35.35, [goal(0.0, 0.0, course=-114.0)])
    assert len(flight.passes) == 1
    assert flight.moments[-1].state.time < 25.0


@pytest.mark.parametrize(
    ("start", "heading", "course"),
    [
        ((-128.3, 88.2, -155.1), -0.09, 1.65),
        ((-43.5, -171.7, -157.6), -2.05, 0.80),
        ((29.9, 157.3, -148.8), -2.36, 2.32),
        ((-58.5, -49.6, -145.4), -3.06, 0.98),
        ((60.1, 58.5, -143.6), 0.36, -1.64),
    ],
)
def test_a_goal_circle_that_the_start_lies_in_is_not_forbidden(start, heading, course):
    """It counted as blocked: a full circle more, 31 to 37 s instead of 14 to 19."""
    flight = flown(start, deg(heading), [goal(0.0, 0.0, course=deg(course))])
    assert flight.finished
    assert flight.moments[-1].state.time < 21.0
    assert flight.reversals <= 3  # of three turns, and the roll-out


def test_on_the_way_for_height_the_goal_counts_as_near_so_that_the_path_is_steep():
    leg = new_leg()._replace(phase=OUTBOUND, radius=80.0, final_approach=40.0)
    here = PlanarState(0.0, -80.0, 25.0, 0.0)
    assert leg_course(leg, here, 30.0).remaining == pytest.approx(80.0 + 40.0)
    assert fly_leg(leg, here, Paths(1000.0, 1.0, 1000.0), GAINS).phase == OUTBOUND
    assert fly_leg(leg, here, Paths(0.0, 1.0, 0.0), GAINS).phase == ON_PATH


@pytest.mark.parametrize("v_n", [(0.0, 0.0, 0.0), (0.0, 0.0, 3.0)])
def test_height_to_gain_without_any_speed_over_ground(v_n):
    """The centre of the circle was a division by zero."""
    here = state((-300.0, 0.0, -20.0), 0.0, wind=(-25.0, 0.0, 0.0))._replace(v_n=v_n)
    setpoint, _, wish = guide_within_limits(
        here, GuidanceTarget((0.0, 0.0, -150.0), 0.0, 0.0, 0.0, 0.0), VEHICLE, fresh_memory()
    )
    assert wish.phase == OUTBOUND
    assert is_within_limits(setpoint)


@pytest.mark.parametrize("circle", [0.0, 1.0])
def test_an_airspeed_of_zero_in_a_head_wind(circle):
    """As on the ground, or of a blocked tube: zero over zero stopped the companion."""
    here = state((-300.0, 0.0, -20.0), 0.0, wind=(-12.0, 0.0, 0.0))._replace(airspeed=0.0)
    setpoint, _, _ = guide_within_limits(
        here, GuidanceTarget((0.0, 0.0, -150.0), 0.0, 0.0, circle, 100.0), VEHICLE, fresh_memory()
    )
    assert is_within_limits(setpoint)
