"""The software autopilot's own flight: circles from any start, in wind and gusts."""

import math
from dataclasses import replace
from functools import cache
from random import Random

import numpy as np
import pytest
import sim_flights
from aeroplanes import AEROSONDE, CESSNA, EASYSTAR
from conversations_with_autopilot import ATTITUDES, UPDATE, Dialogue, setpoint

from vfguide.autopilots.px4 import Px4Mode
from vfguide.earth.geodesy import geodetic_to_ned, ned_to_geodetic, tangent_plane
from vfguide.geometry.so3 import from_euler, to_quaternion
from vfguide.geometry.units import DEG, G0
from vfguide.link.enums import MavCmd
from vfguide.sim.autopilot.flight_mode import Mode
from vfguide.sim.autopilot.loiter_circle import BANK_SHARE, HOLD_RADIUS, largest_bank, radius_in
from vfguide.sim.bench import Bench
from vfguide.sim.condition import FlightCondition, Start, Weather
from vfguide.sim.trim import TrimError, trim
from vfguide.sim.turbulence import Turbulence
from vfguide.sim.vehicle import Setup, Vehicle

pytestmark = pytest.mark.slow

AIRCRAFT = {
    "aerosonde": (AEROSONDE, sim_flights.AEROSONDE),
    "c172p": (CESSNA, sim_flights.CESSNA),
    "easystar": (EASYSTAR, sim_flights.EASYSTAR),
}
GROUND, ALTITUDE = 488.0, 838.0
ORIGIN = (47.4 * DEG, 8.5 * DEG, ALTITUDE)
CALM = Weather()


@cache
def trimmed(name: str, airspeed: float, climb: float = 0.0) -> FlightCondition:
    bench = Bench(AIRCRAFT[name][1], ALTITUDE)
    try:
        return trim(bench, airspeed, climb)
    except TrimError:  # too steep for steady flight
        return replace(trim(bench, airspeed), climb=climb)


def vehicle(name, weather=CALM, bank=0.0, climb=0.0, airspeed=None, yaw=0.0):
    aircraft, model = AIRCRAFT[name]
    cruise = aircraft.airspeed_cruise
    condition = replace(trimmed(name, airspeed or cruise, climb), bank=bank)
    start = Start(*ORIGIN, yaw, condition)
    return Vehicle(Setup(1, model, aircraft, cruise, start, weather, GROUND), 1_767_225_600_000_000)


class Flight:
    """What was flown in a hold: rows over time."""

    def __init__(self, flown: Vehicle, seconds: float):
        truths = []
        for _ in range(round(seconds / 0.02)):
            flown.advance(UPDATE)
            truths.append(flown.truth)
        plane = tangent_plane(*ORIGIN)
        self.p_n = np.array(
            [geodetic_to_ned(plane, t.latitude, t.longitude, t.altitude) for t in truths]
        )
        self.height = np.array([t.altitude - ALTITUDE for t in truths])
        self.bank = np.array([t.roll for t in truths])
        self.airspeed = np.array([t.airspeed for t in truths])
        self.load = np.array([-t.force_b[2] / G0 for t in truths])

    def circle(self, seconds: float) -> tuple[np.ndarray, float, float]:
        """Centre, radius and largest distance from it [m] of the last seconds, by least squares."""
        points = self.p_n[-round(seconds / 0.02) :, :2]
        A = np.column_stack((2.0 * points, np.ones(len(points))))
        north, east, rest = np.linalg.lstsq(A, (points**2).sum(1), rcond=None)[0]
        centre, radius = np.array([north, east]), math.sqrt(rest + north**2 + east**2)
        return centre, radius, float(np.abs(np.hypot(*(points - centre).T) - radius).max())


def turn_time(name: str) -> float:
    return AIRCRAFT[name][0].airspeed_cruise / G0


def random_start(name: str, rnd: Random, turbulence: Turbulence) -> Vehicle:
    """Any bank up to that of the limits, climb, airspeed and heading, in wind up to 60 %."""
    aircraft, _ = AIRCRAFT[name]
    wind, direction = rnd.uniform(0.0, 0.6) * aircraft.airspeed_cruise, rnd.uniform(-3.0, 3.0)
    weather = Weather(
        (wind * math.cos(direction), wind * math.sin(direction), 0.0), turbulence, rnd.randrange(99)
    )
    return vehicle(
        name,
        weather,
        bank=rnd.uniform(-1.0, 1.0) * 43.0 * DEG,
        climb=rnd.uniform(-aircraft.descent_max, aircraft.climb_max),
        airspeed=rnd.uniform(1.08 * aircraft.airspeed_min, 0.95 * aircraft.airspeed_max),
        yaw=rnd.uniform(-math.pi, math.pi),
    )


@pytest.mark.parametrize("name", AIRCRAFT)
@pytest.mark.parametrize("seed", range(4))
def test_from_any_start_it_enters_a_level_circle(name, seed):
    aircraft, _ = AIRCRAFT[name]
    flight = Flight(random_start(name, Random(seed), Turbulence.NONE), 45.0 * turn_time(name))
    _, radius, off = flight.circle(20.0 * turn_time(name))
    assert radius >= HOLD_RADIUS * aircraft.airspeed_cruise**2 / G0 * 0.99
    assert off < 0.02 * radius
    assert np.abs(flight.height).max() < 6.0
    late = slice(len(flight.height) // 2, None)
    assert np.abs(flight.height[late]).max() < 1.0
    assert np.abs(flight.airspeed[late] - aircraft.airspeed_cruise).max() < 0.5
    assert np.abs(flight.bank).max() < aircraft.bank_max
    assert flight.airspeed.min() > aircraft.airspeed_min
    assert flight.load.max() < aircraft.load_max
    assert flight.load.min() > 0.0


@pytest.mark.parametrize(
    ("name", "turbulence", "height"),
    [
        ("aerosonde", Turbulence.MODERATE, 30.0),
        ("c172p", Turbulence.MODERATE, 20.0),
        ("easystar", Turbulence.LIGHT, 10.0),
    ],
)
@pytest.mark.parametrize("seed", range(3))
def test_in_gusts_it_stays_in_the_air_and_inside_its_limits(name, turbulence, height, seed):
    aircraft, _ = AIRCRAFT[name]
    flight = Flight(random_start(name, Random(seed), turbulence), 45.0 * turn_time(name))
    assert np.abs(flight.height).max() < height
    assert np.abs(flight.bank).max() < aircraft.bank_max
    assert flight.airspeed.min() > 0.95 * aircraft.airspeed_min
    assert flight.airspeed.max() < 1.15 * aircraft.airspeed_max
    # The shortest gusts are felt before anything moves.
    assert flight.load.max() < aircraft.load_max + 0.6
    assert flight.load.min() > aircraft.load_min - 0.4


def test_without_wind_the_circle_is_the_documented_one_to_the_right():
    flight = Flight(vehicle("aerosonde"), 60.0)
    centre, radius, _ = flight.circle(30.0)
    assert radius == pytest.approx(1.57 * 25.0**2 / G0, rel=0.01)
    assert centre == pytest.approx([0.0, radius], abs=2.0)
    assert flight.bank[-1] > 0.0


@pytest.mark.parametrize("name", AIRCRAFT)
@pytest.mark.parametrize("part", [1.1, 1.4])
def test_in_a_wind_faster_than_itself_it_flies_level_with_the_nose_to_it(name, part):
    aircraft, _ = AIRCRAFT[name]
    weather = Weather((0.0, part * aircraft.airspeed_cruise, 0.0))
    flown = vehicle(name, weather, bank=30.0 * DEG)
    flight = Flight(flown, 30.0 * turn_time(name))
    assert np.isfinite(flight.p_n).all()
    assert np.abs(flight.height).max() < 6.0
    assert math.sin(flown.truth.yaw) < -0.5
    assert np.abs(flight.bank).max() < aircraft.bank_max


def test_it_returns_to_a_circle_about_its_start():
    flown = vehicle("aerosonde", Weather((5.0, 0.0, 0.0)))
    talk = Dialogue(flown)
    talk.fly(20.0, setpoint(thrust=0.3))
    talk.set_mode(Px4Mode.OFFBOARD)
    talk.fly(20.0, setpoint(0.0, 0.01, 0.0, 0.4))
    talk.command(MavCmd.NAV_RETURN_TO_LAUNCH)
    flight = Flight(flown, 150.0)
    centre, radius, off = flight.circle(40.0)
    assert centre == pytest.approx([0.0, 0.0], abs=3.0)
    assert off < 0.02 * radius
    assert abs(flight.height[-1]) < 1.0


def test_it_takes_over_from_a_steep_climbing_turn_whose_setpoints_end():
    flown = vehicle("aerosonde")
    talk = Dialogue(flown)
    steep = to_quaternion(from_euler(-45.0 * DEG, 12.0 * DEG, 0.0))
    turn = setpoint(mask=ATTITUDES, attitude=steep, thrust=0.9)
    talk.fly(0.2, turn)
    talk.set_mode(Px4Mode.OFFBOARD)
    talk.fly(6.0, turn)
    assert flown.truth.roll < -40.0 * DEG
    talk.fly(1.1)
    assert flown.autopilot.mode is Mode.LOST_TO_HOLD
    height = flown.truth.altitude - ALTITUDE
    flight = Flight(flown, 60.0)
    _, radius, off = flight.circle(25.0)
    assert off < 0.02 * radius
    assert np.abs(flight.height - height).max() < 6.0
    assert np.abs(flight.bank[100:]).max() <= BANK_SHARE * AEROSONDE.bank_max + 1.0 * DEG
    assert flight.load.max() < AEROSONDE.load_max


def test_a_position_far_away_and_a_pause_do_not_upset_it():
    """As after a reset of the position: the circle is then behind, kilometres off."""
    flown = vehicle("aerosonde")
    far = ned_to_geodetic(tangent_plane(*ORIGIN), (-9000.0, 4000.0, 0.0))
    hold, estimate = flown.autopilot._hold, flown.autopilot.estimate
    for time in (1.0, 500.0, 400.0):
        omega_b, thrust = hold.step(estimate._replace(time=time, latitude=far[0], longitude=far[1]))
        assert (np.abs(omega_b) <= AEROSONDE.rate_max).all()
        assert 0.0 <= thrust <= 1.0


def test_the_slower_it_flies_the_less_it_banks():
    """By the load factor that the wing carries: V^2 / V_min^2 = 1 / cos(bank)."""
    assert largest_bank(AEROSONDE, 25.0) == pytest.approx(BANK_SHARE * AEROSONDE.bank_max)
    assert 1.0 / math.cos(largest_bank(AEROSONDE, 20.0)) == pytest.approx((20.0 / 18.0) ** 2)
    assert largest_bank(AEROSONDE, 5.0) == largest_bank(AEROSONDE, 18.0) > 15.0 * DEG


@pytest.mark.parametrize("wind", [0.0, 8.0, 15.0])
def test_the_bank_suffices_downwind_on_the_circle(wind):
    radius = radius_in((0.0, wind, 0.0), 25.0, AEROSONDE)
    needed = math.atan((25.0 + wind) ** 2 / (G0 * radius))
    assert needed < largest_bank(AEROSONDE, 25.0)
