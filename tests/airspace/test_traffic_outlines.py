"""What the search for ways sees of traffic."""

import math

import numpy as np
import pytest

from vfguide.airspace.footprint import Band
from vfguide.airspace.hazards import TRAFFIC_LOOKAHEAD, Intruder, traffic_rows, traffic_zones
from vfguide.airspace.keep_out import KeepOutZone, read_zone_row
from vfguide.airspace.planar_clearance import zone_row_distance
from vfguide.kernels.rows import width

BAND = Band(-120.0, -100.0)


def outlines(v_n=(10.0, -30.0, 0.0), z=-110.0, t=42.0, uncertainty_rate_up=0.0):
    its = Intruder((100.0, 200.0, z), v_n, 40.0, 50.0, 30.0, 3.0, uncertainty_rate_up)
    return traffic_zones(traffic_rows([its]), BAND, 20.0, t)


@pytest.mark.parametrize("t", [42.0, 50.0])
def test_a_circle_that_moves_with_it(t):
    seen = outlines()
    x, y = 100.0 + 10.0 * (t - 40.0), 200.0 - 30.0 * (t - 40.0)
    radius = 50.0 + 3.0 * (2.0 + TRAFFIC_LOOKAHEAD)
    at = (x + 200.0, y, t, math.inf)
    distance = zone_row_distance(read_zone_row(seen.table[0]), seen.sides, *at)
    assert distance == pytest.approx(200.0 - radius)


@pytest.mark.parametrize(("z", "there"), [(-171.0, 0), (-169.0, 1), (-51.0, 1), (-49.0, 0)])
def test_only_what_reaches_into_the_band(z, there):
    assert len(outlines(z=z).table) == there


def test_one_that_climbs_through_the_band_is_there_for_a_while():
    seen = outlines((0.0, 30.0, -2.0), z=-10.0, t=40.0)
    outline = read_zone_row(seen.table[0])
    assert (outline.since, outline.until) == pytest.approx((60.0, 120.0))


def test_nobody():
    nobody = traffic_zones(traffic_rows([]), BAND, 20.0, 0.0)
    assert nobody.table.shape == (0, width(KeepOutZone))
    assert np.size(nobody.sides) == 0
