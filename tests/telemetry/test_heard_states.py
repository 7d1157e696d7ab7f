"""The flight state in the plan's frame, from an autopilot whose own frame lies elsewhere."""

import math

import numpy as np
import pymap3d
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.earth.projection import project
from vfguide.estimation.local_frame import place_state
from vfguide.geometry.units import DEG, DEG_E7, MM
from vfguide.link.messages import (
    AttitudeQuaternion,
    GpsGlobalOrigin,
    LocalPositionNed,
    VfrHud,
    WindCov,
)
from vfguide.telemetry.knowledge import STALE, Knowledge, heard, observe

ORIGIN = (47.397742, 8.545594, 488.0)
PLANE = (ORIGIN[0] * DEG, ORIGIN[1] * DEG, ORIGIN[2])
TWO_CENTIMETRES = 0.02
"""The wire rounds the local origin to 1e-7 degrees."""


def told(lat, lon, alt, v_n=(20.0, 5.0, -1.0), origin=(47.41, 8.57, 600.0), time=(5000, 5000)):
    """What an autopilot says whose vehicle is at (lat, lon [deg], alt [m])."""
    north, east = project(origin[0] * DEG, origin[1] * DEG, lat * DEG, lon * DEG)
    at_position, at_attitude = time
    return [
        GpsGlobalOrigin(round(origin[0] * 1e7), round(origin[1] * 1e7), round(origin[2] / MM)),
        AttitudeQuaternion(at_attitude, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        LocalPositionNed(at_position, north, east, origin[2] - alt, *v_n),
        VfrHud(24.0, 25.0, 0, 50, alt, 0.0),
        WindCov(0, 3.0, -2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    ]


def known_from(messages):
    known = Knowledge()
    for message in messages:
        known = observe(known, message, 0)
    return known


def state_from(messages):
    return place_state(heard(known_from(messages)), PLANE)


@given(st.floats(47.35, 47.45), st.floats(8.48, 8.62), st.floats(500.0, 1500.0))
def test_the_position_is_right_wherever_the_autopilots_frame_begins(lat, lon, alt):
    state = state_from(told(lat, lon, alt))
    north, east, down = pymap3d.geodetic2ned(lat, lon, alt, *ORIGIN)
    assert state.p_n == pytest.approx((north, east, down), abs=TWO_CENTIMETRES)


def test_velocity_attitude_and_wind_turn_into_the_plans_frame():
    lat, lon = 47.44, 8.62
    state = state_from(told(lat, lon, 700.0))
    after = pymap3d.ned2geodetic(20.0, 5.0, -1.0, lat, lon, 700.0)
    moved = np.subtract(
        pymap3d.geodetic2ned(*after, *ORIGIN), pymap3d.geodetic2ned(lat, lon, 700.0, *ORIGIN)
    )
    assert state.v_n == pytest.approx(moved, abs=1e-6)
    nose = np.array(state.R_nb)[:, 0]
    assert nose == pytest.approx((1.0, 0.0, 0.0), abs=2e-3)
    assert abs(nose[1]) > 1e-4  # the meridians are not parallel
    assert math.hypot(*state.wind_n) == pytest.approx(math.hypot(3.0, 2.0))


def test_the_position_is_moved_on_to_the_time_of_the_attitude():
    before = state_from(told(47.4, 8.55, 600.0))
    after = state_from(told(47.4, 8.55, 600.0, time=(5000, 5100)))
    assert np.subtract(after.p_n, before.p_n) == pytest.approx(0.1 * np.array(before.v_n), abs=2e-3)


def test_the_airspeed_is_true():
    state = state_from(told(47.4, 8.55, 2000.0))
    assert state.airspeed == pytest.approx(24.0 * math.sqrt(1.225 / 1.0066), rel=1e-3)


@pytest.mark.parametrize("missing", range(4))
def test_without_any_part_there_is_no_state(missing):
    messages = told(47.4, 8.55, 600.0)
    del messages[missing]
    assert heard(known_from(messages)) is None


def test_a_wind_that_is_not_told_is_not_a_number():
    assert np.isnan(state_from(told(47.4, 8.55, 600.0)[:4]).wind_n).all()


@pytest.mark.parametrize("age", [-0.6, 0.6])
def test_an_old_position_is_not_flown_on(age):
    times = (5000, 5000 + round(1000 * age))
    assert abs(age) > STALE
    assert heard(known_from(told(47.4, 8.55, 600.0, time=times))) is None


def test_an_old_airspeed_is_not_flown_on():
    known = known_from(told(47.4, 8.55, 600.0))
    later = told(47.4, 8.55, 600.0, time=(5700, 5700))[1:3]
    for message in later:
        known = observe(known, message, 0)
    assert math.isnan(heard(known).calibrated)


def test_time_boot_ms_may_wrap_in_flight():
    known = known_from(told(47.4, 8.55, 600.0, time=(2**32 - 20, 20)))
    assert heard(known) is not None


def test_what_cannot_be_true_is_not_taken():
    known = known_from(told(47.4, 8.55, 600.0))
    for lie in (
        LocalPositionNed(5020, math.nan, 0.0, 0.0, 0.0, 0.0, 0.0),
        LocalPositionNed(5020, 0.0, 0.0, 0.0, 1e9, 0.0, 0.0),
        AttitudeQuaternion(5020, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        VfrHud(math.inf, 0.0, 0, 0, 600.0, 0.0),
        WindCov(0, math.nan, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    ):
        assert observe(known, lie, 0) == known


def test_the_wire_scales_are_those_of_mavlink():
    assert round(47.0 * DEG / DEG_E7) == 470_000_000


def test_a_state_is_told_ahead():
    known = known_from(told(47.4, 8.55, 600.0))
    now, then = place_state(heard(known), PLANE), place_state(heard(known, 0.2), PLANE)
    assert np.subtract(then.p_n, now.p_n) == pytest.approx(0.2 * np.array(now.v_n), abs=5e-3)
    assert (then.time, then.airspeed) == (now.time, now.airspeed)
