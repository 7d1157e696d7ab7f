"""The detection range that a plan needs, against escapes that are flown."""

import math
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest
from hypothesis import given
from hypothesis import strategies as st
from scenario_samples import loaded_from
from scenario_texts import MINIMAL

from vfguide.aircraft.point_mass import PointMass, advance
from vfguide.assurance.decision import assurance
from vfguide.files.data import shipped_scenarios
from vfguide.geometry.vector import ZERO
from vfguide.preflight.detection_range import Escape, escape_of, escape_range, side_step, turn_back
from vfguide.preflight.load import load_scenario
from vfguide.preflight.route_checks import GuidedAircraft

pytestmark = pytest.mark.slow

STEP = 0.1
CRUISE = {"aerosonde": 25.0, "easystar": 12.0, "c172p": 45.0}
CESSNA = (
    MINIMAL.replace("[[vehicle]]", '[[vehicle]]\naircraft = "c172p"\nairspeed_mps = 50.0', 1)
    .replace("[-500, 0, -100]", "[-3000, 0, -400]")
    .replace("[0, 0, -100]", "[3000, 0, -400]")
)
TOWER = """
[[obstacle]]
name = "tower"
shape = "cylinder"
position_m = [0, 0, -400]
radius_m = {radius}
height_m = 1000
"""


@cache
def guided(aircraft: str, share: float) -> GuidedAircraft:
    """An aircraft at an airspeed between its slowest and its fastest."""
    speed = f"vehicle.0.airspeed_mps={CRUISE[aircraft]}"
    loaded = load_scenario("first-flight", [f"vehicle.0.aircraft={aircraft}", speed])
    vehicle = loaded.scenario.vehicles[0]
    speeds = loaded.aircraft[aircraft].airspeed
    slow = 1.2 * speeds.min_mps
    gains = loaded.gains(vehicle)._replace(airspeed=slow + share * (speeds.max_mps - slow))
    return GuidedAircraft(loaded.performance(vehicle), gains)


class Block(NamedTuple):
    """A square obstacle that comes nearer."""

    width: float
    """To either side [m]."""
    closing: float
    seen: float
    """How far its front is when it becomes known [m]."""
    latency: float

    def distance(self, x: float, y: float, time: float) -> float:
        """Distance of a point at a time, negative inside."""
        front = self.seen - self.closing * time
        ahead, aside = max(front - x, x - front - 2.0 * self.width), abs(y) - self.width
        outside = math.hypot(max(ahead, 0.0), max(aside, 0.0))
        return outside if outside > 0.0 else max(ahead, aside)


def clearance(each: GuidedAircraft, aside: float, width: float, block: Block) -> float:
    """Least distance from a block straight ahead; the aircraft turns by up to `aside` [rad].

    It flies on for the latency, turns to the right until it is past the block or has turned so
    far, and flies straight on.
    """
    of = assurance(*each)
    motion = PointMass((0.0, 0.0, 0.0), 0.0, 0.0, 0.0, each.gains.airspeed)
    least, turns, time = math.inf, True, 0.0
    while time < 120.0:
        x, y, _ = motion.p_n
        least = min(least, block.distance(x, y, time))
        turns = turns and motion.azimuth < aside and y < width + of.margin
        bank = of.limits.bank_max if turns and time >= block.latency else 0.0
        motion = advance(motion, bank, 0.0, ZERO, of.limits, STEP)
        time += STEP
    return least


def best_clearance(
    each: GuidedAircraft, width: float, closing: float, seen: float, latency: float
) -> float:
    """Of a turn aside and of one back."""
    block = Block(width, closing, seen, latency)
    return max(clearance(each, aside, width, block) for aside in (0.5 * math.pi, math.pi))


@given(
    st.sampled_from(sorted(CRUISE)),
    st.sampled_from([0.0, 0.3, 0.6, 0.95]),
    st.floats(1.0, 2000.0),
    st.floats(0.0, 60.0),
    st.floats(0.0, 0.5),
)
def test_who_sees_an_obstacle_from_the_range_escapes(
    aircraft: str, share: float, width: float, closing: float, latency: float
) -> None:
    each = guided(aircraft, share)
    seen = escape_range(escape_of(each, latency), width, closing)
    assert best_clearance(each, width, closing, seen, latency) >= assurance(*each).margin


@pytest.mark.parametrize(("width", "closing"), [(100.0, 30.0), (500.0, 0.0), (500.0, 15.0)])
def test_three_hundred_metres_are_too_little_for_a_fast_cessna(
    width: float, closing: float
) -> None:
    each = guided("c172p", 0.7)
    assert each.gains.airspeed > 49.0
    assert best_clearance(each, width, closing, 300.0, 0.5) < assurance(*each).margin
    assert escape_range(escape_of(each, 0.5), width, closing) > 300.0


def test_figures_by_hand() -> None:
    """Radius 250 m, 50 m/s, 2 s, 30 m: 250 and 30 m, and 100 m before the turn."""
    escape = Escape(50.0, 250.0, 2.0, 30.0)
    assert escape_range(escape, 220.0, 0.0) == pytest.approx(380.0)
    assert escape_range(escape, 5000.0, 0.0) == pytest.approx(380.0)
    assert side_step(escape, 95.0, 0.0) == pytest.approx(250.0 * math.sqrt(3.0) / 2.0)
    assert side_step(escape, 95.0, 10.0) == pytest.approx(268.8662, abs=1e-3)
    assert side_step(escape, 320.0, 10.0) == pytest.approx(
        250.0 + 10.0 * (125 * math.pi + 100) / 50
    )
    assert turn_back(escape, 0.0) == pytest.approx(250.0)
    assert turn_back(escape, 25.0) == pytest.approx(250.0 * (math.sqrt(0.75) + math.pi / 3.0))
    assert turn_back(escape, 50.0) == math.inf


@given(st.floats(1.0, 900.0), st.floats(1.0, 100.0), st.floats(0.0, 60.0), st.floats(0.1, 10.0))
def test_what_is_larger_or_faster_has_to_be_seen_from_farther(
    width: float, wider: float, closing: float, faster: float
) -> None:
    escape = escape_of(guided("c172p", 0.6), 0.1)
    needed = escape_range(escape, width, closing)
    assert escape_range(escape, width + wider, closing) >= needed
    assert escape_range(escape, width, closing + faster) > needed


def range_of(folder: Path, text: str, *changes: str) -> float:
    return loaded_from(folder, text, changes).scenario.avoidance.detection_range_m


def test_the_default_follows_aircraft_obstacles_wind_and_latency(tmp_path: Path) -> None:
    text = CESSNA + TOWER.format(radius=100)
    calm = range_of(tmp_path, text)
    assert calm > 300.0
    assert range_of(tmp_path, CESSNA) == 300.0
    assert range_of(tmp_path, CESSNA + TOWER.format(radius=300)) > calm
    assert range_of(tmp_path, text, "wind.speed_mps=10") > calm
    assert range_of(tmp_path, text, "obstacle.0.velocity_mps=[-10,0,0]") > calm
    assert range_of(tmp_path, text, "link.delay_ms=200") == pytest.approx(calm + 10.0, abs=1.0)
    assert range_of(tmp_path, text, "guidance.bank_max_deg=30") > calm
    assert (
        range_of(tmp_path, MINIMAL + TOWER.format(radius=30).replace("0, 0,", "-200, 300,")) == 300
    )


def test_the_range_of_an_obstacle_wins_where_it_is_written(tmp_path: Path) -> None:
    far = CESSNA + TOWER.format(radius=100) + "visible_from_m = 900\n"
    loaded = loaded_from(tmp_path, far)
    assert loaded.scenario.obstacles[0].visible_from_m == 900.0
    assert loaded.warnings == ()
    usual = loaded_from(tmp_path, CESSNA + TOWER.format(radius=100)).scenario
    assert usual.obstacles[0].visible_from_m == usual.avoidance.detection_range_m


def test_a_written_range_that_is_too_small_is_warned_of_with_both_numbers(tmp_path: Path) -> None:
    text = CESSNA + TOWER.format(radius=100)
    needed = range_of(tmp_path, text)
    loaded = loaded_from(tmp_path, text, ("avoidance.detection_range_m=300",))
    assert loaded.scenario.obstacles[0].visible_from_m == 300.0
    (warning,) = loaded.warnings
    assert warning == (
        f"{tmp_path / 'x.toml'}: avoidance.detection_range_m = 300 m is less than the {needed:g} m "
        'that vehicle 1 needs to escape from "tower"'
    )
    (warning,) = loaded_from(tmp_path, text + "visible_from_m = 250\n").warnings
    assert "obstacle[0].visible_from_m = 250 m is less than the" in warning
    enough = (f"avoidance.detection_range_m={needed}",)
    assert loaded_from(tmp_path, text, enough).warnings == ()


def test_a_resolved_scenario_is_flown_as_before(tmp_path: Path) -> None:
    loaded = loaded_from(tmp_path, CESSNA + TOWER.format(radius=100))
    loaded.write_resolved(tmp_path / "resolved.toml")
    again = load_scenario(tmp_path / "resolved.toml")
    assert again.scenario == loaded.scenario
    assert again.warnings == ()


@pytest.mark.parametrize("name", shipped_scenarios())
def test_no_shipped_scenario_is_seen_too_late(name: str) -> None:
    assert not any("needs to escape" in each for each in load_scenario(name).warnings)
