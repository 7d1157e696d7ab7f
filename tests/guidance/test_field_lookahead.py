"""Law `field`: a path that is blocked or led back, and who leads then."""

import math

import pytest
from flight_states import VEHICLE, state
from guidance_targets import GOAL
from hazard_samples import ball, hazards
from hypothesis import given
from hypothesis import strategies as st

from vfguide.aircraft.envelope import flyable_radius, usable_bank
from vfguide.airspace.detection import Airspace
from vfguide.airspace.keep_out import NO_FENCE
from vfguide.estimation.estimation import known_state
from vfguide.guidance import field_law
from vfguide.guidance.field_lookahead import PREDICTION_INTERVAL, is_blocked
from vfguide.guidance.field_progress import APPROACH_RADII, next_progress
from vfguide.guidance.guidance_state import FieldProgress, GuidanceState, Leader, leg_begins
from vfguide.guidance.remedies import ALL_REMEDIES
from vfguide.paths.leg import FIELD
from vfguide.planning.objective import objective_at
from vfguide.planning.route import is_on_field, route_on_field

AIRCRAFT, GAINS, _ = VEHICLE
RADIUS = flyable_radius(
    state((0.0, 0.0, 0.0), 0.0), usable_bank(AIRCRAFT, GAINS, GAINS.airspeed), GAINS
)
c, s = math.cos(GOAL.course), math.sin(GOAL.course)


def at(ahead, right=0.0):
    """A place in the goal's frame [m]."""
    north, east, down = GOAL.p_n
    return north + c * ahead - s * right, east + s * ahead + c * right, down


def among(*balls):
    return Airspace(hazards(list(balls), [], floor=-1e4), NO_FENCE, 0.0, 0.0)


def pocket(ahead, half_width=130.0, depth=160.0):
    """Walls of balls round a pocket that opens before the goal."""
    end = [ball(at(ahead, y), 40.0) for y in range(-130, 131, 26)]
    sides = [
        ball(at(ahead - x, side * half_width), 40.0)
        for x in range(0, int(depth) + 1, 20)
        for side in (-1.0, 1.0)
    ]
    return among(*end, *sides)


def test_free_air_is_not_blocked():
    here = state(at(-900.0), GOAL.course)
    assert not is_blocked(ALL_REMEDIES, here, GOAL, None, VEHICLE)
    assert not is_blocked(ALL_REMEDIES, here, GOAL, among(), VEHICLE)


@given(st.floats(-math.pi, math.pi))
def test_a_turn_to_the_goal_is_none_that_is_led_back(course):
    assert not is_blocked(ALL_REMEDIES, state(at(-900.0), course), GOAL, among(), VEHICLE)


@given(st.floats(-30.0, 30.0))
def test_one_obstacle_is_led_past(right):
    airspace = among(ball(at(-600.0, right), 50.0))
    here = state(at(-1000.0), GOAL.course)
    assert not is_blocked(ALL_REMEDIES, here, GOAL, airspace, VEHICLE)


@given(st.floats(-40.0, 40.0))
def test_a_pocket_is_seen_before_it_is_entered(right):
    here = state(at(-1000.0, right), GOAL.course)
    assert is_blocked(ALL_REMEDIES, here, GOAL, pocket(-650.0), VEHICLE)


def flown(here, progress, airspace):
    """Who led at a step, and who leads at the next."""
    nav, goal = known_state(here, here.time - 0.02), objective_at(GOAL, here)
    before = GuidanceState(0.0, 1.0, progress)
    command, after = field_law.update(
        ALL_REMEDIES, nav, goal, route_on_field(), airspace, before, VEHICLE
    )
    return command, after.progress


def test_a_route_is_asked_for_before_a_pocket_and_only_now_and_then():
    here = state(at(-1000.0), GOAL.course)
    _, progress = flown(here, leg_begins(0.0), pocket(-650.0))
    assert progress.leader == Leader.ROUTE
    looked = leg_begins(0.0)._replace(looked=here.time - 0.5 * PREDICTION_INTERVAL)
    _, progress = flown(here, looked, pocket(-650.0))
    assert progress.leader == Leader.FIELD


def test_the_command_says_what_progress_and_passages_need():
    command, progress = flown(state(at(-1000.0), GOAL.course), leg_begins(0.0), None)
    assert command.radius == pytest.approx(RADIUS)
    assert command.phase == FIELD
    assert command.remaining == progress.length == pytest.approx(1000.0)
    assert is_on_field(route_on_field())


def test_an_aircraft_at_rest_in_the_air_has_a_command():
    """Still, with the wind of its velocity over ground: its air velocity is zero."""
    here = state(at(-800.0, 60.0), 0.0)._replace(v_n=(0.0, 0.0, 0.0), airspeed=0.0)
    command, _ = flown(here, leg_begins(0.0), among(ball(at(-700.0, 60.0), 50.0)))
    assert all(map(math.isfinite, (*command[:-1], *command.rates)))


def progress_after(before, length, search=True):
    remedies = ALL_REMEDIES._replace(search=search)
    return next_progress(remedies, before, length, RADIUS, 10.0, GAINS)


def test_who_leads_next():
    """On the field, on a route until it is nearer, after an approach that leads away."""
    field = FieldProgress(Leader.FIELD, 900.0, 900.0, 9.0, 9.0)
    assert progress_after(field, 800.0).leader == Leader.FIELD
    assert progress_after(field._replace(since=-60.0), 900.0).leader == Leader.ROUTE
    assert progress_after(field._replace(since=-60.0), 900.0, False).leader == Leader.FIELD
    route = field._replace(leader=Leader.ROUTE)
    assert progress_after(route, 800.0).leader == Leader.ROUTE
    assert progress_after(route, 900.0 - 5.0 * RADIUS).leader == Leader.FIELD
    approach = field._replace(leader=Leader.APPROACH, nearest=20.0)
    left = progress_after(approach, APPROACH_RADII * RADIUS)
    assert (left.leader, left.nearest) == (Leader.ROUTE, APPROACH_RADII * RADIUS)
    assert progress_after(approach, 300.0, False).leader == Leader.FIELD
    circle = field._replace(leader=Leader.CIRCLE)
    assert progress_after(circle, 900.0).leader == Leader.FIELD
