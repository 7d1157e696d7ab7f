"""Angle of attack and sideslip by roll, pitch and body rates, against a body that flies."""

import math

import pytest
from aeroplanes import AEROSONDE
from hypothesis import example, given
from hypothesis import strategies as st
from rate_body import SIDE_FORCE, advance, level

from vfguide.aircraft.flight_model import SIDE_FORCE_RATIO
from vfguide.estimation.flow_angles import (
    LARGEST_FLOW_ANGLE,
    LONGEST_FLOW_GAP,
    FlowAngles,
    follow_flow,
    fresh_flow,
)
from vfguide.geometry.so3 import from_euler, rot_z
from vfguide.geometry.units import DEG, G0
from vfguide.geometry.vector import matmul, matvec, transpose

SPEED = 25.0
DT = 0.04
OF_ITS_SIDE_FORCE = AEROSONDE._replace(alpha_load=SIDE_FORCE_RATIO * G0 * SPEED**2 / SIDE_FORCE)
anything = st.floats(-1e6, 1e6)
rates = st.tuples(*(st.floats(-limit, limit) for limit in (0.5, 0.15, 0.3)))


def truth(body):
    """Angle of attack and sideslip of a body [rad]."""
    u, v, w = matvec(transpose(body.R_nb), body.air_n)
    return math.atan2(w, u), math.asin(v / SPEED)


CLIMBING = [(0.0, 0.140625, 0.296875), (0.0, 0.140625, 0.296875), (0.0, 0.0, 0.0)]
"""Turns in a climb that slips: thrust along the path, not the nose, makes 9 degrees of 7."""


@example(CLIMBING, 0.0)
@given(st.lists(rates, min_size=1, max_size=4), st.floats(-math.pi, math.pi))
def test_the_angles_are_those_of_a_body_that_flies(turns, heading):
    """Rates that change every second, from level flight, with the side force of the model."""
    body, seen = level((0.0, 0.0, -100.0), heading, SPEED, OF_ITS_SIDE_FORCE), fresh_flow()
    for wanted in turns:
        for _ in range(25):
            for _ in range(4):
                body = advance(body, wanted, (0.0, 0.0, 0.0), OF_ITS_SIDE_FORCE, DT / 4)
            seen = follow_flow(seen, body.R_nb, body.omega_b, SPEED, OF_ITS_SIDE_FORCE, DT)
            bank = math.atan2(body.R_nb[2][1], body.R_nb[2][2])
            if abs(bank) > 60.0 * DEG or abs(truth(body)[1]) > 25.0 * DEG:
                return
    alpha, beta = truth(body)
    assert seen.alpha == pytest.approx(alpha, abs=1.5 * DEG)
    assert seen.beta == pytest.approx(beta, abs=2.0 * DEG)


@given(st.floats(-math.pi, math.pi), st.floats(-1.0, 1.0), st.floats(-0.5, 0.5), rates)
def test_the_yaw_does_not_matter(yaw, bank, pitch, omega_b):
    R_nb = from_euler(bank, pitch, 0.0)
    turned = matmul(rot_z(yaw), R_nb)
    seen = follow_flow(FlowAngles(0.1, 0.2), R_nb, omega_b, SPEED, AEROSONDE, DT)
    again = follow_flow(FlowAngles(0.1, 0.2), turned, omega_b, SPEED, AEROSONDE, DT)
    assert again == pytest.approx(seen, abs=1e-12)


@given(st.tuples(anything, anything, anything), anything, st.floats(-10.0, 1e9))
def test_whatever_is_told_they_are_bounded(omega_b, airspeed, elapsed):
    seen = follow_flow(
        FlowAngles(0.1, 0.2), from_euler(0.7, 0.1, 2.0), omega_b, airspeed, AEROSONDE, elapsed
    )
    assert max(map(abs, seen)) <= LARGEST_FLOW_ANGLE


@given(st.floats(0.0, LONGEST_FLOW_GAP), rates)
def test_a_gap_is_as_many_steps(gap, omega_b):
    """One measurement after a gap is as good as many with the same rates."""
    R_nb, once, often = from_euler(0.3, 0.05, 0.0), FlowAngles(0.05, 0.1), FlowAngles(0.05, 0.1)
    once = follow_flow(once, R_nb, omega_b, SPEED, AEROSONDE, gap)
    for _ in range(40):
        often = follow_flow(often, R_nb, omega_b, SPEED, AEROSONDE, gap / 40)
    assert once == pytest.approx(often, abs=1.0 * DEG)


def test_a_coordinated_turn_does_not_slip():
    bank = 45.0 * DEG
    turn = G0 * math.tan(bank) / SPEED
    omega_b = (0.0, turn * math.sin(bank), turn * math.cos(bank))
    seen = fresh_flow()
    for _ in range(200):
        seen = follow_flow(seen, from_euler(bank, 0.0, 0.0), omega_b, SPEED, AEROSONDE, DT)
    load = 1.0 / math.cos(bank)
    assert seen.beta == pytest.approx(0.0, abs=1e-3)
    assert seen.alpha == pytest.approx(
        AEROSONDE.alpha_zero + AEROSONDE.alpha_load * load / SPEED**2, abs=1e-3
    )
