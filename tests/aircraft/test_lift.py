"""Bank and load of a turn, and the attitude that carries them."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.aircraft.coordinated_turn import attitude_for_lift, lift_for_turn
from vfguide.geometry.units import DEG, G0

BANK_MAX, LOAD_MAX = 50.0 * DEG, 1.7
LATERAL = st.floats(-40.0, 40.0)
GAMMA = st.floats(-15.0 * DEG, 15.0 * DEG)


@given(LATERAL, GAMMA)
def test_limits_hold_and_the_weight_is_carried(lateral, gamma):
    lift = lift_for_turn(lateral, gamma, BANK_MAX, LOAD_MAX)
    assert abs(lift.bank) <= BANK_MAX + 1e-12
    assert lift.load <= LOAD_MAX + 1e-12
    assert lift.load * math.cos(lift.bank) == pytest.approx(math.cos(gamma))
    assert lift.bank * lateral >= 0.0


@given(st.floats(-10.0, 10.0))
def test_within_the_limits_the_turn_is_the_one_asked_for(lateral):
    lift = lift_for_turn(lateral, 0.0, BANK_MAX, LOAD_MAX)
    assert lift.load * G0 * math.sin(lift.bank) == pytest.approx(lateral, abs=1e-9)


@given(
    *(st.floats(-math.pi, math.pi), st.floats(-0.4, 0.4)),
    *(st.floats(-0.9, 0.9), st.floats(-0.1, 0.2)),
)
def test_the_body_is_banked_about_the_air_velocity_and_pitched_by_alpha(
    azimuth, elevation, bank, alpha
):
    R_nb = np.array(attitude_for_lift(azimuth, elevation, bank, alpha))
    level = math.cos(elevation)
    air = np.array([level * math.cos(azimuth), level * math.sin(azimuth), -math.sin(elevation)])
    x, y, z = R_nb.T @ air
    assert y == pytest.approx(0.0, abs=1e-12)  # no sideslip
    assert math.atan2(z, x) == pytest.approx(alpha, abs=1e-12)
    right_wing = R_nb[:, 1]
    assert right_wing[2] == pytest.approx(math.sin(bank) * level, abs=1e-12)
    assert np.linalg.det(R_nb) == pytest.approx(1.0)
