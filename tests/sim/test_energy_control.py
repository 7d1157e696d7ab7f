"""Height and airspeed by total energy, flown by a point that gains and loses energy."""

import math

import pytest
from aeroplanes import AEROSONDE, EASYSTAR
from hypothesis import given
from hypothesis import strategies as st

from vfguide.geometry.units import DEG, G0
from vfguide.sim.autopilot.energy_control import (
    AIRSPEED_TIME,
    EnergyState,
    Longitudinal,
    fresh_energy,
    pitch_and_thrust,
)

DT = 0.02
PITCH_LAG = 0.5
"""Time constant with which the path follows the pitch [s]."""


def alpha(aircraft, airspeed: float) -> float:
    """Angle of attack of level flight [rad]."""
    return aircraft.alpha_zero + aircraft.alpha_load / airspeed**2


def at_once(aircraft, **changes):
    """Pitch and thrust of the first step in level flight at cruise, but for the changes."""
    level = Longitudinal(0.0, 0.0, aircraft.airspeed_cruise, 0.0, 0.0)
    pitch, thrust, _ = pitch_and_thrust(level._replace(**changes), fresh_energy(), aircraft, DT)
    return pitch, thrust


class Point:
    """An aeroplane whose path follows its pitch, whose speed its thrust, its drag and its path."""

    def __init__(self, aircraft, height: float, airspeed: float, share: float = 1.0):
        """`height` [m] above the one to hold; `share` is what the motor gives of its thrust."""
        self.aircraft, self.share = aircraft, share
        self.height, self.airspeed, self.gamma = height, airspeed, 0.0
        self.state = fresh_energy()

    def fly(self, seconds: float) -> list[tuple[float, float]]:
        """Heights and airspeeds."""
        aircraft, flown = self.aircraft, []
        for _ in range(round(seconds / DT)):
            now = Longitudinal(
                -self.height,
                aircraft.airspeed_cruise - self.airspeed,
                self.airspeed,
                math.sin(self.gamma),
                0.0,
            )
            pitch, thrust, self.state = pitch_and_thrust(now, self.state, aircraft, DT)
            path = pitch - alpha(aircraft, self.airspeed)
            self.gamma += DT / PITCH_LAG * (path - self.gamma)
            excess = self.share * thrust - aircraft.thrust_trim
            gain = excess / aircraft.thrust_per_climb - math.sin(self.gamma)
            self.airspeed += G0 * gain * DT
            self.height += self.airspeed * math.sin(self.gamma) * DT
            flown.append((self.height, self.airspeed))
        return flown


@pytest.mark.parametrize("aircraft", [AEROSONDE, EASYSTAR])
def test_level_flight_at_cruise_is_trim(aircraft):
    pitch, thrust = at_once(aircraft)
    assert pitch == pytest.approx(alpha(aircraft, aircraft.airspeed_cruise))
    assert thrust == aircraft.thrust_trim


def test_in_a_turn_the_wing_carries_more_and_the_thrust_pays_for_it():
    """sin(pitch) = sin(alpha) cos(bank) in a level turn without sideslip."""
    bank = 40.0 * DEG
    pitch, thrust = at_once(AEROSONDE, bank=bank)
    load = 1.0 / math.cos(bank)
    carried = AEROSONDE.alpha_zero + load * AEROSONDE.alpha_load / 25.0**2
    assert math.sin(pitch) == pytest.approx(math.sin(carried) * math.cos(bank), rel=0.01)
    paid = AEROSONDE.thrust_per_load * (load**2 - 1.0)
    assert thrust == pytest.approx(AEROSONDE.thrust_trim + paid)


def test_height_for_airspeed_leaves_the_total_energy_and_the_thrust():
    """A climb whose sine is the deceleration over g."""
    climb = 3.0 / (3.0 * 25.0)
    slower = -climb * G0 * AIRSPEED_TIME
    _, thrust = at_once(AEROSONDE, height_missing=3.0, airspeed_missing=slower)
    assert thrust == pytest.approx(AEROSONDE.thrust_trim, abs=1e-6)


def test_both_missing_ask_for_thrust_and_only_height_for_pitch():
    level = at_once(AEROSONDE)
    slow, low = at_once(AEROSONDE, airspeed_missing=1.0), at_once(AEROSONDE, height_missing=2.0)
    assert slow[1] > level[1]
    assert low[1] > level[1]
    assert slow[0] == pytest.approx(level[0])
    assert low[0] > level[0]


def test_what_thrust_cannot_give_the_airspeed_and_the_climb_do_without():
    weak = EnergyState(0.5, 0.0)  # 0.8 of the thrust is needed already
    now = Longitudinal(5.0, 3.0, 25.0, 0.0, 0.0)
    able, thrust, _ = pitch_and_thrust(now, fresh_energy(), AEROSONDE, DT)
    unable, full, _ = pitch_and_thrust(now, weak, AEROSONDE, DT)
    assert thrust < 1.0
    assert full == 1.0
    assert unable < able


def test_near_the_stall_the_nose_goes_down_and_does_not_answer_to_sinking():
    weak = EnergyState(0.5, 0.0)
    slow = Longitudinal(5.0, 7.0, 18.0, 0.0, 0.0)
    pitch, thrust, _ = pitch_and_thrust(slow, weak, AEROSONDE, DT)
    assert thrust == 1.0
    assert pitch < alpha(AEROSONDE, 18.0)
    sinking, _, after = pitch_and_thrust(slow._replace(climb=-0.3), weak, AEROSONDE, DT)
    assert sinking <= alpha(AEROSONDE, 18.0)
    assert after.pitch <= 0.0


@pytest.mark.parametrize("aircraft", [AEROSONDE, EASYSTAR])
@pytest.mark.parametrize("height", [-40.0, 0.0, 40.0])
@pytest.mark.parametrize("faster", [-0.2, 0.0, 0.25])
@pytest.mark.parametrize("share", [0.8, 1.0, 1.2])
def test_height_and_airspeed_come_back_whatever_the_motor_gives(aircraft, height, faster, share):
    cruise = aircraft.airspeed_cruise
    point = Point(aircraft, height, cruise * (1.0 + faster), share)
    flown = point.fly(60.0)
    assert min(speed for _, speed in flown) > aircraft.airspeed_min
    # A dive with the motor off ends in no more than this.
    assert max(speed for _, speed in flown) < 1.1 * aircraft.airspeed_max
    rest = point.fly(20.0)
    assert max(abs(h) for h, _ in rest) < 0.5
    assert max(abs(speed - cruise) for _, speed in rest) < 0.02 * cruise


def test_an_integral_rests_while_thrust_is_at_its_stop():
    low = Longitudinal(1e3, 20.0, 20.0, 0.0, 0.0)
    _, thrust, after = pitch_and_thrust(low, fresh_energy(), AEROSONDE, DT)
    assert thrust == 1.0
    assert after.thrust == 0.0


BOUNDED = st.floats(-1e5, 1e5)


@given(
    now=st.tuples(BOUNDED, BOUNDED, st.floats(0.0, 1e3), BOUNDED, st.floats(-3.2, 3.2)),
    state=st.tuples(st.floats(-0.5, 0.5), st.floats(-0.1, 0.1)),
    dt=st.floats(0.0, 0.1),
)
def test_pitch_and_thrust_are_always_sane(now, state, dt):
    pitch, thrust, after = pitch_and_thrust(Longitudinal(*now), EnergyState(*state), AEROSONDE, dt)
    assert abs(pitch) < 45.0 * DEG
    assert 0.0 <= thrust <= 1.0
    assert abs(after.thrust) <= 0.5
    assert abs(after.pitch) <= 0.1
