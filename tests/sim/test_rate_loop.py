from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sim_flights import (
    CESSNA,
    STEPS_PER_S,
    airborne,
    airframe,
    bench,
    fly,
    steady,
    terms,
    thrust_in,
)

from vfguide.geometry.units import DEG
from vfguide.sim.condition import Start, Weather
from vfguide.sim.inner_loop.airframe_model import identify
from vfguide.sim.inner_loop.inner_loop import inner_loop
from vfguide.sim.inner_loop.rate_loop import INTEGRAL_MAX, rate_loop
from vfguide.sim.inner_loop.thrust_map import throttle_for
from vfguide.sim.plant import STEP, Plant
from vfguide.sim.signals import Controls, Inner
from vfguide.sim.turbulence import Turbulence

CRUISE_AIR = Inner(0.0, 0.0, 0.0, 0.055, 0.0, airspeed=25.0, density=1.15)
FRESH = (0.0, 0.0, 0.0)


def unit_setpoint(axis: int, rate: float) -> tuple[float, float, float]:
    return (rate if axis == 0 else 0.0, rate if axis == 1 else 0.0, rate if axis == 2 else 0.0)


def step_response(axis: int, rate: float, airspeed: float) -> np.ndarray:
    """Body rates of a second after a step, as shares of it; (201, 3)."""
    thrust = thrust_in(steady(airspeed))
    truths = fly(airborne(airspeed), unit_setpoint(axis, rate), 1.0, thrust)
    return np.array([t.omega_b for t in truths]) / rate


def rise_time(response: np.ndarray) -> float:
    """From 10 to 90 % [s]."""
    return STEP * float(np.argmax(response > 0.9) - np.argmax(response > 0.1))


@pytest.mark.parametrize("airspeed", [18.0, 25.0, 32.0])
@pytest.mark.parametrize(
    ("axis", "rate_dps", "rise", "overshoot"),
    [
        pytest.param(0, 60.0, 0.065, 0.06, id="p"),
        pytest.param(0, -60.0, 0.065, 0.06, id="-p"),
        pytest.param(1, -10.0, 0.115, 0.10, id="-q"),
        pytest.param(2, 8.0, 0.20, 0.10, id="r"),
        pytest.param(2, -8.0, 0.20, 0.10, id="-r"),
    ],
)
def test_steps_are_followed_at_every_airspeed(axis, rate_dps, rise, overshoot, airspeed):
    response = step_response(axis, rate_dps * DEG, airspeed)[:, axis]
    assert rise_time(response) == pytest.approx(rise, abs=0.025)
    assert response.max() < 1.0 + overshoot + 0.01
    assert response[60:120] == pytest.approx(1.0, abs=0.12)


@pytest.mark.parametrize("airspeed", [25.0, 32.0])
def test_pitch_up_is_followed_where_the_elevator_suffices(airspeed):
    response = step_response(1, 15.0 * DEG, airspeed)[:, 1]
    assert rise_time(response) == pytest.approx(0.115, abs=0.015)
    assert response.max() < 1.10


@pytest.mark.parametrize(("axis", "rate_dps"), [(0, 60.0), (1, 15.0), (2, 8.0)])
def test_an_axis_leaves_the_others_alone(axis, rate_dps):
    response = step_response(axis, rate_dps * DEG, 25.0)[:100]
    others = np.delete(response, axis, axis=1)
    assert abs(others * rate_dps).max() < 1.6


def test_rates_follow_in_turbulence():
    weather = Weather((0.0, 8.0, 0.0), Turbulence.SEVERE, seed=3)
    truths = fly(airborne(weather=weather), FRESH, 30.0)
    rates = np.array([t.omega_b for t in truths])
    assert rates.std(axis=0) == pytest.approx(np.zeros(3), abs=14.0 * DEG)
    assert rates.mean(axis=0) == pytest.approx(np.zeros(3), abs=0.3 * DEG)
    assert max(abs(t.roll) for t in truths) < 25.0 * DEG


def test_a_demand_beyond_the_surfaces_does_no_harm():
    # A second of 600 deg/s of roll: the aileron stays at its stop, the integral waits.
    plant, memory, tables = airborne(30.0), FRESH, airframe().tables
    ailerons = []
    for _ in range(STEPS_PER_S):
        controls, memory = inner_loop(tables, plant.inner(), (10.0, 0.0, 0.0, 0.4), memory, STEP)
        plant.advance(controls)
        ailerons.append(controls[0])
    assert ailerons[20:] == pytest.approx([1.0] * (STEPS_PER_S - 20))
    assert abs(memory[0]) < 1.0
    rolls = []
    for _ in range(STEPS_PER_S // 2):
        controls, memory = inner_loop(tables, plant.inner(), (0.0, 0.0, 0.0, 0.4), memory, STEP)
        plant.advance(controls)
        rolls.append(plant.inner()[0])
    assert min(rolls) > -20.0 * DEG
    assert abs(rolls[-1]) < 8.0 * DEG


def test_the_integral_waits_at_the_stop_and_comes_back_at_once():
    table = airframe().rates
    _, at_stop = rate_loop(table, CRUISE_AIR, (20.0, 0.0, 0.0), (1.0, 0.0, 0.0), STEP)
    assert at_stop[0] == 1.0
    turned = CRUISE_AIR._replace(p=19.9)
    surfaces, back = rate_loop(table, turned, (19.0, 0.0, 0.0), (1.0, 0.0, 0.0), STEP)
    assert surfaces[0] == 1.0
    assert back[0] < 1.0


def test_a_wrong_airframe_costs_no_steady_rate():
    # Damping half as large and a trim that is off: the integrals make up for it.
    table = airframe().rates.copy()
    wrong = terms(table)
    wrong.damping[:, 0] *= 0.5
    wrong.zero[:] += (0.001, 0.003, 0.001)
    plant, memory, wanted = airborne(), FRESH, (0.1, 0.0, 0.05)
    throttle = steady().controls.throttle
    rates = []
    for _ in range(3 * STEPS_PER_S):
        surfaces, memory = rate_loop(table, Inner(*plant.inner()), wanted, memory, STEP)
        plant.advance((*surfaces, throttle))
        rates.append(plant.inner()[:3])
    assert np.mean(rates[-100:], axis=0) == pytest.approx(wanted, abs=0.5 * DEG)


def test_surfaces_are_those_that_the_table_asks_for():
    # Feed-forward alone: in cruise, without error, the surfaces are those of the trim.
    cruise = steady()
    inner = CRUISE_AIR._replace(alpha=cruise.alpha, density=bench().density)
    surfaces, memory = rate_loop(airframe().rates, inner, FRESH, FRESH, STEP)
    assert surfaces == pytest.approx(cruise.controls[:3], abs=1e-6)
    assert memory == FRESH


def test_an_error_asks_for_an_acceleration_that_the_surfaces_give():
    # Proportional gain 12, 9, 6 1/s: from the trim, an error of 0.05 rad/s asks for so much.
    cruise = steady()
    density = bench().density
    inner = Inner(-0.05, -0.05, -0.05, cruise.alpha, 0.0, airspeed=25.0, density=density)
    surfaces, _ = rate_loop(airframe().rates, inner, FRESH, FRESH, STEP)
    controls = Controls(*surfaces, throttle=cruise.controls.throttle)
    found = bench().accelerations(replace(cruise, controls=controls))
    assert found.omega_dot_b == pytest.approx([0.6, 0.45, 0.3], abs=0.02)


def test_gains_fall_as_dynamic_pressure_rises():
    def aileron_for_an_error(airspeed: float, density: float) -> float:
        table = airframe().rates
        inner = Inner(-0.1, 0.0, 0.0, 0.05, 0.0, airspeed, density)
        still = inner._replace(p=0.0)
        ((a, _, _), _) = rate_loop(table, inner, FRESH, FRESH, STEP)
        ((b, _, _), _) = rate_loop(table, still, FRESH, FRESH, STEP)
        return a - b

    reference = aileron_for_an_error(20.0, 1.2)
    assert aileron_for_an_error(40.0, 1.2) == pytest.approx(reference / 4.0)
    assert aileron_for_an_error(20.0, 0.6) == pytest.approx(reference * 2.0)


reals = st.floats(-1e6, 1e6)


@given(
    st.tuples(*[reals] * 5, st.floats(0.0, 500.0), st.floats(0.01, 2.0)),
    st.tuples(reals, reals, reals, reals),
    st.tuples(*[st.floats(-INTEGRAL_MAX, INTEGRAL_MAX)] * 3),
)
def test_controls_and_memory_stay_in_their_limits(inner, setpoint, memory):
    controls, memory = inner_loop(airframe().tables, inner, setpoint, memory, STEP)
    assert all(-1.0 <= surface <= 1.0 for surface in controls[:3])
    assert 0.0 <= controls[3] <= 1.0
    assert all(abs(integral) <= INTEGRAL_MAX for integral in memory)


def test_the_loops_change_nothing_that_they_are_given():
    table = airframe().rates
    before = table.copy()
    arguments = (table, CRUISE_AIR, (0.1, 0.2, 0.3), (0.5, 0.5, 0.5), STEP)
    assert rate_loop(*arguments) == rate_loop(*arguments)
    assert (table == before).all()


def test_the_inner_loop_is_rate_loop_and_throttle():
    its, setpoint = airframe(), (0.2, 0.1, -0.1, 0.4)
    controls, memory = inner_loop(its.tables, (*CRUISE_AIR,), setpoint, FRESH, STEP)
    assert (controls[:3], memory) == rate_loop(its.rates, CRUISE_AIR, setpoint[:3], FRESH, STEP)
    assert controls[3] == throttle_for(its.thrust.throttles, its.thrust.axes, 0.4, 25.0)


def test_thrust_setpoints_move_the_aeroplane():
    # m V' = T - D: 0.2 of the full thrust more, less the lag of the motor.
    plant = airborne()
    first, *_, last = fly(plant, FRESH, 1.0, thrust_in(steady()) + 0.2)
    gained = 0.2 * airframe().thrust.full_thrust / 11.0 * (1.0 - 0.125)
    assert last.airspeed - first.airspeed == pytest.approx(gained, rel=0.15)


def test_a_stock_model_flies_hands_off_and_follows_steps():
    cessna = identify(CESSNA, 55.0, 1000.0)
    place = Start(0.8, 0.1, 1000.0, 0.0, cessna.cruise)
    for setpoint, seconds in ((FRESH, 10.0), ((20.0 * DEG, 0.0, 0.0), 1.0)):
        plant, memory = Plant(CESSNA, place), FRESH
        for _ in range(round(seconds * STEPS_PER_S)):
            wanted = (*setpoint, cessna.cruise_thrust)
            controls, memory = inner_loop(cessna.tables, plant.inner(), wanted, memory, STEP)
            plant.advance(controls)
        assert plant.inner()[:3] == pytest.approx(setpoint, abs=1.0 * DEG)
        assert plant.truth().altitude == pytest.approx(1000.0, abs=2.0)
