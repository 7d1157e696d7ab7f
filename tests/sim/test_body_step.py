"""Law flight on a rigid body: body rates that fly it to goals and on to the circle."""

import math

import numpy as np
import pytest
from aeroplanes import AEROSONDE

from vfguide.aircraft.performance import Gains
from vfguide.aircraft.vehicle import Vehicle
from vfguide.geometry.angles import wrap
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG
from vfguide.guidance.laws import FLIGHT
from vfguide.kernels.rows import row_of
from vfguide.loop.legs import Goal, leg_rows
from vfguide.loop.loop_report import goal_of_row
from vfguide.loop.rows import step_body
from vfguide.loop.state import fresh_state, row_of_state
from vfguide.sim.kinematic import Bodies, Commands, advance

SPEED, UPDATE, RADIUS = 25.0, 0.02, 100.0
GOALS = (
    Goal((0.0, 0.0, -50.0), 0.5, 0.0, 5.0, 10.0 * DEG),
    Goal((400.0, 300.0, -70.0), -1.0, 3.0 * DEG, 5.0, 10.0 * DEG),
)
STARTS = [
    ((-600.0, 0.0, -50.0), (0.0, 0.0, 0.0)),
    ((-600.0, 200.0, -90.0), (0.0, 0.0, math.pi)),
    ((300.0, -300.0, -30.0), (math.pi, 0.0, 1.0)),
    ((100.0, 500.0, -120.0), (0.0, 0.5 * math.pi, 0.0)),
    ((30.0, 10.0, -50.0), (0.0, -0.5 * math.pi, 2.0)),
]


def fly(goals, p_n, euler, seconds, side=1.0):
    """Bodies, rates and legs at every update."""
    legs = leg_rows(goals, side, RADIUS)
    vehicle = row_of(Vehicle(AEROSONDE, Gains(SPEED), True))
    bodies = Bodies(np.array([p_n]), np.array([from_euler(*euler)]))
    row, flown = row_of_state(fresh_state()), []
    for k in range(round(seconds / UPDATE)):
        p, R = bodies.p_n[0], bodies.R_nb[0]
        omega_b, row, _ = step_body(k * UPDATE, p, R, row, legs, FLIGHT, vehicle)
        flown.append((p, R, omega_b, goal_of_row(row)))
        bodies = advance(bodies, Commands(np.array([SPEED]), np.array([omega_b])), UPDATE)
    return [np.array(column) for column in zip(*flown, strict=True)]


def at_goal(goal, p_n, R_nb):
    """Miss [m], and errors of course and climb [rad], at the nearest of some moments."""
    nearest = int(np.linalg.norm(p_n - goal.p_n, axis=1).argmin())
    nose, off = R_nb[nearest, :, 0], p_n[nearest] - goal.p_n
    miss = np.linalg.norm(off - (off @ nose) * nose)
    course = abs(wrap(math.atan2(nose[1], nose[0]) - goal.course))
    return miss, course, abs(math.asin(-nose[2]) - goal.climb)


@pytest.mark.parametrize(("p_n", "euler"), STARTS)
def test_both_goals_are_met_in_their_poses_from_any_attitude(p_n, euler):
    p, R, rates, leg = fly(GOALS, p_n, euler, 180.0)
    assert leg[-1] == 2
    for number, goal in enumerate(GOALS):
        its = slice(np.flatnonzero(leg == number)[0], np.flatnonzero(leg == number + 1)[0] + 1)
        miss, course, climb = at_goal(goal, p[its], R[its])
        assert miss < 0.5
        assert course < 1.0 * DEG
        assert climb < 1.0 * DEG
    assert np.isfinite(rates).all()
    assert (np.abs(rates) <= np.array(AEROSONDE.rate_max) + 1e-12).all()


def test_a_goal_that_is_missed_too_often_is_given_up():
    exact = GOALS[0]._replace(tolerance=1e-9, attempts=2)
    p, _, _, leg = fly((exact, GOALS[1]), (-600.0, 30.0, -50.0), (0.0, 0.0, 0.0), 240.0)
    assert leg[-1] == 2
    approaching = (p[leg == 0] - exact.p_n) @ (math.cos(exact.course), math.sin(exact.course), 0.0)
    near = np.linalg.norm(p[leg == 0] - exact.p_n, axis=1) < 20.0
    assert np.count_nonzero(np.diff((near & (approaching < 0.0)).astype(int)) == 1) == 2


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_after_the_last_goal_it_flies_a_level_circle_that_leaves_the_goal(side):
    goal = GOALS[0]
    p, _, _, leg = fly(GOALS[:1], (-600.0, 30.0, -50.0), (0.0, 0.0, 0.0), 120.0, side)
    after = p[leg == 1][round(20.0 / UPDATE) :]
    assert len(after) * UPDATE * SPEED > 2.0 * math.pi * RADIUS
    to_side = side * np.array((-math.sin(goal.course), math.cos(goal.course)))
    centre = np.array(goal.p_n[:2]) + RADIUS * to_side
    off = np.linalg.norm(after[:, :2] - centre, axis=1) - RADIUS
    assert np.abs(off).max() < 2.0
    assert np.abs(after[:, 2] - goal.p_n[2]).max() < 0.5


def test_it_banks_as_the_aeroplane_would():
    p, R, _, leg = fly(GOALS[:1], (-600.0, 30.0, -50.0), (0.0, 0.0, 0.0), 120.0)
    steady = R[leg == 1][-500:]
    bank = np.arctan2(steady[:, 2, 1], steady[:, 2, 2])
    assert bank == pytest.approx(math.atan(SPEED**2 / (9.80665 * RADIUS)), abs=1.0 * DEG)
    assert p.shape == (6000, 3)
