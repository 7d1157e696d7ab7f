"""Of the sideslip that is told only a little is asked back at once: a wrong wind looks like it."""

import math

import pytest
from flight_states import VEHICLE
from hypothesis import given
from hypothesis import strategies as st

from vfguide.aircraft.command import GuidanceCommand, unknown_rates
from vfguide.aircraft.coordinated_turn import attitude_for_lift
from vfguide.aircraft.state import FlightState
from vfguide.control import control
from vfguide.control.control import MOST_SIDESLIP_ASKED, fresh_control
from vfguide.estimation.estimation import known_state
from vfguide.geometry.units import DEG

SPEED = 25.0
angles = st.floats(-math.pi, math.pi)
banks = st.floats(-50.0 * DEG, 50.0 * DEG)


def rates(azimuth, sideslip, bank, asked):
    """Body rates for a bank, of a flight whose told air velocity has a sideslip [rad]."""
    aircraft = VEHICLE.aircraft
    load = 1.0 / math.cos(bank)
    alpha = aircraft.alpha_zero + aircraft.alpha_load * load / SPEED**2
    R_nb = attitude_for_lift(azimuth - sideslip, 0.0, bank, alpha)
    v_n = (SPEED * math.cos(azimuth), SPEED * math.sin(azimuth), 0.0)
    zero = (0.0, 0.0, 0.0)
    nav = known_state(FlightState(0.0, zero, v_n, R_nb, SPEED, zero), -1.0)
    load = 1.0 / math.cos(asked)
    command = GuidanceCommand(
        azimuth, azimuth, 0.0, 0.0, asked, load, 1e3, 0, 60.0, unknown_rates()
    )
    return control.update(nav, command, fresh_control(), VEHICLE)[0].omega_b


@given(angles, banks, banks, st.floats(0.15, math.pi - 0.15), st.sampled_from((-1.0, 1.0)))
def test_a_gross_sideslip_is_answered_like_a_small_one(azimuth, bank, asked, size, side):
    gross, small = (
        rates(azimuth, side * size, bank, asked),
        rates(azimuth, side * 0.12, bank, asked),
    )
    assert gross == pytest.approx(small, abs=1e-6)


@given(angles, st.floats(-0.9 * MOST_SIDESLIP_ASKED, 0.9 * MOST_SIDESLIP_ASKED))
def test_a_small_sideslip_is_taken_back_in_full(azimuth, sideslip):
    _, _, r = rates(azimuth, sideslip, 0.0, 0.0)
    assert r == pytest.approx(VEHICLE.gains.k_w * sideslip, rel=0.02, abs=1e-6)
