"""Law `field`: where it leads, and what each remedy does."""

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
from vfguide.field.navigation import navigation_field
from vfguide.geometry.angles import wrap
from vfguide.geometry.units import DEG
from vfguide.geometry.velocity import azimuth_of
from vfguide.guidance.field_direction import DIFFERENCE_TIME, led, slope_of
from vfguide.guidance.free_line import line_length
from vfguide.guidance.remedies import ALL_REMEDIES

GAINS = VEHICLE.gains
RADIUS = flyable_radius(
    state((0.0, 0.0, 0.0), 0.0), usable_bank(VEHICLE.aircraft, GAINS, GAINS.airspeed), GAINS
)
angles = st.floats(-math.pi, math.pi)
far = st.floats(4.0, 40.0)


def at(x, y, course=0.0, z=None):
    """A state at a place in the goal's frame, in turn radii."""
    c, s = math.cos(GOAL.course), math.sin(GOAL.course)
    north, east, down = GOAL.p_n
    place = (
        north + RADIUS * (c * x - s * y),
        east + RADIUS * (s * x + c * y),
        down if z is None else z,
    )
    return state(place, course)


def length(here, remedies=ALL_REMEDIES):
    return line_length(here.p_n, GOAL, RADIUS, remedies.bounded_circles)


def leads(here, airspace=None, remedies=ALL_REMEDIES):
    return led(remedies, here, GOAL, airspace, VEHICLE)


@given(far, st.floats(-1.5, 1.5), angles)
def test_before_the_goal_it_is_the_papers_field_in_the_plane(distance, bearing, course):
    x, y = -distance * math.cos(bearing), distance * math.sin(bearing)
    if x > -1.0:
        return
    north, east, _ = navigation_field((x, y, 0.0))
    off = azimuth_of(leads(at(x, y, course)).F) - GOAL.course - math.atan2(east, north)
    assert wrap(off) == pytest.approx(0.0, abs=1e-9)


@given(far, angles, angles)
def test_its_line_becomes_shorter_as_it_is_followed(distance, bearing, course):
    x, y = distance * math.cos(bearing), distance * math.sin(bearing)
    here = at(x, y, course)
    step, along = 0.05, azimuth_of(leads(here).F) - GOAL.course
    after = at(x + step * math.cos(along), y + step * math.sin(along), course)
    assert length(after) < length(here) + 1e-6


@given(far, angles, angles)
def test_its_turn_rate_is_that_of_its_course_along_the_motion(distance, bearing, course):
    x, y = distance * math.cos(bearing), distance * math.sin(bearing)
    here = at(x, y, course)
    step = DIFFERENCE_TIME
    north, east, down = here.p_n
    later = here._replace(
        p_n=(north + step * here.v_n[0], east + step * here.v_n[1], down + step * here.v_n[2])
    )
    turned = wrap(azimuth_of(leads(later).F) - azimuth_of(leads(here).F)) / step
    if abs(turned) < 1.0:
        assert leads(here).turning == pytest.approx(turned, abs=1e-6)


def test_without_bounded_circles_it_leads_away_on_the_axis_ahead():
    here = at(20.0, 0.1)
    print_alone = ALL_REMEDIES._replace(bounded_circles=False)
    away, back = leads(here, remedies=print_alone), leads(here)
    assert abs(wrap(azimuth_of(away.F) - GOAL.course)) < 5.0 * DEG
    assert abs(wrap(azimuth_of(back.F) - GOAL.course)) > 150.0 * DEG
    assert length(here) < 60.0 * RADIUS < length(here, print_alone)


@given(st.floats(-0.9, 0.9), st.floats(1.2, 3.0))
def test_a_ball_ahead_is_led_past(aside, distance):
    here = at(-20.0, 0.0, GOAL.course)
    c, s = math.cos(GOAL.course), math.sin(GOAL.course)
    north, east, down = here.p_n
    ahead, right = 40.0 * distance, 40.0 * aside
    centre = (north + c * ahead - s * right, east + s * ahead + c * right, down)
    among = Airspace(hazards([ball(centre, 40.0)], [], floor=-1e4), NO_FENCE, 0.0, 0.0)
    off = wrap(azimuth_of(leads(here, among).F) - azimuth_of(leads(here).F))
    if abs(aside) > 0.05:
        assert off * aside <= 0.0, "it turns to the side on which there is more room"
    assert abs(off) > 1.0 * DEG


def test_a_goal_above_is_led_up_to():
    assert slope_of(leads(at(-20.0, 0.0, z=GOAL.p_n[2] + 50.0)).F) > 0.0
    assert slope_of(leads(at(-20.0, 0.0, z=GOAL.p_n[2] - 50.0)).F) < 0.0
