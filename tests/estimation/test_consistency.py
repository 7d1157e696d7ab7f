"""What is told is held against the rest: each lie is found, honest flight is not doubted."""

import math

import numpy as np
import pytest
from flight_states import VEHICLE
from hypothesis import given, settings
from hypothesis import strategies as st

from vfguide.aircraft.state import FlightState
from vfguide.estimation.air_state import fresh_air
from vfguide.estimation.consistency import as_flown, follow, fresh_consistency
from vfguide.geometry.so3 import exp, from_euler, rot_z
from vfguide.geometry.units import DEG, G0
from vfguide.geometry.vector import add, matmul, norm, scale, sub

pytestmark = pytest.mark.slow

STEP = 0.02
SPEED = 25.0
NONE = math.nan, math.nan, math.nan
angles = st.floats(0.0, 2.0 * math.pi)
winds = st.tuples(st.floats(-6.0, 6.0), st.floats(-6.0, 6.0))


def honest(course, wind, bank, seconds):
    """States and body rates of a level coordinated turn, or of straight flight."""
    aircraft, p_n, states = VEHICLE.aircraft, (0.0, 0.0, -100.0), []
    wind_n = (*wind, 0.0)
    rate = G0 * math.tan(bank) / SPEED
    alpha = aircraft.alpha_zero + aircraft.alpha_load / math.cos(bank) / SPEED**2
    omega_b = None
    for k in range(round(seconds / STEP)):
        azimuth = course + rate * k * STEP
        v_n = add((SPEED * math.cos(azimuth), SPEED * math.sin(azimuth), 0.0), wind_n)
        R_nb = matmul(from_euler(bank, 0.0, azimuth), from_euler(0.0, alpha, 0.0))
        omega_b = tuple(np.array(R_nb).T @ np.array([0.0, 0.0, rate]))
        states.append((FlightState(k * STEP, p_n, v_n, R_nb, SPEED, wind_n), omega_b))
        p_n = add(p_n, scale(STEP, v_n))
    return states


def checked(states):
    """The state of the checks after all of them, with the thrust of level flight."""
    s, air, aircraft = fresh_consistency(), fresh_air(), VEHICLE.aircraft
    for state, omega_b in states:
        s = follow(state, omega_b, aircraft.thrust_trim, s, air, aircraft)
    return s


def told(states, lie, since=0.0):
    """The states with a lie from a time on."""
    return [(lie(m) if m.time >= since else m, omega_b) for m, omega_b in states]


def doubts(s):
    """The names of what is doubted."""
    times = {
        "yaw": s.yaw_doubt,
        "velocity": s.velocity_doubt,
        "wind": s.air.wind_doubt,
        "airspeed": s.air.airspeed_doubt,
        "attitude": s.attitude_doubt,
    }
    return {name for name, time in times.items() if time > 0.0}


@given(angles, winds, st.floats(-40.0 * DEG, 40.0 * DEG))
@settings(max_examples=60, deadline=None)
def test_honest_flight_is_not_doubted_and_not_changed(course, wind, bank):
    states = honest(course, wind, bank, 4.0)
    s, last = checked(states), states[-1][0]
    assert doubts(s) == set()
    assert as_flown(last, s) == last


@given(angles, winds, st.floats(20.0, 180.0), st.sampled_from((-1.0, 1.0)), st.booleans())
@settings(max_examples=60, deadline=None)
def test_a_wrong_yaw_is_taken_back(course, wind, degrees, side, sudden):
    states = honest(course, wind, 0.0, 4.0)
    turn = rot_z(side * max(degrees, 0.0 if sudden else 35.0) * DEG)
    lie = told(states, lambda m: m._replace(R_nb=matmul(turn, m.R_nb)), 2.0 if sudden else 0.0)
    s, true = checked(lie), states[-1][0]
    assert doubts(s) == {"yaw"}
    flown = as_flown(lie[-1][0], s)
    off = np.arccos(
        np.clip((np.trace(np.array(flown.R_nb).T @ np.array(true.R_nb)) - 1) / 2, -1, 1)
    )
    assert off < 6.0 * DEG


@given(angles, winds, angles, st.floats(5.0, 30.0), st.floats(-5.0, 5.0), st.booleans())
@settings(max_examples=60, deadline=None)
def test_a_wrong_ground_velocity_is_corrected_by_the_position(course, wind, at, size, down, sudden):
    states = honest(course, wind, 0.0, 4.0)
    error = (size * math.cos(at), size * math.sin(at), down)
    lie = told(states, lambda m: m._replace(v_n=add(m.v_n, error)), 2.0 if sudden else 0.0)
    s, true = checked(lie), states[-1][0]
    assert "velocity" in doubts(s)
    assert doubts(s) <= {"velocity", "wind"}  # the first of both may look wrong for a moment
    assert norm(sub(as_flown(lie[-1][0], s).v_n, true.v_n)) < 1.0


@given(angles, winds, angles, st.floats(5.0, 35.0))
@settings(max_examples=60, deadline=None)
def test_a_wind_that_jumps_is_not_believed(course, wind, at, size):
    states = honest(course, wind, 0.0, 4.0)
    error = (size * math.cos(at), size * math.sin(at), 0.0)
    s = checked(told(states, lambda m: m._replace(wind_n=add(m.wind_n, error)), 2.0))
    assert doubts(s) == {"wind"}
    assert math.isnan(as_flown(states[-1][0], s).wind_n[0])


@given(angles, winds, angles, st.floats(4.0, 20.0))
@settings(max_examples=60, deadline=None)
def test_a_wind_that_grows_more_quickly_than_the_air_does_is_not_believed(course, wind, at, rate):
    along = (math.cos(at), math.sin(at), 0.0)

    def grown(m):
        return m._replace(wind_n=add(m.wind_n, scale(rate * (m.time - 2.0), along)))

    told_wrong = told(honest(course, wind, 0.0, 2.0 + 8.0 / rate), grown, since=2.0)
    assert doubts(checked(told_wrong)) == {"wind"}


@given(angles, winds, angles, st.floats(0.0, 1.0))
@settings(max_examples=60, deadline=None)
def test_a_wind_that_changes_as_the_air_does_is_believed(course, wind, at, rate):
    """The aircraft is in the same air: its ground velocity changes with it."""
    change = scale(rate, (math.cos(at), math.sin(at), 0.0))
    windier, offset = [], (0.0, 0.0, 0.0)
    for m, omega_b in honest(course, wind, 0.0, 6.0):
        gust = scale(m.time, change)
        offset = add(offset, scale(STEP, gust))
        wind_n, v_n = add(m.wind_n, gust), add(m.v_n, gust)
        windier.append((m._replace(p_n=add(m.p_n, offset), v_n=v_n, wind_n=wind_n), omega_b))
    assert doubts(checked(windier)) == set()


@given(angles, winds, st.sampled_from((0, 1)), st.floats(20.0, 90.0), st.sampled_from((-1.0, 1.0)))
@settings(max_examples=60, deadline=None)
def test_a_roll_or_pitch_that_turns_without_the_body_is_found_at_once(
    course, wind, axis, degrees, side
):
    states = honest(course, wind, 0.0, 2.06)
    error = exp(scale(side * degrees * DEG, (1.0 - axis, float(axis), 0.0)))
    s = checked(told(states, lambda m: m._replace(R_nb=matmul(m.R_nb, error)), 2.0))
    assert "attitude" in doubts(s)


@pytest.mark.parametrize("degrees", [-60.0, -30.0, 30.0, 60.0])
def test_a_roll_that_is_wrong_from_the_beginning_is_found_within_a_second(degrees):
    states = honest(0.5, (0.0, 0.0), 0.0, 1.0)
    error = exp((degrees * DEG, 0.0, 0.0))
    s = checked(told(states, lambda m: m._replace(R_nb=matmul(m.R_nb, error))))
    assert "attitude" in doubts(s)


@given(angles, winds, st.floats(1.0, 60.0), st.floats(2.0, 8.0))
@settings(max_examples=40, deadline=None)
def test_a_position_reset_and_a_pause_are_no_lies(course, wind, jump, pause):
    states = honest(course, wind, 0.0, 3.0)
    later = [
        (m._replace(p_n=add(m.p_n, (jump, -jump, 0.0))), w) if m.time > 1.5 else (m, w)
        for m, w in states
    ]
    after = [(m._replace(time=m.time + pause), w) for m, w in states]
    assert doubts(checked(later)) == set()
    assert doubts(checked(states + after)) == set()


def test_nothing_is_doubted_where_wind_and_airspeed_are_not_told():
    states = honest(1.0, (3.0, -2.0), 0.3, 4.0)
    untold = told(states, lambda m: m._replace(airspeed=math.nan, wind_n=NONE))
    assert doubts(checked(untold)) == set()
