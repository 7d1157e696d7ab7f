import math
import shutil

import numpy as np
import pytest
from sim_flights import AEROSONDE, ALTITUDE, CESSNA, airframe, bench, steady

from vfguide.geometry.units import DEG
from vfguide.sim.condition import FlightCondition, Model
from vfguide.sim.fdm import ModelError
from vfguide.sim.identify import IdentifyError, identify, rate_table
from vfguide.sim.rate_loop import ALPHA, BETA, INVERSE, ONE, PP_RR, PQ, PR, QR, P, Q, R
from vfguide.sim.signals import Controls
from vfguide.sim.thrust_map import throttle_for
from vfguide.sim.trim import TrimError

AREA, SPAN, CHORD, STOP = 0.55, 2.8956, 0.18994, 25.0 * DEG
JX, JY, JZ, JXZ = 0.8244, 1.135, 1.759, 0.1204
INERTIA = np.array([[JX, 0.0, -JXZ], [0.0, JY, 0.0], [-JXZ, 0.0, JZ]])
LEVERS = np.array([SPAN, CHORD, SPAN])


def table_column(coefficients) -> np.ndarray:
    """Accelerations over rho V^2 of the moment coefficients Cl, Cm, Cn."""
    return np.linalg.solve(INERTIA, 0.5 * AREA * LEVERS * np.array(coefficients))


@pytest.mark.parametrize(
    ("column", "coefficients"),
    [(ALPHA, (0.0, -2.74, 0.0)), (BETA, (-0.13, 0.0, 0.073))],
)
def test_static_terms_are_the_coefficients_of_the_book(column, coefficients):
    assert airframe().rates[:, column] == pytest.approx(table_column(coefficients), abs=3e-4)


@pytest.mark.parametrize(
    ("column", "coefficients", "length"),
    [
        (P, (-0.51, 0.0, 0.069), SPAN),
        (Q, (0.0, -38.21, 0.0), CHORD),
        (R, (0.25, 0.0, -0.095), SPAN),
    ],
)
def test_damping_terms_are_the_coefficients_of_the_book(column, coefficients, length):
    expected = 0.5 * length * table_column(coefficients)
    assert airframe().rates[:, column] == pytest.approx(expected, abs=2e-4)


def test_effect_of_the_surfaces_is_that_of_the_book():
    effect = STOP * np.column_stack(
        [
            table_column((0.17, 0.0, -0.011)),
            table_column((0.0, -0.99, 0.0)),
            table_column((0.0024, 0.0, -0.069)),
        ]
    )
    assert airframe().rates[:, INVERSE:] @ effect == pytest.approx(np.eye(3), abs=1e-3)


def test_gyroscopic_terms_are_the_gammas_of_the_book():
    # Beard and McLain (3.13): Gamma_1 to Gamma_8.
    gamma = JX * JZ - JXZ**2
    g1, g2 = JXZ * (JX - JY + JZ) / gamma, (JZ * (JZ - JY) + JXZ**2) / gamma
    g5, g6, g7 = (JZ - JX) / JY, JXZ / JY, ((JX - JY) * JX + JXZ**2) / gamma
    expected = np.zeros((3, 4))
    expected[0, PQ - PQ], expected[0, QR - PQ] = g1, -g2
    expected[1, PR - PQ], expected[1, PP_RR - PQ] = g5, -g6
    expected[2, PQ - PQ], expected[2, QR - PQ] = g7, -g1
    assert airframe().rates[:, PQ:INVERSE] == pytest.approx(expected, abs=1e-3)


def test_in_cruise_the_table_gives_no_acceleration():
    cruise, table = steady(), airframe().rates
    static = table[:, ONE] + table[:, ALPHA] * cruise.alpha + table[:, BETA] * cruise.beta
    effect = np.linalg.inv(table[:, INVERSE:])
    assert static + effect @ cruise.controls[:3] == pytest.approx(np.zeros(3), abs=1e-7)


@pytest.mark.parametrize("airspeed", [18.0, 32.0])
def test_the_table_is_the_same_at_other_airspeeds(airspeed):
    # Terms without dimension; the torque of the propeller is in the first column.
    other = rate_table(bench(), steady(airspeed))
    assert other[:, ALPHA:] == pytest.approx(airframe().rates[:, ALPHA:], rel=1e-3, abs=1e-3)
    assert other[:, ONE] == pytest.approx(airframe().rates[:, ONE], abs=1e-3)


def test_the_table_is_the_same_in_thin_air():
    high = identify(AEROSONDE, 25.0, 3000.0)
    assert high.rates[:, ALPHA:] == pytest.approx(airframe().rates[:, ALPHA:], rel=1e-3, abs=1e-3)


def test_full_thrust_is_a_third_of_the_weight():
    low = identify(AEROSONDE, 25.0, 150.0)
    assert low.thrust.full_thrust == pytest.approx(36.2, abs=0.2)
    assert low.cruise_thrust == pytest.approx(0.295, abs=0.003)


@pytest.mark.parametrize("altitude", [ALTITUDE - 500.0, ALTITUDE, ALTITUDE + 500.0])
@pytest.mark.parametrize("airspeed", [18.0, 21.3, 25.0, 28.9, 32.0])
@pytest.mark.parametrize("setpoint", [0.0, 0.1, 0.33, 0.6])
def test_the_throttle_for_a_thrust_gives_that_thrust(setpoint, airspeed, altitude):
    thrust, air = airframe().thrust, bench(altitude)
    throttle = throttle_for(thrust.throttles, thrust.axes, setpoint, airspeed, air.density)
    found = air.thrust(FlightCondition(airspeed, 0.05, controls=Controls(throttle=throttle)))
    tolerance = 0.1 if altitude == ALTITUDE else 0.3
    assert throttle == 1.0 or found == pytest.approx(setpoint * thrust.full_thrust, abs=tolerance)


def throttles(airspeed: float, density: float = 1.15) -> list[float]:
    thrust = airframe().thrust
    setpoints = np.linspace(-0.5, 1.5, 81)
    return [
        throttle_for(thrust.throttles, thrust.axes, float(s), airspeed, density) for s in setpoints
    ]


@pytest.mark.parametrize("airspeed", [0.0, 9.0, 15.0, 25.0, 33.0, 60.0])
@pytest.mark.parametrize("density", [0.6, 1.15, 1.4])
def test_throttle_rises_with_thrust_and_stays_between_0_and_1(airspeed, density):
    found = throttles(airspeed, density)
    assert min(found) >= 0.0
    assert max(found) <= 1.0
    assert found == sorted(found)


def test_setpoints_beyond_0_and_1_are_those():
    found = throttles(25.0)
    assert set(found[:21]) == {found[20]}
    assert set(found[60:]) == {found[60]}
    assert found[20] < 0.7 < found[40] < 0.9 < found[60]


def test_a_model_is_measured_once_and_again_when_its_file_changes(tmp_path):
    shutil.copytree(AEROSONDE.folder, tmp_path / "aerosonde")
    model = Model(tmp_path, "aerosonde")
    first = identify(model, 25.0)
    assert identify(model, 25.0) is first
    assert identify(model, 24.0) is not first
    model.file.write_text(model.file.read_text().replace("> -38.21 <", "> -30 <"))
    assert abs(identify(model, 25.0).rates[1, Q]) < 0.8 * abs(first.rates[1, Q])


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
    with pytest.raises(IdentifyError, match="aerosonde"):
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
    assert cessna.rates[1, ALPHA] < 0.0
    assert cessna.rates[2, BETA] > 0.0
    assert (np.diag(cessna.rates[:, [P, Q, R]]) < 0.0).all()
