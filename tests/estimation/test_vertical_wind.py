"""The vertical wind that the lift shows."""

import math

import numpy as np
import pytest
from aeroplanes import AEROSONDE
from hypothesis import given
from hypothesis import strategies as st

from vfguide.aircraft.state import FlightState
from vfguide.estimation.air_state import AIRSPEED, fresh_air
from vfguide.estimation.vertical_wind import GUST_ANGLE_MAX, LONGEST_GAP, RISE_TIME, feel_rise
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import G0
from vfguide.geometry.vector import add, matvec, scale, sub

SPEED = 25.0
HERE = STILL = (0.0, 0.0, 0.0)


def flight(bank, azimuth, gamma, load, rise):
    """Specific force, velocity over ground and attitude of a flight in air that rises."""
    alpha = AEROSONDE.alpha_zero + AEROSONDE.alpha_load * load / SPEED**2
    R_na = from_euler(bank, gamma, azimuth)
    R_nb = tuple(map(tuple, np.array(R_na) @ np.array(from_euler(0.0, alpha, 0.0))))
    v_air_n = matvec(R_na, (SPEED, 0.0, 0.0))
    force_n = matvec(R_nb, (0.0, 0.0, -load * G0))
    return force_n, add(v_air_n, (0.0, 0.0, -rise)), R_nb


def felt(force_n, v_n, R_nb, seconds=3.0, dt=0.02):
    air = known_air()
    told = FlightState(0.0, HERE, v_n, R_nb, SPEED, STILL)
    air = feel_rise(told, air, AEROSONDE)
    # The velocity that is told changes by the force, the attitude by as much: it stays.
    before_n = sub(v_n, scale(dt, add(force_n, (0.0, 0.0, G0))))
    for k in range(1, round(seconds / dt) + 1):
        air = air._replace(vertical=air.vertical._replace(v_n=before_n))
        air = feel_rise(told._replace(time=k * dt), air, AEROSONDE)._replace(time=k * dt)
    return air.vertical.rise


def known_air():
    air = fresh_air()
    air.estimate.x[AIRSPEED] = SPEED
    return air._replace(time=0.0)


@given(
    st.floats(-0.9, 0.9),
    st.floats(-math.pi, math.pi),
    st.floats(-0.15, 0.15),
    st.floats(0.3, 1.7),
    st.floats(-3.0, 3.0),
)
def test_the_lift_shows_how_fast_the_air_rises(bank, azimuth, gamma, load, rise):
    """Across the wing: its slip and the cosine of the bank leave a little."""
    at = flight(bank, azimuth, gamma, load, rise)
    expected = rise * (math.cos(bank) * math.cos(gamma)) ** 2
    assert felt(*at) == pytest.approx(expected, abs=0.03 + 0.05 * abs(rise))


def test_it_settles_in_its_time():
    at = flight(0.0, 1.0, 0.0, 1.0, 2.0)
    assert felt(*at, seconds=RISE_TIME, dt=0.002) == pytest.approx(
        2.0 * (1.0 - math.exp(-1.0)), 0.05
    )


def test_no_jump_of_the_velocity_makes_a_storm():
    _, v_n, R_nb = flight(0.0, 0.0, 0.0, 1.0, 0.0)
    air = known_air()
    told = FlightState(0.0, HERE, v_n, R_nb, SPEED, STILL)
    jumped = told._replace(time=0.02, v_n=add(v_n, (0.0, 0.0, 5.0)))
    air = feel_rise(jumped, feel_rise(told, air, AEROSONDE), AEROSONDE)
    assert abs(air.vertical.rise) <= GUST_ANGLE_MAX * SPEED * 0.02 / RISE_TIME


def test_what_is_not_a_number_is_not_felt():
    _, v_n, R_nb = flight(0.0, 0.0, 0.0, 1.0, 1.0)
    told = FlightState(0.02, HERE, (math.nan, *v_n[1:]), R_nb, SPEED, STILL)
    assert feel_rise(told, known_air(), AEROSONDE).vertical.rise == 0.0


def test_after_a_pause_it_begins_anew():
    _, v_n, R_nb = flight(0.0, 0.0, 0.0, 1.0, 1.0)
    air = known_air()
    air = air._replace(vertical=air.vertical._replace(rise=2.0))
    told = FlightState(2.0 * LONGEST_GAP, HERE, v_n, R_nb, SPEED, STILL)
    assert feel_rise(told, air, AEROSONDE).vertical.rise == 0.0
    assert feel_rise(told._replace(time=0.0), air, AEROSONDE).vertical.rise == 0.0
