import math

import numpy as np
import pytest
from sim_flights import AEROSONDE, bench

from vfguide.geometry.units import DEG, G0
from vfguide.sim.bench import Bench
from vfguide.sim.condition import FlightCondition
from vfguide.sim.trim import TrimError, trim


@pytest.mark.parametrize(
    ("airspeed", "alpha_deg", "throttle"),
    [(18.0, 8.30, 0.59), (20.0, 6.25, 0.64), (25.0, 3.11, 0.78), (30.0, 1.40, 0.93)],
)
def test_level_flight_of_the_aerosonde(airspeed, alpha_deg, throttle):
    # Measured earlier on an independent model of the same numbers, at 150 m.
    condition = trim(Bench(AEROSONDE, 150.0), airspeed)
    assert condition.alpha / DEG == pytest.approx(alpha_deg, abs=0.02)
    assert condition.controls.throttle == pytest.approx(throttle, abs=0.005)


def test_trim_at_sea_level_by_hand():
    # Small angles: CL0 + CL_alpha alpha + CL_de de = C_W, Cm0 + Cm_alpha alpha + Cm_de de = 0,
    # and thrust carries T sin(alpha) of the weight: solved for alpha with T = 10.8 N.
    condition = trim(Bench(AEROSONDE), 25.0)
    pressure_area = 0.5 * 1.225 * 25.0**2 * 0.55
    weight = 11.0 * 9.806
    slope = 5.61 - 0.13 * 2.74 / 0.99
    zero = 0.23 + 0.13 * 0.0135 / 0.99
    alpha = (weight / pressure_area - zero) / (slope + 10.8 / pressure_area)
    assert condition.alpha == pytest.approx(alpha, abs=0.1 * DEG)
    elevator = (0.0135 - 2.74 * alpha) / 0.99
    assert condition.controls.elevator * 25.0 * DEG == pytest.approx(elevator, abs=0.3 * DEG)


@pytest.mark.parametrize("climb_deg", [-10.0, 0.0, 8.0, 13.0])
def test_a_trim_does_not_accelerate_and_climbs_as_asked(climb_deg):
    condition = trim(bench(), 25.0, climb_deg * DEG)
    found = bench().accelerations(condition)
    assert np.abs(found).max() < 1e-4
    assert condition.climb == climb_deg * DEG
    assert abs(condition.bank) < 0.2 * DEG


def test_thrust_is_drag_plus_the_weight_that_climbs():
    at_150_m = Bench(AEROSONDE, 150.0)
    level, climbing = (at_150_m.thrust(trim(at_150_m, 25.0, c * DEG)) for c in (0.0, 10.0))
    weight = at_150_m.mass * G0
    assert level / weight == pytest.approx(0.099, abs=0.001)
    assert climbing - level == pytest.approx(weight * math.sin(10.0 * DEG), rel=0.02)


@pytest.mark.parametrize(
    ("airspeed", "climb_deg"),
    [
        pytest.param(16.5, 0.0, id="below the speed where the elevator is at its stop"),
        pytest.param(33.5, 0.0, id="above full throttle"),
        pytest.param(25.0, 14.5, id="steeper than full throttle"),
        pytest.param(0.0, 0.0, id="hover"),
    ],
)
def test_flights_beyond_the_envelope_are_refused(airspeed, climb_deg):
    with pytest.raises(TrimError, match="aerosonde: no steady flight"):
        trim(bench(), airspeed, climb_deg * DEG)


def test_flights_just_inside_the_envelope_are_found():
    for airspeed, climb_deg in ((17.8, 0.0), (32.0, 0.0), (25.0, 12.5)):
        assert trim(bench(), airspeed, climb_deg * DEG).airspeed == airspeed


def test_equal_questions_have_identical_answers():
    assert trim(Bench(AEROSONDE), 22.0) == trim(Bench(AEROSONDE), 22.0)


@pytest.mark.parametrize("bank_deg", [-40.0, 0.0, 40.0])
def test_pitch_gives_the_path_its_climb(bank_deg):
    condition = FlightCondition(
        25.0, alpha=5.0 * DEG, beta=3.0 * DEG, bank=bank_deg * DEG, climb=7.0 * DEG
    )
    u, v, w = condition.v_air_b
    pitch, bank = condition.pitch, condition.bank
    down = -math.sin(pitch) * u + math.cos(pitch) * (math.sin(bank) * v + math.cos(bank) * w)
    assert -down / 25.0 == pytest.approx(math.sin(7.0 * DEG), abs=1e-12)
