"""Footprints: what an obstacle covers of a band of heights."""

import math

import numpy as np
import pytest
from shape_samples import SHAPES, random_shape

from vfguide.airspace.footprint import (
    Band,
    Section,
    Side,
    crossing_times,
    read_side,
    section_in,
    sides_round,
)
from vfguide.airspace.keep_out import obstacle_zones
from vfguide.airspace.planar_clearance import clearance_at
from vfguide.field.obstacle import Obstacle, obstacle_distance, obstacle_rows
from vfguide.kernels.rows import columns

MARGIN = 20.0


def random_points(rng, count, band):
    x, y = rng.uniform(-150.0, 150.0, (2, count))
    return zip(x, y, rng.uniform(band.top, band.bottom, count), strict=True)


@pytest.mark.parametrize("number", range(40))
def test_an_obstacle_is_at_least_as_far_as_its_footprint(number):
    rng = np.random.default_rng(number)
    place, heading = (0.0, 0.0, float(rng.uniform(-60.0, 60.0))), rng.uniform(-3.0, 3.0)
    velocity = (3.0, -2.0, float(rng.choice([0.0, -2.0, 4.0])))
    rows = obstacle_rows([Obstacle(random_shape(rng), place, heading, velocity)])
    band = Band(-15.0, 10.0)
    hazards = obstacle_zones(rows, band, MARGIN)
    for x, y, z in random_points(rng, 40, band):
        t = float(rng.uniform(0.0, 20.0))
        covered = min(clearance_at(hazards, x, y, t).distance, MARGIN)
        actual = obstacle_distance(rows, 0, (x, y, z), t)
        assert actual >= covered - 1e-3 * (1.0 + abs(actual)) or covered < 0.0


@pytest.mark.parametrize("name", SHAPES)
def test_a_footprint_is_hardly_larger_than_the_widest_section(name):
    rows = obstacle_rows([Obstacle(SHAPES[name], (0.0, 0.0, 0.0), 0.4)])
    hazards = obstacle_zones(rows, Band(-1.0, SHAPES[name].semi_axes[2]), 0.0)
    for bearing in np.linspace(0.0, 6.0, 25):
        at = np.array([math.cos(bearing), math.sin(bearing)]) * 200.0
        heights = np.linspace(0.0, SHAPES[name].semi_axes[2], 40)
        nearest = min(obstacle_distance(rows, 0, (*at, z), 0.0) for z in heights)
        covered = clearance_at(hazards, *at, 0.0).distance
        assert nearest - 0.03 * 200.0 <= covered <= nearest + 0.1


def test_unequal_exponents_are_touched_where_points_of_the_section_reach():
    section = Section(60.0, 25.0, 1.3, 4.0)
    angle = np.linspace(0.0, 2.0 * math.pi, 20_001)
    c, s = np.cos(angle), np.sin(angle)
    x = np.copysign(60.0 * np.abs(c) ** (1 / 1.3), c)
    y = np.copysign(25.0 * np.abs(s) ** (1 / 4.0), s)
    for side in map(read_side, sides_round(section, 1.0, 0.0)):
        assert side.distance == pytest.approx(np.max(side.nx * x + side.ny * y), abs=0.02)


def test_the_corners_of_a_polygon_lie_on_the_sides_that_meet_there():
    sides = columns(Side, sides_round(Section(60.0, 25.0, 1.3, 4.0), 0.6, 0.8))
    for shift in (0, 1):
        nx, ny, distance = (np.roll(a, shift) for a in (sides.nx, sides.ny, sides.distance))
        np.testing.assert_allclose(nx * sides.x + ny * sides.y, distance, rtol=1e-12)


def test_what_flies_above_or_below_is_none():
    rows = obstacle_rows([Obstacle(SHAPES["sphere"], (0.0, 0.0, 0.0))])
    assert len(obstacle_zones(rows, Band(-100.0, -70.0), 25.0).table) == 0
    assert len(obstacle_zones(rows, Band(-100.0, -70.0), 31.0).table) == 1
    assert section_in(rows, 0, Band(-100.0, -70.0)).a == 0.0


def test_what_climbs_is_in_the_band_for_a_while():
    rows = obstacle_rows([Obstacle(SHAPES["sphere"], (0.0, 0.0, 200.0), v_n=(0.0, 0.0, -4.0))])
    assert crossing_times(rows, 0, Band(-10.0, 10.0)) == (37.5, 62.5)
    hazards = obstacle_zones(rows, Band(-10.0, 10.0), 0.0)
    assert clearance_at(hazards, 0.0, 0.0, 37.0).distance == math.inf
    assert clearance_at(hazards, 0.0, 0.0, 50.0).distance == pytest.approx(-40.0)


def test_a_cone_counts_where_it_is_widest_in_the_band():
    rows = obstacle_rows([Obstacle(SHAPES["cone"], (0.0, 0.0, 0.0))])
    upper = section_in(rows, 0, Band(-30.0, -10.0)).a
    lower = section_in(rows, 0, Band(-30.0, 20.0)).a
    assert upper == pytest.approx(25.0 * 0.75, abs=0.5)
    assert lower == pytest.approx(25.0 * 1.5, abs=0.5)
