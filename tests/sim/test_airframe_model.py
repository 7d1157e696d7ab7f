import math
import shutil

import numpy as np
import pytest
from sim_flights import AEROSONDE, ALTITUDE, CESSNA, airframe, bench, steady, terms

from vfguide.geometry.units import DEG
from vfguide.sim.condition import FlightCondition, Model
from vfguide.sim.fdm import ModelError
from vfguide.sim.inner_loop.airframe_model import Airframe, AirframeModelError, identify, rate_table
from vfguide.sim.inner_loop.thrust_map import throttle_for
from vfguide.sim.signals import Controls
from vfguide.sim.trim import TrimError

AREA, SPAN, CHORD, STOP = 0.55, 2.8956, 0.18994, 25.0 * DEG
JX, JY, JZ, JXZ = 0.8244, 1.135, 1.759, 0.1204
INERTIA = np.array([[JX, 0.0, -JXZ], [0.0, JY, 0.0], [-JXZ, 0.0, JZ]])
LEVERS = np.array([SPAN, CHORD, SPAN])


def table_column(coefficients) -> np.ndarray:
    """Accelerations over rho V^2 of the moment coefficients Cl, Cm, Cn."""
    return np.linalg.solve(INERTIA, 0.5 * AREA * LEVERS * np.array(coefficients))


@pytest.mark.parametrize(
    ("angle", "coefficients"),
    [("alpha", (0.0, -2.74, 0.0)), ("beta", (-0.13, 0.0, 0.073))],
)
def test_static_terms_are_the_coefficients_of_the_book(angle, coefficients):
    found = getattr(terms(airframe().rates), angle)
    assert found == pytest.approx(table_column(coefficients), abs=3e-4)


@pytest.mark.parametrize(
    ("rate", "coefficients", "length"),
    [
        (0, (-0.51, 0.0, 0.069), SPAN),
        (1, (0.0, -38.21, 0.0), CHORD),
        (2, (0.25, 0.0, -0.095), SPAN),
    ],
)
def test_damping_terms_are_the_coefficients_of_the_book(rate, coefficients, length):
    expected = 0.5 * length * table_column(coefficients)
    assert terms(airframe().rates).damping[:, rate] == pytest.approx(expected, abs=2e-4)


def test_effect_of_the_surfaces_is_that_of_the_book():
    effect = STOP * np.column_stack(
        [
            table_column((0.17, 0.0, -0.011)),
            table_column((0.0, -0.99, 0.0)),
            table_column((0.0024, 0.0, -0.069)),
        ]
    )
    assert terms(airframe().rates).surface @ effect == pytest.approx(np.eye(3), abs=1e-3)


def test_gyroscopic_terms_are_the_gammas_of_the_book():
    # Beard and McLain (3.13): Gamma_1 to Gamma_8.
    gamma = JX * JZ - JXZ**2
    g1, g2 = JXZ * (JX - JY + JZ) / gamma, (JZ * (JZ - JY) + JXZ**2) / gamma
    g5, g6, g7 = (JZ - JX) / JY, JXZ / JY, ((JX - JY) * JX + JXZ**2) / gamma
    found = terms(airframe().rates)
    assert found.pq == pytest.approx([g1, 0.0, g7], abs=1e-3)
    assert found.pr == pytest.approx([0.0, g5, 0.0], abs=1e-3)
    assert found.qr == pytest.approx([-g2, 0.0, -g1], abs=1e-3)
    assert found.pp_rr == pytest.approx([0.0, -g6, 0.0], abs=1e-3)


def test_in_cruise_the_table_gives_no_acceleration():
    cruise, its = steady(), terms(airframe().rates)
    static = its.zero + its.alpha * cruise.alpha + its.beta * cruise.beta
    effect = np.linalg.inv(its.surface)
    assert static + effect @ cruise.controls[:3] == pytest.approx(np.zeros(3), abs=1e-7)


def assert_alike(table: np.ndarray, other: np.ndarray) -> None:
    """All but the accelerations at no angle and no rate are the same."""
    table, other = table.copy(), other.copy()
    terms(table).zero[:], terms(other).zero[:] = 0.0, 0.0
    assert table == pytest.approx(other, rel=1e-3, abs=1e-3)


@pytest.mark.parametrize("airspeed", [18.0, 32.0])
def test_the_table_is_the_same_at_other_airspeeds(airspeed):
    # The torque of the propeller, which is not the same, is in `zero`.
    other = rate_table(bench(), steady(airspeed))
    assert_alike(other, airframe().rates)
    assert terms(other).zero == pytest.approx(terms(airframe().rates).zero, abs=1e-3)


def test_the_table_is_the_same_in_thin_air():
    high = identify(AEROSONDE, 25.0, 3000.0)
    assert_alike(high.rates, airframe().rates)


def test_full_thrust_is_a_third_of_the_weight():
    low = identify(AEROSONDE, 25.0, 150.0)
    assert low.thrust.full_thrust == pytest.approx(36.2, abs=0.2)
    assert low.cruise_thrust == pytest.approx(0.295, abs=0.003)


@pytest.mark.parametrize("altitude", [ALTITUDE - 500.0, ALTITUDE, ALTITUDE + 500.0])
@pytest.mark.parametrize("airspeed", [18.0, 21.3, 25.0, 28.9, 32.0])
@pytest.mark.parametrize("setpoint", [0.0, 0.1, 0.33, 0.6])
def test_the_throttle_for_a_thrust_gives_that_thrust(setpoint, airspeed, altitude):
    thrust, air = airframe().thrust, bench(altitude)
    throttle = throttle_for(thrust.throttles, thrust.axes, setpoint, airspeed)
    found = air.thrust(FlightCondition(airspeed, 0.05, controls=Controls(throttle=throttle)))
    wanted = setpoint * thrust.full_thrust * air.density / bench().density
    tolerance = 0.1 if altitude == ALTITUDE else 0.3
    assert throttle == 1.0 or found == pytest.approx(wanted, abs=tolerance)


def throttles(airspeed: float) -> list[float]:
    thrust = airframe().thrust
    setpoints = np.linspace(-0.5, 1.5, 81)
    return [throttle_for(thrust.throttles, thrust.axes, float(s), airspeed) for s in setpoints]


@pytest.mark.parametrize("airspeed", [0.0, 9.0, 15.0, 25.0, 33.0, 60.0])
def test_throttle_rises_with_thrust_and_stays_between_0_and_1(airspeed):
    found = throttles(airspeed)
    assert min(found) >= 0.0
    assert max(found) <= 1.0
    assert found == sorted(found)


def test_setpoints_beyond_0_and_1_are_those():
    found = throttles(25.0)
    assert set(found[:21]) == {found[20]}
    assert set(found[60:]) == {found[60]}
    assert found[20] < 0.7 < found[40] < 0.9 < found[60]


def pitch_damping(its: Airframe) -> float:
    return terms(its.rates).damping[1, 1]


def test_a_model_is_measured_once_and_again_when_its_file_changes(tmp_path):
    shutil.copytree(AEROSONDE.folder, tmp_path / "aerosonde")
    model = Model(tmp_path, "aerosonde")
    first = identify(model, 25.0)
    assert identify(model, 25.0) is first
    assert identify(model, 24.0) is not first
    model.file.write_text(model.file.read_text().replace("> -38.21 <", "> -30 <"))
    assert abs(pitch_damping(identify(model, 25.0))) < 0.8 * abs(pitch_damping(first))


def test_equal_models_are_measured_identically(tmp_path):
    shutil.copytree(AEROSONDE.folder, tmp_path / "aerosonde")
    again = identify(Model(tmp_path, "aerosonde"), 25.0, ALTITUDE)
    assert again.cruise == airframe().cruise
    assert again.cruise_thrust == airframe().cruise_thrust
    assert (again.rates == airframe().rates).all()
    assert (again.thrust.throttles == airframe().thrust.throttles).all()


def test_a_model_without_a_rudder_is_refused(tmp_path):
    shutil.copytree(AEROSONDE.folder, tmp_path / "aerosonde")
    model = Model(tmp_path, "aerosonde")
    text = model.file.read_text().replace("> fcs/rudder-cmd-norm <", "> fcs/flap-cmd-norm <")
    model.file.write_text(text)
    # The trim needs no rudder if nothing yaws: a motor without torque.
    model.file.write_text(text.replace("-0.737562149", "0"))
    with pytest.raises(AirframeModelError, match="aerosonde"):
        identify(model, 25.0)


def test_what_cannot_fly_is_refused(tmp_path):
    with pytest.raises(TrimError):
        identify(AEROSONDE, 40.0)
    with pytest.raises(ModelError):
        identify(Model(tmp_path, "aerosonde"), 25.0)


def test_a_stock_model_needs_no_coefficients_of_ours():
    cessna = identify(CESSNA, 55.0, 1000.0)
    assert 0.0 < cessna.cruise.controls.throttle < 1.0
    assert np.isfinite(cessna.rates).all()
    assert math.isfinite(cessna.cruise_thrust)
    its = terms(cessna.rates)
    assert its.alpha[1] < 0.0
    assert its.beta[2] > 0.0
    assert (np.diag(its.damping) < 0.0).all()
