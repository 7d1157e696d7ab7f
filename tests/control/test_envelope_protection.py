"""Body rates that keep bank and load factor inside their limits."""

import math

import pytest
from aeroplanes import AEROSONDE
from hypothesis import given
from hypothesis import strategies as st

from vfguide.aircraft.coordinated_turn import attitude_for_lift
from vfguide.control.envelope_protection import (
    BANK_OVERSHOOT,
    BANK_TIME,
    GUST_LOAD_RATIO,
    LOAD_RESERVE,
    LOAD_TIME,
    MAX_LOAD_EXCESS,
    SIDESLIP_MAX,
    SIDESLIP_TIME,
    load_of,
    within_envelope,
)
from vfguide.estimation.flow_angles import FlowAngles, follow_flow
from vfguide.geometry.so3 import IDENTITY, from_euler
from vfguide.geometry.units import DEG, G0
from vfguide.geometry.vector import Mat3, Vec3

LEAST, MOST = AEROSONDE.load_min + LOAD_RESERVE, GUST_LOAD_RATIO * AEROSONDE.load_max
BANK = 0.87
SPEEDS = st.floats(18.0, 38.0)
BANKS = st.floats(-0.8, 0.8)


def within(
    omega: Vec3, R_nb: Mat3, load: float, speed: float, flow: FlowAngles | None = None
) -> Vec3:
    """The rates; without `flow`, attitude and rates show the same load and no sideslip."""
    flow = flow or straight(load, speed)
    return within_envelope(omega, R_nb, load, flow, speed, BANK, AEROSONDE)


def straight(load: float, speed: float) -> FlowAngles:
    """Flight with a load factor, without sideslip."""
    return FlowAngles(AEROSONDE.alpha_zero + AEROSONDE.alpha_load * load / speed**2, 0.0)


@given(st.floats(-1.0, 3.0), SPEEDS, BANKS, st.floats(-0.2, 0.2))
def test_the_attitude_for_a_lift_meets_the_air_with_that_load(load, speed, bank, gamma):
    alpha = AEROSONDE.alpha_zero + AEROSONDE.alpha_load * load / speed**2
    R_nb = attitude_for_lift(0.7, gamma, bank, alpha)
    c = math.cos(gamma)
    air = (speed * c * math.cos(0.7), speed * c * math.sin(0.7), -speed * math.sin(gamma))
    assert load_of(R_nb, air, speed, AEROSONDE) == pytest.approx(load, abs=1e-9)


@given(st.floats(-1.0, 0.95), st.floats(1.01, 5.0), SPEEDS)
def test_level_flight_is_free_whatever_the_limits(least, most, speed):
    limits = AEROSONDE._replace(load_min=least, load_max=most)
    level = (0.1, 0.0, 0.3)
    assert within_envelope(level, IDENTITY, 1.0, straight(1.0, speed), speed, BANK, limits) == level


@given(st.floats(LEAST, MOST), SPEEDS, BANKS)
def test_the_pitch_rate_of_a_load_inside_the_limits_is_free(load, speed, bank):
    R_nb = from_euler(bank, 0.05, 0.3)
    steady = (load - R_nb[2][2]) * G0 / speed
    p, q, _ = within((0.1, steady, 0.0), R_nb, load, speed)
    assert (p, q) == pytest.approx((0.1, steady), abs=1e-9)


@given(st.floats(0.01, MAX_LOAD_EXCESS), SPEEDS, BANKS)
def test_a_load_outside_is_taken_back(outside, speed, bank):
    """Beside the rate of the limit itself, the angle of attack changes by what is too much."""
    R_nb = from_euler(bank, 0.05, 0.3)
    back = outside * AEROSONDE.alpha_load / speed**2 / LOAD_TIME
    for limit, load, push in ((LEAST, LEAST - outside, -9.0), (MOST, MOST + outside, 9.0)):
        steady = (limit - R_nb[2][2]) * G0 / speed
        _, rate, _ = within((0.0, push, 0.0), R_nb, load, speed)
        assert rate - steady == pytest.approx(math.copysign(back, -push))


def test_a_tumble_asks_for_no_more_than_a_large_load():
    for load, push, most in (
        (-50.0, -9.0, LEAST - MAX_LOAD_EXCESS),
        (50.0, 9.0, MOST + MAX_LOAD_EXCESS),
    ):
        far = within((0.0, push, 0.0), IDENTITY, load, 25.0)
        assert far == within((0.0, push, 0.0), IDENTITY, most, 25.0)


@given(st.floats(1.2, math.pi))
def test_upside_down_nothing_pulls_toward_the_ground(bank):
    assert within((0.0, -9.0, 0.0), from_euler(bank, 0.0, 0.0), LEAST, 25.0)[1] == 0.0


@given(st.floats(-math.pi, math.pi), st.floats(-5.0, 5.0))
def test_the_bank_does_not_run_through_its_limit(bank, rate):
    limit = BANK + BANK_OVERSHOOT
    rolled = within((rate, 0.0, 0.0), from_euler(bank, 0.0, 0.0), 1.0, 25.0)[0]
    assert abs(bank + BANK_TIME * rolled) <= limit + 1e-9
    if abs(bank + BANK_TIME * rate) < limit - 1e-9:
        assert rolled == rate, "inside every rate is free"


@given(BANKS, st.floats(-30.0 * DEG, 30.0 * DEG), st.floats(-3.0, 3.0), SPEEDS)
def test_the_sideslip_does_not_run_through_its_limit(bank, beta, r, speed):
    R_nb, dt, alpha = from_euler(bank, 0.05, 0.3), 0.01, 0.05
    flow = FlowAngles(alpha, beta)
    omega = within((0.0, 0.0, r), R_nb, 1.0, speed, flow)
    after = follow_flow(flow, R_nb, omega, speed, AEROSONDE, dt).beta
    if abs(beta) > SIDESLIP_MAX:
        assert abs(after) < abs(beta), "it is taken back"
    assert (
        abs(beta + (after - beta) / dt * SIDESLIP_TIME) < max(SIDESLIP_MAX, abs(beta)) + 0.5 * DEG
    )


@given(st.floats(-BANK, BANK), SPEEDS)
def test_the_yaw_rate_of_a_coordinated_turn_is_free(bank, speed):
    turn = G0 * math.tan(bank) / speed
    omega = (0.0, turn * math.sin(bank), turn * math.cos(bank))
    load = 1.0 / math.cos(bank)
    assert within(omega, from_euler(bank, 0.0, 0.0), load, speed)[2] == omega[2]


@given(st.floats(-1.0, 4.0), st.floats(-1.0, 4.0), SPEEDS)
def test_the_load_by_the_rates_is_limited_too(told, load, speed):
    """Of the told load and that of attitude and rates, the one nearer to a limit counts."""
    R_nb, flow = from_euler(0.3, 0.05, 0.3), straight(load, speed)
    down, up = (within((0.0, push, 0.0), R_nb, told, speed, flow)[1] for push in (-9.0, 9.0))
    lowest = within((0.0, -9.0, 0.0), R_nb, min(told, load), speed)[1]
    highest = within((0.0, 9.0, 0.0), R_nb, max(told, load), speed)[1]
    if lowest <= highest:
        assert (down, up) == pytest.approx((lowest, highest))
    else:
        assert down == up == pytest.approx(0.5 * (lowest + highest)), "they contradict each other"
