"""What goes out while no attitude is heard and the autopilot still follows."""

import math

import numpy as np
import pytest
from conversations import Conversation, flying, heartbeat, setpoints, state
from hypothesis import given, settings
from hypothesis import strategies as st
from rate_body import Body, advance, level, load_factor

from vfguide.aircraft.coordinated_turn import attitude_for_lift
from vfguide.autopilots.engagement import Phase
from vfguide.autopilots.px4 import Px4Mode
from vfguide.companion.setpoints import COAST_AFTER, true_cruise
from vfguide.control.coasting import coast
from vfguide.earth.atmosphere import DENSITY_0, isa_density
from vfguide.geometry.so3 import to_quaternion
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import ZERO
from vfguide.link.messages import VfrHud
from vfguide.telemetry.knowledge import Knowledge

OFFBOARD = Px4Mode.OFFBOARD


def silence(talk, seconds, mode=OFFBOARD):
    """The autopilot beats and says no state."""
    out = []
    for tick in range(round(seconds * 50)):
        talk.now += 20_000
        talk.boot_ms += 20
        if tick % 25 == 0:
            out += talk.hear(heartbeat(mode))
        out += talk.poll()
    return setpoints(out)


def test_one_setpoint_ends_the_roll_and_no_other_follows():
    talk = flying()
    assert not silence(talk, COAST_AFTER - 0.03)
    (coasting,) = silence(talk, 2.0)
    assert np.isfinite([coasting.body_roll_rate, coasting.body_pitch_rate]).all()


@pytest.mark.parametrize("engage", [True, False])
def test_the_autopilot_may_follow_before_it_is_heard_to(engage):
    """60 degrees of bank: the first heartbeat in the new mode was lost with the attitudes."""
    talk = Conversation(engage=engage)
    assert setpoints(talk.fly(0.9))
    assert talk.companion.phase in (Phase.ASKING, Phase.OFFERING)
    before = talk.companion.phase
    (coasting,) = silence(talk, 0.6, Px4Mode.HOLD)
    assert coasting.body_roll_rate == pytest.approx(0.0, abs=1.0)
    assert talk.companion.phase is before


def test_where_attitudes_come_again_they_are_flown_on_and_it_may_happen_again():
    talk = flying()
    for _ in range(3):
        assert len(silence(talk, 0.6)) == 1
        assert len(setpoints(talk.fly(1.0, OFFBOARD))) >= 45


def test_where_attitudes_come_on_and_nothing_else_the_bank_is_the_one_that_is_told():
    """It was turned on by the roll rate of the last setpoint, though it was known to be level."""
    talk = flying()
    out = []
    for tick in range(50):
        talk.now += 20_000
        talk.boot_ms += 20
        beat = [heartbeat(OFFBOARD)] if tick % 25 == 0 else []
        out += talk.hear(*beat, state(talk.boot_ms)[-1]) + talk.poll()
    coasting = setpoints(out)[-1]
    assert abs(setpoints(talk.said[:-60])[-1].body_roll_rate) > 1.0
    assert coasting.q == pytest.approx((1.0, 0.0, 0.0, 0.0), abs=1e-6)
    assert coasting.body_roll_rate == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("height", [0.0, 3000.0, 6000.0])
def test_the_turn_is_that_of_the_true_airspeed(height):
    plan = flying().companion.flight.plan
    hud = VfrHud(25.0, 25.0, 0, 0, height, 0.0)
    thinner = DENSITY_0 / isa_density(height)
    assert true_cruise(Knowledge(hud=hud), plan) ** 2 == pytest.approx(
        thinner * plan.tuned.airspeed**2
    )


def test_nothing_goes_out_to_an_autopilot_that_does_not_follow():
    talk = flying()
    talk.hear(heartbeat(Px4Mode.HOLD))
    assert not silence(talk, 1.0)


def test_nothing_goes_out_while_setpoints_are_only_offered():
    talk = flying()
    talk.fly(1.0, Px4Mode.HOLD)
    assert not silence(talk, 1.0)


@given(st.floats(-60.0, 60.0), st.floats(-60.0, 60.0), st.floats(0.6, 2.2), st.floats(12.0, 50.0))
@settings(max_examples=60)
def test_a_second_without_attitudes_leaves_the_envelope_of_no_aircraft(rate, bank, load, speed):
    """From any bank, roll rate and load that guidance flies: the turn goes on as it is by then."""
    aircraft = flying().companion.flight.plan.aircraft
    aircraft = aircraft._replace(alpha_load=aircraft.alpha_load * (speed / 25.0) ** 2)
    start = level((0.0, 0.0, -100.0), 0.0, speed, aircraft)
    alpha = aircraft.alpha_zero + aircraft.alpha_load * load / speed**2
    R_nb = attitude_for_lift(0.0, 0.0, math.copysign(bank, rate) * DEG, alpha)
    body = Body(0.0, start.p_n, start.air_n, R_nb, (rate * DEG, 0.0, 0.0))
    wanted_b, q_nb, steps = body.omega_b, to_quaternion(R_nb), 0
    while body.time < 1.2:
        if steps == 20:
            wanted_b, _ = coast(q_nb, wanted_b, body.time, speed, 50.0 * DEG)
        body, steps = advance(body, wanted_b, ZERO, aircraft, 0.01), steps + 1
        assert abs(math.atan2(body.R_nb[2][1], body.R_nb[2][2])) < (abs(bank) + 22.0) * DEG
        assert -0.3 < load_factor(body, aircraft) < 2.7
    assert body.p_n[2] - start.p_n[2] < 12.0


@pytest.mark.parametrize("bank", [-80.0, -30.0, 0.0, 30.0, 80.0])
def test_a_bank_beyond_the_largest_is_taken_back(bank):
    q_nb = to_quaternion(attitude_for_lift(0.0, 0.0, bank * DEG, 0.0))
    (p, q, _), _ = coast(q_nb, ZERO, 0.2, 25.0, 50.0 * DEG)
    assert q >= 0.0
    assert p == pytest.approx(0.0 if abs(bank) < 50.0 else -math.copysign(30.0 * DEG, bank))
