import math

import numpy as np
import pytest
from aeroplanes import AEROSONDE, EASYSTAR
from flight_states import motion
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from vfguide.aircraft.performance import Gains
from vfguide.aircraft.point_mass import advance, dynamics, lagged
from vfguide.geometry.units import G0

pytestmark = pytest.mark.slow

FLOWN = dynamics(AEROSONDE, Gains(25.0))
SMALL = dynamics(EASYSTAR, Gains(11.0))
STILL = (0.0, 0.0, 0.0)
angles = st.floats(-0.9, 0.9)


def by_integration(at, bank, gamma, wind_n, limits, dt):
    """North, east, down, azimuth, bank, path angle `dt` later, by SciPy."""

    def slope(_, x):
        error = np.clip((bank - x[4]) / limits.bank_lag, -limits.roll_rate, limits.roll_rate)
        flat = at.airspeed * math.cos(x[5])
        return (
            flat * math.cos(x[3]) + wind_n[0],
            flat * math.sin(x[3]) + wind_n[1],
            wind_n[2] - at.airspeed * math.sin(x[5]),
            G0 * math.tan(x[4]) / at.airspeed,
            error,
            (gamma - x[5]) / limits.path_lag,
        )

    start = (*at.p_n, at.azimuth, at.bank, at.gamma)
    return solve_ivp(slope, (0.0, dt), start, rtol=1e-10, atol=1e-10, max_step=0.01).y[:, -1]


@given(bank=angles, wanted=angles, dt=st.floats(1e-4, 0.05))
def test_a_step_back_undoes_a_step_where_the_roll_rate_is_limited(bank, wanted, dt):
    reach = FLOWN.roll_rate * FLOWN.bank_lag
    assume(abs(bank - wanted) > reach + FLOWN.roll_rate * dt)
    at = motion(azimuth=0.4, bank=bank, gamma=0.05)
    back = advance(advance(at, wanted, 0.05, STILL, FLOWN, dt), wanted, 0.05, STILL, FLOWN, -dt)
    assert back.bank == pytest.approx(bank, abs=1e-12)
    assert back.azimuth == pytest.approx(0.4, abs=1e-9)


@pytest.mark.parametrize("limits", [FLOWN, SMALL], ids=["aerosonde", "easystar"])
@given(bank=angles, wanted=angles, gamma=st.floats(-0.17, 0.17), climb=st.floats(-0.17, 0.17))
def test_a_second_of_steps_is_the_solution_of_the_equations(limits, bank, wanted, gamma, climb):
    at, wind_n = motion(azimuth=0.4, bank=bank, gamma=gamma), (3.0, -2.0, 0.5)
    expected = by_integration(at, wanted, climb, wind_n, limits, 1.0)
    after = at
    for _ in range(5):
        after = advance(after, wanted, climb, wind_n, limits, 0.2)
    assert (after.bank, after.gamma) == pytest.approx(expected[4:], abs=1e-7)
    assert after.azimuth == pytest.approx(expected[3], abs=2e-3)
    assert after.p_n == pytest.approx(expected[:3], abs=0.05)


@given(st.floats(-1.5, 1.5), st.floats(-1.5, 1.5), st.floats(0.0, 3.0), st.floats(0.0, 3.0))
def test_two_lags_are_one(value, wanted, first, second):
    once = lagged(value, wanted, 0.4, 1.1, first + second)
    twice = lagged(lagged(value, wanted, 0.4, 1.1, first), wanted, 0.4, 1.1, second)
    assert once == pytest.approx(twice, abs=1e-12)


@given(st.floats(-1.5, 1.5), st.floats(-1.5, 1.5), st.floats(0.0, 3.0))
def test_a_lag_never_overshoots_nor_exceeds_its_rate(value, wanted, dt):
    after = lagged(value, wanted, 0.4, 1.1, dt)
    assert min(value, wanted) - 1e-12 <= after <= max(value, wanted) + 1e-12
    assert abs(after - value) <= 1.1 * dt + 1e-12


def test_a_full_turn_ends_where_it_began():
    bank, limits = 0.8, FLOWN
    start = at = motion(bank=bank)
    steps = 100
    dt = 2.0 * math.pi * 25.0 / (G0 * math.tan(bank)) / steps
    for _ in range(steps):
        at = advance(at, bank, 0.0, STILL, limits, dt)
    assert at.p_n == pytest.approx(start.p_n, abs=1e-6)
    assert at.azimuth == pytest.approx(2.0 * math.pi)
