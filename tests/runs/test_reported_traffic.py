"""Flights among traffic whose reports are late, by pressure, incomplete, or of the vehicle."""

import math

import numpy as np
import pytest
from altered import fly_altered
from flights import scenario_file

from vfguide.geometry.units import CDEG
from vfguide.link.enums import AdsbFlags
from vfguide.link.messages import AdsbVehicle, GlobalPositionInt, GpsRawInt

pytestmark = pytest.mark.slow

HEAD_ON = """
name = "head-on"
duration_s = 75.0
[avoidance]
traffic = true
[[vehicle]]
id = 1
position_m = [-900.0, 0.0, -140.0]
[[vehicle.goal]]
position_m = [800.0, 0.0, -140.0]
heading_deg = 0.0
[[traffic]]
name = "HEADON"
position_m = [900.0, 5.0, -140.0]
velocity_mps = [-32.0, 0.0, 0.0]
"""
TURNS = """
name = "turns"
duration_s = 140.0
[avoidance]
traffic = true
[[vehicle]]
id = 1
position_m = [-320.0, 30.0, -140.0]
heading_deg = 75.0
[[vehicle.goal]]
position_m = [260.0, 310.0, -145.0]
heading_deg = 250.0
[[vehicle.goal]]
position_m = [10.0, -20.0, -140.0]
heading_deg = 110.0
"""
COLLISION = 20.0
"""Two safety radii [m]."""
OWN = 0xABC123


def told_as_heard(_, message):
    return [message]


def changed(change):
    """Every report of traffic changed."""

    def alter(_, message):
        return [change(message) if isinstance(message, AdsbVehicle) else message]

    return alter


def separation(flight):
    """Least true distance from the aircraft of HEAD_ON [m]."""
    t, p_n = flight.record.time, flight.record.p_n
    there = np.array([900.0, 5.0, -140.0]) + t[:, None] * np.array([-32.0, 0.0, 0.0])
    return float(np.linalg.norm(p_n - there, axis=1).min())


class Echo:
    """What a receiver aboard hears of the vehicle's own transponder, `late` [s]."""

    def __init__(self, late):
        self.late, self.next, self.waiting = late, 0.4, []

    def __call__(self, t, message):
        if isinstance(message, GlobalPositionInt) and t >= self.next:
            self.next += 1.0
            self.waiting.append((t + self.late, own_report(message)))
        due = [report for at, report in self.waiting if at <= t]
        self.waiting = [each for each in self.waiting if each[0] > t]
        return [message, *due]


def own_report(place):
    course = math.atan2(place.vy, place.vx)
    told = (place.lat, place.lon, 1, place.alt, round(course / CDEG) % 36_000)
    speed = round(math.hypot(place.vx, place.vy))
    return AdsbVehicle(OWN, *told, speed, -place.vz, "ECHO", 1, 0, 0x9F, 0)


@pytest.mark.parametrize("late", [0.0, 0.6, 1.3, 2.0])
def test_the_own_transponder_is_no_traffic(tmp_path, late):
    """It was fled from all through the flight, NOTHING IS CLEAR, and no goal was reached."""
    flight = fly_altered(tmp_path, Echo(late), scenario=scenario_file(tmp_path, TURNS))
    found = [t for t, note in flight.told if note == "transponder ABC123 is this aircraft's own"]
    assert len(found) == 1
    assert found[0] < 20.0
    alarms = [t for t, note in flight.told if "NOTHING IS CLEAR" in note]
    assert all(t < found[0] for t in alarms)
    assert not alarms or late > 0.5
    assert flight.result.verdict == "good"


def members(number):
    rng = np.random.default_rng(16)
    for _ in range(number):
        base = rng.choice(["qne", "qnh", "geometric"])
        qnh = float(np.round(rng.uniform(973.0, 1053.0), 1))
        undulation = float(np.round(rng.uniform(-60.0, 60.0), 1))
        late = float(np.round(rng.uniform(0.0, 2.0), 1))
        yield str(base), qnh, undulation, late, bool(rng.integers(2))


@pytest.mark.parametrize(("base", "qnh", "undulation", "late", "pressure"), list(members(24)))
def test_heights_of_any_base_are_kept_clear_of(tmp_path, base, qnh, undulation, late, pressure):
    """With a pressure altitude 170 m off it was passed at 1 m, and nothing was told."""
    changes = (
        f"traffic.0.altitude_type='{base}'",
        f"weather.qnh_hpa={qnh}",
        f"origin.undulation_m={undulation}",
        f"traffic.0.delay_s={late}",
        f"autopilot.pressure_message={str(pressure).lower()}",
    )
    flight = fly_altered(
        tmp_path, told_as_heard, *changes, scenario=scenario_file(tmp_path, HEAD_ON)
    )
    assert separation(flight) > COLLISION
    is_doubted = base != "geometric" and not pressure
    assert len(flight.notes("tells no pressure")) == is_doubted
    assert not flight.notes("height above the ellipsoid")


def test_a_report_without_velocity_is_not_fled_from(tmp_path):
    """Its volume grew by 60 m/s for as long as it was heard: it was fled from for half a minute."""
    lacks = AdsbFlags.VALID_HEADING | AdsbFlags.VALID_VELOCITY | AdsbFlags.VERTICAL_VELOCITY_VALID
    alter = changed(
        lambda said: said._replace(
            flags=said.flags & ~int(lacks), heading=0, hor_velocity=0, ver_velocity=0
        )
    )
    flight = fly_altered(
        tmp_path, alter, "duration_s=120.0", scenario=scenario_file(tmp_path, HEAD_ON)
    )
    assert separation(flight) > COLLISION
    assert flight.result.verdict == "good"
    assert not flight.notes("NOTHING IS CLEAR")
    assert not flight.notes("escape")


def back(said):
    return said._replace(heading=(said.heading + 18_000) % 36_000)


def to_the_right(said):
    return said._replace(heading=(said.heading + 9_000) % 36_000)


def standing(said):
    return said._replace(hor_velocity=0)


def without_address(said):
    return said._replace(ICAO_address=0)


@pytest.mark.parametrize("change", [back, to_the_right, standing, without_address])
def test_it_is_kept_clear_of_whatever_its_reports_say_besides_its_place(tmp_path, change):
    """It was flown through: a velocity was believed, an aircraft without an address was none."""
    flight = fly_altered(tmp_path, changed(change), scenario=scenario_file(tmp_path, HEAD_ON))
    assert separation(flight) > COLLISION
    assert flight.result.verdict == "good"
    assert not flight.notes("NOTHING IS CLEAR")


@pytest.mark.parametrize("off", [-100.0, 100.0])
@pytest.mark.parametrize("begin", [1.0, 15.0])
def test_an_undulation_that_changes_in_flight_is_not_believed_alone(tmp_path, off, begin):
    """The traffic was put 100 m above or below where it was, and flown through."""

    def alter(t, message):
        if isinstance(message, GpsRawInt) and t > begin:
            return [message._replace(alt_ellipsoid=message.alt_ellipsoid + round(off * 1e3))]
        return [message]

    flight = fly_altered(tmp_path, alter, scenario=scenario_file(tmp_path, HEAD_ON))
    assert separation(flight) > COLLISION
    assert flight.result.verdict == "good"


class SentFromEverywhere:
    """Each report after one with the same address from another place."""

    def __init__(self):
        self.rng = np.random.default_rng(5)

    def __call__(self, _, message):
        if not isinstance(message, AdsbVehicle):
            return [message]
        lat, lon = self.rng.integers(-300_000, 300_000, 2).tolist()
        return [message._replace(lat=message.lat + lat, lon=message.lon + lon), message]


def test_an_aircraft_is_seen_among_false_reports_of_its_address(tmp_path):
    scenario = scenario_file(tmp_path, HEAD_ON)
    flight = fly_altered(tmp_path, SentFromEverywhere(), scenario=scenario)
    assert separation(flight) > COLLISION
    assert flight.result.verdict == "good"
