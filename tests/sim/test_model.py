"""The Aerosonde's XML in plain JSBSim, against the book's equations."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sim_flights import ALTITUDE, bench, plain_jsbsim

from vfguide.geometry.units import DEG, FT, G0, LBF
from vfguide.sim.condition import FlightCondition
from vfguide.sim.signals import Controls

MASS, AREA, SPAN, CHORD = 11.0, 0.55, 2.8956, 0.18994
INERTIA = np.array([[0.8244, 0.0, -0.1204], [0.0, 1.135, 0.0], [-0.1204, 0.0, 1.759]])
STOP = 25.0 * DEG


@pytest.fixture
def fdm():
    return plain_jsbsim("aerosonde", 25.0, 3.1 * DEG, 25.0 * math.tan(3.1 * DEG))


def test_plain_jsbsim_flies_the_model(fdm):
    for name in ("aileron", "elevator", "rudder", "throttle"):
        assert f"fcs/{name}-cmd-norm (RW)" in fdm.query_property_catalog("fcs/")
    fdm["fcs/throttle-cmd-norm"] = 0.78
    fdm["fcs/elevator-cmd-norm"] = -0.31
    for _ in range(400):
        assert fdm.run()
    assert fdm["simulation/sim-time-sec"] == pytest.approx(2.0)
    assert 20.0 < fdm["velocities/vt-fps"] * FT < 30.0
    assert abs(fdm["position/h-sl-ft"] * FT - ALTITUDE) < 15.0


@pytest.mark.parametrize("surface", ["aileron", "elevator", "rudder"])
def test_a_servo_lags_by_30_ms_and_stops_at_25_deg(fdm, surface):
    def after(command: float, seconds: float) -> float:
        fdm[f"fcs/{surface}-cmd-norm"] = command
        for _ in range(round(seconds / 0.005)):
            fdm.run()
        return fdm[f"fcs/{surface}-pos-rad"]

    # A step of 5 deg asks for less than 6 rad/s: a pure lag.
    assert after(0.2, 0.03) == pytest.approx(0.2 * STOP * (1.0 - math.exp(-1.0)), rel=0.07)
    assert after(0.0, 1.0) == pytest.approx(0.0, abs=1e-6)
    # A step of 25 deg asks for 14.5 rad/s: the limit holds at first.
    assert after(1.0, 0.02) == pytest.approx(6.0 * 0.02, rel=0.1)
    assert after(1.0, 1.0) == pytest.approx(STOP, rel=1e-6)
    assert after(-2.0, 1.0) == pytest.approx(-STOP, rel=1e-6)


def test_the_motor_spools_up_in_an_eighth_of_a_second(fdm):
    fdm["fcs/throttle-cmd-norm"] = 0.5
    for _ in range(200):
        fdm.run()
    before = fdm["propulsion/speed-rps"]
    fdm["fcs/throttle-cmd-norm"] = 0.6
    for _ in range(25):
        fdm.run()
    share = (fdm["propulsion/speed-rps"] - before) / (fdm["propulsion/steady-speed-rps"] - before)
    assert share == pytest.approx(1.0 - math.exp(-1.0), abs=0.04)


@pytest.mark.parametrize("command", [-0.5, 1.5])
def test_throttle_ends_at_0_and_1(fdm, command):
    def thrust(throttle: float) -> float:
        fdm["fcs/throttle-cmd-norm"] = throttle
        fdm.set_trim_status(True)
        fdm.suspend_integration()
        for _ in range(3):
            fdm.run()
        return fdm["propulsion/thrust-n"]

    assert thrust(command) == thrust(min(max(command, 0.0), 1.0))


def test_the_belly_stops_the_fall(fdm):
    fdm["fcs/elevator-cmd-norm"] = 1.0
    for _ in range(12_000):
        fdm.run()
    assert abs(fdm["position/h-agl-ft"] * FT) < 0.3
    assert abs(fdm["velocities/vt-fps"]) * FT < 1.0


def aerodynamics(condition: FlightCondition, density: float) -> np.ndarray:
    """Force [N] and moment [N m] in body axes; Beard and McLain, chapter 4."""
    alpha, beta, v = condition.alpha, condition.beta, condition.airspeed
    p, q, r = np.array(condition.omega_b) * np.array([SPAN, CHORD, SPAN]) / (2.0 * v)
    da, de, dr = STOP * np.array(condition.controls[:3])
    up, down = math.exp(-50.0 * (alpha - 0.47)), math.exp(50.0 * (alpha + 0.47))
    blend = (1.0 + up + down) / ((1.0 + up) * (1.0 + down))
    attached = 0.23 + 5.61 * alpha
    plate = 2.0 * math.copysign(1.0, alpha) * math.sin(alpha) ** 2 * math.cos(alpha)
    lift = (1.0 - blend) * attached + blend * plate + 7.95 * q + 0.13 * de
    drag = 0.043 + attached**2 / (math.pi * 0.9 * SPAN**2 / AREA) + 0.0135 * abs(de)
    c, s = math.cos(alpha), math.sin(alpha)
    coefficients = [
        -drag * c + lift * s,
        -0.98 * beta + 0.075 * da + 0.19 * dr,
        -drag * s - lift * c,
        SPAN * (-0.13 * beta - 0.51 * p + 0.25 * r + 0.17 * da + 0.0024 * dr),
        CHORD * (0.0135 - 2.74 * alpha - 38.21 * q - 0.99 * de),
        SPAN * (0.073 * beta + 0.069 * p - 0.095 * r - 0.011 * da - 0.069 * dr),
    ]
    return 0.5 * density * v**2 * AREA * np.array(coefficients)


def propeller(throttle: float, v: float, density: float) -> tuple[float, float]:
    """Thrust [N] and torque [N m] in steady state; section 4.3 of the supplement."""
    diameter, resistance, constant = 0.508, 0.042, 60.0 / (2.0 * math.pi * 145.0)

    def torque(omega: float) -> float:
        n = omega / (2.0 * math.pi)
        j = v / (n * diameter)
        return density * n**2 * diameter**5 * (0.00523 + 0.00497 * j - 0.01664 * j**2)

    def excess(omega: float) -> float:
        return constant * ((44.4 * throttle - constant * omega) / resistance - 1.5) - torque(omega)

    low, high = 1.0, 1000.0
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) > 0.0 else (low, middle)
    n = low / (2.0 * math.pi)
    j = v / (n * diameter)
    thrust = density * n**2 * diameter**4 * (0.09357 - 0.06044 * j - 0.1079 * j**2)
    return thrust, torque(low)


angles = st.floats(-0.5, 0.5)
rates = st.floats(-2.0, 2.0)
surfaces = st.floats(-1.0, 1.0)


@given(
    st.builds(
        FlightCondition,
        airspeed=st.floats(15.0, 35.0),
        alpha=angles,
        beta=angles,
        omega_b=st.tuples(rates, rates, rates),
        controls=st.builds(Controls, surfaces, surfaces, surfaces, st.floats(0.4, 1.0)),
    )
)
def test_forces_and_moments_are_those_of_the_book(condition):
    density = bench().density
    thrust, torque = propeller(condition.controls.throttle, condition.v_air_b[0], density)
    load = aerodynamics(condition, density) + np.array([thrust, 0.0, 0.0, -torque, 0.0, 0.0])
    omega, pitch = np.array(condition.omega_b), condition.pitch
    gravity = 9.805 * np.array([-math.sin(pitch), 0.0, math.cos(pitch)])
    v_dot = load[:3] / MASS + gravity - np.cross(omega, condition.v_air_b)
    omega_dot = np.linalg.solve(INERTIA, load[3:] - np.cross(omega, INERTIA @ omega))
    found = bench().accelerations(condition)
    assert found.v_dot_b == pytest.approx(v_dot, abs=0.02, rel=1e-3)
    assert found.omega_dot_b == pytest.approx(omega_dot, abs=0.02, rel=1e-3)


def test_weight_is_that_of_11_kg(fdm):
    assert fdm["inertia/weight-lbs"] * LBF == pytest.approx(MASS * G0, rel=1e-3)
