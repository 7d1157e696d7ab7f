"""Body rates for an attitude, against the attitude that they make."""

import math

import pytest
from aeroplanes import AEROSONDE
from hypothesis import given
from hypothesis import strategies as st

from vfguide.geometry.so3 import exp, from_euler, to_euler, to_quaternion
from vfguide.geometry.units import DEG, G0
from vfguide.geometry.vector import matmul, scale
from vfguide.link.enums import AttitudeTypeMask
from vfguide.link.messages import SetAttitudeTarget
from vfguide.sim.autopilot.attitude_control import (
    ATTITUDE_GAIN,
    demand_of,
    rates_for_attitude,
    within_limits,
)

BANKS = st.floats(-70.0 * DEG, 70.0 * DEG)
PITCHES = st.floats(-40.0 * DEG, 40.0 * DEG)
YAWS = st.floats(-3.0, 3.0)
SHORT = 1e-5
"""Half the time between the two attitudes of a difference [s]."""


def euler_rates(euler, omega_b):
    """Rates of roll, pitch and yaw under body rates, from two attitudes [rad/s]."""
    before, after = (
        to_euler(matmul(from_euler(*euler), exp(scale(time, omega_b)))) for time in (-SHORT, SHORT)
    )
    return [(b - a) / (2.0 * SHORT) for a, b in zip(before, after, strict=True)]


@given(roll=BANKS, pitch=PITCHES, phi=BANKS, theta=PITCHES, psi=YAWS)
def test_roll_and_pitch_decay_and_the_yaw_is_that_of_the_turn(roll, pitch, phi, theta, psi):
    euler = (phi, theta, psi)
    omega_b = rates_for_attitude(roll, pitch, euler, 25.0)
    turn = G0 * math.tan(phi) * math.cos(theta) / 25.0
    expected = [ATTITUDE_GAIN * (roll - phi), ATTITUDE_GAIN * (pitch - theta), turn]
    assert euler_rates(euler, omega_b) == pytest.approx(expected, abs=1e-6)


def test_a_level_turn_that_is_flown_already_asks_for_its_own_rates():
    """The heading turns at g tan(roll) / V."""
    p, q, r = rates_for_attitude(0.5, 0.0, (0.5, 0.0, 1.0), 25.0)
    turn = G0 * math.tan(0.5) / 25.0
    assert (p, q, r) == pytest.approx((0.0, turn * math.sin(0.5), turn * math.cos(0.5)))


def test_it_rolls_the_shorter_way():
    assert rates_for_attitude(3.0, 0.0, (-3.0, 0.0, 0.0), 25.0)[0] < 0.0
    assert rates_for_attitude(-3.0, 0.0, (3.0, 0.0, 0.0), 25.0)[0] > 0.0


@given(
    asked=st.tuples(st.floats(-4.0, 4.0), st.floats(-1.6, 1.6)),
    euler=st.tuples(st.floats(-3.2, 3.2), st.floats(-1.6, 1.6), YAWS),
    airspeed=st.floats(0.0, 100.0),
)
def test_rates_stay_in_their_limits_in_any_attitude(asked, euler, airspeed):
    omega_b = rates_for_attitude(*asked, euler, airspeed)
    p, q, r = within_limits(omega_b, euler, airspeed, AEROSONDE)
    most = AEROSONDE.rate_max
    assert abs(p) <= most[0]
    assert abs(r) <= most[2]
    assert abs(q) <= most[1]


@pytest.mark.parametrize("airspeed", [20.0, 25.0, 32.0])
@pytest.mark.parametrize("bank", [0.0, 40.0 * DEG])
def test_a_pull_and_a_push_stop_short_of_the_load_factors(airspeed, bank):
    euler = (bank, 0.0, 0.0)
    for pitch, limit in ((1.0, AEROSONDE.load_max), (-1.0, AEROSONDE.load_min)):
        omega_b = rates_for_attitude(bank, pitch, euler, airspeed)
        _, q, _ = within_limits(omega_b, euler, airspeed, AEROSONDE)
        assert math.cos(bank) + q * airspeed / G0 == pytest.approx(1.0 + 0.7 * (limit - 1.0))


RATES_IGNORED = (
    AttitudeTypeMask.BODY_ROLL_RATE_IGNORE,
    AttitudeTypeMask.BODY_PITCH_RATE_IGNORE,
    AttitudeTypeMask.BODY_YAW_RATE_IGNORE,
    AttitudeTypeMask.THROTTLE_IGNORE,
)


def setpoint(mask):
    banked = to_quaternion(from_euler(30.0 * DEG, 3.0 * DEG, 2.0))
    return SetAttitudeTarget(0, 1, 1, mask, banked, 0.1, 0.2, 0.3, 0.6)


@pytest.mark.parametrize("ignored", range(16))
def test_of_a_setpoint_of_rates_what_is_ignored_is_zero(ignored):
    flags = [flag for k, flag in enumerate(RATES_IGNORED) if ignored >> k & 1]
    said = setpoint(sum(flags, int(AttitudeTypeMask.ATTITUDE_IGNORE)))
    expected = [
        0.0 if flag in flags else value
        for flag, value in zip(RATES_IGNORED, (0.1, 0.2, 0.3, 0.6), strict=True)
    ]
    assert demand_of(said, (0.1, 0.0, 1.0), 25.0) == pytest.approx(expected)


@pytest.mark.parametrize(("mask", "thrust"), [(0, 0.6), (AttitudeTypeMask.THROTTLE_IGNORE, 0.0)])
def test_of_a_setpoint_of_attitude_roll_and_pitch_are_flown_and_no_yaw(mask, thrust):
    now = (0.1, 0.0, 1.0)
    rates = rates_for_attitude(30.0 * DEG, 3.0 * DEG, now, 25.0)
    assert demand_of(setpoint(mask), now, 25.0) == pytest.approx((*rates, thrust))
