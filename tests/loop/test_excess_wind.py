"""A wind as fast as the aircraft: recognised with hysteresis, held against in the frame of air."""

import math

import pytest
from flight_states import VEHICLE, state
from flown_stages import fresh_memory, guide
from hypothesis import given
from hypothesis import strategies as st

from vfguide.geometry.angles import wrap
from vfguide.planning.excess_wind import (
    EXCESS_RATIO,
    RELEASE_RATIO,
    WIND_SMOOTHING_TIME,
    WindHold,
    fresh_wind_hold,
    in_air_frame,
    into_wind,
    update_wind_hold,
)


def in_wind(speed):
    return state((0.0, 0.0, -120.0), 0.3, wind=(0.0, speed, 0.0))


def after(stand, speed, seconds):
    for _ in range(round(seconds / 0.02)):
        stand = update_wind_hold(stand, in_wind(speed), 25.0, 0.02)
    return stand


@pytest.mark.parametrize("part", [0.0, 0.5, 0.94, 0.96, 1.0, 2.0])
def test_it_holds_above_a_part_of_the_airspeed(part):
    assert after(fresh_wind_hold(), part * 25.0, 0.02).holds == (part > EXCESS_RATIO)


@pytest.mark.parametrize("part", [0.84, 0.86, 0.94, 1.1])
def test_it_goes_on_holding_until_the_wind_has_fallen_below_another(part):
    stand = after(fresh_wind_hold(), 30.0, 1.0)
    assert after(stand, part * 25.0, 10.0 * WIND_SMOOTHING_TIME).holds == (part > RELEASE_RATIO)


def test_a_gust_changes_nothing():
    stand = after(fresh_wind_hold(), 20.0, 1.0)
    assert not after(stand, 27.0, 1.0).holds
    assert after(stand, 27.0, 10.0).holds


def test_the_height_is_that_where_it_began():
    stand = after(fresh_wind_hold(), 30.0, 0.02)
    lower = in_wind(30.0)._replace(p_n=(0.0, 0.0, -90.0))
    assert update_wind_hold(stand, lower, 25.0, 0.02).down == -120.0


@given(st.floats(-math.pi, math.pi), st.floats(-math.pi, math.pi), st.floats(20.0, 45.0))
def test_it_turns_towards_the_wind_from_any_heading(yaw, toward, speed):
    wind = (speed * math.cos(toward), speed * math.sin(toward), 0.0)
    here = state((50.0, -70.0, -120.0), yaw, roll=0.0, wind=wind)
    target = into_wind(WindHold(1.2, True, -120.0), here)
    _, _, wish = guide(in_air_frame(here), target, VEHICLE, fresh_memory())
    assert abs(wrap(wish.azimuth - toward - math.pi)) < 1e-3
    turn = wrap(wish.azimuth - yaw)
    if 0.05 < abs(turn) < 2.5:
        assert math.copysign(1.0, wish.bank) == math.copysign(1.0, turn)


@pytest.mark.parametrize("height", [-30.0, 30.0])
def test_the_height_is_held_while_the_aircraft_is_blown_backwards(height):
    here = state((0.0, 0.0, -120.0 - height), 0.0, roll=0.0, wind=(-40.0, 0.0, 0.0))
    target = into_wind(WindHold(1.6, True, -120.0), here)
    memory = fresh_memory()
    for k in range(50):
        each = in_air_frame(here._replace(time=1.0 + 0.02 * k))
        _, memory, wish = guide(each, target, VEHICLE, memory)
    assert wish.gamma * height < 0.0  # down from above, up from below
