"""The velocity of aircraft that report none."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from reported import ALL, ORIGIN, moving

from vfguide.link.enums import AdsbFlags
from vfguide.surveillance.heights import HeightDatum
from vfguide.surveillance.picture import Picture
from vfguide.surveillance.report import ASSUMED_SPEED, SMALL_AIRCRAFT, placed_at

NEITHER = ALL & ~int(
    AdsbFlags.VALID_HEADING | AdsbFlags.VALID_VELOCITY | AdsbFlags.VERTICAL_VELOCITY_VALID
)
DATUM = HeightDatum(0.0, 0.0)
speeds = st.floats(-80.0, 80.0)


def newest(v_n, seconds, flags=NEITHER, interval=1.0, sd=0.0):
    """The newest report of one that flies straight on."""
    picture, rng = Picture(ORIGIN, SMALL_AIRCRAFT), np.random.default_rng(1)
    for k in range(round(seconds / interval) + 1):
        t = k * interval
        p_n = np.array([300.0, -200.0, -150.0]) + t * np.array(v_n) + rng.normal(0.0, sd, 3)
        message = moving(tuple(map(float, p_n)), v_n, flags=flags)
        picture.hear(message, 5000 + round(1000 * t), None, DATUM)
    return picture.newest(1)


@given(st.tuples(speeds, speeds, st.floats(-8.0, 8.0)), st.floats(0.5, 2.0))
def test_it_is_where_it_was_over_the_time(v_n, interval):
    each = newest(v_n, 8.0, interval=interval).intruder
    assert each.v_n == pytest.approx(v_n, abs=0.1)
    assert each.uncertainty_rate <= SMALL_AIRCRAFT.uncertainty_rate + 10.0


def test_the_first_report_stands_and_is_doubted():
    each = newest((30.0, 0.0, 0.0), 0.0).intruder
    assert each.v_n[:2] == pytest.approx((0.0, 0.0), abs=0.01)
    assert each.uncertainty_rate == SMALL_AIRCRAFT.uncertainty_rate + ASSUMED_SPEED


@pytest.mark.parametrize("sd", [0.0, 3.0, 5.0])
@pytest.mark.parametrize("speed", [20.0, 60.0])
def test_the_doubt_holds_the_error(sd, speed):
    """Ten seconds ahead it is within the volume."""
    v_n = (0.0, speed, 0.0)
    report = newest(v_n, 20.0, sd=sd)
    ahead = placed_at(report, report.time_ms + 10_000)
    truth = np.array([300.0, -200.0, -150.0]) + 30.0 * np.array(v_n)
    miss = math.hypot(ahead[0] - truth[0], ahead[1] - truth[1])
    assert miss <= report.intruder.radius + 10.0 * report.intruder.uncertainty_rate


def test_a_told_velocity_is_kept():
    each = newest((0.0, 25.0, 0.0), 8.0, flags=ALL)
    assert each.intruder[3:] == SMALL_AIRCRAFT
    level = newest((0.0, 25.0, -3.0), 8.0, flags=ALL & ~int(AdsbFlags.VERTICAL_VELOCITY_VALID))
    assert level.intruder.v_n[2] == pytest.approx(-3.0, abs=0.05)
    assert level.intruder.uncertainty_rate == SMALL_AIRCRAFT.uncertainty_rate


def test_a_height_that_becomes_comparable_is_no_climb():
    picture = Picture(ORIGIN, SMALL_AIRCRAFT)
    for k in range(9):
        message = moving((300.0, 25.0 * k, -150.0), (0.0, 25.0, 0.0), flags=NEITHER)
        message = message._replace(altitude_type=0)
        datum = HeightDatum(None, 0.0) if k < 5 else HeightDatum(120.0, 0.0)
        picture.hear(message, 5000 + 1000 * k, None, datum)
        assert abs(picture.newest(1).intruder.v_n[2]) < 0.1
