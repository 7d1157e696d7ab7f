"""Flights in bad air, with bad sensors: judged by the truth and by what the operator is told."""

from contextlib import ExitStack
from dataclasses import dataclass

import numpy as np
import pytest

from vfguide.preflight.load import load_scenario
from vfguide.results.judge import judge
from vfguide.results.record import FlightRecord
from vfguide.results.result import Result
from vfguide.runs.aeroplanes import Aeroplanes
from vfguide.runs.lockstep import Lockstep
from vfguide.runs.logs import Logs

pytestmark = pytest.mark.slow

LIGHT = ("wind.speed_mps=5.0", 'wind.turbulence="light"')
UNTOLD = "autopilot.wind_message=false"


@dataclass(frozen=True)
class Flown:
    """A flight and what was said in it."""

    record: FlightRecord
    result: Result
    told: tuple[tuple[float, str], ...]

    def when(self, words):
        """When the operator was told first [s]."""
        return next(time for time, note in self.told if words in note)

    def believed_wind_error(self, late=10.0):
        """[m/s], from `late` [s] on."""
        from_here = self.record.time > late
        wind = self.record.wind_n[from_here, :2]
        air = self.record.air
        believed = np.column_stack((air.wind_north, air.wind_east))
        return np.linalg.norm(believed[from_here] - wind, axis=1)


def fly(folder, *changes, scenario="first-flight"):
    loaded = load_scenario(scenario, ("duration_s=150.0", *changes))
    told = []
    with ExitStack() as stack:
        fleet = Aeroplanes(loaded, Logs(folder, stack))
        lockstep = Lockstep(fleet, loaded.scenario.duration_s)
        while lockstep.ending is None:
            lockstep.advance()
            told += [(lockstep.sim_s, note) for note in fleet.members[0].companion.news()]
        records = fleet.records()
    return Flown(records[0], judge(loaded.scenario, records, lockstep.sim_s, 1.0), tuple(told))


def goal_of(flight):
    return flight.result.vehicles[0].goals[0]


def test_a_goal_that_cannot_be_met_is_given_up(tmp_path):
    goals = (
        "vehicle.0.goal=[{position_m=[0, 0, -125], heading_deg=0, tolerance_m=0.001, attempts=2}, "
        "{position_m=[500, 0, -125], heading_deg=0, attempts=2}]"
    )
    flight = fly(tmp_path, *LIGHT, goals)
    first = flight.when("goal 1 missed by")
    given_up = flight.when("goal 1 missed 2 times: going on to goal 2")
    assert first + 10.0 < given_up < flight.when("goal 2 reached")
    exact, easy = flight.result.vehicles[0].goals
    assert (exact.reached, easy.reached) == (False, True)
    assert exact.time_s in (
        pytest.approx(first, abs=0.1),
        pytest.approx(given_up, abs=0.1),
    )
    assert given_up < easy.time_s < flight.result.sim_s == pytest.approx(easy.time_s + 5.0, abs=0.1)
    assert flight.result.verdict == "bad"
    assert flight.result.reasons == ("goal 1 of vehicle 1 not reached",)


def test_circles_that_the_height_needs_are_no_alarm(tmp_path):
    high = "vehicle.0.goal.0.position_m=[0.0, 0.0, -420.0]"
    flight = fly(tmp_path, *LIGHT, high)
    assert goal_of(flight).reached
    course = np.unwrap(np.arctan2(flight.record.v_n[:, 1], flight.record.v_n[:, 0]))
    first_minute = course[flight.record.time < 60.0]
    assert np.ptp(first_minute) > 4.0 * np.pi  # two circles to one side before anything else
    assert not any("no progress" in note for _, note in flight.told)


def test_circles_that_lead_nowhere_are_told_once(tmp_path):
    """The motor carries level flight and no climb."""
    high = "vehicle.0.goal.0.position_m=[0.0, 0.0, -220.0]"
    flight = fly(tmp_path, "autopilot.thrust_scale=0.25", high, "duration_s=450.0")
    assert not goal_of(flight).reached
    (alarm,) = [note for _, note in flight.told if "no progress" in note]
    assert alarm.startswith("no progress to goal 1: flown a full circle more than its path has")


def test_no_airspeed_sensor(tmp_path):
    flight = fly(tmp_path, *LIGHT, UNTOLD, "autopilot.airspeed_fails_at_s=0")
    assert goal_of(flight).reached
    assert goal_of(flight).miss_m <= 3.0
    assert flight.when("no airspeed is heard: airspeed is estimated") < 1.0
    assert flight.record.airspeed.min() >= 1.1 * 17.6
    assert np.median(flight.believed_wind_error()) < 2.0
    off = flight.record.air.airspeed[500:] - flight.record.airspeed[500:]
    assert np.median(np.abs(off)) < 1.5


@pytest.mark.parametrize("fault", ["missing", "frozen", "blocked"])
def test_an_airspeed_sensor_that_fails_in_flight(tmp_path, fault):
    flight = fly(
        tmp_path, *LIGHT, "autopilot.airspeed_fails_at_s=10", f'autopilot.airspeed_fault="{fault}"'
    )
    assert goal_of(flight).reached
    assert goal_of(flight).miss_m <= 3.0
    told = "the airspeed sensor is not believed any more"
    told = "no airspeed is heard any more" if fault == "missing" else told
    assert 10.0 < flight.when(told) < 20.0
    assert flight.record.airspeed.min() >= 1.1 * 17.6
    assert flight.record.airspeed.max() <= 32.0


def test_a_position_reset_near_the_goal(tmp_path):
    """The position is 8 m off until 5 s before the goal is passed."""
    resets = (
        "autopilot.reset=[{time_s=0.0, position_m=[8.0, 0.0, 0.0]}, "
        "{time_s=19.0, position_m=[-8.0, 0.0, 0.0]}]"
    )
    flight = fly(tmp_path, resets)
    assert goal_of(flight).reached
    assert goal_of(flight).miss_m <= 2.0
    assert flight.when("has jumped by 8 m") == pytest.approx(19.0, abs=0.05)
    at = (flight.record.time > 18.9) & (flight.record.time < 20.5)
    wanted = np.diff(flight.record.omega_wanted_b[at], axis=0)
    assert np.abs(wanted).max() < np.radians(15.0)  # from one setpoint to the next


def test_a_jump_across_the_goal_passes_nothing(tmp_path):
    reset = "autopilot.reset=[{time_s=22.0, position_m=[0.0, 80.0, 0.0]}]"
    flight = fly(tmp_path, reset, "duration_s=30.0")
    assert flight.when("has jumped by 80 m") == pytest.approx(22.0, abs=0.05)
    assert not any("reached" in note or "missed" in note for _, note in flight.told)


def test_an_origin_reset(tmp_path):
    reset = "autopilot.reset=[{time_s=15.0, origin_m=[400.0, -300.0, 20.0]}]"
    flight, calm = fly(tmp_path, reset), fly(tmp_path / "..")
    assert goal_of(flight).reached
    assert goal_of(flight).miss_m <= 0.5
    assert flight.when("has moved the origin") == pytest.approx(15.0, abs=0.1)
    same = min(len(flight.record.time), len(calm.record.time))
    apart = np.linalg.norm(flight.record.p_n[:same] - calm.record.p_n[:same], axis=1)
    assert apart[: round(24.0 / 0.02)].max() < 2.0


@pytest.mark.parametrize("changes", [(), (UNTOLD,)])
def test_a_wind_above_the_airspeed_is_held_against_until_it_falls(tmp_path, changes):
    flight = fly(
        tmp_path,
        "wind.speed_mps=27.0",
        "wind.change=[{time_s=30.0, speed_mps=27.0}, {time_s=50.0, speed_mps=12.0}]",
        *changes,
    )
    assert flight.when("goal 1 unreachable now: wind ") < 1.0
    (note,) = [text for _, text in flight.told if "goal 1 unreachable now" in text]
    wind = float(note.split("wind ")[1].split(" of 25 m/s")[0])
    assert wind == pytest.approx(27.0, abs=1.0 if changes else 0.0)  # 0.3 s old if it is not told
    soon = np.searchsorted(flight.record.time, 2.0)
    air = flight.record.air
    believed = np.hypot(air.wind_north[soon], air.wind_east[soon])
    assert believed == pytest.approx(27.0, abs=0.1)
    assert 33.0 < flight.when("the wind has fallen: flying to goal 1 of 1") < 55.0
    assert goal_of(flight).reached
    assert goal_of(flight).miss_m <= 2.0
    held = flight.record.time < 33.0
    settled = held & (flight.record.time > 12.0)
    assert np.linalg.norm(flight.record.v_n[settled], axis=1).max() < 4.0
    assert np.abs(flight.record.p_n[held, 2] + 120.0).max() < 10.0
    assert flight.record.airspeed.min() > 1.2 * 17.6


@pytest.mark.parametrize(
    "motor",
    [
        ("autopilot.thrust_scale=0.75",),
        ("autopilot.thrust_scale=1.4",),
        ("autopilot.thrust_sag_per_min=0.8", "autopilot.thrust_floor=0.5"),
    ],
)
def test_a_wrong_thrust_map_is_absorbed(tmp_path, motor):
    flight = fly(tmp_path, *motor)
    assert goal_of(flight).reached
    assert goal_of(flight).miss_m <= 0.2
    assert flight.record.airspeed.min() > 24.0
    assert flight.record.airspeed.max() < 26.0


@pytest.mark.parametrize("scale", [0.3, 0.2])  # 30 % of the thrust carries level flight
def test_without_thrust_for_both_speed_goes_before_height(tmp_path, scale):
    goal = "vehicle.0.goal.0.position_m=[2500.0, 0.0, -160.0]"
    flight = fly(tmp_path, f"autopilot.thrust_scale={scale}", goal, "duration_s=60.0")
    assert flight.record.airspeed.min() > 17.6  # the stall
    assert (flight.record.p_n[-1, 2] > -120.0) == (scale < 0.3)


def test_strong_wind_with_shear_is_estimated(tmp_path):
    flight = fly(tmp_path, "wind.speed_mps=15.0", "wind.shear_mps_per_100m=4.0", UNTOLD)
    assert goal_of(flight).reached
    assert goal_of(flight).miss_m <= 1.0
    assert np.median(flight.believed_wind_error()) < 0.5


def test_the_seed_alone_gives_the_errors(tmp_path):
    def errors(*changes):
        return fly(tmp_path, "sensors={}", "duration_s=3.0", *changes).record.position_error_n

    assert (errors() == errors()).all()
    assert not (errors() == errors("seed=2")).all()
    # Other weather, another flight: the same errors at the same times.
    windy = errors("wind.speed_mps=9.0")
    assert errors() == pytest.approx(windy, abs=1e-3)
