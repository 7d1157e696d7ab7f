import math
import subprocess
import sys

import numpy as np
import pytest
from sim_flights import (
    AEROSONDE,
    AIRCRAFT,
    ALTITUDE,
    CESSNA,
    GROUND,
    MODELS,
    airborne,
    airframe,
    fly,
    start,
    steady,
    thrust_in,
)

from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG
from vfguide.sim.bench import Bench
from vfguide.sim.condition import FlightCondition, Model, Start, Weather
from vfguide.sim.fdm import ModelError
from vfguide.sim.inner_loop.inner_loop import inner_loop
from vfguide.sim.plant import STEP, Plant
from vfguide.sim.signals import Controls, Inner
from vfguide.sim.trim import trim
from vfguide.sim.turbulence import GustyAir, Turbulence

pytestmark = pytest.mark.slow

CALM_RATES = (0.0, 0.0, 0.0)
EAST_WIND = Weather((0.0, -8.0, 0.0))
"""It comes from the east."""


def gusty(seed: int = 1, level: Turbulence = Turbulence.MODERATE) -> Weather:
    return Weather((3.0, 4.0, 0.0), level, seed)


def air_velocity(truth) -> np.ndarray:
    """Velocity through the air in NED, from attitude and air data."""
    a, b, v = truth.alpha, truth.beta, truth.airspeed
    v_b = v * np.array([math.cos(a) * math.cos(b), math.sin(b), math.sin(a) * math.cos(b)])
    return np.array(from_euler(truth.roll, truth.pitch, truth.yaw)) @ v_b


def copy_of_the_model(directory, change):
    text = AEROSONDE.file.read_text()
    changed = change(text)
    assert changed != text
    (directory / "broken").mkdir()
    (directory / "broken" / "broken.xml").write_text(changed)
    return Model(directory, "broken")


def test_a_flight_starts_where_it_was_asked_to():
    truth = airborne(yaw=200.0 * DEG).truth()
    assert truth.time == 0.0
    assert truth.latitude == pytest.approx(47.4 * DEG, abs=1e-12)
    assert truth.longitude == pytest.approx(8.5 * DEG, abs=1e-12)
    assert truth.altitude == pytest.approx(ALTITUDE, abs=1e-6)
    assert truth.yaw == pytest.approx(200.0 * DEG, abs=1e-12)
    assert truth.pitch == pytest.approx(steady().pitch, abs=1e-9)
    assert truth.airspeed == pytest.approx(25.0, abs=1e-9)
    assert truth.alpha == pytest.approx(steady().alpha, abs=1e-9)
    assert truth.density == pytest.approx(1.151, abs=0.002)
    # Level and without sideslip, the specific force is that against the weight.
    against_weight = (9.8 * math.sin(truth.pitch), 0.0, -9.8 * math.cos(truth.pitch))
    assert truth.force_b == pytest.approx(against_weight, abs=0.02)


@pytest.mark.parametrize("yaw_deg", [0.0, 90.0, 237.0])
@pytest.mark.parametrize("wind_n", [(0.0, 0.0, 0.0), (-7.0, 3.0, 0.0), (5.0, 6.0, -1.0)])
def test_a_flight_starts_in_equilibrium_with_the_air(yaw_deg, wind_n):
    plant = airborne(yaw=yaw_deg * DEG, weather=Weather(wind_n))
    assert np.ravel(plant.readings.accelerations()) == pytest.approx(np.zeros(6), abs=0.005)
    assert plant.truth().airspeed == pytest.approx(25.0, abs=1e-9)
    for _ in range(100):
        plant.advance(steady().controls)
    # What is left is Coriolis: the ground turns with the earth, and the wind with the ground.
    assert plant.inner()[:3] == pytest.approx(CALM_RATES, abs=3e-3)
    assert plant.truth().airspeed == pytest.approx(25.0, abs=0.01)


@pytest.mark.parametrize("airspeed", [18.0, 25.0, 32.0])
def test_hands_off_the_rate_loop_keeps_attitude_and_height(airspeed):
    # 20 s at zero rates with the thrust of the trim: the phugoid is not damped by rates, but
    # nothing excites it either.
    plant = airborne(airspeed)
    last = fly(plant, CALM_RATES, 20.0, thrust_in(steady(airspeed)))[-1]
    assert plant.time == pytest.approx(20.0)
    assert last.roll == pytest.approx(steady(airspeed).bank, abs=0.7 * DEG)
    assert last.pitch == pytest.approx(steady(airspeed).pitch, abs=0.2 * DEG)
    assert last.altitude == pytest.approx(ALTITUDE, abs=2.0)
    assert last.airspeed == pytest.approx(airspeed, abs=0.2)


def test_velocity_over_ground_is_that_through_the_air_plus_the_wind():
    for truth in fly(airborne(yaw=0.7, weather=gusty()), (0.3, 0.1, 0.1), 3.0):
        assert truth.v_n == pytest.approx(air_velocity(truth) + truth.wind_n, abs=1e-6)


def test_wind_from_the_east_drifts_a_northbound_aeroplane_to_the_west():
    truths = fly(airborne(weather=EAST_WIND), CALM_RATES, 10.0)
    assert truths[-1].wind_n == pytest.approx((0.0, -8.0, 0.0), abs=1e-6)
    assert math.atan2(truths[-1].v_n[1], truths[-1].v_n[0]) == pytest.approx(
        math.atan2(-8.0, 25.0), abs=0.5 * DEG
    )
    metres_west = (truths[0].longitude - truths[-1].longitude) * 6.38e6 * math.cos(47.4 * DEG)
    assert metres_west == pytest.approx(80.0, abs=1.0)


def test_position_is_the_integral_of_the_velocity():
    truths = fly(airborne(yaw=1.0), (0.0, 0.05, 0.05), 10.0)
    north, east, down = 0.005 * np.sum([t.v_n for t in truths[1:]], axis=0)
    a, e2 = 6378137.0, 0.00669437999014
    s2 = math.sin(47.4 * DEG) ** 2
    meridian = a * (1.0 - e2) / (1.0 - e2 * s2) ** 1.5 + ALTITUDE
    normal = a / math.sqrt(1.0 - e2 * s2) + ALTITUDE
    first, last = truths[0], truths[-1]
    assert (last.latitude - first.latitude) * meridian == pytest.approx(north, abs=0.1)
    way_east = (last.longitude - first.longitude) * normal * math.cos(47.4 * DEG)
    assert way_east == pytest.approx(east, abs=0.1)
    assert first.altitude - last.altitude == pytest.approx(down, abs=0.1)


def test_height_above_ground_is_altitude_above_the_level_ground():
    for truth in fly(airborne(), CALM_RATES, 20.0, every=400):
        assert truth.height_above_ground == pytest.approx(truth.altitude - GROUND, abs=1e-3)


def test_the_ground_stops_a_dive():
    plant = airborne()
    dive = FlightCondition(25.0, climb=-40.0 * DEG, controls=Controls(elevator=0.0))
    plant = Plant(AEROSONDE, start(dive), ground_altitude=ALTITUDE - 20.0)
    heights = []
    for _ in range(2000):
        plant.advance((0.0, 0.0, 0.0, 0.0))
        heights.append(plant.truth().height_above_ground)
    assert min(heights) > -2.0
    assert abs(heights[-1]) < 0.5


@pytest.mark.parametrize(
    ("controls", "moved", "sign"),
    [
        pytest.param(Controls(aileron=0.2), 0, 1.0, id="aileron rolls right"),
        pytest.param(Controls(elevator=0.2), 1, -1.0, id="elevator lowers the nose"),
        pytest.param(Controls(rudder=0.2), 2, -1.0, id="rudder yaws left"),
    ],
)
def test_what_a_positive_command_does(controls, moved, sign):
    plant, trimmed = airborne(), steady().controls
    for _ in range(20):
        plant.advance(tuple(a + b for a, b in zip(controls, trimmed, strict=True)))
    assert sign * plant.inner()[moved] > 1.0 * DEG


def test_body_rates_are_the_change_of_attitude():
    # p turns right wing down, q nose up, r nose right.
    for rates in ((0.2, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.1)):
        first, last = (fly(airborne(), rates, 1.0)[k] for k in (100, 120))
        turned = np.array([last.roll, last.pitch, last.yaw]) - [first.roll, first.pitch, first.yaw]
        turned = (turned + math.pi) % (2.0 * math.pi) - math.pi
        axis = rates.index(max(rates))
        assert turned[axis] == pytest.approx(0.1 * last.omega_b[axis], rel=0.1)
        assert last.omega_b[axis] == pytest.approx(max(rates), rel=0.15)


def test_inner_is_part_of_the_truth():
    plant = airborne(weather=gusty())
    fly(plant, CALM_RATES, 1.0)
    t = plant.truth()
    p, q, r = t.omega_b
    assert Inner(*plant.inner()) == Inner(
        p=p, q=q, r=r, alpha=t.alpha, beta=t.beta, airspeed=t.airspeed, density=t.density
    )


@pytest.mark.parametrize("ground", [0.0, GROUND, 3000.0])
@pytest.mark.parametrize("height", [150.0, 450.0])
def test_gusts_are_those_of_the_height_above_the_ground(ground, height):
    """Each step the air is the mean wind and the gust of the place into which it has flown."""
    place = Start(47.4 * DEG, 8.5 * DEG, ground + height, 0.4, steady())
    plant = Plant(AEROSONDE, place, gusty(7), ground)
    air, mean = GustyAir(Turbulence.MODERATE, 7), np.array([3.0, 4.0, 0.0])
    before = plant.truth()
    assert before.wind_n == pytest.approx(mean + air.gust_at(height), abs=1e-6)
    for after in fly(plant, (0.2, 0.05, 0.1), 2.0)[1:]:
        over_ground = before.altitude - ground
        v_air_n = tuple((before.v_n - mean).tolist())
        gust_n = air.fly(v_air_n, over_ground, STEP)
        assert after.wind_n == pytest.approx(mean + gust_n, abs=1e-5)
        before = after


@pytest.mark.parametrize(("name", "airspeed"), [("easystar", 10.5), ("c172p", 50.0)])
def test_gusts_are_the_same_for_every_aircraft(name, airspeed):
    model, mean = MODELS[name], np.array([3.0, 4.0, 0.0])
    condition = trim(Bench(model, ALTITUDE), airspeed)
    plant = Plant(model, start(condition), gusty(3, Turbulence.SEVERE), GROUND)
    air, before = GustyAir(Turbulence.SEVERE, 3), plant.truth()
    for _ in range(200):
        plant.advance(condition.controls)
        after = plant.truth()
        gust_n = air.fly(tuple((before.v_n - mean).tolist()), before.altitude - GROUND, STEP)
        assert after.wind_n == pytest.approx(mean + gust_n, abs=1e-5)
        before = after


def test_a_flight_starts_in_equilibrium_with_the_gusts():
    plant = airborne(yaw=2.0, weather=gusty(5, Turbulence.SEVERE))
    assert np.abs(plant.truth().wind_n - np.array([3.0, 4.0, 0.0])).max() > 0.5
    assert plant.truth().airspeed == pytest.approx(25.0, abs=1e-9)
    assert np.ravel(plant.readings.accelerations()) == pytest.approx(np.zeros(6), abs=0.005)


def test_calm_air_has_no_gusts():
    wind_n = [t.wind_n for t in fly(airborne(weather=Weather((3.0, 4.0, 0.0))), CALM_RATES, 1.0)]
    assert np.array(wind_n) == pytest.approx(np.tile((3.0, 4.0, 0.0), (201, 1)), abs=1e-12)


def test_equal_flights_are_bit_identical_whatever_else_is_flying():
    alone = fly(airborne(weather=gusty(7)), (0.2, 0.02, 0.0), 4.0)
    others = [airborne(weather=gusty(seed)) for seed in (7, 8)]
    for other in others:
        fly(other, (0.1, 0.0, 0.0), 1.0)
    plant, memory, among_others = airborne(weather=gusty(7)), (0.0, 0.0, 0.0), []
    for _ in range(800):
        among_others.append(plant.truth())
        setpoint = (0.2, 0.02, 0.0, 0.3)
        controls, memory = inner_loop(airframe().tables, plant.inner(), setpoint, memory, 0.005)
        plant.advance(controls)
        others[1].advance(controls)
    assert [*among_others, plant.truth()] == alone


def test_seeds_make_the_gusts():
    one, two, same = (fly(airborne(weather=gusty(seed)), CALM_RATES, 1.0) for seed in (1, 2, 1))
    assert one != two
    assert one == same
    large = fly(airborne(weather=gusty(2**63 + 5)), CALM_RATES, 1.0)
    assert large not in (one, two)


def test_two_steps_of_5_ms_are_about_one_of_10_ms():
    def roll_after_half_a_second(dt: float) -> float:
        plant = Plant(AEROSONDE, start(), dt=dt)
        for _ in range(round(0.5 / dt)):
            plant.advance((0.2, -0.31, 0.0, 0.78))
        assert plant.time == pytest.approx(0.5)
        return plant.truth().roll

    # Servo lags keep their time.
    assert roll_after_half_a_second(0.01) == pytest.approx(
        roll_after_half_a_second(0.0025), rel=0.05
    )


def test_nothing_reaches_the_terminal(capfd, tmp_path):
    plant = Plant(AEROSONDE, start(), ground_altitude=ALTITUDE - 5.0)
    for _ in range(1000):
        plant.advance((0.0, 1.0, 0.0, 0.0))
    with pytest.raises(ModelError):
        Plant(copy_of_the_model(tmp_path, lambda text: text[:6000]), start())
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("change", "complaint"),
    [
        pytest.param(lambda t: t[:6000], r"xml: line \d+ XML parse error", id="truncated"),
        pytest.param(lambda t: "", "no element found", id="empty"),
        pytest.param(lambda t: "hello", "syntax error", id="not XML"),
        pytest.param(
            lambda t: t.replace("<metrics>", "<metrix>").replace("</metrics>", "</metrix>"),
            "No metrics element",
            id="no metrics",
        ),
        pytest.param(lambda t: t.replace("5.61 <", "5,6l <"), "numeric", id="no number"),
        pytest.param(
            lambda t: t.replace("<abs>", "<nabs>").replace("</abs>", "</nabs>"),
            "Bad operation <nabs>",
            id="unknown function",
        ),
        pytest.param(
            lambda t: t.replace("fcs/aileron-pos-rad <", "fcs/aileron-rad <"),
            "fcs/aileron-rad does not exist",
            id="unknown property",
        ),
        pytest.param(
            lambda t: t.replace(" fcs/throttle-cmd-norm ", " fcs/lever "),
            "no property fcs/throttle-cmd-norm",
            id="no throttle",
        ),
        pytest.param(lambda t: t.replace(" 43.10293 ", " 0 "), "not finite", id="no number at all"),
    ],
)
def test_a_broken_model_is_named_with_its_fault(tmp_path, change, complaint):
    model = copy_of_the_model(tmp_path, change)
    with pytest.raises(ModelError, match=complaint) as caught:
        Plant(model, start())
    assert str(caught.value).startswith(str(model.file))
    assert "\n" not in str(caught.value)


def test_a_model_that_fails_in_flight_is_named(tmp_path):
    later = (
        "<ifthen> <gt> <property> simulation/sim-time-sec </property> <value> 0.1 </value> </gt>"
        "<property> no/such </property> <value> -0.98 </value> </ifthen>"
    )
    model = copy_of_the_model(tmp_path, lambda t: t.replace("<value> -0.98 </value>", later))
    plant = Plant(model, start())
    with pytest.raises(ModelError, match=r"broken\.xml: in flight: .*no/such"):
        fly(plant, CALM_RATES, 0.5)
    assert 0.05 < plant.time < 0.15


def test_a_missing_model_is_named(tmp_path):
    with pytest.raises(ModelError, match="nowhere: no such directory"):
        Plant(Model(tmp_path, "nowhere"), start())
    (tmp_path / "empty").mkdir()
    with pytest.raises(ModelError, match=r"empty\.xml: no such file"):
        Plant(Model(tmp_path, "empty"), start())


def test_an_unreadable_model_is_named(tmp_path):
    (tmp_path / "folder" / "folder.xml").mkdir(parents=True)
    with pytest.raises(ModelError, match=r"folder\.xml"):
        Plant(Model(tmp_path, "folder"), start())


def test_a_broken_model_does_not_end_the_process(tmp_path):
    # JSBSim's destructor calls std::terminate on such a model.
    copy_of_the_model(tmp_path, lambda t: t.replace("fcs/aileron-pos-rad <", "fcs/nothing <"))
    code = (
        "from pathlib import Path\n"
        "from vfguide.sim.condition import Model\n"
        "from vfguide.sim.fdm import ModelError, load\n"
        f"try: load(Model(Path({str(tmp_path)!r}), 'broken'), 0.005)\n"
        "except ModelError: print('refused')\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        check=False,
        text=True,
        cwd=AIRCRAFT.parent,
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "refused\n", "")


def test_engine_files_beside_the_model_are_found():
    condition = FlightCondition(55.0, alpha=0.01, controls=Controls(throttle=0.7))
    plant = Plant(CESSNA, Start(0.8, 0.1, 1000.0, 0.0, condition))
    assert plant.readings.thrust() > 500.0
