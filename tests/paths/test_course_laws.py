"""Courses in the plane: the paper's field, lines, the loiter circle."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from planar_states import SPEED, at

from vfguide.field.navigation import navigation_field
from vfguide.geometry.angles import wrap
from vfguide.geometry.se2 import Pose
from vfguide.paths.course_laws import arc_to_goal, field_course, line_course, loiter_course

RADIUS = 80.0
PLACE = st.floats(-1500.0, 1500.0)
COURSE = st.floats(-math.pi, math.pi)
SIDE = st.sampled_from([1.0, -1.0])


def rate(course_of, place):
    """The course's rate along the present velocity, by central differences."""
    h = 1e-4
    later = course_of(place._replace(x=place.x + h * place.vx, y=place.y + h * place.vy))
    sooner = course_of(place._replace(x=place.x - h * place.vx, y=place.y - h * place.vy))
    return wrap(later.chi - sooner.chi) / (2.0 * h)


@given(st.floats(-1500.0, -40.0), PLACE, COURSE)
def test_before_the_core_the_course_is_that_of_the_papers_field(x, y, course):
    found = field_course(at(x, y, course), 30.0)
    F = navigation_field((x, y, 0.0))
    assert wrap(found.chi - math.atan2(F[1], F[0])) == pytest.approx(0.0, abs=1e-12)
    expected = rate(lambda place: field_course(place, 30.0), at(x, y, course))
    assert found.chi_rate == pytest.approx(expected, rel=1e-5, abs=1e-7)


@given(st.floats(-29.0, 60.0), st.floats(-10.0, 10.0), COURSE)
def test_in_the_core_it_is_that_of_a_line(x, y, course):
    found = field_course(at(x, y, course), 30.0)
    assert found.chi == pytest.approx(-2.0 * math.atan(y / 30.0))
    expected = rate(lambda place: field_course(place, 30.0), at(x, y, course))
    assert found.chi_rate == pytest.approx(expected, rel=1e-5, abs=1e-7)


@given(st.floats(-900.0, -10.0), st.floats(-400.0, 400.0))
def test_the_remaining_path_is_the_arc_of_the_field(x, y):
    assume(abs(y) > 1.0)
    theta = np.linspace(0.0, 2.0 * (math.pi - abs(math.atan2(y, x))), 20_001)
    radius = (x * x + y * y) / (2.0 * abs(y))
    arc = np.stack((-radius * np.sin(theta), radius * (1.0 - np.cos(theta))))
    length = np.linalg.norm(np.diff(arc), axis=0).sum()
    assert arc_to_goal(x, y) == pytest.approx(length, rel=1e-6)
    assert np.allclose(arc[:, -1], (x, abs(y)), atol=1e-6)


@given(PLACE, PLACE, COURSE, COURSE)
def test_the_course_onto_a_line_leads_to_it_and_ends_along_it(x, y, along, course):
    here, line = at(x, y, course), Pose(30.0, -20.0, along)
    found = line_course(here, line, RADIUS)
    off = math.cos(along) * (y - line.y) - math.sin(along) * (x - line.x)
    onto = math.sin(wrap(found.chi - along))
    assert onto * off <= 0.0
    assert abs(onto) == pytest.approx(1.25 * abs(off) / math.hypot(RADIUS, 1.25 * off), abs=1e-9)
    expected = rate(lambda place: line_course(place, line, RADIUS), here)
    assert found.chi_rate == pytest.approx(expected, rel=1e-4, abs=1e-6)


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("start", [(600.0, 0.0), (-300.0, 250.0), (5.0, 5.0), (0.0, 79.0)])
def test_a_loiter_converges_to_its_circle_and_never_turns_tighter(start, side):
    x, y = start
    dt, tightest = 0.02, 0.0
    for _ in range(6000):
        here = at(x, y, 0.0)
        chi = loiter_course(here, side, RADIUS).chi
        flown = at(x, y, chi)
        turn = loiter_course(flown, side, RADIUS).chi_rate
        if math.hypot(x, y) > RADIUS:
            tightest = max(tightest, abs(turn) / SPEED)
        x, y = x + dt * flown.vx, y + dt * flown.vy
    assert math.hypot(x, y) == pytest.approx(RADIUS, abs=1.0)
    assert math.copysign(1.0, turn) == side
    assert tightest <= 1.02 / RADIUS


@given(PLACE, PLACE, SIDE, COURSE)
def test_the_loiters_rate_is_the_derivative(x, y, side, course):
    assume(math.hypot(x, y) > 5.0)
    here = at(x, y, course)
    expected = rate(lambda place: loiter_course(place, side, RADIUS), here)
    found = loiter_course(here, side, RADIUS).chi_rate
    assert found == pytest.approx(expected, rel=1e-4, abs=1e-6)
