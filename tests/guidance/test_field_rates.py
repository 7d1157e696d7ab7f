"""Law `field`: the rates of its command, and the obstacles that it need not look at."""

import math

import numpy as np
import pytest
from flight_states import VEHICLE, state
from guidance_targets import GOAL
from hazard_samples import ball, hazards
from hypothesis import assume, given
from hypothesis import strategies as st

from vfguide.aircraft.envelope import flyable_radius, usable_bank
from vfguide.aircraft.point_mass import dynamics
from vfguide.airspace.detection import Airspace
from vfguide.airspace.keep_out import NO_FENCE
from vfguide.estimation.estimation import known_state
from vfguide.geometry.so3 import bank_angle, from_euler
from vfguide.geometry.units import G0
from vfguide.geometry.vector import add, norm, scale, sub
from vfguide.geometry.velocity import azimuth_of, path_of, velocity_along
from vfguide.guidance import field_law
from vfguide.guidance.field_barriers import with_near_obstacles
from vfguide.guidance.field_direction import led
from vfguide.guidance.guidance_state import GuidanceState, leg_begins
from vfguide.guidance.remedies import ALL_REMEDIES
from vfguide.planning import planning
from vfguide.planning.objective import objective_at
from vfguide.planning.route import fresh_route

AIRCRAFT, GAINS, _ = VEHICLE
RADIUS = flyable_radius(
    state((0.0, 0.0, 0.0), 0.0), usable_bank(AIRCRAFT, GAINS, GAINS.airspeed), GAINS
)
STEP = 1e-4
far = st.tuples(st.floats(-900.0, -400.0), st.floats(-300.0, 300.0), st.floats(-180.0, -120.0))
winds = st.tuples(st.floats(-6.0, 6.0), st.floats(-6.0, 6.0), st.floats(-0.5, 0.5))
courses, banks = st.floats(-math.pi, math.pi), st.floats(-0.7, 0.7)
balls = st.lists(
    st.tuples(st.floats(-900.0, 900.0), st.floats(-500.0, 500.0), st.floats(-300.0, 0.0)),
    max_size=8,
)


def among(places, t=2.0):
    return Airspace(hazards([ball(place, 60.0) for place in places], []), NO_FENCE, t, 0.0)


def advanced(here, command, dt):
    """The state a short time later, by the derivatives of the point mass alone."""
    air, lags = sub(here.v_n, here.wind_n), dynamics(AIRCRAFT, GAINS)
    speed = norm(air)
    path = path_of(air, speed)
    bank = bank_angle(here.R_nb)
    turned = azimuth_of(air) + dt * G0 * math.tan(bank) / speed
    climbed = path + dt * (command.gamma - path) / lags.path_lag
    v_n = add(velocity_along(turned, climbed, speed), here.wind_n)
    return here._replace(p_n=add(here.p_n, scale(dt, here.v_n)), v_n=v_n)


def command_at(here, airspace, elapsed):
    """The command of the field, without what it keeps from the step before."""
    nav = known_state(here, here.time - elapsed)
    goal = objective_at(GOAL, here)
    s = GuidanceState(0.0, 1.0, leg_begins(0.0))
    route = planning.update(nav, goal, None, False, fresh_route(), 0.0, VEHICLE)
    return field_law.update(ALL_REMEDIES, nav, goal, route, airspace, s, VEHICLE)[0]


@given(far, courses, banks, winds, balls)
def test_the_rates_are_the_derivative_of_the_command_along_the_motion(
    p_n, course, bank, wind, places
):
    here = state(p_n, course, wind=wind, time=10.0)._replace(R_nb=from_euler(bank, 0.05, course))
    airspace = among(places)
    now = command_at(here, airspace, 0.02)

    def there(dt):
        around = airspace._replace(time=airspace.time + dt)
        return command_at(advanced(here, now, dt)._replace(time=10.0), around, 0.02 + dt)

    before, after = there(-STEP), there(STEP)
    for name in ("gamma", "bank", "load"):
        backward = (getattr(now, name) - getattr(before, name)) / STEP
        forward = (getattr(after, name) - getattr(now, name)) / STEP
        assume(abs(forward - backward) < 0.05)  # at a limit, or where an obstacle begins to act
        assert getattr(now.rates, name) == pytest.approx(0.5 * (backward + forward), abs=2e-3)
    speed = norm(sub(here.v_n, here.wind_n))
    assert now.rates.azimuth == pytest.approx(G0 * math.tan(bank) / speed, abs=1e-6)
    assert now.rates.are_known


def test_without_the_lead_they_are_not_known():
    here = state((-700.0, 50.0, -150.0), 0.3)
    nav, goal = known_state(here, -1.0), objective_at(GOAL, here)
    s = GuidanceState(0.0, 1.0, leg_begins(0.0))
    route = planning.update(nav, goal, None, False, fresh_route(), 0.0, VEHICLE)
    remedies = ALL_REMEDIES._replace(lead=False)
    command, _ = field_law.update(remedies, nav, goal, route, None, s, VEHICLE)
    assert not command.rates.are_known


@given(far, courses, winds, balls, st.booleans())
def test_obstacles_that_are_left_out_would_change_nothing(p_n, course, wind, places, written):
    here, airspace = state(p_n, course, wind=wind), among(places)
    remedies = ALL_REMEDIES._replace(reactive_range=not written)
    near = with_near_obstacles(remedies, airspace, here, RADIUS, GAINS)
    assert len(near.hazards.obstacles) <= len(places)
    among_near, among_all = (led(remedies, here, GOAL, each, VEHICLE) for each in (near, airspace))
    assert pytest.approx(among_all.F, abs=1e-9) == among_near.F
    assert among_near.turning == pytest.approx(among_all.turning, abs=1e-9)


def test_far_obstacles_are_left_out():
    here = state((-700.0, 0.0, -150.0), 0.0)
    airspace = among([(-550.0, 0.0, -150.0), (900.0, 0.0, -150.0)])
    near = with_near_obstacles(ALL_REMEDIES, airspace, here, RADIUS, GAINS)
    assert np.array_equal(near.hazards.obstacles, airspace.hazards.obstacles[:1])
