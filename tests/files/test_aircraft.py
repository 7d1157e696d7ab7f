"""Every shipped aircraft: its file says what its model does, and its autopilot flies it."""

import math
import shutil
from functools import cache

import numpy as np
import pytest
from sim_flights import ALTITUDE, EASYSTAR, MODELS, STEPS_PER_S, plain_jsbsim

from vfguide.files.aircraft_file import Aircraft, load_aircraft
from vfguide.files.data import find_aircraft
from vfguide.geometry.units import DEG, FT, G0
from vfguide.sim.bench import Bench
from vfguide.sim.condition import FlightCondition, Model, Start
from vfguide.sim.fdm import stock_root
from vfguide.sim.inner_loop.airframe_model import Airframe, identify
from vfguide.sim.inner_loop.inner_loop import inner_loop
from vfguide.sim.plant import STEP, Plant
from vfguide.sim.signals import Controls
from vfguide.sim.trim import TrimError, trim

pytestmark = pytest.mark.slow

HANDS_OFF = (0.0, 0.0, 0.0)
SEA_LEVEL = 0.0
GROUND = -1000.0


@cache
def file(name: str) -> Aircraft:
    return load_aircraft(find_aircraft(name))


@cache
def bench(name: str) -> Bench:
    return Bench(MODELS[name], SEA_LEVEL)


def airframe(name: str) -> Airframe:
    return identify(MODELS[name], file(name).airspeed.cruise_mps, SEA_LEVEL)


def flown(name: str, omega_b, seconds: float, thrust: float = 0.0) -> tuple[Plant, np.ndarray]:
    """The plant after a flight from the cruise, and of every step p, q, r and thrust [N]."""
    its, memory, rows = airframe(name), HANDS_OFF, []
    start = Start(0.8, 0.1, SEA_LEVEL, 0.0, its.cruise)
    plant = Plant(MODELS[name], start, ground_altitude=GROUND)
    for _ in range(round(seconds * STEPS_PER_S)):
        wanted = (*omega_b, its.cruise_thrust + thrust)
        controls, memory = inner_loop(its.tables, plant.inner(), wanted, memory, STEP)
        plant.advance(controls)
        rows.append((*plant.inner()[:3], plant.readings.thrust()))
    return plant, np.array(rows)


def time_to_63_percent(values: np.ndarray) -> float:
    return STEP * (float(np.argmax(values > 1.0 - math.exp(-1.0))) + 1.0)


@pytest.mark.parametrize("name", MODELS)
def test_it_flies_level_at_its_airspeeds_with_the_angle_of_attack_of_its_file(name):
    its, speeds = file(name).performance(), file(name).airspeed
    for airspeed in (speeds.min_mps, speeds.cruise_mps, speeds.max_mps):
        found = trim(bench(name), airspeed).alpha
        wanted = its.alpha_zero + its.alpha_load / airspeed**2
        most = 0.4 if airspeed == speeds.cruise_mps else 2.0
        assert wanted == pytest.approx(found, abs=most * DEG), airspeed


@pytest.mark.parametrize("name", MODELS)
def test_below_its_slowest_airspeed_there_is_soon_no_level_flight(name):
    with pytest.raises(TrimError):
        trim(bench(name), 0.92 * file(name).airspeed.min_mps)


@pytest.mark.parametrize("name", MODELS)
def test_its_steepest_paths_are_steady_flight(name):
    its = file(name)
    for climb_deg in (its.limits.climb_max_deg, -its.limits.descent_max_deg):
        steady = trim(bench(name), its.airspeed.cruise_mps, climb_deg * DEG)
        assert 0.0 < steady.controls.throttle < 1.0


@pytest.mark.parametrize("name", MODELS)
def test_the_thrust_of_its_file_is_that_of_its_model(name):
    its, full = file(name).thrust, airframe(name).thrust.full_thrust
    assert its.trim == pytest.approx(airframe(name).cruise_thrust, abs=0.01)
    assert its.per_climb == pytest.approx(bench(name).mass * G0 / full, rel=0.04)


@pytest.mark.parametrize("name", MODELS)
def test_the_responses_of_its_file_are_measured(name):
    its = file(name)
    rate = min(its.limits.roll_rate_max_dps, 60.0) * DEG
    _, rolled = flown(name, (rate, 0.0, 0.0), 0.5)
    assert time_to_63_percent(rolled[:, 0] / rate) == pytest.approx(its.response.roll_s, abs=0.026)
    _, pushed = flown(name, HANDS_OFF, 3.0, 0.1)
    share = (pushed[:, 3] - pushed[0, 3]) / (0.1 * airframe(name).thrust.full_thrust)
    assert time_to_63_percent(share) == pytest.approx(its.response.thrust_s, rel=0.25)


@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("axis", [0, 1, 2])
def test_its_rate_loop_follows_half_of_what_it_may_be_asked_for(name, axis):
    limits = file(name).limits
    most = (limits.roll_rate_max_dps, limits.pitch_rate_max_dps, limits.yaw_rate_max_dps)[axis]
    for rate in (0.5 * most * DEG, -0.5 * most * DEG):
        omega_b = tuple(rate if axis == i else 0.0 for i in range(3))
        _, rates = flown(name, omega_b, 0.6)
        share = rates[:, axis] / rate
        assert time_to_63_percent(share) < 0.2
        assert share.max() < 1.2
        assert share[60:] == pytest.approx(1.0, abs=0.2)


@pytest.mark.parametrize("name", MODELS)
def test_it_flies_hands_off_and_every_fresh_one_alike(name):
    (plant, rates), (_, again) = flown(name, HANDS_OFF, 10.0), flown(name, HANDS_OFF, 10.0)
    assert (rates == again).all()
    truth = plant.truth()
    assert truth.airspeed == pytest.approx(file(name).airspeed.cruise_mps, abs=0.5)
    assert truth.altitude == pytest.approx(SEA_LEVEL, abs=3.0)


@pytest.mark.parametrize(
    ("name", "airspeeds"),
    [
        ("c172p", (65.0, 45.0, 25.0, 45.0)),
        ("c182", (35.0, 45.0)),
        ("J3Cub", (40.0, 25.0)),
    ],
)
def test_a_trim_does_not_depend_on_what_was_asked_before(name, airspeeds):
    one = Bench(Model(stock_root(), name), ALTITUDE)
    for airspeed in airspeeds:
        found = trim(one, airspeed)
        fresh = trim(Bench(Model(stock_root(), name), ALTITUDE), airspeed)
        assert found.alpha == pytest.approx(fresh.alpha, abs=1e-4)
        assert found.controls == pytest.approx(fresh.controls, abs=1e-3)


def test_plain_jsbsim_flies_the_easystar():
    fdm = plain_jsbsim("easystar", 11.0, 1.2 * DEG)
    fdm["fcs/throttle-cmd-norm"] = 0.49
    for _ in range(400):
        assert fdm.run()
    assert 9.0 < fdm["velocities/vt-fps"] * FT < 13.0
    assert abs(fdm["position/h-sl-ft"] * FT - ALTITUDE) < 5.0
    fdm["fcs/throttle-cmd-norm"] = 0.0
    fdm["fcs/elevator-cmd-norm"] = 0.5
    for _ in range(30_000):
        assert fdm.run()
    assert abs(fdm["position/h-agl-ft"] * FT) < 0.2
    assert abs(fdm["velocities/vt-fps"]) * FT < 1.0


SPAN, AREA, CHORD = 1.366, 0.24, 0.171
TAIL, TAIL_SLOPE, ARM = 0.0414, 3.84, 0.52
VOLUME = TAIL * ARM / (AREA * CHORD)
ASPECT = SPAN**2 / AREA
WING_SLOPE = 2.0 * math.pi * ASPECT / (2.0 + math.sqrt(ASPECT**2 + 4.0))
DOWNWASH = 2.0 * WING_SLOPE / (math.pi * ASPECT)
SLOPE = WING_SLOPE + 0.9 * TAIL_SLOPE * TAIL / AREA * (1.0 - DOWNWASH)
NEUTRAL = 0.25 + 0.9 * TAIL_SLOPE * VOLUME * (1.0 - DOWNWASH) / SLOPE
"""The EasyStar's geometry and what the handbook makes of it."""


def coefficients(**changes) -> np.ndarray:
    """Force across the air and moments of the EasyStar, as CL, Cl, Cm, Cn, at 11 m/s."""
    its, air = bench("easystar"), 11.0
    condition = FlightCondition(
        air, **{"alpha": 0.02, "controls": Controls(throttle=0.4), **changes}
    )
    found = its.accelerations(condition)
    pressure = 0.5 * its.density * air**2 * AREA
    omega = np.array(condition.omega_b)
    force = its.mass * (found.v_dot_b + np.cross(omega, condition.v_air_b))
    force -= (
        its.mass * 9.805 * np.array([-math.sin(condition.pitch), 0.0, math.cos(condition.pitch)])
    )
    inertia = np.array(its.inertia)
    moment = inertia @ found.omega_dot_b + np.cross(omega, inertia @ omega)
    lift = force[0] * math.sin(condition.alpha) - force[2] * math.cos(condition.alpha)
    return np.array([lift, *moment / (SPAN, CHORD, SPAN)]) / pressure


def slope(step: float, **changes) -> np.ndarray:
    return (coefficients(**changes) - coefficients()) / step


def test_the_easystar_has_the_derivatives_of_its_geometry():
    lift, _, pitch, _ = slope(0.02, alpha=0.04)
    assert lift == pytest.approx(SLOPE, rel=0.03)
    assert pitch == pytest.approx(-SLOPE * (NEUTRAL - 0.35), rel=0.06)
    q = 0.5
    lift, _, pitch, _ = slope(q * CHORD / 22.0, omega_b=(0.0, q, 0.0))
    assert lift == pytest.approx(1.8 * TAIL_SLOPE * VOLUME, rel=0.03)
    assert pitch == pytest.approx(-1.8 * TAIL_SLOPE * VOLUME * ARM / CHORD, rel=0.03)
    _, roll, _, _ = slope(0.5 * SPAN / 22.0, omega_b=(0.5, 0.0, 0.0))
    assert roll == pytest.approx(-0.50, rel=0.02)
    full = 25.0 * DEG
    moved = Controls(elevator=0.2, throttle=0.4)
    _, _, pitch, _ = slope(0.2 * full, controls=moved)
    assert pitch == pytest.approx(-0.9 * TAIL_SLOPE * 0.58 * VOLUME, rel=0.03)
    _, _, _, yaw = slope(0.05, beta=0.05)
    fin = 2.9 * 0.9 * 0.0149 / AREA * ARM / SPAN
    assert yaw == pytest.approx(fin - 0.015, rel=0.05)


def test_thrust_above_the_centre_of_gravity_lowers_the_nose():
    more = coefficients(controls=Controls(throttle=0.8)) - coefficients()
    thrust = bench("easystar").thrust(FlightCondition(11.0, 0.02, controls=Controls(throttle=0.8)))
    thrust -= bench("easystar").thrust(FlightCondition(11.0, 0.02, controls=Controls(throttle=0.4)))
    pressure = 0.5 * bench("easystar").density * 11.0**2 * AREA
    assert more[2] == pytest.approx(-0.04 * thrust / (CHORD * pressure), rel=0.02)


def test_an_aircraft_in_another_folder_is_the_same(tmp_path):
    shutil.copytree(EASYSTAR.folder, tmp_path / "easystar")
    again = identify(Model(tmp_path, "easystar"), 11.0, SEA_LEVEL)
    assert (again.rates == airframe("easystar").rates).all()
