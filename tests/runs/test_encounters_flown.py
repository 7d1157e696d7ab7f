"""Encounters that were predicted before the flight, and those that were flown."""

import math
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from vfguide.preflight.encounter_checks import encounters
from vfguide.preflight.load import load_scenario
from vfguide.preflight.route_checks import GuidedAircraft
from vfguide.results.verdict import min_separation
from vfguide.runs.lockstep import fly_scenario

pytestmark = pytest.mark.slow

HEAD = """
name = "pair"
duration_s = 150.0
plant = "{plant}"
[wind]
speed_mps = {wind}
from_deg = {from_deg}
"""
VEHICLE = """
[[vehicle]]
id = {sysid}
aircraft = "{aircraft}"
position_m = [{x}, {y}, -120.0]
heading_deg = {heading}
"""
GOAL = """
[[vehicle.goal]]
position_m = [{x}, {y}, -{height}]
heading_deg = {heading}
"""
SPEEDS = {"aerosonde": 25.0, "easystar": 12.0}


def pair(seed: int, plant: str) -> str:
    """Two vehicles that are near the origin at about the same time, and fly on to 1 or 2 goals."""
    rng = np.random.default_rng(seed)
    when, wind = rng.uniform(20.0, 50.0), rng.uniform(0.0, 8.0) * (plant == "jsbsim")
    from_deg = rng.uniform(0.0, 360.0)
    text = HEAD.format(plant=plant, wind=wind, from_deg=from_deg)
    courses = rng.uniform(0.0, 2.0 * math.pi) + np.array((0.0, rng.uniform(0.6, 5.6)))
    for sysid, course in enumerate(courses.tolist(), start=1):
        aircraft = str(rng.choice(sorted(SPEEDS)))
        speed = SPEEDS[aircraft] if plant == "jsbsim" else 25.0
        off = math.radians(from_deg) - course
        ground = math.sqrt(speed**2 - (wind * math.sin(off)) ** 2) - wind * math.cos(off)
        place = -when * ground * along(course) + rng.normal(0.0, 10.0, 2)
        heading = math.degrees(course + rng.normal(0.0, 0.2)) % 360.0
        text += VEHICLE.format(
            sysid=sysid, aircraft=aircraft, x=place[0], y=place[1], heading=heading
        )
        place = rng.uniform(100.0, 400.0) * along(course + rng.normal(0.0, 0.05))
        for _ in range(rng.integers(1, 3)):
            height, turn = rng.uniform(116.0, 124.0), math.degrees(course + rng.normal(0.0, 0.5))
            text += GOAL.format(x=place[0], y=place[1], height=height, heading=turn % 360.0)
            place = place + rng.uniform(200.0, 400.0) * along(course + 1.0)
    return text


def along(course: float) -> np.ndarray:
    return np.array((math.cos(course), math.sin(course)))


COUNT = 14


class Compared(NamedTuple):
    """Each pair as it was predicted and flown."""

    errors: np.ndarray
    warned: np.ndarray
    met: np.ndarray


def compared(plant: str, folder: Path) -> Compared:
    errors, warned, met = list[float](), list[bool](), list[bool]()
    for seed in range(COUNT):
        file = folder / "pair.toml"
        file.write_text(pair(seed, plant))
        loaded = load_scenario(file)
        guided = [
            GuidedAircraft(loaded.performance(v), loaded.gains(v)) for v in loaded.scenario.vehicles
        ]
        flown = list(zip(loaded.scenario.vehicles, guided, strict=True))
        ((_, _, meeting),) = encounters(loaded.scenario, flown)
        separation = min_separation(fly_scenario(loaded, folder).records)
        assert separation is not None
        errors.append(abs(meeting.distance - separation))
        warned.append(any("come within" in each for each in loaded.warnings))
        met.append(separation < 20.0)
    assert 3 <= sum(met) < COUNT
    return Compared(np.array(errors), np.array(warned), np.array(met))


def test_the_warning_agrees_with_nearly_all_flights(tmp_path: Path) -> None:
    pairs = compared("jsbsim", tmp_path)
    assert np.median(pairs.errors) < 2.0
    assert np.mean(pairs.errors < 5.0) > 0.8
    assert np.sum(pairs.warned != pairs.met) <= 1


def test_the_warning_agrees_with_all_flights_of_rigid_bodies(tmp_path: Path) -> None:
    """A point mass that rolls was predicted before: one pair met at 7.7 m with no warning."""
    pairs = compared("kinematic", tmp_path)
    assert pairs.errors.max() < 0.01
    assert (pairs.warned == pairs.met).all()
